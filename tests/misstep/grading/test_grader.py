"""Grading, part by part: the paper, the judge, what is heard of a run, messages, refusals."""

import json
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import submissions
from submissions import as_bytes, code, handed_in, problem_of, right, verdicts
from typed_answers import as_typed, typable

from kincourse import COURSE, find_sheet, sheets
from misstep.answers.number import Numbers
from misstep.grading import redacted_sheet
from misstep.grading.collect.notebook import UnusableNotebook
from misstep.grading.collect.run_plan import PlannedCell, ReleasedSheet, RunPlan, plan_run, read_released_sheet
from misstep.grading.fork_server import child_environment
from misstep.grading.judging import judge_process
from misstep.grading.judging.grader import Grader, start_judge
from misstep.grading.judging.parse_output import parse_output
from misstep.grading.publish.mathml import render_sentence
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import UNSAFE_OPTION, Limits, SandboxUnavailable
from misstep.grading.sandbox.runner import Runner
from misstep.grading.steps import LEASES_PER_PROCESS, StepFailed
from misstep.judge import judge
from misstep.problem import Problem
from misstep.storage.deserialize import MIME
from misstep.storage.serialize import to_data

if sys.platform == "win32":
    pytest.skip("clocks and limits of the judge are those of Unix", allow_module_level=True)

on_linux = pytest.mark.skipif(
    bool(submissions.sandbox_lacks()), reason=f"this machine lacks {submissions.sandbox_lacks()}"
)

ROOT = Path(__file__).parents[3]


# --- the paper ---


def test_a_paper_holds_what_is_given_and_no_answer():
    for name in sheets():
        problems = [template.variant("ada") for template in find_sheet(name).problems]
        stand_in = redacted_sheet.load_redacted(redacted_sheet.redact(find_sheet(name), problems))
        assert stand_in.name == name
        for template, problem in zip(stand_in.problems, problems, strict=True):
            side = template.variant("another student")
            assert side.statement == problem.statement
            assert set(side.given) == set(problem.given)
            assert not side.mistakes
            with pytest.raises(AttributeError, match="not available while a sheet is graded"):
                _ = side.answer.value


# --- the judge ---


@pytest.mark.parametrize("name", sheets())
def test_the_judge_names_the_mistake_in_an_answer_that_was_stored(name):
    seed, _ = submissions.judge_of(name).redacted_sheet("ada")
    problems = [template.variant("ada").with_inputs(seed) for template in find_sheet(name).problems]
    mistaken = {k: typable(problem)[0] for k, problem in enumerate(problems, start=1) if typable(problem)}
    data = {k: to_data(as_typed(wrong.value), problems[k - 1].answer.inputs) for k, wrong in mistaken.items()}
    told = verdicts(name, "ada", seed, {k: json.loads(json.dumps(one)) for k, one in data.items()})
    for k, wrong in mistaken.items():
        assert told[k].points < told[k].max
        seen = judge(problems[k - 1], as_typed(wrong.value)).findings[0]  # it may come before the mistake
        assert wrong.names in told[k].explanations[0] or seen.mistake == "metres"
        assert told[k].explanations[0] == seen.alternatives


def test_a_paper_has_other_inputs_each_time_and_the_judge_knows_them_by_the_seed():
    made = find_sheet("03_poe_space")
    seeds = [submissions.judge_of(made.name).redacted_sheet("ada")[0] for _ in range(2)]
    assert seeds[0] != seeds[1]
    inputs = [made.problems[6].variant("ada").with_inputs(seed).answer.inputs for seed in seeds]
    assert not np.isclose(inputs[0], inputs[1]).any()


