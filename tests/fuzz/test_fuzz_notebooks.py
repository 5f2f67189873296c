"""Fuzz grading: for any folder or zip of submissions and any roster, every student gets valid points and a reason.

The output of the sandbox is made up here and corrupted too; the judge, the gradebook and all pages are the real ones.
"""

import json
import math
import pickle
import tempfile
import warnings
import zipfile
from contextlib import nullcontext, suppress
from functools import cache
from pathlib import Path

import nbformat
from assertions import assert_explained, assert_verdict, limit_processor_time
from corruption import (
    LEAVES,
    PIECE,
    change_json,
    change_text,
    corrupted_json,
    corrupted_texts,
    mostly,
    noise,
    often,
    pieces,
    random_sources,
)
from fuzz_settings import fuzz_settings
from hypothesis import given
from hypothesis import strategies as st
from submissions import SHEET, as_bytes, handed_in, judge_of, released, right

from kincourse import find_sheet
from misstep.grading.collect.files import UnreadableFile
from misstep.grading.collect.gather import WrongRoster, gather
from misstep.grading.collect.roster import read_roster
from misstep.grading.collect.run_plan import plan_run, read_released_sheet
from misstep.grading.jobs import grade_best, make_jobs
from misstep.grading.judging.grader import Grader
from misstep.grading.judging.parse_output import parse_output
from misstep.grading.nbgrader.cells import fill_outputs, restore_metadata
from misstep.grading.publish.pages_and_tables import write_page, write_tables
from misstep.grading.publish.result_store import ResultStore
from misstep.grading.sandbox.limits import Limits
from misstep.grading.sandbox.runner import RunOutcome
from misstep.grading.steps import do_step
from misstep.storage.deserialize import MIME
from misstep.storage.serialize import to_data

NAMES = pieces(rf"""
ada.ipynb  ada/{SHEET}.ipynb  ada/{SHEET} (1).ipynb  submitted/ada/{SHEET}/{SHEET}.ipynb  ada/notes.txt  bob.IPYNB  x.pdf
lovelaceada_1815_99_{SHEET}.ipynb  Ada Lovelace_1815_assignsubmission_file_/{SHEET}.ipynb  submission_99/{SHEET}.ipynb
submission_metadata.yml  ../out.ipynb  /etc/x.ipynb  C:\x.ipynb  .hidden/a
""")
METADATA = (
    "submission_99:\n  :submitters:\n  - :name: Ada\n    :sid: '007'\n    :email: ada@x\n  :created_at: 2026-01-01\n"
)
ROSTERS = (
    "id\nada\nbob\n",
    "Student,ID,SIS User ID,SIS Login ID,Section\nPoints Possible,,,,\n'Ada, L',1815,7,ada,1\nBob,1816,8,bob,1\n",
    'Identifier,Full name,Email address,Grade,Maximum Grade\nParticipant 1815,Ada,ada,,"10,00"\nParticipant 7,Bob,bob,,10\n',
    "First Name,Last Name,SID,Email\nAda,L,007,ada@x\nBob,B,8,bob@x\n",
)
WORDS = rf"""
"cells"  "cell_type"  "code"  "source"  "metadata"  "nbgrader"  "grade_id"  "check-1"  NaN  Infinity  null
[[  {{}}  []  <<<<<<< a  =======  student = 'x'  open_sheet(\"{SHEET}\"  open_sheet('01_frames')  \ud800  %PDF  PK
check-0  check-001  check-999  check-٣  check-1  cell_type  grade_id
"""


class Prompter:
    """A stand-in for the sandbox, with prepared and corrupted output.

    asked           the problem that gets its right answer
    changes, slips  changes to the lines of the output, as data and as text
    """

    asked, changes, slips = 0, (), ()

    def run(self, redacted, sources, limits):
        lines = [{"cell": number, "outputs": self._outputs(source)} for number, source in enumerate(sources)]
        lines = change_json(lines, self.changes, (*LEAVES, lines[-1:]))
        text = "\n".join(map(json.dumps, lines if isinstance(lines, list) else [lines]))
        return RunOutcome(change_text(text, self.slips).encode(errors="surrogatepass"), "", 0.1, 50.0)

    def _outputs(self, source):
        outputs = [{"output_type": "stream", "name": "stdout", "text": "0.5\n"}]
        if source == grader().sheet.checks.get(self.asked):
            right = find_sheet(SHEET).problems[self.asked - 1].variant("ada").answer.value
            emission = {"sheet": SHEET, "problem": self.asked, "student": "ada", "answer": to_data(right)}
            data = {"text/html": "<b>", "text/plain": "x", "image/png": "iVBORw0KGgo=", MIME: emission}
            outputs += [{"output_type": "display_data", "metadata": {}, "data": data}] * 2
        return outputs


class Here:
    """Does steps in this process."""

    is_spoiled = False

    def __init__(self, steps):
        self.steps = steps

    def do(self, step, *, seconds, **arguments):
        with limit_processor_time(seconds):
            outcome, value = do_step(self.steps, step, pickle.loads(pickle.dumps(arguments)))
        assert outcome != "failed", value
        if outcome == "raised":
            raise value
        return pickle.loads(pickle.dumps(value))

    def process(self):
        return nullcontext(self)


