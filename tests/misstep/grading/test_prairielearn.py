"""PrairieLearn: each exported question lives through generate, parse, grade and file, as its documentation describes them.

What PrairieLearn's elements do between these calls is done here by a few lines: they read each input into `submitted_answers`.
"""

import json
import re
import runpy
import subprocess
import sys

import numpy as np
import pytest

from kincourse import COURSE, find_sheet
from misstep.answers.choice import Choice, ReasonedChoice
from misstep.answers.ordering import Ordering
from misstep.cli import main
from misstep.grading.prairielearn import export
from misstep.problem import Problem
from misstep.storage import to_data

LEFT_OUT = [
    template.number
    for name in COURSE.sheets()
    for template in find_sheet(name).problems
    if template.level == "Open" or template.number == "03.11"
]
QUESTIONS = {
    (name, k): template
    for name in COURSE.sheets()
    for k, template in enumerate(find_sheet(name).problems, start=1)
    if template.number not in LEFT_OUT
}


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    out = tmp_path_factory.mktemp("pl") / "course"
    assert export(COURSE, out) == (len(QUESTIONS), LEFT_OUT)
    return out


def test_the_course_has_the_files_and_keys_that_prairielearn_requires(exported, capsys):
    required = {
        "infoCourse.json": {"name", "title", "topics"},
        "infoCourseInstance.json": {"uuid", "longName"},
        "infoAssessment.json": {"uuid", "type", "title", "set", "number"},
        "info.json": {"uuid", "type", "title", "topic"},
    }
    files = [path for path in exported.rglob("*.json") if "serverFilesCourse" not in path.parts]
    infos = {path: json.loads(path.read_text("utf-8")) for path in files}
    for path, info in infos.items():
        assert required[path.name] <= set(info), path
    uuids = [info["uuid"] for info in infos.values() if "uuid" in info]
    assert len(set(uuids)) == len(uuids)
    topics = {topic["name"] for topic in infos[exported / "infoCourse.json"]["topics"]}
    named = [one["id"] for info in infos.values() for zone in info.get("zones", []) for one in zone["questions"]]
    assert sorted(named) == sorted(f"{name}/{k:02}" for name, k in QUESTIONS)
    for id_ in named:
        assert infos[exported / "questions" / id_ / "info.json"]["topic"] in topics
    assert {path.name for path in (exported / "serverFilesCourse").glob("[!at]*")} == {"kinlib", "misstep", "kincourse"}
    assert main(["export", "prairielearn", str(exported)]) == 2
    assert "must be a new or an empty folder" in capsys.readouterr().err


def test_a_question_needs_no_package_of_widgets(exported):
    code = "import glob, runpy, sys; sys.path.insert(0, 'serverFilesCourse'); [*map(runpy.run_path, glob.glob('questions/*/01/server.py'))]"
    code += "; import traitlets; assert traitlets.Any is traitlets.Bool"
    subprocess.run([sys.executable, "-c", code], cwd=exported, check=True)


def submitted(problem, value, data):
    """What PrairieLearn's elements leave in `submitted_answers` for an answer."""
    if isinstance(problem.answer, ReasonedChoice):
        choices = [one for one in (problem.answer.choice, problem.answer.reason) if isinstance(one, Choice)]
        given = {}
        for shown, choice, chosen in zip(data["params"]["choices"], choices, value, strict=False):
            data["params"][shown["name"]] = [{"key": f"k{place}"} for place in range(len(choice.options))]
            given[shown["name"]] = f"k{list(choice.options).index(chosen)}"
        if len(choices) == 2:
            return given
        return given | submitted(Problem("", problem.answer.reason), value[1], data)
    if isinstance(problem.answer, Ordering):
        return {"answer": [{"inner_html": name} for name in value]}
    stored = to_data(value)
    if "list" in stored:
        rows = enumerate(stored["list"], start=1)
        return {f"entry_{i}_{j}": one["text"] for i, row in rows for j, one in enumerate(row["list"], start=1)}
    array = np.array(stored["fields"]["rows"] if "fields" in stored else stored["array"], dtype=float)
    parts = array.reshape(-1, *((one := data["params"]["matrices"][0])["rows"], one["columns"]))
    names = [one["name"] for one in data["params"]["matrices"]]
    return {name: {"_type": "ndarray", "_value": part.tolist()} for name, part in zip(names, parts, strict=True)}


def judged(question, data, answers):
    """The data after parsing and grading; what is refused is not graded."""
    data = json.loads(json.dumps(data)) | {"submitted_answers": answers, "format_errors": {}, "feedback": {}}
    question["parse"](data)
    if not data["format_errors"]:
        question["grade"](data)
    return json.loads(json.dumps(data, allow_nan=False))


def test_a_question_of_each_kind_judges_right_answers_planted_mistakes_and_nonsense(exported):
    drawn = {place: template.variant("prairielearn 7") for place, template in QUESTIONS.items()}
    kinds = {(type(problem.answer), bool(problem.figure)): place for place, problem in drawn.items()}
    for name, k in kinds.values():
        judges_right_answers_planted_mistakes_and_nonsense(exported / "questions" / name / f"{k:02}", drawn[name, k])


def judges_right_answers_planted_mistakes_and_nonsense(folder, problem):
    question, page = runpy.run_path(str(folder / "server.py")), (folder / "question.html").read_text("utf-8")
    data = {"variant_seed": 7, "params": {}, "correct_answers": {}}
    question["generate"](data)
    assert set(re.findall(r"params\.(\w+)", page)) <= set(data["params"])
    figure = question["file"]({**data, "filename": "figure.svg"})
    assert (b"<svg" in (figure or b""), bool(data["params"]["alt"])) == (bool(problem.figure),) * 2
    right = submitted(problem, problem.answer.value, data)
    graded = judged(question, data, right)
    assert graded["score"] == 1, graded["format_errors"]
    assert all(part["score"] == 1 for part in graded["partial_scores"].values())
    assert "Right" in graded["feedback"]["card"]
    values = [problem.answer.value, *(one.value for one in problem.known_mistakes)]
    forms = [(set(stored), stored.get("shape")) for stored in map(to_data, values)]  # some mistakes are of another form
    wrong = dict.fromkeys(right, "1")  # in the place of formulas
    if not data["params"]["formulas"]:
        wrong = submitted(problem, values[forms.index(forms[0], 1)], data)
    graded = judged(question, data, wrong)
    assert graded["score"] < 1
    assert "Re-read" in graded["feedback"]["card"]
    nonsense = {key: [{"inner_html": "?"}] if isinstance(value, list) else "?" for key, value in right.items()}
    assert judged(question, data, nonsense)["format_errors"]