def test_a_verdict_says_why_and_has_the_section_the_problem_and_its_figure_if_there_is_something_to_mend():
    sheet = find_sheet("03_poe_space")
    right = sheet.problems[2].variant("ada").answer
    answers = {2: [9, 9], 3: to_data(right.value, right.inputs)}
    section = sheet.problems[1].lecture.partition("#")[2].lower().replace(" ", "-")
    for site in ("https://example.org/course/", ""):
        told = verdicts(sheet.name, "ada", 0, answers, site=site)
        page = f"{site}lectures/03_poe_space.html#{section}" if site else ""
        assert [told[k].address for k in (1, 2, 3)] == ["", page, ""]
    assert [told[k].statement for k in (1, 2, 3)] == [t.variant("ada").statement for t in sheet.problems[:3]]
    assert ["<figure" in told[k].figure for k in (1, 2, 3)] == [False, True, False]
    for data, words in [
        ({"score": 3}, "no known form"),
        ({"other": "frame"}, "got frame"),
        ({"array": [None] * 18, "shape": [3, 6]}, "NaN"),
        (None, "Expected"),
        *(
            ({"symbolic": text}, "cannot be read")  # without computing with numbers that are too large
            for text in ("sin(exp(exp(30)))**2", "sign(sin(exp(exp(exp(4)))))", "log(exp(exp(exp(9))))")
        ),
    ]:
        verdict = submissions.judge_of(sheet.name).verdict("ada", 1, data, seed=0)
        assert verdict.points == 0
        assert words in verdict.verdict
    hostile = {"list": [{"text": "<script>alert(1)</script>"}]}
    lines = submissions.judge_of(sheet.name).verdict("ada", 6, hostile, seed=0).verdict.splitlines()
    quoted = "".join(map(str, map(render_sentence, lines)))
    assert "&lt;script&gt;" in quoted
    assert "<script" not in quoted


def test_the_address_of_the_site_is_complete_or_refused():
    path = submissions.released()
    assert read_released_sheet(path, site="https://example.org").site == "https://example.org"
    with pytest.raises(ValueError, match=r"must begin with https:// or http://; got 'example.org'"):
        read_released_sheet(path, site="example.org")


def test_a_figure_that_cannot_be_drawn_costs_nothing():
    asked = Problem("How many?", Numbers(np.array(3.0)), figure=lambda: 1 / 0)
    assert judge_process.figure_html(asked) == ""


SLOW_COURSE = {
    "__init__.py": 'from misstep.catalog import Course\nCOURSE = Course("slow_course")',
    "lecture_01_slow/__init__.py": "",
    "lecture_01_slow/problems.py": """
import os
import time

import numpy as np

from misstep import Problem, Sheet, mistake, problem
from misstep.answers.number import Numbers


class Slow(Numbers):
    is_spoiled, memory = False, None

    def read(self, given):
        if given == 16:
            Slow.is_spoiled = True
        if Slow.is_spoiled or (Slow.memory is not None and given == 9):
            raise TypeError("something of the judge is spoiled")
        if given == 17:
            Slow.memory = np.ones(60_000_000)
        if given == 13:
            sum(range(10**13))  # one call of C code, which no signal handler of Python can interrupt
        if given == 14:
            os.abort()
        if given == 15:
            time.sleep(5)
        return super().read(given)


@problem("01.1", "Twice", points=1, lecture="01_slow#Twice")
def twice(sampler):
    if os.path.exists(f"{__file__}.abort"):
        os.abort()
    x = sampler.length(0.1, 0.5)
    return Problem("Twice?", Slow(np.array(2 * x)), [mistake("half", np.array(x / 2), "No.")], {"x": x})


@problem("01.2", "One", points=1, lecture="01_slow#Twice")
def one(sampler):
    return Problem("One?", Numbers(np.array(1.0)), [mistake("two", np.array(2.0), "No.")])


SHEET = Sheet("01_slow", "Slow", [twice, one])
""",
}


@pytest.fixture(scope="module")
def slow_judge(tmp_path_factory):
    """A function that asks a judge for the states of two answers, the first of which may take long to read."""
    tmp_path = tmp_path_factory.mktemp("slow")
    for name, text in SLOW_COURSE.items():
        path = tmp_path / "slow_course" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    sheet = ReleasedSheet("01_slow", tmp_path, {}, str(tmp_path / "slow_course"))
    with start_judge(sheet) as started:
        grader = SimpleNamespace(_unanswered=started.do("problems"), sheet=sheet, _limits=Limits())

        def ask(student, first):
            with started.process() as judge:
                told, _ = Grader._verdicts(grader, judge, student, 0, {1: {"number": first}, 2: {"number": 1.0}})
            return [told[k].state for k in (1, 2)], told[1].verdict

        ask.judge, ask.folder = started, tmp_path
        yield ask