class Rehearsal(Grader):
    """A grader without a sandbox, with its judge in this process."""

    def __init__(self, sheet):
        self.sheet, self.is_safe, self._runner, self._limits = sheet, False, Prompter(), Limits()
        judge = judge_of(sheet.name)
        self._judge = Here({**judge.steps, "plan": plan_run, "parse": parse_output})
        self._covered = ()
        self._unanswered = judge.problems()


@cache
def grader():
    return Rehearsal(read_released_sheet(released()))


@cache
def handed_out():
    return nbformat.read(released(), as_version=4)


def cases():
    """A folder or a zip, its files by name, the roster, and the changes to the zip and to the output of the runs."""
    whole = [json.loads(released().read_text("utf-8")), handed_in("ada", right("ada")), handed_in("bob", right("ada"))]
    small = {
        "cells": [{"cell_type": "code", "source": ["student = 'ada'\n", f"sheet = open_sheet('{SHEET}', student)"]}]
    }
    documents = [*whole, whole[1], small]
    as_json = corrupted_json(st.sampled_from(documents), pieces(WORDS)).map(as_bytes_of)
    as_text = corrupted_texts(st.sampled_from([as_bytes(each).decode() for each in documents]), WORDS).map(_encoded)
    codings = st.sampled_from(documents).map(lambda each: json.dumps(each).encode("utf-16"))
    others = st.one_of(
        corrupted_texts(st.just(METADATA)).map(_encoded), noise().map(_encoded), st.binary(max_size=60), codings
    )
    contents = often(4, as_json, as_text, others)
    names = often(4, st.sampled_from(NAMES), corrupted_texts(st.sampled_from(NAMES), cuts=(r"[^/]+", PIECE)))
    rosters = often(
        4, st.sampled_from([None, *ROSTERS]), corrupted_texts(st.sampled_from(ROSTERS), cuts=(r"[^,\n]*", PIECE))
    )
    files = st.lists(st.tuples(names, contents), min_size=1, max_size=3)
    lists = st.tuples(*[st.lists(random_sources(), max_size=most) for most in (2, 2, 1)])
    return st.tuples(mostly(["folder", "zip"], ["file"]), files, rosters, lists, st.integers(0, 8))


def as_bytes_of(data):
    return json.dumps(data).encode()


def _encoded(text):
    return text.encode(errors="surrogatepass")


@fuzz_settings(15)
@given(st.deferred(cases))
def test_every_student_of_any_submission_gets_valid_points_and_a_reason(case):
    kind, files, roster_text, (changes, slips, flips), asked = case
    prompter = grader()._runner
    prompter.changes, prompter.slips, prompter.asked = changes, slips, asked
    with tempfile.TemporaryDirectory() as root:
        try:
            roster = _roster(Path(root), roster_text)
            source = _laid(Path(root), kind, files, flips)
            try:
                gathered = gather(source, SHEET, roster)
            except WrongRoster:
                roster = None
                gathered = gather(source, SHEET)
        except ValueError as error:
            assert_explained(error, ValueError, UnreadableFile)
            return
        store = ResultStore(Path(root) / "out")
        for job in make_jobs(gathered.submissions, grader().sheet, ""):
            result = job.complete(grade_best(grader().grade, *job.request))
            assert_fair(result)
            store.save(result, job.fingerprint)
            loaded = store.load(result.student, job.fingerprint)
            assert loaded is not None
            assert (loaded.points, loaded.status, len(loaded.cells)) == (
                result.points,
                result.status,
                len(result.cells),
            )
            for content in job.contents:
                assert_fit_for_nbgrader(content, result)
        try:
            students = [submission.student for submission in gathered.submissions]
            for student in students:
                write_page(store.folder.parent, student, "")
            write_tables(Path(root) / "out", students, roster)
        except ValueError as error:
            assert_explained(error)


def assert_fair(result):
    assert math.isfinite(result.points)
    assert 0 <= result.points <= result.max
    assert result.status == "graded" or result.reason
    for problem in result.problems:
        assert_verdict(problem)


def assert_fit_for_nbgrader(content, result):
    with suppress(Exception), warnings.catch_warnings(action="ignore"):
        # what nbformat cannot read is filled in the sheet that was handed out
        notebook = fill_outputs(restore_metadata(content, result, handed_out()), result, ())
        nbformat.validate(notebook)
        return
    nbformat.validate(fill_outputs(restore_metadata(None, result, handed_out()), result, ()))


def _roster(root, text):
    if text is None:
        return None
    (root / "roster.csv").write_bytes(_encoded(text))
    return read_roster(root / "roster.csv")


def _laid(root, kind, files, flips):
    """The files in a folder, or in a zip with some bytes changed, without the names that this file system refuses."""
    place = root / "in"
    if kind == "zip":
        with zipfile.ZipFile(place, "w", zipfile.ZIP_DEFLATED) as archive, warnings.catch_warnings(action="ignore"):
            for name, content in files:
                with suppress(ValueError, IndexError):
                    archive.writestr(name, content)
        data = bytearray(place.read_bytes())
        for chance in flips:
            data[chance.randrange(len(data))] = chance.randrange(256)
        place.write_bytes(data)
    elif kind == "file":
        place.write_bytes(files[0][1])
    else:
        place.mkdir()
        for name, content in files:
            path = place / name.lstrip("/").replace("..", "")
            with suppress(OSError, ValueError):
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
    return place
