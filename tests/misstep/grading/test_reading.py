"""Bytes of students: each step that reads them takes time in proportion to them, and none stalls the others."""

import subprocess
import sys
import time
from functools import partial

import heavy_notebooks
import pytest
import submissions
from heavy_notebooks import READABLE, UNREADABLE, honest
from submissions import SHEET

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NOTHING IS READ: this machine lacks {lacking}", allow_module_level=True)

from misstep.__main__ import main
from misstep.grading.collect.notebook import UnusableNotebook
from misstep.grading.collect.run_plan import read_released_sheet
from misstep.grading.judging.grader import start_judge
from misstep.grading.publish.result_store import ResultStore
from misstep.grading.sandbox.limits import Limits
from misstep.grading.steps import StepFailed

SECONDS = Limits().reading_seconds

RELEASED = read_released_sheet(submissions.released())
SOLUTION = str(submissions.ROOT / "solutions" / SHEET / f"{SHEET}.ipynb")


@pytest.fixture(scope="module")
def judge():
    with start_judge(RELEASED) as started:
        yield started


def test_no_notebook_reaches_the_limit_of_what_reads_it(judge):
    for name, make in READABLE.items():
        plan = judge.do("plan", seconds=SECONDS, sheet=RELEASED, content=make("ada"))
        assert (len(plan.problems), plan.typed_id) == (12, "ada"), name
    for name, (make, reason) in UNREADABLE.items():
        with pytest.raises(UnusableNotebook) as refused:
            judge.do("plan", seconds=SECONDS, sheet=RELEASED, content=make("ada"))
        assert reason in str(refused.value), name


def test_an_answer_that_is_slow_to_quote_or_to_walk_costs_only_its_problem(tmp_path):
    shown = partial(honest, last=heavy_notebooks.SHOWN)
    made = {"eve": heavy_notebooks.heavy_answer, "fay": heavy_notebooks.nested_answer, "ada": shown}
    for student, make in made.items():
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / "x.ipynb").write_bytes(make(student))
    assert main(["grade", SOLUTION, str(tmp_path / "in"), "--out", str(tmp_path / "out")]) == 0
    store = ResultStore(tmp_path / "out")
    assert [store.load(student).points for student in made] == [25, 25, 28]
    assert {path.stem for path in (tmp_path / "out" / "feedback").iterdir()} == {*made}


def test_a_step_that_takes_too_long_or_ends_its_process_costs_itself_alone(judge):
    for _ in range(2):
        with pytest.raises(StepFailed, match=r"it takes more than 0\.01 s of processor time"):
            judge.do("plan", seconds=0.01, sheet=RELEASED, content=READABLE["an image of 20 MB"]("ada"))
        assert judge.do("plan", sheet=RELEASED, content=honest("ada")).typed_id == "ada"
    with pytest.raises(StepFailed, match="it raises TypeError"):
        judge.do("plan", sheet=RELEASED)
    with start_judge(RELEASED) as closed:
        pass
    with pytest.raises(StepFailed, match="The server of processes has ended"):
        closed.do("plan", sheet=RELEASED, content=b"")


# --- stopping ---


@pytest.mark.parametrize("moment", [".lock", "results/ada.json"])
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
