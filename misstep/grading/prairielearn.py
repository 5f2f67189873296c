"""PrairieLearn: the problems of a course as questions of a server that holds the answers, for points that count.

    misstep export prairielearn OUT

OUT is the folder of a PrairieLearn course, with a folder for each question, whose `server.py` names the problem. The packages are
copied to `serverFilesCourse`, where PrairieLearn looks for modules; it has NumPy, SymPy and matplotlib, but no widgets.

Source: https://docs.prairielearn.com/question/server/ and the JSON schemas of PrairieLearn.
"""

import json
import shutil
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from functools import lru_cache
from importlib.resources import files
from pathlib import Path
from typing import Any
from uuid import NAMESPACE_URL, uuid5

import numpy as np

from misstep.answers.base import Answer, Unreadable
from misstep.answers.choice import Choice, ReasonedChoice
from misstep.answers.ordering import Ordering
from misstep.answers.prose import Prose
from misstep.catalog import Course, find_course
from misstep.judge import judge
from misstep.problem import Problem, Template
from misstep.storage import to_data
from misstep.verdict import Verdict

Data = dict[str, Any]
"""What PrairieLearn passes to each function, which changes it in place."""

QUESTION = """<pl-question-panel>
<markdown>{{{params.statement}}}</markdown>
{{#params.alt}}<pl-figure type="dynamic" file-name="figure.svg" alt="{{params.alt}}"></pl-figure>{{/params.alt}}
{{#params.given}}<details><summary>The given values, to copy</summary><pre>{{params.given}}</pre></details>{{/params.given}}
</pl-question-panel>
{{#params.matrices}}
<p><pl-matrix-component-input answers-name="{{name}}" label="{{label}}" rows="{{rows}}" columns="{{columns}}">
</pl-matrix-component-input></p>
{{/params.matrices}}
{{#params.has.formulas}}<p>Formulas in Python's notation, such as <code>L_1*cos(q_1)</code>.</p>{{/params.has.formulas}}
{{#params.formulas}}
<p>{{#cells}}<pl-string-input answers-name="{{name}}" aria-label="{{name}}" size="14" show-help-text="false">
</pl-string-input> {{/cells}}</p>
{{/params.formulas}}
{{#params.choices}}
<pl-multiple-choice answers-name="{{name}}" order="fixed" hide-letter-keys="true">
{{#options}}<pl-answer correct="{{right}}">{{text}}</pl-answer>{{/options}}
</pl-multiple-choice>
{{/params.choices}}
{{#params.has.blocks}}
<pl-order-blocks answers-name="answer" grading-method="ranking" source-blocks-order="alphabetized" feedback="none">
{{#params.blocks}}<pl-answer correct="{{right}}" ranking="{{place}}">{{text}}</pl-answer>{{/params.blocks}}
</pl-order-blocks>
{{/params.has.blocks}}
<pl-submission-panel>{{{feedback.card}}}</pl-submission-panel>
"""
"""One page for all questions: each shows the inputs for which `generate` has left the sizes."""

SERVER = """from {package} import find_sheet
from misstep.grading.prairielearn import Question

question = Question(find_sheet({sheet!r}).problems[{index}])
generate, parse, grade, file = question.generate, question.parse, question.grade, question.file
"""

WIDGETS = '''"""Takes the place of a package of widgets, which a question does not show."""
class Unused:
    def __init__(self, *_, **__): self.tag = lambda **_: self
    def __call__(self, method): return method
def __getattr__(name): return Unused
'''


