"""Bytes of students: each step that reads them takes time in proportion to them, and none stalls the others."""

import importlib
import pkgutil
import re
import subprocess
import sys
import time

import heavy_notebooks
import pytest
import submissions
from heavy_notebooks import READABLE, UNREADABLE, honest
from submissions import SHEET

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NOTHING IS READ: this machine lacks {lacking}", allow_module_level=True)

from misstep.__main__ import main
from misstep.grading import code_digest, collect, judging, nbgrader, publish, sandbox
from misstep.grading.collect import layouts, roster
from misstep.grading.collect.run_plan import plan_step, read_released_sheet
from misstep.grading.judging.grader import Grader
from misstep.grading.nbgrader import gradebook
from misstep.grading.publish.result_store import ResultStore
from misstep.grading.reading import Reader, StepFailed

SOLUTION = str(submissions.ROOT / "solutions" / SHEET / f"{SHEET}.ipynb")


@pytest.fixture(scope="module")
def grader():
    with Grader(read_released_sheet(submissions.released())) as started:
        yield started


@pytest.mark.parametrize("name", [*READABLE, *UNREADABLE])
def test_no_notebook_reaches_the_limit_of_what_reads_it(name, grader):
    content = (READABLE | UNREADABLE)[name]("ada")
    result = grader.grade("ada", content)
    assert not [limit for limit in result.limits if "read" in limit]
    assert result.points == (24 if name in READABLE else 0)
    assert (result.status == "broken") == (name in UNREADABLE)
    assert result.reason or name in READABLE


@pytest.mark.parametrize("make", [heavy_notebooks.heavy_answer, heavy_notebooks.nested_answer])
def test_an_answer_that_is_slow_to_quote_or_to_walk_costs_only_its_problem(make, tmp_path):
    for student, content in (("eve", make("eve")), ("ada", honest("ada"))):
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / "x.ipynb").write_bytes(content)
    assert main(["grade", SOLUTION, str(tmp_path / "in"), "--out", str(tmp_path / "out")]) == 0
    store = ResultStore(tmp_path / "out")
    assert [store.load(student).points for student in ("eve", "ada")] == [21, 24]
    assert {path.stem for path in (tmp_path / "out" / "feedback").iterdir()} == {"eve", "ada"}


def test_a_step_that_takes_too_long_or_ends_its_process_costs_itself_alone():
    sheet = {"name": SHEET, "checks": {}, "opening": ""}
    with Reader() as reader:
        for _ in range(2):
            with pytest.raises(StepFailed, match=r"more than 0\.01 s of processor time"):
                reader.do("plan", seconds=0.01, sheet=sheet, content=READABLE["an image of 20 MB"]("ada"))
            assert reader.do("plan", sheet=sheet, content=honest("ada"))["typed_id"] == "ada"
        with pytest.raises(StepFailed, match="reading it raises TypeError"):
            reader.do("plan", sheet=sheet)
    with pytest.raises(StepFailed, match="nothing is read any more"):
        reader.do("plan", sheet=sheet, content=b"")


# --- expressions ---

OTHERS = (layouts, roster, gradebook, code_digest)
"""Their expressions see names of files, of at most 255 characters, the instructor's own tables, and our own files."""


def expressions():
    """Every regular expression of grading that sees what students wrote, by its name."""
    found = {}
    for package in (collect, judging, nbgrader, publish, sandbox):
        for module in pkgutil.iter_modules(package.__path__, f"{package.__name__}."):
            found |= vars(importlib.import_module(module.name))
    excluded = {id(value) for module in OTHERS for value in vars(module).values()}
    return {name: one for name, one in found.items() if isinstance(one, re.Pattern) and id(one) not in excluded}


EXPRESSIONS = {name: one for name, one in expressions().items() if isinstance(one.pattern, str)}

UNITS = (
    *(
        "a",
        "1",
        " ",
        "\n",
        "\t",
        "$",
        "`",
        "\\",
        "'",
        '"',
        "-",
        "_",
        "(",
        "=",
        ".",
        "#",
        "<",
        "%",
        ",",
        "$`",
        "$\n",
        "= ",
        "a ",
    ),
    *(
        "open_sheet(",
        "open_sheet('",
        ".check(",
        ".check(1,",
        ".check(1, a",
        "student",
        "student = 'a",
        "sheet.",
        "%%time",
        "\\dfrac",
    ),
    *("check-1", "a.a:", "sheet.show(1", "sheet.tally() ", "<<<<<<< ", "======="),
)


def seconds_of(pattern, text):
    """The least processor time of three searches through a text."""
    times = []
    for _ in range(3):
        start = time.process_time()
        pattern.sub("", text)
        times.append(time.process_time() - start)
    return min(times)


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_an_expression_takes_time_in_proportion_to_the_text(name):
    """Four times the text take four times as long, not sixteen times. What takes less than a millisecond is not compared."""
    pattern = EXPRESSIONS[name]
    for unit in UNITS:
        for start in ("", ".check(", "student", "open_sheet(", "$", "`"):
            short, long = (start + unit * (count // len(unit)) for count in (2_500, 10_000))
            if (seconds := seconds_of(pattern, long)) > 0.001:
                assert seconds < 9 * max(seconds_of(pattern, short), 0.0002), (unit, start)


def test_planning_takes_time_in_proportion_to_the_notebook():
    sheet = read_released_sheet(submissions.released())
    given = {"name": SHEET, "checks": dict(sheet.checks), "opening": sheet.opening}

    def seconds(content):
        times = []
        for _ in range(3):
            start = time.process_time()
            plan_step(given, submissions_base64(content))
            times.append(time.process_time() - start)
        return min(times)

    name = heavy_notebooks.NAME
    for line in (f"# {name} ", f"{name} == 0; ", f"{name}.a = 0; ", "%time 1\n", f"{name} += 1\n"):
        short, long = (heavy_notebooks.with_cells("ada", line * count) for count in (1_000, 4_000))
        assert seconds(long) < 9 * seconds(short)


def submissions_base64(content):
    return heavy_notebooks.b64encode(content).decode()


# --- stopping ---


@pytest.mark.parametrize("moment", [".lock", "results/ada.json", "feedback/ada.html"])
def test_an_interrupt_ends_the_run_at_any_moment_and_says_so_in_a_sentence(moment, tmp_path):
    """A submission that would run for an hour does not keep it."""
    endless = submissions.as_bytes(submissions.handed_in("eve", first="import time\nwhile True: time.sleep(1)"))
    for student, content in (("ada", honest("ada")), ("eve", endless), ("fay", endless)):
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / "x.ipynb").write_bytes(content)
    limits = [f"--limit={name}=3600" for name in ("cell_seconds", "cell_wall_seconds", "seconds", "wall_seconds")]
    command = [sys.executable, "-m", "misstep", "grade", SOLUTION, str(tmp_path / "in"), "--out", str(tmp_path / "out")]
    with subprocess.Popen([*command, *limits], cwd=submissions.ROOT, stderr=subprocess.PIPE, text=True) as process:
        while not (tmp_path / "out" / moment).exists() and process.poll() is None:
            time.sleep(0.01)
        process.send_signal(2)
        told = process.communicate(timeout=120)[1]
    assert process.returncode == 130
    assert "the same command continues from there" in told
    assert "Traceback" not in told
