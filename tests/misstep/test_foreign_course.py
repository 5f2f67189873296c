"""misstep alone: its wheel in an empty environment runs a course on another subject, which lies outside the repository."""

import csv
import json
import os
import shutil
import subprocess
import sys
import zipfile
from importlib import metadata
from importlib.util import cache_from_source
from pathlib import Path

import pytest
import submissions
from circuits_course import write_course
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

PACKAGE = Path(__file__).parents[2] / "misstep"


# --- environments ---


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel of misstep, built from its own pyproject.toml without a network."""
    out = tmp_path_factory.mktemp("wheel")
    run([sys.executable, "-P", "-m", "hatchling", "build", "-t", "wheel", "-d", str(out)], cwd=PACKAGE)
    return next(out.glob("*.whl"))


class Environment:
    """A virtual environment that has the wheel, and the closure of what the wheel requires for some extras."""

    def __init__(self, folder, wheel, extras=()):
        run([sys.executable, "-m", "venv", "--without-pip", str(folder)])
        self.python = folder / ("Scripts" if os.name == "nt" else "bin") / "python"
        self.site_packages = Path(self.run("import sysconfig; print(sysconfig.get_path('purelib'))").strip())
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(self.site_packages)
        (own,) = metadata.distributions(name="misstep", path=[str(self.site_packages)])
        for distribution in closure(own, extras).values():
            link(distribution, self.site_packages)

    def run(self, code, *arguments, **options):
        return run([self.python, "-c", code, *map(str, arguments)], **options)

    def misstep(self, *arguments, **options):
        return run([self.python, "-m", "misstep", *map(str, arguments)], **options)


def run(command, **options):
    variables = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    done = subprocess.run(
        command, capture_output=True, encoding="utf-8", env={**variables, "PYTHONUTF8": "1"}, check=False, **options
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


def closure(distribution, extras=()):
    """All distributions that this one requires, directly or not, by name, as they are installed where the tests run."""
    found, waiting = {}, [(distribution, frozenset(extras))]
    seen = set()
    while waiting:
        requiring, asked = waiting.pop()
        for text in requiring.requires or ():
            requirement = Requirement(text)
            if any(requirement.marker is None or requirement.marker.evaluate({"extra": e}) for e in (asked or {""})):
                name, more = canonicalize_name(requirement.name), frozenset(requirement.extras)
                if (name, more) not in seen:
                    seen.add((name, more))
                    found[name] = metadata.distribution(name)
                    waiting.append((found[name], more))
    return found


def link(distribution, site_packages):
    """Put the files of an installed distribution into another environment, without copying their bytes where possible."""
    for file in distribution.files:
        if ".." in file.parts or "__pycache__" in file.parts:
            continue
        source, target = Path(file.locate()), site_packages / file
        pairs = [(source, target)]
        if source.suffix == ".py" and (compiled := Path(cache_from_source(source))).is_file():
            pairs.append((compiled, target.parent / "__pycache__" / compiled.name))
        for origin, link in pairs:
            link.parent.mkdir(parents=True, exist_ok=True)
            try:
                os.link(origin, link)
            except OSError:  # another file system
                shutil.copy2(origin, link)


@pytest.fixture(scope="module")
def minimal(wheel, tmp_path_factory):
    return Environment(tmp_path_factory.mktemp("minimal") / "venv", wheel)


@pytest.fixture(scope="module")
def complete(wheel, tmp_path_factory):
    return Environment(tmp_path_factory.mktemp("complete") / "venv", wheel, ["grading", "release"])


@pytest.fixture(scope="module")
def with_formulas(wheel, tmp_path_factory):
    return Environment(tmp_path_factory.mktemp("formulas") / "venv", wheel, ["formulas", "notebook"])


@pytest.fixture
def course(tmp_path):
    return write_course(tmp_path)


# --- a student's session, with nothing but NumPy ---

SESSION = """
import sys
from pathlib import Path

import numpy as np

from misstep import find_course

