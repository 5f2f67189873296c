"""The memory of a submission: no way to hold it goes beyond the limit, and what all processes hold is counted."""

import json
import os
import subprocess
import sys

import pytest
import submissions
from attacks import HOARD, WAYS_TO_HOLD_MEMORY

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO LIMIT OF MEMORY IS TESTED: this machine lacks {lacking}", allow_module_level=True)

from kincourse import COURSE
from misstep.grading.judging import judge_process
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import Limits
from misstep.grading.sandbox.memory import held_bytes, process_tree
from misstep.grading.sandbox.runner import Runner

LIMITS = Limits(seconds=30.0, memory_mb=400, scratch_mb=32)
REPORT = "print('held', held // MB)"


@pytest.fixture(scope="module")
def redacted():
    return judge_process.redacted_sheet(COURSE, "03_poe_space", "ada")[1]


@pytest.fixture(scope="module")
def confined():
    runner = Runner(setup_for(COURSE))
    yield runner
    runner.close()


@pytest.fixture(scope="module")
def unconfined():
    """A runner without the sandbox, where only the watch from outside limits the memory of all processes together."""
    runner = Runner(setup_for(COURSE), is_safe=False)
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


HOARD_IN_PROCESSES = """
import os, time
for _ in range(8):
    if os.fork() == 0:
        hoard = bytearray(60 << 20)
        time.sleep(60)
time.sleep(60)
"""

HOARD_IN_FILES = """
import os, time
for _ in range(16):
    os.write(os.memfd_create("x"), bytes(50 << 20))
time.sleep(60)
"""


def test_what_all_processes_hold_is_added_up_and_ended(unconfined, redacted):
    for code in (HOARD_IN_PROCESSES, HOARD_IN_FILES):
        outcome = unconfined.run(redacted, ["print('before')", code], LIMITS)
        assert outcome.end_reason == "it held more than 400 MB of memory, all its processes and files together"
        assert lines_printed(outcome) == ["before"]
        assert not outcome.ended_by_itself


def test_a_process_that_left_its_session_ends_with_its_submission(unconfined, redacted):
    code = "import subprocess\nprint(subprocess.Popen(['sleep', '97'], start_new_session=True).pid)"
    outcome = unconfined.run(redacted, [code], LIMITS)
    (number,) = lines_printed(outcome)
    assert outcome.end_reason == ""
    with pytest.raises(ProcessLookupError):
        os.kill(int(number), 0)


@pytest.fixture
def hoarder():
    """A process that holds 100 MB, half of it in a process of its own."""
    code = "import os, time; os.fork(); hoard = bytearray(50 << 20); print(flush=True); time.sleep(60)"
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, start_new_session=True) as process:
        for _ in range(2):
            process.stdout.readline()
        yield process.pid
        os.killpg(process.pid, 9)


def test_the_memory_of_a_process_is_that_of_its_descendants_too(hoarder):
    first, second = process_tree(hoarder)
    assert 50 < held_bytes(second) >> 20 < 75
    assert 100 < held_bytes(first) >> 20 < 150
    assert held_bytes(2**22 + 1) == 0
