"""Effects of hostile submissions: the attacks of the tests on misstep and on plain nbgrader.

    python -m benchmarks.course.hostile                 as root, on Linux; takes some minutes
    python -m benchmarks.course.hostile proc heap       only attacks with these words in their names

For nbgrader, each attack runs in its own process and mount namespaces, on a read-only disk except for the course and the
attacked folder, because otherwise it could destroy the machine that runs this benchmark. Attacks that would use up memory,
processes or disk, or change mounts, are not run with nbgrader.

An attack can win *points* without an answer, *read* a secret, *change* a file, *reach* a port, leave a process *alive*, or
leave the submission without a *grade*. "-" means that it achieved none of these.
"""

import json
import os
import socket
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

import attacks
from submissions import as_bytes, attacking, descendants, released, right

from benchmarks.course.nbgrader_baseline import SHEET, Course

CANARY = "SECRET-CANARY"

MAX_OWN_PROCESSES = 4
"""The processes that count what an attack has left alive: the shell, its subshell, ps and wc."""

UNLIMITED = {
    *("20 GB are asked for", "a fork bomb", "a thread bomb", "the output floods", "the pipe floods", "the disk fills"),
    "the sandbox is asked to let go",
}
"""Attacks that a grader without limits cannot survive."""


def main(*words):
    """Print a line for each attack, and how many succeeded."""
    from misstep.grading.collect.run_plan import read_released_sheet
    from misstep.grading.judging.grader import Grader
    from misstep.grading.sandbox.limits import Limits

    names = [name for name in attacks.ATTACKS if not words or any(word in name for word in words)]
    os.environ["SECRET_TOKEN"] = CANARY
    successes = {"misstep": 0, "nbgrader": 0}
    limits = Limits(cell_seconds=2, seconds=4, memory_mb=1024, output_mb=1)
    with socket.create_server(("127.0.0.1", 0)) as port, tempfile.TemporaryDirectory() as top:
        port.setblocking(False)
        course = Course(Path(top, "course"), timeout=5)
        with Grader(read_released_sheet(released()), limits) as grader:
            print(f"{'attack':44}  {'misstep':32}  nbgrader")
            for number, name in enumerate(names):
                outside = Path(top, f"outside{number}")
                by_misstep = effects(outside, port, partial(grade_with_misstep, grader), name)
                if name in UNLIMITED:
                    by_nbgrader = "not tried"
                else:
                    by_nbgrader = effects(
                        outside, port, partial(grade_with_nbgrader, course, f"student{number}", outside), name
                    )
                successes["misstep"] += by_misstep != "-"
                successes["nbgrader"] += by_nbgrader not in {"-", "not tried"}
                print(f"{name:44}  {by_misstep:32}  {by_nbgrader}", flush=True)
    tried = len(names) - len(UNLIMITED & set(names))
    print(
        f"successful: {successes['misstep']} of {len(names)} against misstep, {successes['nbgrader']} of {tried} against nbgrader"
    )


def effects(outside, port, grade, name):
    """Run an attack with a grader, and list its effects."""
    prepare_target(outside)
    before = listing(outside)
    replayed = "{" + ", ".join(f"{k}: {line.partition(' = ')[2]}" for k, line in right("bob").items()) + "}"
    places = {"folder": outside, "port": port.getsockname()[1], "replayed": replayed}
    points, outputs, alive = grade(attacking("ada", attacks.source(name, **places)))
    achieved = {
        "no grade": points is None,
        f"{points or 0:g} points": bool(points),
        "reads": CANARY in outputs,
        "changes": listing(outside) != before,
        "reaches": was_reached(port),
        "alive": alive,
    }
    return ", ".join(effect for effect, is_achieved in achieved.items() if is_achieved) or "-"


def grade_with_misstep(grader, notebook):
    """Grade with misstep; return points, outputs, and whether a process is left alive."""
    result = grader.grade("ada", as_bytes(notebook))
    return result.points, json.dumps([cell.outputs for cell in result.cells]), len(descendants(grader)) > 1


def grade_with_nbgrader(course, student, outside, notebook):
    """Grade with nbgrader; return points, outputs, and whether a process is left alive."""
    course.hand_in(student, notebook)
    script = (
        f"mount --make-rprivate / && for d in {course.folder} {outside} /dev/shm; do mount --bind $d $d; done && "
        f"mount -o remount,ro,bind / && cd {course.folder} && "
        f"timeout 120 {sys.executable} -m nbgrader autograde {SHEET} --student={student}; code=$?; sleep 0.5; "
        "echo $code $(ps -e --no-headers | wc -l)"
    )
    command = ["unshare", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc", "sh", "-c", script]
    home = course.folder / "home"
    home.mkdir(exist_ok=True)
    paths = {"HOME": str(home), "TMPDIR": str(home), "PYTHONPATH": str(released().parents[2])}
    paths["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(command, env=os.environ | paths, capture_output=True, text=True, check=False)
    code, count = map(int, done.stdout.split()[-2:])
    graded = course.folder / "autograded" / student / SHEET / f"{SHEET}.ipynb"
    text = graded.read_text("utf-8") if graded.exists() else ""
    outputs = json.dumps([cell.get("outputs") for cell in json.loads(text)["cells"]]) if text else ""
    points = course.scores().get(student) if code == 0 else None
    return points, outputs, count > MAX_OWN_PROCESSES


def prepare_target(folder):
    """Make a folder with the files that attacks try to read or change."""
    import shutil
    import sqlite3

    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    folder.chmod(0o777)
    (folder / "secret.txt").write_text(CANARY)
    with sqlite3.connect(folder / "gradebook.db") as book:
        book.execute("create table grade (score real)")
        book.execute("insert into grade values (7)")
    book.close()


def listing(folder):
    """Return the content of every file in a folder."""
    return {path.name: path.read_bytes() for path in folder.iterdir()} if folder.exists() else {}


def was_reached(port):
    """Return whether a connection was opened since the last call."""
    try:
        port.accept()[0].close()
    except BlockingIOError:
        return False
    return True


if __name__ == "__main__":
    main(*sys.argv[1:])
