"""Submissions to grade: sheets filled in, as students hand them in, and made without running anything."""

import ctypes
import ctypes.util
import json
import re
import subprocess
import sys
from copy import deepcopy
from functools import cache
from pathlib import Path

import numpy as np
from typed_answers import typable

from kincourse import find_sheet
from misstep.answers.expression import ClosedForm

ROOT = Path(__file__).parents[2]
SHEET = "03_poe_space"


def released(name=SHEET):
    """The path of the sheet that students get."""
    return ROOT / "exercises" / name / f"{name}.ipynb"


@cache
def _released(name):
    return json.loads(released(name).read_text("utf-8"))


def handed_in(student, lines=None, first="", last="", name=SHEET):
    """A notebook: the student's id at the top, lines by problem in the answer cells, more code before and after."""
    notebook = deepcopy(_released(name))
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        if cell["id"] == "open":
            source = source.replace("your id", student)
        if (k := problem_of(cell, "answer")) in (lines or {}):
            source = source.replace("# your lines here", lines[k])
        cell["source"] = source
    opened = next(i for i, cell in enumerate(notebook["cells"]) if cell["id"] == "open")
    notebook["cells"].insert(opened + 1, code(first))
    notebook["cells"].append(code(last))
    return notebook


def code(source, **metadata):
    return {
        "cell_type": "code",
        "id": "own",
        "metadata": metadata,
        "source": source,
        "outputs": [],
        "execution_count": None,
    }


def problem_of(cell, kind):
    """The problem that an answer or check cell belongs to, or None."""
    found = re.fullmatch(rf"{kind}-(\d+)", cell.get("id", ""))
    return int(found[1]) if found else None


def names(name=SHEET):
    """By problem, the variable that its check cell hands in."""
    checks = {k: "".join(cell["source"]) for cell in _released(name)["cells"] if (k := problem_of(cell, "check"))}
    return {k: re.search(r", *(\w+)\)", source)[1] for k, source in checks.items()}


@cache
def right(student, name=SHEET):
    """Lines with the right answers, typed in, by problem."""
    return typed(student, lambda problem: problem.answer.value, "kl.Chain({screws}, {home}).fk", name)


@cache
def mistaken(student, made="omega x p", name=SHEET):
    """Lines with the answers that a mistake leads to, by problem: this one where it can be made, or else the first."""
    home_first = "lambda q: {home} @ kl.Chain({screws}, np.eye(4)).fk(q)"

    def mistake_in(problem):
        return max(typable(problem), key=lambda mistake: mistake.name == made).value

    return typed(student, mistake_in, home_first, name)


def attacking(student, attack):
    """A notebook that runs an attack, and hands in what the attack put into `answers`, or else what is wrong."""
    lines = {
        k: f"{line}\n{names()[k]} = globals().get('answers', {{}}).get({k}, {names()[k]})"
        for k, line in wrong(student).items()
    }
    return handed_in(student, lines, first=attack)


@cache
def wrong(student):
    """Lines with answers that are wrong in every part, by problem."""
    return typed(student, lambda problem: far(problem.answer.value), "lambda q: np.full((4, 4), 50.0)")


def typed(student, answer, function, name=SHEET):
    """Lines with answers to a student's variants, as numbers and names; where a function is asked for, with this one.

    Problems that ask for formulas, and those that build on them, are left blank.
    """
    lines = {}
    for k, template in enumerate(find_sheet(name).problems, start=1):
        problem = template.variant(student)
        if isinstance(problem.answer, ClosedForm) or (callable(problem.answer.value) and not problem.given):
            continue
        if callable(problem.answer.value):
            value = function.format(**{given: literal(number) for given, number in problem.given.items()})
        else:
            value = literal(answer(problem))
        lines[k] = f"{names(name)[k]} = {value}"
    return lines


def far(value):
    """Another value of the same kind, wrong in every part."""
    return value + 50 if isinstance(value, np.ndarray) else value[::-1]


def literal(value):
    return f"np.array({value.tolist()!r})" if isinstance(value, np.ndarray) else repr(value)


def as_bytes(notebook):
    return json.dumps(notebook, indent=1, ensure_ascii=False).encode()


def sandbox_lacks():
    """What this machine has not of what the sandbox needs, found without asking the sandbox; "" if nothing."""
    if sys.platform != "linux":
        return "Linux"
    tries = [["unshare", *more, "--mount", "--pid", "--fork", "true"] for more in ([], ["--user", "--map-root-user"])]
    if all(subprocess.run(words, capture_output=True, check=False).returncode for words in tries):
        return "the right to make namespaces"
    if ctypes.CDLL(None).syscall(444, None, 0, 1) < 1:
        return "Landlock in its kernel"
    return "" if ctypes.util.find_library("seccomp") else "the library libseccomp2"


def judge_of(sheet=SHEET):
    """What judges a sheet, in this process."""
    from misstep.grading.judging.judge_process import Judge  # it needs Linux or macOS

    return Judge(find_sheet(sheet))


def verdicts(sheet, student, seed, answers, site=""):
    """The judge's verdict on each problem of a sheet, for answers as data, by problem."""
    judge, numbers = judge_of(sheet), range(1, len(find_sheet(sheet).problems) + 1)
    return {k: judge.verdict(student, k, answers.get(k), seed=seed, site=site) for k in numbers}


def descendants(grader):
    """The processes that a grader's server has started and that still are: one, its copy that forks, if all went well."""

    def below(process):
        children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
        return [*children, *(one for child in children for one in below(child))]

    return below(grader._runner.server.process.pid)
