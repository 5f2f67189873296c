"""misstep alone: its wheel in an empty environment runs a course on another subject, which lies outside the repository."""

import os
import shutil
import subprocess
import sys
import zipfile
from importlib import metadata
from pathlib import Path

import pytest
import submissions
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from misstep.new_course import write_course

# --- environments ---


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
    """Put an installed distribution into another environment."""
    for name in {file.parts[0] for file in distribution.files if ".." not in file.parts} - {"__pycache__"}:
        (site_packages / name).symlink_to(distribution.locate_file(name))


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel of misstep, built from its own pyproject.toml without a network."""
    out = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-P", "-m", "hatchling", "build", "-t", "wheel", "-d", str(out)]
    subprocess.run(command, cwd=submissions.ROOT / "misstep", check=True, capture_output=True)
    return next(out.glob("*.whl"))


@pytest.fixture(scope="module")
def minimal(wheel, tmp_path_factory):
    return Environment(tmp_path_factory.mktemp("minimal") / "venv", wheel)


@pytest.fixture
def course(tmp_path):
    """The package of a new course outside of the repository."""
    write_course(tmp_path / "dice", "probability")
    return tmp_path / "dice" / "dice"


# --- a student's session, with nothing but NumPy ---

SESSION = """
import sys
from fractions import Fraction
from pathlib import Path

from misstep import find_course

course = find_course(sys.argv[1])
assert course.sheets() == ["01_dice"]
sheet = course.open_sheet("01_dice", "ada")
sheet.show(1)
rolls = sheet.given(1).rolls
assert sheet.check(1, 1 - Fraction(5, 6) ** rolls).score == 2
wrong = sheet.check(1, Fraction(rolls, 6))
assert (wrong.score, wrong.judgement.mistakes) == (0, ["added"])
assert wrong.judgement.findings[0].message in wrong.card.text()
assert sheet.check(1, f"1 - (5/6)^{rolls}").judgement.state == "right"
given = sheet.given(3)
assert sheet.check(3, f"[{given.face}, {given.face + 1})").score == 2
assert sheet.check(3, f"({given.face}, {given.face + 1}]").judgement.mistakes == ["ends of an interval"]
assert sheet.tally().score == 2
question = course.find_question("01/doubled")
assert question.options[question.right].text.startswith("no")

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
    assert "At least one six** (2 points)" in output
    assert "`given.rolls`" in output
    assert output.splitlines()[-1] == "installed packages: misstep numpy"


def test_an_installed_course_is_found_by_its_entry_point(minimal, course):
    """It is installed as a package with an entry point, as its wheel would be."""
    shutil.copytree(course, minimal.site_packages / "dice", ignore=shutil.ignore_patterns("__pycache__"))
    information = minimal.site_packages / "dice-1.0.dist-info"
    information.mkdir()
    (information / "METADATA").write_text("Metadata-Version: 2.1\nName: dice\nVersion: 1.0\n", encoding="utf-8")
    (information / "entry_points.txt").write_text("[misstep.courses]\ndice = dice:COURSE\n", encoding="utf-8")
    try:
        told = minimal.run(SESSION, "dice", cwd=course.parent.parent)
        assert "installed packages: dice misstep numpy" in told
    finally:
        for name in ("dice", "dice-1.0.dist-info"):
            shutil.rmtree(minimal.site_packages / name)


FORMULAS = """
import sys

import sympy as sp

from misstep import load_course
from misstep.answers.expression import ClosedForm

U, R_1, R_2 = sp.symbols("U R_1 R_2", positive=True)
divider = ClosedForm(U * R_2 / (R_1 + R_2))
assert divider.agrees(divider.read("U / (1 + R_1 / R_2)"), divider.value) == [True]
course = load_course(sys.argv[1])
question = course.ask("01/doubled")
assert "application/vnd.jupyter.widget-view+json" in question._repr_mimebundle_()
question.commit(question.item.right)
assert "Both may show a six, and this counts once." in course.explain("01/doubled").card.text()
"""


def test_formulas_and_questions_need_their_extras_and_no_more(wheel, course, tmp_path):
    Environment(tmp_path / "venv", wheel, ["formulas", "notebook"]).run(FORMULAS, course)


HELP = """
from misstep.cli import COMMANDS, main

for name in COMMANDS:
    try:
        main([name, "--help"])
    except SystemExit as end:
        assert not end.code, name
"""


def test_a_command_without_its_extra_names_the_extra(minimal):
    assert "--roster" in minimal.run(HELP)
    for command, extra in (("grade sheet.ipynb submissions --out results", "grading"), ("release", "release")):
        with pytest.raises(AssertionError, match=rf"pip install 'misstep\[{extra}\]'"):
            minimal.misstep(*command.split())


def test_the_wheel_contains_the_whole_template_of_a_new_course(minimal, tmp_path):
    minimal.misstep("new-course", tmp_path / "circuits")
    write_course(tmp_path / "here" / "circuits")
    made, here = (
        sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
        for folder in (tmp_path / "circuits", tmp_path / "here" / "circuits")
    )
    assert made == here
    assert {"README.md", "pyproject.toml", ".github/workflows/site.yml", "solutions/01_ohm/01_ohm.ipynb"} <= set(made)
