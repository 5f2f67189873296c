"""What hostile submissions get: the attacks of the tests, against kinlib and against stock nbgrader, side by side.

    python -m benchmarks.course.hostile                 as root, on Linux: it takes some minutes
    python -m benchmarks.course.hostile proc heap       only attacks with these words in their names

nbgrader runs each attack in namespaces of processes and mounts made for it, on a disk that can be read and not written,
but for the course and the folder that is attacked: or this would be no benchmark, but the end of the machine that runs it.
Attacks that would take all its memory, processes or disk, or turn its mounts, are not tried on nbgrader.

An attack *wins points* that no answer earned, *reads* a secret, *changes* a file, *reaches* a port, leaves a process
*alive*, or leaves the submission without a *grade*. Nothing of this is a dash.
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

ALONE = 4
"""So many processes are left when nothing is: the shell, its copy that counts, and what it counts with."""

TOO_MUCH = {
    *("20 GB are asked for", "a fork bomb", "a thread bomb", "the output floods", "the pipe floods", "the disk fills"),
    "the sandbox is asked to let go",
}
"""For a grader without limits."""


def main(*words):
    """Print a line for each attack, and how many won."""
    from misstep.grading.collect.run_plan import read_released_sheet
    from misstep.grading.judging.grader import Grader
    from misstep.grading.sandbox.limits import Limits

    names = [name for name in attacks.ATTACKS if not words or any(word in name for word in words)]
    os.environ["SECRET_TOKEN"] = CANARY
    won = {"kinlib": 0, "nbgrader": 0}
    limits = Limits(cell_seconds=2, seconds=4, memory_mb=1024, output_mb=1)
    with socket.create_server(("127.0.0.1", 0)) as port, tempfile.TemporaryDirectory() as top:
        port.setblocking(False)
        course = Course(Path(top, "course"), timeout=5)
        with Grader(read_released_sheet(released()), limits) as grader:
            print(f"{'attack':44}  {'kinlib':32}  nbgrader")
            for number, name in enumerate(names):
                outside = Path(top, f"outside{number}")
                by_us = effects(outside, port, partial(ours, grader), name)
                if name in TOO_MUCH:
                    by_them = "not tried"
                else:
                    by_them = effects(outside, port, partial(theirs, course, f"student{number}", outside), name)
                won["kinlib"] += by_us != "-"
                won["nbgrader"] += by_them not in {"-", "not tried"}
                print(f"{name:44}  {by_us:32}  {by_them}", flush=True)
    tried = len(names) - len(TOO_MUCH & set(names))
    print(f"won: {won['kinlib']} of {len(names)} against kinlib, {won['nbgrader']} of {tried} against nbgrader")


def effects(outside, port, graded, name):
    """What an attack achieved with a grader, in words."""
    lay_out(outside)
    before = listing(outside)
    replayed = "{" + ", ".join(f"{k}: {line.partition(' = ')[2]}" for k, line in right("bob").items()) + "}"
    places = {"folder": outside, "port": port.getsockname()[1], "replayed": replayed}
    points, told, alive = graded(attacking("ada", attacks.source(name, **places)))
    found = {
        "no grade": points is None,
        f"{points or 0:g} points": bool(points),
        "reads": CANARY in told,
        "changes": listing(outside) != before,
        "reaches": was_reached(port),
        "alive": alive,
    }
    return ", ".join(word for word, is_so in found.items() if is_so) or "-"


def ours(grader, notebook):
    """Points, outputs, and whether a process survived."""
    result = grader.grade("ada", as_bytes(notebook))
    return result.points, json.dumps([cell.outputs for cell in result.cells]), len(descendants(grader)) > 1


def theirs(course, student, outside, notebook):
    """Points, outputs, and whether a process survived, after stock nbgrader."""
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
    told = graded.read_text("utf-8") if graded.exists() else ""
    outputs = json.dumps([cell.get("outputs") for cell in json.loads(told)["cells"]]) if told else ""
    points = course.scores().get(student) if code == 0 else None
    return points, outputs, count > ALONE


def lay_out(folder):
    """A fresh folder with what an attack would like to reach."""
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
    """What is in a folder, byte by byte."""
    return {path.name: path.read_bytes() for path in folder.iterdir()} if folder.exists() else {}


def was_reached(port):
    """Whether somebody has called since the last time."""
    try:
        port.accept()[0].close()
    except BlockingIOError:
        return False
    return True


if __name__ == "__main__":
    main(*sys.argv[1:])
