"""More than one machine: a real scheduler and two real workers on loopback, one of them killed in the middle."""

import json
import os
import subprocess
import sys
import threading
import time

import pytest
import submissions
from submissions import SHEET, as_bytes, handed_in, right

if sys.platform != "linux":
    pytest.skip("the sandbox is made of Linux", allow_module_level=True)

from misstep.__main__ import main
from misstep.grading.judging import cluster
from misstep.grading.publish.grades_csv import grades_table
from misstep.grading.publish.result_store import ResultStore

STUDENTS = [f"student{number}" for number in range(6)]

SLOW = "import time\ntime.sleep(0.5)"

SECONDS = 120
"""How long to wait for a process that imports on a busy machine."""


def dask(*arguments):
    environment = {**os.environ, "PYTHONPATH": str(submissions.ROOT), "PYTHONWARNINGS": "ignore"}
    command = [sys.executable, "-m", "dask", *arguments, "--no-dashboard"]
    return subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def until(is_so, what):
    deadline = time.monotonic() + SECONDS
    while not is_so():
        assert time.monotonic() < deadline, f"{what}: not within {SECONDS} s"
        time.sleep(0.05)


@pytest.fixture
def running(tmp_path):
    """The address of a scheduler, and its two workers."""
    told = tmp_path / "scheduler.json"
    processes = [dask("scheduler", "--scheduler-file", str(told), "--host", "127.0.0.1", "--port", "0", "--no-show")]
    try:
        until(told.exists, "the scheduler starts")
        worker = ["worker", "--scheduler-file", str(told), "--host", "127.0.0.1", "--no-nanny", "--nthreads", "1"]
        processes += [dask(*worker, "--name", name) for name in ("one", "two")]
        address = json.loads(told.read_text())["address"]
        yield address, processes[1:]
    finally:
        for process in processes:
            process.kill()
            process.wait()


def test_a_worker_is_killed_in_the_middle_and_everybody_is_graded_once(running, tmp_path, monkeypatch, capsys):
    address, workers = running
    for student in STUDENTS:
        (tmp_path / "in" / student).mkdir(parents=True)
        content = as_bytes(handed_in(student, right(student), first=SLOW))
        (tmp_path / "in" / student / f"{SHEET}.ipynb").write_bytes(content)
    kept = []
    keep = ResultStore.save
    monkeypatch.setattr(
        ResultStore, "save", lambda self, result, mark: (kept.append(result.student), keep(self, result, mark))
    )
    from distributed import Client

    with Client(address, timeout=SECONDS, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=SECONDS)
    killer = threading.Thread(target=lambda: (until(lambda: len(kept) >= 2, "two are graded"), workers[0].kill()))
    killer.start()
    sheet = submissions.ROOT / "solutions" / SHEET / f"{SHEET}.ipynb"
    out = tmp_path / "out"
    code = main(["grade", str(sheet), str(tmp_path / "in"), "--out", str(out), "--cluster", address])
    killer.join()
    if "The sandbox cannot" in capsys.readouterr().err:
        pytest.skip("NO CLUSTER IS TESTED: this machine has no sandbox")
    assert code == 0
    assert workers[0].poll() is not None
    assert workers[1].poll() is None
    assert sorted(kept) == STUDENTS
    results = [ResultStore(out).load(student) for student in STUDENTS]
    assert [result.points for result in results] == [28] * len(STUDENTS)
    assert (out / "grades.csv").read_text("utf-8") == grades_table(results)


def test_a_missing_scheduler_is_told(monkeypatch):
    monkeypatch.setattr(cluster, "CONNECT_TIMEOUT", "0.2s")
    with pytest.raises(cluster.ClusterUnreachable, match="No Dask scheduler answers at tcp"):
        cluster.connect("tcp://127.0.0.1:1").__enter__()
