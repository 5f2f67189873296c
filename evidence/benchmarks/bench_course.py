"""What a class waits for: importing kinlib, grading beside nbgrader, and the memory that a student takes on a Hub.

Commands are run as a user runs them, from start to end. nbgrader has its defaults, and one job, because it has no more; each of its
checks is `assert sheet.check(k, ...).score == 3`, which an instructor would write who has this course and no grader but nbgrader.
"""

import os
import random
import resource
import subprocess
import sys
import time

import nbformat
import psutil
import pytest
from jupyter_client import KernelManager
from nbclient import NotebookClient
from nbgrader_course import ROOT, Course
from submissions import as_bytes, handed_in, mistaken, released, right

NOTEBOOKS = ("notebooks/03_poe_space.ipynb", "solutions/03_poe_space/03_poe_space.ipynb")
"""What a student has open at the same time: a lecture and its sheet."""


def processor_time():
    """Return the processor time of all processes that this one has started and that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


@pytest.mark.benchmark(timer=processor_time)
@pytest.mark.parametrize("name", ["kinlib", "numpy"])
def test_import(name, benchmark, tmp_path):
    """The processor time of a new Python that imports a package, with bytecode cached, as it is where packages are installed."""
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    environment |= {"PYTHONPYCACHEPREFIX": str(tmp_path), "PYTHONPATH": str(ROOT)}
    benchmark.extra_info |= {"section": "import", "library": name, "size": 1}
    command = [sys.executable, "-c", f"import {name}"]
    benchmark.pedantic(
        lambda: subprocess.run(command, env=environment, check=True), rounds=21, iterations=1, warmup_rounds=1
    )


def submission(number):
    """Return a student and a submission: most answers right, some with a known mistake, some missing."""
    chance, student = random.Random(number), f"student{number:04}"
    good, bad = right(student), mistaken(student, number)
    lines = {k: chance.choices([good[k], bad[k], "pass"], [6, 3, 1])[0] for k in good}
    return student, handed_in(student, lines)


def with_misstep(jobs):
    """Prepare the grading of submissions by misstep, its pages of feedback included."""

    def prepare(folder, submissions):
        for student, notebook in submissions:
            path = folder / "submitted" / student / released().name
            path.parent.mkdir(parents=True)
            path.write_bytes(as_bytes(notebook))
        command = [sys.executable, "-m", "misstep", "grade", released(), folder / "submitted", "--out", folder / "out"]
        environment = os.environ | {"PYTHONPATH": str(ROOT)}
        options = [*command, "--jobs", str(jobs)]
        return lambda: subprocess.run(options, env=environment, check=True, stdout=subprocess.DEVNULL)

    return prepare


def with_nbgrader(folder, submissions):
    """Prepare the grading of submissions by `nbgrader autograde`, which writes no feedback."""
    course = Course(folder / "course")
    for student, notebook in submissions:
        course.hand_in(student, notebook)
    return course.autograde


GRADERS = {
    "misstep grade --jobs 1": with_misstep(1),
    "misstep grade --jobs 2": with_misstep(2),
    "nbgrader autograde, its defaults": with_nbgrader,
}


@pytest.mark.benchmark(timer=time.perf_counter)
@pytest.mark.parametrize("grader", GRADERS)
def test_grading(grader, benchmark, tmp_path, pytestconfig):
    count = pytestconfig.getoption("submissions")
    run = GRADERS[grader](tmp_path, [submission(number) for number in range(count)])
    before = processor_time()
    benchmark.pedantic(run, rounds=1, iterations=1)
    benchmark.extra_info |= {"section": "grading", "library": grader, "size": count}
    benchmark.extra_info["processor"] = processor_time() - before


@pytest.mark.skipif(sys.platform != "linux", reason="proportional memory is counted on Linux alone")
@pytest.mark.benchmark(timer=time.perf_counter)
def test_memory_of_a_student(benchmark, tmp_path):
    """A server of JupyterLab, and two kernels that have run a lecture and its sheet; what processes share counts once (PSS)."""
    lab = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--port=0", f"--notebook-dir={tmp_path}"]

    def measure():
        with subprocess.Popen(
            lab, stderr=subprocess.PIPE, text=True, env=os.environ | {"HOME": str(tmp_path)}
        ) as server:
            next(line for line in server.stderr if "is running at" in line)
            sizes = [proportional_size(server.pid), *map(size_of_kernel, NOTEBOOKS)]
            server.terminate()
            server.stderr.read()
        return sum(sizes)

    benchmark.extra_info |= {"section": "student", "library": "a server, a lecture and its sheet", "size": 1}
    benchmark.extra_info["megabytes"] = benchmark.pedantic(measure, rounds=1, iterations=1)


def size_of_kernel(notebook):
    """Run a notebook, and return the memory of its kernel before it ends."""
    manager = KernelManager()
    cells = nbformat.read(ROOT / notebook, as_version=4)
    client = NotebookClient(cells, km=manager, timeout=600, resources={"metadata": {"path": str(ROOT)}})
    with client.setup_kernel():
        for index, cell in enumerate(cells.cells):
            client.execute_cell(cell, index)
        return proportional_size(manager.provisioner.pid)


def proportional_size(process):
    """Return the proportional set size of a process in MB."""
    return psutil.Process(process).memory_full_info().pss / 1e6
