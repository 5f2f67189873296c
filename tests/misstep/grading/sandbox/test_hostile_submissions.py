"""Hostile and strange submissions: each gets a grade and a reason, none a point too many, and no neighbour loses one."""

import json
import os
import re
import socket
import sqlite3
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from dataclasses import asdict
from hashlib import sha256

import attacks
import pytest
import submissions
from attacks import ENDLESS, LIMITS, SHORT
from submissions import as_bytes, attacking, code, descendants, handed_in, mistaken, right

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO ATTACK IS TRIED: this machine lacks {lacking}", allow_module_level=True)

from misstep.grading.collect.run_plan import read_released_sheet
from misstep.grading.judging.grader import Grader
from misstep.grading.sandbox.allowed_syscalls import ALLOWED_COMMANDS, ALLOWED_SYSCALLS

NEIGHBOUR = "neighbour"

NEIGHBOUR_AFTER = 4
"""After how many attacks an honest submission is graded: fewer than steps.LEASES_PER_PROCESS, so that what an attack leaves
behind in the judge would still be there."""


@pytest.fixture(scope="module")
def outside(tmp_path_factory):
    """What an attack would like to reach, on the machine that grades."""
    folder = tmp_path_factory.mktemp("outside")
    folder.chmod(0o777)
    (folder / "secret.txt").write_text("SECRET-CANARY")
    (folder / "solutions.ipynb").write_text("SECRET-CANARY")
    with closing(sqlite3.connect(folder / "gradebook.db")) as book, book:
        book.execute("create table grade (score real)")
        book.execute("insert into grade values (7)")
    return folder


@pytest.fixture(scope="module")
def port():
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.setblocking(False)
        yield server


@pytest.fixture(scope="module")
def grader():
    os.environ["SECRET_TOKEN"] = "SECRET-CANARY"
    with Grader(read_released_sheet(submissions.released()), LIMITS) as made:
        yield made