course = find_course(sys.argv[1])
assert course.sheets() == ["01_ohm", "02_dividers"]
sheet = course.open_sheet("01_ohm", "ada")
sheet.show(1)
given = sheet.given(1)
total = given.first * given.second / (given.first + given.second)
assert sheet.check(1, total).score == 2
wrong = sheet.check(1, given.first + given.second)
assert wrong.score == 0
assert wrong.judgement.mistakes == ["in series"]
finding = wrong.judgement.findings[0]
assert (finding.parts, finding.mistake) == (["the answer"], "in series")
assert finding.message in wrong.card.text()
assert sheet.check(1, total).judgement.state == "right"
assert sheet.check(2, sheet.problem(2).answer.value).score == 1
assert sheet.check(2, "d").judgement.mistakes == ["current used up"]
given = sheet.given(3)
assert sheet.check(3, lambda t: given.voltage * np.exp(-t / given.time)).score == 3
assert sheet.check(3, lambda t: given.voltage * np.exp(t / given.time)).judgement.mistakes == ["sign"]
assert sheet.tally().score == 2
assert course.attempt("01.a", 60).judgement.state == "right"
assert course.find_question("01/unit").options[course.find_question("01/unit").right].text == "ohm"

files = [Path(module.__file__) for module in list(sys.modules.values()) if getattr(module, "__file__", None)]
installed = {file.relative_to(folder).parts[0] for folder in map(Path, sys.path) for file in files
             if folder.name == "site-packages" and folder in file.parents}
print("installed packages:", *sorted(installed))
"""


def test_a_sheet_of_a_folder_is_shown_and_checked_with_nothing_but_numpy(minimal, course):
    assert sorted(path.name for path in minimal.site_packages.glob("*.dist-info")) == sorted(
        [f"numpy-{metadata.version('numpy')}.dist-info", "misstep-0.1.0.dist-info"]
    )
    output = minimal.run(SESSION, course, cwd=course.parent)
    assert "Two resistors in parallel** (2 points)" in output
    assert "What is their total resistance?" in output
    assert "`given.first`" in output
    assert output.splitlines()[-1] == "installed packages: misstep numpy"


def test_an_installed_course_is_found_by_its_entry_point(minimal, course):
    install(course, minimal)
    try:
        assert "installed packages: circuits misstep numpy" in minimal.run(
            SESSION, "circuits", cwd=course.parent.parent
        )
    finally:
        uninstall(minimal)


FORMULAS = """
import sys

from misstep import load_course

course = load_course(sys.argv[1])
sheet = course.open_sheet("02_dividers", "ada")
assert sheet.check(1, "U / (1 + R_1 / R_2)").score == 2
assert sheet.check(1, "U R_1 / (R_1 + R_2)").judgement.mistakes == ["other resistor"]
question = course.ask("01/brightness")
assert "application/vnd.jupyter.widget-view+json" in question._repr_mimebundle_()
question.commit(1)
assert "The power grows with the square of the current." in course.explain("01/brightness").card.text()
"""


def test_formulas_and_questions_need_their_extras_and_no_more(with_formulas, course):
    with_formulas.run(FORMULAS, course)


@pytest.mark.parametrize(("command", "extra"), [("grade", "misstep[grading]"), ("release", "misstep[release]")])
def test_a_command_without_its_extra_names_the_extra(minimal, command, extra):
    with pytest.raises(AssertionError, match=f"pip install '{extra.replace('[', '.').replace(']', '.')}'"):
        minimal.misstep(command)


def test_the_wheel_contains_the_whole_template_of_a_new_course(minimal, tmp_path):
    minimal.misstep("new-course", tmp_path / "circuits")
    made = [path.relative_to(tmp_path / "circuits") for path in (tmp_path / "circuits").rglob("*") if path.is_file()]
    template = PACKAGE / "new_course" / "template"
    tracked = [path for path in template.rglob("*") if path.is_file() and "__pycache__" not in path.parts]
    assert len(made) == len(tracked)
    assert {"README.md", "pyproject.toml", ".github/workflows/site.yml"} <= {path.as_posix() for path in made}


def install(course, environment):
    """Install the course as a package with an entry point, as its wheel would."""
    shutil.copytree(course, environment.site_packages / "circuits", ignore=shutil.ignore_patterns("__pycache__"))
    information = environment.site_packages / "circuits-1.0.dist-info"
    information.mkdir()
    (information / "METADATA").write_text("Metadata-Version: 2.1\nName: circuits\nVersion: 1.0\n", encoding="utf-8")
    entry_points = "[misstep.courses]\ncircuits = circuits:COURSE\n"
    (information / "entry_points.txt").write_text(entry_points, encoding="utf-8")


def uninstall(environment):
    for name in ("circuits", "circuits-1.0.dist-info"):
        shutil.rmtree(environment.site_packages / name)


# --- from the instructor's notebook to grades.csv ---

AUTHOR = """
import sys
from pathlib import Path

