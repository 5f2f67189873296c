"""A submission cannot read the course, wherever the course is: in site-packages, in an editable checkout, or in a folder."""

import json
import os
import sys

import pytest
import submissions

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO SANDBOX IS TESTED: this machine lacks {lacking}", allow_module_level=True)

from kincourse import COURSE
from misstep.catalog import load_course
from misstep.grading.judging.judge_process import Judge
from misstep.grading.sandbox.course_stub import engine_folder, setup_for
from misstep.grading.sandbox.limits import Limits
from misstep.grading.sandbox.rootfs import is_inside, readable_paths
from misstep.grading.sandbox.runner import Runner
from misstep.grading.sandbox.submission_process import PIPE_DESCRIPTOR

CANARY = "RIGHT-ANSWER-CANARY"

INIT = """
from misstep.catalog import Course

COURSE = Course("{name}", warm_up=("import {name}",))
open_sheet = COURSE.open_sheet
"""

PROBLEMS = """
import numpy as np

from misstep import Problem, Sheet, mistake, problem
from misstep.answers.number import Numbers

SECRET = "RIGHT-ANSWER-CANARY"


@problem("01.1", "Twice", points=1, lecture="01_twice#Twice")
def twice(sampler):
    x = sampler.length(0.1, 0.5)
    wrong = [mistake(name, np.array(value), "No.") for name, value in {"a": x / 2, "b": -x, "c": 5 * x}.items()]
    return Problem(f"Twice {x}?", Numbers(np.array(2 * x)), wrong, {"x": x})


SHEET = Sheet("01_twice", "Twice", [twice])
"""

READ_FILES = """
from pathlib import Path
for path in Path("{parent}").rglob("*"):
    if "/{name}/" in str(path) and path.is_file():
        print("fo" "und", path, path.read_text(errors="replace"))
print(open("{problems}").read())
"""

WALK_ROOT = """
import os
for folder, _, names in os.walk("/"):
    if "lecture_01_twice" in folder or "lecture_01_frames" in folder:
        print("fo" "und", folder, names)
"""

IMPORT_MODULES = """
import importlib, sys
sys.path.insert(0, "{parent}")
for name in [name for name in sys.modules if name.split(".")[0] == "{name}"]:
    del sys.modules[name]
for name in ["{name}.lecture_{sheet}.problems", "{name}.catalog", "misstep.grading.judging.judge_process"]:
    try:
        print("fo" "und", importlib.import_module(name).__file__)
    except ImportError:
        pass
"""

SEARCH_MEMORY = """
import gc, sys
secret = "RIGHT-ANSWER-" + "CANARY"
for name, module in list(sys.modules.items()):
    if name.startswith("{name}.") or (name == "{name}" and getattr(module, "__file__", None)):
        print("fo" "und", name)
for thing in gc.get_objects():
    if isinstance(thing, dict) and thing.get("SECRET") == secret:
        print("fo" "und", secret)
    if type(thing).__name__ == "Problem" or str(vars(type(thing)).get("__module__")).startswith("{name}."):
        print("fo" "und", type(thing))
    if type(thing).__name__ == "function" and str(thing.__module__).startswith("{name}."):
        print("fo" "und", thing)
"""

LIST_PATHS = """
import os, sys
modules = [module for name, module in sys.modules.items() if name.partition(".")[0] in ("misstep", "__main__")]
print(dict(os.environ), sys.argv, sys.orig_argv, os.getcwd())
print([(vars(module).get("__file__"), list(vars(module).get("__path__") or [])) for module in modules])
print([path for path in sys.path if not os.path.exists(path)])
"""

LIST_DESCRIPTORS = """
import os
def is_open(descriptor):
    try: return bool(os.fstat(descriptor))
    except OSError: return False
print("open:", *(k for k in range(1 << 16) if is_open(k)))
"""

OPEN_SHEET = """
from {name} import open_sheet
print("opened", open_sheet("{sheet}", "ada").problem(1).statement != "")
"""


def write_course(parent, name):
    folder = parent / name
    (folder / "lecture_01_twice").mkdir(parents=True)
    (folder / "__init__.py").write_text(INIT.format(name=name))
    (folder / "lecture_01_twice" / "__init__.py").write_text("")
    (folder / "lecture_01_twice" / "problems.py").write_text(PROBLEMS)
    return folder