class Question:
    """The functions of one question, which PrairieLearn calls."""

    def __init__(self, template: Template) -> None:
        self._template = template
        self._variant = lru_cache(maxsize=4)(template.variant)

    def _problem(self, data: Data) -> Problem:
        return self._variant(f"prairielearn {data['variant_seed']}")

    def generate(self, data: Data) -> None:
        """Draw the numbers, and leave the statement, the sizes of the inputs and the right answer in the data."""
        problem = self._problem(data)
        figure = problem.figure() if problem.figure else None
        inputs: Data = {"matrices": [], "formulas": [], "choices": [], "blocks": []}
        for k, answer in enumerate(_answers(problem.answer)):
            kind, shown, right = _inputs(answer, k)
            inputs[kind] += shown
            data["correct_answers"].update(right)
        arrays = {k: f"np.array({v.tolist()})" for k, v in problem.given.items() if isinstance(v, np.ndarray)}
        given = "\n".join(f"{k} = {arrays.get(k, repr(v))}" for k, v in problem.given.items())
        data["params"].update(statement=problem.statement, given=given, alt=getattr(figure, "alt", ""), **inputs)
        data["params"]["has"] = {kind: bool(ones) for kind, ones in inputs.items()}

    def parse(self, data: Data) -> None:
        """Say of an answer that is none why it cannot be read; PrairieLearn then counts no attempt."""
        problem = self._problem(data)
        if data["format_errors"]:
            return
        try:
            problem.answer.read(_submitted(problem, data))
        except (Unreadable, ValueError, KeyError, TypeError, IndexError) as error:
            data["format_errors"][next(iter(data["submitted_answers"]), "answer")] = str(error)

    def grade(self, data: Data) -> None:
        """Judge the answer: the points, those of each part, and the card as feedback."""
        problem = self._problem(data)
        judgement = judge(problem, _submitted(problem, data))
        data["score"] = judgement.fraction
        data["partial_scores"] = {
            part: {"score": float(judgement.state == "right" or part in judgement.right_parts), "weight": 1}
            for part in problem.answer.parts
        }
        data["feedback"]["card"] = Verdict(self._template, judgement).card.html()

    def file(self, data: Data) -> bytes | None:
        """Return the figure as SVG."""
        figure = self._problem(data).figure
        svg: str = figure().labelled_svg() if figure else ""
        return svg.encode() if data["filename"] == "figure.svg" else None


def _answers(answer: Answer) -> Sequence[Answer]:
    return (answer.choice, answer.reason) if isinstance(answer, ReasonedChoice) else (answer,)


def _inputs(answer: Answer, k: int) -> tuple[str, list[Data], Data]:
    """Return the kind of the inputs for one of the answers, what the page shows of each, and the right answers by name."""
    if isinstance(answer, Choice):
        texts = {name: f"{name}: {text}" for name, text in answer.options.items()}
        shown = [{"text": text, "right": str(name == answer.value).lower()} for name, text in texts.items()]
        return "choices", [{"name": f"choice_{k}", "options": shown}], {}
    if isinstance(answer, Ordering):
        names = dict.fromkeys([*answer.value, *answer.among])
        blocks = [{"text": name, "right": str(name in answer.value).lower()} for name in names]
        return "blocks", [block | {"place": place} for place, block in enumerate(blocks, start=1)], {}
    right = _right(answer)
    if right.dtype == object:
        texts = {f"entry_{i + 1}_{j + 1}": text for (i, j), text in np.ndenumerate(right)}
        cells = np.reshape([{"name": name} for name in texts], right.shape)
        return "formulas", [{"cells": row} for row in cells.tolist()], texts
    # An array is a stack of matrices, and a vector is one row.
    matrices = right.reshape(-1, *(size := np.atleast_2d(right).shape[-2:]))
    shown, values = [], {}
    for place, matrix in enumerate(matrices.tolist(), start=1):
        label = f"{place}: " * (right.ndim > 2)
        shown.append({"name": f"answer_{place}_", "label": label, "rows": size[0], "columns": size[1]})
        values[f"answer_{place}_"] = {"_type": "ndarray", "_value": matrix, "_dtype": "float64"}
    return "matrices", shown, values


def _right(answer: Answer) -> np.ndarray[Any, Any]:
    """Return the right answer as an array: of numbers, or of formulas as texts."""
    stored: Any = to_data(answer.value)
    if "list" in stored:
        return np.array([[entry["text"] for entry in row["list"]] for row in stored["list"]], dtype=object)
    if "fields" in stored:
        return np.array(stored["fields"]["rows"], dtype=float)
    return np.array(stored["array"], dtype=float).reshape(stored["shape"])


def _submitted(problem: Problem, data: Data) -> Any:
    submitted = [_value(answer, k, data) for k, answer in enumerate(_answers(problem.answer))]
    return submitted if len(submitted) > 1 else submitted[0]