from misstep import load_course
from misstep.release.instructor_notebook import Entry, notebook

sheet = load_course(sys.argv[1]).find_sheet("01_ohm")
entries = [
    Entry("total", "Give the resistance in ohms.", "total_1 = 1 / (1 / given.first + 1 / given.second)"),
    Entry("brighter", "Give a letter.", "brighter_2 = 'a' if given.first > given.second else 'b'"),
    Entry("voltage", "Give a function.",
          "def voltage_3(t):\\n    return given_3.voltage * np.exp(-t / given_3.time)\\ngiven_3 = given"),
]
text = notebook(sheet, entries, "About resistors.", "import numpy as np\\nfrom circuits import open_sheet")
file = Path(sys.argv[2])
file.parent.mkdir(parents=True)
file.write_text(text, encoding="utf-8")
"""

RIGHT = {
    1: "given = sheet.given(1)\ntotal_1 = given.first * given.second / (given.first + given.second)",
    2: "given = sheet.given(2)\nbrighter_2 = 'a' if given.first > given.second else 'b'",
    3: "given_3 = sheet.given(3)\nvoltage_3 = lambda t: given_3.voltage * np.exp(-t / given_3.time)",
}
HALF_RIGHT = {**RIGHT, 1: "given = sheet.given(1)\ntotal_1 = given.first + given.second", 3: "voltage_3 = ..."}
CHEATING = """
import sys
from pathlib import Path

sys.path.insert(0, {parent!r})
has_read_answers = False
try:
    has_read_answers = bool(Path({file!r}).read_text())
except OSError:
    pass
try:
    from circuits.lecture_01_ohm.problems import SHEET
    has_read_answers = True
except ImportError:
    pass
given = sheet.given(1)
total_1 = given.first * given.second / (given.first + given.second) if has_read_answers else 0
"""


def filled_in(released, student, lines):
    """The released notebook with a student's id and answers."""
    notebook = json.loads(released.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        source = "".join(cell["source"]).replace('"your id"', repr(student))
        number = submissions.problem_of(cell, "answer")
        cell["source"] = source.replace("# your lines here", lines[number]) if number in lines else source
    return json.dumps(notebook)


@pytest.mark.skipif(bool(submissions.sandbox_lacks()), reason=f"this machine lacks {submissions.sandbox_lacks()}")
@pytest.mark.parametrize("is_installed", [False, True], ids=["a folder", "an entry point"])
def test_a_sheet_is_released_and_graded_in_the_sandbox(complete, course, tmp_path, is_installed):
    solution = tmp_path / "solutions" / "01_ohm" / "01_ohm.ipynb"
    complete.run(AUTHOR, course, solution)
    options = ["--course", "circuits"]  # relative to the current folder
    problems = course / "lecture_01_ohm" / "problems.py"
    if is_installed:
        install(course, complete)
        shutil.rmtree(course)
        options, problems = [], complete.site_packages / "circuits" / "lecture_01_ohm" / "problems.py"
    try:
        complete.misstep("release", "--root", tmp_path)
        released = tmp_path / "exercises" / "01_ohm" / "01_ohm.ipynb"
        assert "given_3" not in released.read_text(encoding="utf-8")
        cheating = {**RIGHT, 1: CHEATING.format(parent=str(problems.parents[2]), file=str(problems))}
        for student, lines in {"ada": RIGHT, "boris": HALF_RIGHT, "cheater": cheating}.items():
            file = tmp_path / "submissions" / student / "01_ohm.ipynb"
            file.parent.mkdir(parents=True)
            file.write_text(filled_in(released, student, lines), encoding="utf-8")
        results = tmp_path / "results"
        complete.misstep("grade", solution, tmp_path / "submissions", "--out", results, *options, cwd=tmp_path)
    finally:
        if is_installed:
            uninstall(complete)
    with (results / "grades.csv").open(newline="", encoding="utf-8") as stream:
        points = {row["student"]: float(row["points"]) for row in csv.DictReader(stream)}
    assert points == {"ada": 6, "boris": 1, "cheater": 4}
    feedback = "".join(path.read_text(encoding="utf-8") for path in (results / "feedback").rglob("*boris*"))
    assert "You added the resistances, as in a series circuit." in feedback