@pytest.fixture(params=["in a folder", "in site-packages", "in an editable checkout"])
def course(request, tmp_path, monkeypatch):
    """A course and its sheet; its folder is on the disk in one of the ways in which courses are found."""
    if request.param == "in an editable checkout":
        yield COURSE, "01_frames"
        return
    if request.param == "in a folder":
        name, parent = "course_in_folder", tmp_path
    else:  # this folder is among those that every submission may read
        name, parent = "course_in_site", tmp_path / "site-packages"
        parent.mkdir()
        monkeypatch.syspath_prepend(str(parent))
        monkeypatch.setenv("PYTHONPATH", str(parent))
    folder = write_course(parent, name)
    if request.param == "in site-packages":
        information = parent / f"{name}-1.0.dist-info"
        information.mkdir()
        (information / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
        (information / "entry_points.txt").write_text(f"[misstep.courses]\n{name} = {name}:COURSE\n")
        assert is_inside(str(folder), readable_paths([]))
    yield load_course(folder), "01_twice"
    for module in [module for module in sys.modules if module.partition(".")[0] == name]:
        del sys.modules[module]


def run(course, sheet, is_safe, *attacks):
    """What each attack prints, and the errors that it raises."""
    problems = course.folder / f"lecture_{sheet}" / "problems.py"
    names = {"name": course.package, "sheet": sheet, "parent": course.folder.parent, "problems": problems}
    sources = [attack.replace("{", "{{").replace("}", "}}") for attack in attacks]
    for name in names:
        sources = [source.replace("{{" + name + "}}", "{" + name + "}") for source in sources]
    _, redacted = Judge(course.find_sheet(sheet)).redacted_sheet("ada")
    runner = Runner(setup_for(course), is_safe)
    try:
        outcome = runner.run(redacted, [source.format(**names) for source in sources], Limits())
    finally:
        runner.close()
    lines = [json.loads(line) for line in outcome.output.splitlines()]
    return [json.dumps(line["outputs"]) for line in lines]


def test_a_submission_opens_its_sheet_and_reads_nothing_of_the_course_and_of_the_grader(course, monkeypatch):
    course, sheet = course
    monkeypatch.setenv("PATH", f"{os.environ['PATH']}:{course.folder.parent}")
    attacks = (LIST_PATHS, LIST_DESCRIPTORS, READ_FILES, WALK_ROOT, IMPORT_MODULES, SEARCH_MEMORY)
    opened, *told = run(course, sheet, True, OPEN_SHEET, *attacks)
    assert "opened True" in opened
    assert len(told) == len(attacks)
    for output in told:
        assert "found" not in output
        assert CANARY not in output
    paths, descriptors, files, _, _, memory = told
    assert "FileNotFoundError" in files
    assert "error" not in memory, "the search of the memory must run to its end"
    assert "/scratch" in paths
    assert str(course.folder.parent) not in paths
    assert str(engine_folder()) not in paths
    assert f"open: 0 1 2 {PIPE_DESCRIPTOR + 1}\\n" in descriptors


@pytest.mark.parametrize("course", ["in an editable checkout"], indirect=True)
def test_without_the_sandbox_the_same_attack_reads_the_course_but_finds_no_right_answer_in_the_memory(course):
    """So the test above tests the sandbox, and not attacks that would find nothing anywhere."""
    course, sheet = course
    files, memory = run(course, sheet, False, 'print(open("{problems}").read())', SEARCH_MEMORY)
    assert "SHEET = Sheet(" in files
    assert "found" not in memory
    assert "error" not in memory


def test_every_place_of_the_course_the_engine_and_the_released_sheet_is_hidden(tmp_path):
    hidden = setup_for(COURSE, tmp_path).hidden
    assert {str(COURSE.folder.resolve()), str(engine_folder()), str(tmp_path)} <= set(hidden)


def test_a_course_that_is_no_folder_is_refused(monkeypatch):
    monkeypatch.setattr(type(COURSE), "folder", property(lambda _: engine_folder() / "course.zip"))
    with pytest.raises(ValueError, match="must be a folder on the disk"):
        setup_for(COURSE)