def test_a_slow_answer_costs_its_own_problem_and_the_time_of_nobody_else(slow_judge):
    with ThreadPoolExecutor(3) as pool:
        slow = pool.submit(slow_judge, "eve", 13)
        honest = [pool.submit(slow_judge, f"student {k}", 9) for k in range(9)]
        assert [one.result()[0] for one in honest] == [["wrong", "right"]] * 9
        assert not slow.done()
        states, text = slow.result()
    assert states == ["unreadable", "right"]
    assert "got an answer that cannot be judged: it takes more than 4 s of processor time" in text


def test_an_answer_that_ends_the_judge_costs_its_own_problem(slow_judge):
    states, text = slow_judge("eve", 14)
    assert states == ["unreadable", "right"]
    assert "got an answer that cannot be judged: it ends the process" in text
    assert slow_judge("eve", 15)[0] == ["wrong", "right"], (
        "the clock counts what the judge computes, not a busy machine"
    )


def test_what_an_unreadable_or_a_large_answer_leaves_in_the_judge_is_gone_for_the_next_student(slow_judge):
    for given, state in ((16, "unreadable"), (17, "wrong")):
        assert slow_judge("eve", given)[0] == [state, "right"]
        assert slow_judge("ada", 9)[0] == ["wrong", "right"]


def test_each_student_of_a_long_row_gets_the_verdicts_that_the_student_would_get_alone():
    sheet = find_sheet(submissions.SHEET)
    own = to_data(sheet.problems[0].variant("student 0").answer.value)
    with start_judge(ReleasedSheet(sheet.name, Path("/on/another/machine"), {}, "kincourse")) as judge:
        for k in range(LEASES_PER_PROCESS + 2):  # so that one process ends and the next one begins
            asked = {"student": f"student {k}", "k": 1, "data": own, "seed": 1}
            told, alone = judge.do("verdict", **asked), submissions.judge_of(sheet.name).verdict(**asked)
            assert told == alone
            assert (told.state == "right") == (k == 0)


def test_a_judge_that_ends_while_it_draws_says_so_and_draws_again_for_the_next_request(slow_judge):
    assert slow_judge.judge.do("redacted sheet", student="bob")
    (abort := slow_judge.folder / "slow_course" / "lecture_01_slow" / "problems.py.abort").touch()
    with pytest.raises(StepFailed, match="it ends the process"):
        slow_judge.judge.do("redacted sheet", student="fred")
    abort.unlink()
    assert slow_judge.judge.do("redacted sheet", student="fred")


# --- what is heard ---

PLAN = RunPlan([PlannedCell("1"), PlannedCell("check", 1), PlannedCell("check", 2)])
EMISSION = {"sheet": "s", "problem": 1, "student": "ada", "answer": {"number": 1.0}}


def line(cell, *outputs):
    return json.dumps({"cell": cell, "outputs": list(outputs)}).encode() + b"\n"


def shown(emission, **more):
    return {"output_type": "display_data", "metadata": {}, "data": {MIME: emission, "text/plain": "x"}, **more}


def test_the_last_answer_is_heard_from_the_check_cell_of_its_problem():
    heard = parse_output(
        "s", PLAN, line(0) + line(1, shown({**EMISSION, "answer": None}), shown(EMISSION)) + line(2), "ada"
    )
    assert heard.answers == {1: {"number": 1.0}}
    assert heard.typed_id == "ada"
    assert heard.cells[1].outputs[0]["data"] == {"text/plain": "x"}


def test_what_is_not_an_answer_of_ours_is_not_heard():
    raw = b'{"cell": 1, "outputs": [' + json.dumps(shown(EMISSION)).encode() + b"]}\n"
    for said in (
        line(0, shown(EMISSION)) + line(1),
        line(0) + line(1) + line(2, shown(EMISSION)),
        line(0) + line(1, shown({**EMISSION, "sheet": "t"})),
        line(0) + line(1, shown({**EMISSION, "problem": 2})),
        line(0) + line(1, shown({**EMISSION, "points": 3})),
        line(0) + line(1, shown({**EMISSION, "student": 7})),
        line(0) + line(1, shown({**EMISSION, "answer": {"text": "x" * 300_000}})),
        line(0) + line(1, shown(EMISSION, output_type="execute_result")),
        line(0) + line(1, shown(EMISSION, metadata=7)),
        line(1, shown(EMISSION)),
        *(line(0) + raw.replace(b"1.0", number) for number in (b"1e999", b"NaN")),
        line(0) + line(1, shown(EMISSION)).replace(b'"ada"', rb'"\ud800"'),
        *(line(0) + junk + b"\n" for junk in (b"[" * 100_000, b"9" * 10_000)),
        b"\xff\xfe\n",
        b"",
    ):
        assert not parse_output("s", PLAN, said, "ada").answers