def _value(answer: Answer, k: int, data: Data) -> Any:
    given = data["submitted_answers"]
    if isinstance(answer, Choice):
        keys = [option["key"] for option in data["params"][f"choice_{k}"]]
        return list(answer.options)[keys.index(given[f"choice_{k}"])]
    if isinstance(answer, Ordering):
        return [block["inner_html"].strip() for block in given["answer"]]
    right = _right(answer)
    if right.dtype == object:
        entries = np.reshape([given[f"entry_{i + 1}_{j + 1}"] for i, j in np.ndindex(right.shape)], right.shape)
        return (entries[:, 0] if right.shape[1] == 1 else entries).tolist()
    values = [given[one["name"]]["_value"] for one in data["params"]["matrices"]]
    return np.array(values, dtype=float).reshape(right.shape)


def add_arguments(parser: ArgumentParser) -> None:
    """Add the arguments of `misstep export`."""
    parser.add_argument("platform", choices=["prairielearn"])
    parser.add_argument("out", type=Path, help="a new folder for the PrairieLearn course")


def run(options: Namespace) -> int:
    """Write the course, and say which problems are left out."""
    count, left_out = export(find_course(), options.out)
    print(f"{options.out} is a PrairieLearn course with {count} questions.")
    print(f"Left out, because their answer is a function or a text: {', '.join(left_out) or 'none'}.")
    return 0


def export(course: Course, out: Path) -> tuple[int, list[str]]:
    """Write the PrairieLearn course into a new folder. Returns the number of questions, and the problems that are left out.

    Raises ValueError for a folder that has something in it.
    """
    if out.exists() and any(out.iterdir()):
        raise ValueError(f"{out} must be a new or an empty folder; it has {next(out.iterdir()).name}.")
    folder = out / "courseInstances" / "Course"
    topics, count, left_out = [], 0, []
    for name in course.sheets():
        sheet = course.find_sheet(name)
        questions = []
        for index, template in enumerate(sheet.problems):
            answer = template.variant("sample").answer
            if answer.inputs or isinstance(answer, Prose):
                left_out.append(template.number)
                continue
            id_ = f"{name}/{index + 1:02}"
            info: Data = {"uuid": _uuid(course, id_), "title": f"{template.number} {template.title}", "type": "v3"}
            info |= {"topic": sheet.title, "tags": [name], "singleVariant": False}
            code = SERVER.format(package=course.package, sheet=name, index=index)
            for file, content in (("info.json", info), ("question.html", QUESTION), ("server.py", code)):
                _write(out / "questions" / id_ / file, content)
            questions.append({"id": id_, "autoPoints": template.points, "maxAutoPoints": template.points})
        number, count = name.partition("_")[0], count + len(questions)
        assessment = {"uuid": _uuid(course, name), "type": "Homework", "title": sheet.title, "set": "Homework"}
        zones = [{"title": sheet.title, "questions": questions}]
        _write(folder / "assessments" / name / "infoAssessment.json", {**assessment, "number": number, "zones": zones})
        topics.append({"name": sheet.title, "color": "blue1"})
    _write(out / "infoCourse.json", {"name": course.package, "title": course.package, "topics": topics})
    _write(folder / "infoCourseInstance.json", {"uuid": _uuid(course, "Course"), "longName": "Course"})
    for package in ("anywidget", "traitlets"):
        _write(out / "serverFilesCourse" / f"{package}.py", WIDGETS)
    for package in ("misstep", course.package, *course.requires):
        folder, ignore = out / "serverFilesCourse" / package, shutil.ignore_patterns("__pycache__")
        shutil.copytree(str(files(package)), folder, ignore=ignore)
    return count, left_out


def _uuid(course: Course, name: str) -> str:
    """Return the same identifier for the same question in each export, so that PrairieLearn keeps its history."""
    return str(uuid5(NAMESPACE_URL, f"https://misstep/{course.package}/{name}"))


def _write(path: Path, content: Data | str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content if isinstance(content, str) else json.dumps(content, indent=2) + "\n", "utf-8")