def listing(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


@pytest.mark.parametrize("name", attacks.ATTACKS)
def test_an_attack_gains_nothing_reads_nothing_changes_nothing(name, grader, outside, port, monkeypatch):
    monkeypatch.setattr(grader, "_limits", SHORT if name in ENDLESS else LIMITS)
    replayed = "{" + ", ".join(f"{k}: {line.partition(' = ')[2]}" for k, line in right("bob").items()) + "}"
    places = {"folder": outside, "port": port.getsockname()[1], "replayed": replayed}
    before = listing(outside)
    result = grader.grade("ada", as_bytes(attacking("ada", attacks.source(name, **places))))

    assert result.points == 0
    assert result.max == 37
    assert result.status in {"graded", "stopped"}
    assert result.reason or result.status == "graded"
    assert all(problem.verdict for problem in result.problems)

    told = json.dumps([cell.outputs for cell in result.cells])
    assert "SECRET-CANARY" not in told
    assert "NEIGHBOUR-CANARY" not in told
    assert "uid=0" not in told
    assert listing(outside) == before
    with pytest.raises(BlockingIOError):
        port.accept()
    assert len(descendants(grader)) == 1

    if [*reversed(attacks.ATTACKS)].index(name) % NEIGHBOUR_AFTER == 0:  # so also after the last one
        honest = handed_in(NEIGHBOUR, right(NEIGHBOUR), first="'NEIGHBOUR-CANARY'")
        assert grader.grade(NEIGHBOUR, as_bytes(honest)).points == 28


# --- strange, and honest ---


def full(change=None, student="ada", lines=None, **more):
    """A sheet with every answer right, after something happened to it."""
    notebook = handed_in(student, {**right(student), **(lines or {})}, **more)
    if change:
        change(notebook)
    return notebook


def without(*names):
    def change(notebook):
        notebook["cells"] = [cell for cell in notebook["cells"] if cell["id"] not in names]

    return change


def doubled(notebook):
    notebook["cells"].insert(3, dict(cell_of(notebook, "check-1")))


def edited(notebook):
    cell_of(notebook, "check-1")["source"] = "sheet.check(1, np.zeros((3, 6)))"


def from_colab(notebook):
    """Colab keeps its own ids in the metadata, and source as one text; nbgrader's names are gone."""
    notebook["metadata"] = {"colab": {"provenance": []}, "kernelspec": {"name": "python3"}}
    notebook["nbformat_minor"] = 0
    for cell in notebook["cells"]:
        cell["metadata"] = {"id": cell.pop("id") + "Xy7"}
    notebook["cells"].insert(0, code("!pip install kinlib\nfrom google.colab import drive"))


def from_vs_code(notebook):
    """VS Code writes lines, other ids, and its own metadata."""
    for number, cell in enumerate(notebook["cells"]):
        cell["metadata"] = {"vscode": {"languageId": "python"}}
        cell["id"] = f"{number:08x}"
        cell["source"] = cell["source"].splitlines(keepends=True)


def with_outputs(notebook):
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            cell["outputs"] = [{"output_type": "stream", "name": "stdout", "text": "x" * 200_000}]


def with_lines_of_windows(notebook):
    for cell in notebook["cells"]:
        cell["source"] = cell["source"].replace("\n", "\r\n")


def with_a_conflict_in_a_cell(notebook):
    answer = cell_of(notebook, "answer-1")
    answer["source"] = "<<<<<<< HEAD\nscrews_1 = 1\n=======\n" + answer["source"] + "\n>>>>>>> theirs\n"


def spoiled(k, line):
    """Every answer right, and a line in cell k after its answer."""
    return full(lines={k: right("ada")[k] + "\n" + line})


def cell_of(notebook, name):
    return next(cell for cell in notebook["cells"] if cell["id"] == name)


STRANGE = {
    "as it should be": (full, 28, ""),
    "magics, plots and displays": (
        lambda: full(
            first="%matplotlib inline\n%time 1 + 1\nimport matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.show()"
        ),
        28,
        "",
    ),
    "a cell that awaits": (lambda: full(first="import asyncio\nawait asyncio.sleep(0)"), 28, ""),
    "mistaken": (lambda: handed_in("ada", mistaken("ada")), None, ""),
    "an id in capitals": (lambda: full(student="ADA"), 28, ""),
    "another id, numbers typed in": (
        lambda: full(student="bob"),
        0,
        "opened for 'bob', and graded with the numbers of 'ada'",
    ),
    "from Colab": (lambda: full(from_colab), 28, "Passed over while grading: "),
    "from VS Code": (lambda: full(from_vs_code), 28, ""),
    "outputs of 6 MB": (lambda: full(with_outputs), 28, ""),
    "Windows line ends": (lambda: full(with_lines_of_windows), 28, ""),
    "a byte order mark": (lambda: b"\xef\xbb\xbf" + as_bytes(full()), 28, ""),
    "UTF-16": (lambda: as_bytes(full()).decode().encode("utf-16"), 28, ""),
    "Latin-1": (lambda: as_bytes(full(first="'über'")).decode().encode("latin-1"), 28, ""),
    "half a character": (lambda: as_bytes(full(first="'*'")).replace(b"'*'", rb"print('\ud83d')"), 28, ""),
    "a check cell deleted": (lambda: full(without("check-1")), 28, "03.1: .*deleted"),
    "an answer cell deleted": (
        lambda: full(without("answer-1")),
        25,
        "03.1: .*NameError: name 'screws_1' is not defined",
    ),
    "the first cell deleted": (lambda: full(without("open")), 28, "No id was found in the sheet"),
    "a check cell doubled": (lambda: full(doubled), 28, "03.1: .*2 times"),
    "a check cell edited": (lambda: full(edited), 28, "03.1: .*edited"),
    "a cell with a typing error": (lambda: spoiled(1, "x = = 1"), 25, "SyntaxError"),
    "a cell that fails": (lambda: spoiled(1, "1 / 0"), 28, "ZeroDivisionError"),
    "a cell that leaves": (lambda: spoiled(1, "import sys\nsys.exit()"), 28, "SystemExit"),
    "a cell that asks": (
        lambda: spoiled(1, "name = input('Who are you?')"),
        28,
        "cannot be used while a sheet is graded",
    ),
    "a loop without end": (lambda: spoiled(1, "while True: pass"), 28, "CellTimeout: This cell took too long"),
    "recursion without end": (lambda: spoiled(1, "f = lambda: f()\nf()"), 28, "RecursionError"),
    "20 GB": (lambda: spoiled(1, "np.ones(20 * 2**27)"), 28, "MemoryError"),
    "a list without end": (
        lambda: spoiled(1, "a = [0]\nwhile True:\n    a *= 2"),
        28,
        "more memory than a submission may use",
    ),
    "much printed": (lambda: full(first="for _ in range(20): print('x' * 1_000_000)"), 28, ""),
    "os._exit after four problems": (
        lambda: spoiled(5, "import os\nos._exit(0)"),
        25,
        "left out, and the other cells were run without it: the process ended itself",
    ),
    "a crash after four problems": (lambda: spoiled(5, "import ctypes\nctypes.string_at(0)"), 25, "ended by SIGSEGV"),
    "a function that crashes when it is called": (
        lambda: full(lines={7: "fk_7 = lambda *_: __import__('ctypes').string_at(0)"}),
        25,
        "03.7: Its check cell failed with RuntimeError: This cell was left out",
    ),
    "crashes without end": (
        lambda: full(lines=dict.fromkeys((5, 6, 7, 8), "import ctypes\nctypes.string_at(0)")),
        12,
        "stopped in code cell .* ended by SIGSEGV",
    ),
    "a conflict in a cell": (lambda: full(with_a_conflict_in_a_cell), 25, "SyntaxError"),
    "cut off": (lambda: as_bytes(full())[:5000], 0, "cut off or damaged"),
    "empty": (lambda: b"  \n", 0, "is empty"),
    "nothing": (lambda: None, 0, "Nothing was handed in"),
    "a script": (lambda: b"import numpy as np\nscrews_1 = 0", 0, "not a notebook.*not a script"),
    "a PDF": (lambda: b"%PDF-1.7\n...", 0, "a PDF"),
    "a zip": (lambda: b"PK\x03\x04\x00\xff", 0, "a zip"),
    "a web page": (lambda: b"<!DOCTYPE html><html></html>", 0, "a web page"),
    "a list": (lambda: b"[1, 2]", 0, "not a notebook"),
    "cells that are none": (
        lambda: b'{"cells": [1, null, {"cell_type": "code", "source": {"a": 1}, "metadata": 3}]}',
        0,
        "not sheet",
    ),
    "another sheet": (lambda: handed_in("ada", name="05_dh_standard"), 0, "opens 05_dh_standard"),
    "a lecture": (lambda: {"cells": [code("import kinlib as kl\nkl.hat([0, 0, 1])")]}, 0, "none of its cells"),
}


@pytest.mark.parametrize("name", STRANGE)
def test_a_strange_submission_gets_what_its_answers_deserve_and_a_reason(name, grader):
    make, points, reason = STRANGE[name]
    made = make()
    result = grader.grade("ada", as_bytes(made) if isinstance(made, dict) else made)
    odd = [f"{problem.number}: {note}" for problem in result.problems for note in problem.notes]
    told = "\n".join([result.reason, *result.notes, *odd])
    if points is None:
        assert all(problem.mistakes for problem in result.problems[:8])
    else:
        assert result.points == points
    assert re.search(reason, told) if reason else not told
    assert (result.status == "broken") == (not result.cells)
    assert len(result.problems) == 12
    json.dumps(asdict(result), allow_nan=False, ensure_ascii=False).encode()  # so it can be stored as it is


WINDOW = "import matplotlib.pyplot as plt\nplt.switch_backend('TkAgg')\nplt.plot([1, 2])\nplt.show()"


def test_a_result_says_what_was_handed_in_and_how_it_was_run(grader):
    group = "print('shown')\nimport os\nprint(os.getpgrp() == os.getpid() == os.getsid(0))"
    content = as_bytes(full(first=f"{group}\n{WINDOW}"))
    result = grader.grade("ada", content)
    assert result.digest == sha256(content).hexdigest()
    assert result.is_safe
    assert result.typed_id == "ada"
    outputs = [output for cell in result.cells for output in cell.outputs]
    text = "".join(output["text"] for output in outputs if output["output_type"] == "stream")
    assert text == "shown\nTrue\n", "it is in no process group with the grader"
    kinds = [[*output["data"]] for output in outputs if "image/png" in output.get("data", {})]
    assert kinds == [["text/plain", "image/png"]], "a figure is inline, whatever window was asked for"
    notebook = json.loads(content)
    for cell in result.cells:
        assert "".join(notebook["cells"][cell.index]["source"]) == cell.source


def test_many_at_a_time_do_not_mix(grader):
    students = [f"student {i}" for i in range(12)]
    with ThreadPoolExecutor(4) as pool:
        graded = pool.map(lambda s: grader.grade(s, as_bytes(handed_in(s, right(s), first=f"print({s!r})"))), students)
    for student, result in zip(students, graded, strict=True):
        assert (result.student, result.points) == (student, 28)
        assert [output["text"] for output in result.cells[1].outputs] == [f"{student}\n"]


def test_a_server_and_a_judge_that_were_killed_are_started_anew(grader):
    for process in (grader._runner.server.process, grader._judge.server.process):
        process.kill()
        process.wait()
    assert grader.grade("ada", as_bytes(full())).status in {"graded", "broken"}
    assert grader.grade("ada", as_bytes(full())).points == 28


NUMBERS_OF_CALLS = """
import ctypes
libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long
answers = {}
for number in {numbers}:
    ctypes.set_errno(0)
    answers[number] = libc.syscall(number, -1, -1, -1, -1, -1, -1), ctypes.get_errno()
print([number for number, answer in answers.items() if answer not in {(-1, 1), (-1, 38)}])
"""


def test_no_system_call_reaches_the_kernel_that_is_not_on_the_list(grader):
    """The filter answers before the kernel looks at the arguments, with "not permitted" or "no such call"."""
    import pyseccomp

    listed = {*ALLOWED_SYSCALLS, *ALLOWED_COMMANDS, "clone"}
    allowed = {pyseccomp.resolve_syscall(pyseccomp.system_arch(), name) for name in listed}
    traps = {335, 336}  # uretprobe and uprobe of x86-64: the kernel itself ends whatever calls them from elsewhere
    others = [number for number in range(480) if number not in allowed | traps]
    assert len(others) > 200
    result = grader.grade("ada", as_bytes(handed_in("ada", first=NUMBERS_OF_CALLS.replace("{numbers}", str(others)))))
    assert result.cells[1].outputs[0]["text"] == "[]\n"


def test_a_call_with_a_command_that_is_not_on_the_list_is_refused(grader):
    for line in ("fcntl.fcntl(1, 1031, 1 << 20)", "fcntl.ioctl(1, 0x5412, b'x')"):
        code = f"import fcntl\ntry: {line}\nexcept OSError as error: print(error.strerror)"
        result = grader.grade("ada", as_bytes(handed_in("ada", first=code)))
        assert result.cells[1].outputs[0]["text"] == "Function not implemented\n"


SOMEBODY = """
import sys
from attacks import ATTACKS, source
from misstep.grading.judging.grader import Grader
from misstep.grading.collect.run_plan import read_released_sheet
from submissions import as_bytes, attacking, descendants, handed_in, released, right

with Grader(read_released_sheet(released())) as grader:
    for name in sys.argv[2:]:
        result = grader.grade("ada", as_bytes(attacking("ada", source(name, folder=sys.argv[1]))))
        print(name, result.points, len(descendants(grader)))
    print(grader.grade("ada", as_bytes(handed_in("ada", right("ada")))).points)
"""


def test_where_there_is_only_one_user_a_submission_harms_that_user_no_more(outside):
    """As in a container without root, or for a teacher on their own machine: ids cannot tell who is who."""
    names = ["everybody is killed", "files are written outside", "files are deleted", "the sandbox is asked to let go"]
    before = listing(outside)
    command = ["unshare", "--user", "--map-root-user", sys.executable, "-c", SOMEBODY, str(outside), *names]
    paths = {"PYTHONPATH": os.pathsep.join([str(submissions.ROOT), str(submissions.ROOT / "tests" / "support")])}
    done = subprocess.run(command, env=os.environ | paths, capture_output=True, text=True, check=False)
    assert done.stdout.splitlines() == [*(f"{name} 0.0 1" for name in names), "28.0"], done.stderr
    assert listing(outside) == before
