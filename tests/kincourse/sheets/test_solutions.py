"""The official solutions solve: each of them, run in the sandbox where no answer can be read, has full marks."""

from pathlib import Path

import pytest
import submissions

from kincourse import COURSE, sheets

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO SOLUTION IS GRADED: this machine lacks {lacking}", allow_module_level=True)

from misstep.grading.collect.run_plan import plan_run, read_released_sheet
from misstep.grading.judging.parse_output import parse_output
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import Limits
from misstep.grading.sandbox.runner import Runner
from misstep.sheet import SAMPLE_ID

SOLUTIONS = Path(__file__).parents[3] / "solutions"


@pytest.fixture(scope="module")
def runner():
    """One server for all sheets, because it takes seconds to start."""
    started = Runner(setup_for(COURSE, SOLUTIONS))
    yield started
    started.close()


@pytest.mark.parametrize("name", sheets())
def test_every_official_solution_has_full_marks_in_the_sandbox(name, runner):
    """Where a problem is read off a drawing, the solution has what the drawing of SAMPLE_ID shows: update it with the drawing."""
    path = SOLUTIONS / name / f"{name}.ipynb"
    plan = plan_run(read_released_sheet(path), path.read_bytes())
    seed, redacted = submissions.judge_of(name).redacted_sheet(SAMPLE_ID)
    outcome = runner.run(redacted, [cell.source for cell in plan.cells], Limits())
    parsed = parse_output(name, plan, outcome.output, SAMPLE_ID)
    verdicts = submissions.verdicts(name, SAMPLE_ID, seed, parsed.answers)
    assert not [one.verdict for one in verdicts.values() if one.points < one.max]