# --- what is planned ---

SHEET_03 = read_released_sheet(submissions.released())


def test_the_sheets_own_checks_run_in_place_of_the_students():
    notebook = handed_in("ada", right("ada"))
    for cell in notebook["cells"]:
        if problem_of(cell, "check") in (1, 2):
            cell["source"] = "print('mine')"
    planned = plan_run(SHEET_03, as_bytes(notebook))
    assert [step.source for step in planned.cells if step.problem == 1] == [SHEET_03.checks[1]]
    assert set(planned.remarks) == {1, 2}


def test_a_sheet_with_a_copied_check_is_refused(tmp_path):
    path = tmp_path / "x.ipynb"
    notebook = json.loads(submissions.released().read_text("utf-8"))  # students would be told that they edited a check
    notebook["cells"] += [cell for cell in notebook["cells"] if submissions.problem_of(cell, "check") == 2]
    path.write_text(json.dumps(notebook), "utf-8")
    with pytest.raises(
        ValueError, match=r"x\.ipynb: each cell must have a grade_id of its own; got check-2 more than once"
    ):
        read_released_sheet(path)


def test_junk_is_broken_and_says_so():
    for junk in (b"\x00" * 100, b"null", b'"x"', b"{}", b'{"cells": {}}', b"\xff\xfe["):
        with pytest.raises(UnusableNotebook, match=r"\."):
            plan_run(SHEET_03, junk)


# --- processes ---


def test_a_process_that_we_start_sees_no_secrets(monkeypatch):
    monkeypatch.setenv("SECRET_TOKEN", "x")
    assert "SECRET_TOKEN" not in child_environment()


@on_linux
def test_without_a_layer_the_server_refuses(monkeypatch, tmp_path):
    for package, told in {
        "landlock": r"layer 'landlock'.*misstep\[grading\]",
        "pyseccomp": f"layer 'seccomp'.*libseccomp2.*Nothing was run.*{UNSAFE_OPTION}",
    }.items():
        (tmp_path / package).mkdir()
        (tmp_path / package / f"{package}.py").write_text("raise ImportError('it is not installed')")
        monkeypatch.setenv("PYTHONPATH", str(tmp_path / package))
        with pytest.raises(SandboxUnavailable, match=told):
            Runner(setup_for(COURSE))


@on_linux
def test_a_robots_own_sheet_is_judged_by_the_file_beside_the_masters_notebook(tmp_path):
    from kincourse.new_sheet import new_sheet
    from kinlib.chains.robots import rpr

    made = new_sheet(rpr(), tmp_path / "my_robot")
    blank = as_bytes({"cells": [code('from kincourse import open_sheet\nsheet = open_sheet("my_robot", "ada")')]})
    with Grader(read_released_sheet(made)) as grader:
        assert [problem.state for problem in grader.grade("ada", made.read_bytes()).problems].count("right") >= 6
        result = grader.grade("ada", blank)
        assert result.points == 0
        assert all("deleted" in problem.notes[0] for problem in result.problems)


def test_a_robots_sheet_without_its_file_is_refused(tmp_path):
    from kincourse.new_sheet import new_sheet
    from kinlib.chains.robots import rpr

    made = new_sheet(rpr(), tmp_path / "my_robot")
    sheet = read_released_sheet(made)
    made.with_suffix(".json").unlink()
    with pytest.raises(ValueError, match=r"No installed course has a sheet 'my_robot'.*its file my_robot\.json"):
        read_released_sheet(made)
    with pytest.raises(ValueError, match=r"cannot open sheet my_robot.*its file my_robot\.json"):
        Grader(sheet, is_safe=False)
