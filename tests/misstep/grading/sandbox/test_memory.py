"""The memory of a submission: no way to hold it goes beyond the limit."""

import json

import pytest
import submissions
from attacks import HOARD, WAYS_TO_HOLD_MEMORY

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO LIMIT OF MEMORY IS TESTED: this machine lacks {lacking}", allow_module_level=True)

from kincourse import COURSE
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import Limits
from misstep.grading.sandbox.runner import Runner

LIMITS = Limits(seconds=30.0, memory_mb=400, scratch_mb=32)
REPORT = "print('held', held // MB)"


@pytest.fixture(scope="module")
def redacted():
    return submissions.judge_of().redacted_sheet("ada")[1]


@pytest.fixture(scope="module")
def confined():
    runner = Runner(setup_for(COURSE))
    yield runner
    runner.close()


def lines_printed(outcome):
    outputs = [output for line in outcome.output.splitlines() for output in json.loads(line)["outputs"]]
    return [output["text"].strip() for output in outputs if output.get("name") == "stdout"]


@pytest.mark.parametrize("name", [*WAYS_TO_HOLD_MEMORY, "all of them"])
def test_no_way_to_hold_memory_goes_beyond_the_limit(name, confined, redacted):
    """The code tries to hold twice the limit, and counts what it got."""
    ways = list(WAYS_TO_HOLD_MEMORY.values()) if name == "all of them" else [WAYS_TO_HOLD_MEMORY[name]]
    code = "\n".join([HOARD.replace("{most}", str(2 * LIMITS.memory_mb)), *ways, REPORT])
    outcome = confined.run(redacted, [code], LIMITS)
    assert outcome.end_reason == ""
    (report,) = lines_printed(outcome)
    assert int(report.split()[1]) < LIMITS.memory_mb
    assert outcome.memory_mb < LIMITS.memory_mb


def test_a_submission_is_told_at_once_that_there_is_no_more_memory(confined, redacted):
    outcome = confined.run(redacted, ["hoard = bytearray(400 << 20)", "print('goes on')"], LIMITS)
    assert b"MemoryError" in outcome.output
    assert lines_printed(outcome) == ["goes on"]
