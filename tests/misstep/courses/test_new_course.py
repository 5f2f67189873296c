"""A new course: what its README says is done line by line, in an environment in which only the engine and the course exist."""

import csv
import os
import re
import shlex
import subprocess
import sys

import pytest
import submissions

from misstep.cli import main
from misstep.new_course import TEMPLATE, write_course

SET_UP = [
    "python -m venv .venv",
    ".venv/bin/python -m pip install -e '.[instructor]'",
    ".venv/bin/python -m jupyterlab",
]
"""Lines of the README that need a network or a person."""
SITE = [
    ".venv/bin/python -m pip install -e '.[site]'",
    ".venv/bin/python -m pip wheel --no-deps --wheel-dir build/wheels . misstep",
    ".venv/bin/python -m misstep release",
    ".venv/bin/python -m sphinx -W . build/site",
]
"""Lines of the README that build the site. They need a network; the workflow of the course runs them too."""
RIGHT = {
    "resistance_1": "1 / (1 / given.first + 1 / given.second)",
    "voltage_2": "given.peak * np.sin(np.radians(given.degrees))",
    "impedance_3": "f'{given.resistance + 1j * given.reactance} ohm'",
    "my_first_problem_5": "given.a * given.b",
}


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """A new course called circuits, and a function that runs a line of its README."""
    folder = tmp_path_factory.mktemp("new") / "circuits"
    write_course(folder)
    information = folder / "circuits-0.1.0.dist-info"  # as `pip install -e .` writes it
    information.mkdir()
    (information / "METADATA").write_text("Metadata-Version: 2.1\nName: circuits\nVersion: 0.1.0\n", "utf-8")
    (information / "entry_points.txt").write_text("[misstep.courses]\ncircuits = circuits:COURSE\n", "utf-8")

    def run(line, code=0):
        assert line.startswith(".venv/bin/python -m ")
        module, *arguments = shlex.split(line.removeprefix(".venv/bin/python -m "))
        quiet = ["-p", "no:cacheprovider"] if module == "pytest" else []
        environment = {**os.environ, "PYTHONPATH": str(folder)}
        command = [sys.executable, "-m", module, *quiet, *arguments]
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == code, f"{line}\n{done.stdout}{done.stderr}"
        return done.stdout

    return folder, run


def lines_of(readme):
    """The lines that a README tells the reader to run, in order."""
    blocks = re.findall(r"^ *```\n(.*?)^ *```", readme.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    return [line.strip() for block in blocks for line in block.splitlines()]


@pytest.mark.skipif(bool(submissions.sandbox_lacks()), reason=f"this machine lacks {submissions.sandbox_lacks()}")
def test_the_readme_of_a_new_course_leads_to_tested_released_and_graded_sheets(course, hand_in):
    folder, run = course
    done = {}
    readme, instructors = (lines_of(folder / name) for name in ("README.md", "instructors.md"))
    assert [*readme[-len(SITE) - 1 : -1]] == SITE
    assert set(SET_UP) < set(readme)
    for line in [*readme[: -len(SITE) - 1], *instructors]:
        if line in SET_UP:
            continue
        if "misstep grade" in line:
            right = {name: f"{name} = {answer}" for name, answer in RIGHT.items()}
            hand_in(folder, "01_ohm", "ada", right)
            hand_in(folder, "01_ohm", "bob", {**right, "voltage_2": "voltage_2 = given.peak * np.sin(given.degrees)"})
        done[line.split()[3] if "misstep" in line else "pytest"] = run(line, int("misstep check" in line))
    assert set(done) == {"pytest", "new-problem", "check", "preview", "census", "release", "grade"}
    assert re.fullmatch(
        r"\S+problems\.py:\d+: problem 01\.5 still has the statement of a new problem\.\n"
        r"\S+01_ohm\.ipynb: problem 01\.5 still has the solution of a new problem\. .*\n",
        done["check"],
    )
    assert "degrees of $\\varphi$ as radians" in done["preview"]
    released = (folder / "exercises" / "01_ohm" / "01_ohm.ipynb").read_text("utf-8")
    assert "voltage_2 = ..." in released
    assert not any(solution in released for solution in RIGHT.values())
    assert re.search(r"\b\d+ passed", done["pytest"])
    assert re.search(r"^\| 01\.2 \| \d+ \| 0 \| 0 \| 0 \|", done["census"], re.MULTILINE)
    with (folder / "results" / "grades.csv").open(newline="", encoding="utf-8") as stream:
        assert {row["student"]: float(row["points"]) for row in csv.DictReader(stream)} == {"ada": 9, "bob": 7}
    feedback = "".join(path.read_text("utf-8") for path in (folder / "results" / "feedback").rglob("*bob*"))
    assert "what you get if you use the degrees of" in feedback  # a single number shows no more


def test_a_new_course_has_the_name_of_its_folder_everywhere(course):
    files = [
        path
        for path in course[0].rglob("*")
        if path.is_file() and path.suffix in {".py", ".md", ".toml", ".ipynb", ".yml", ".json"}
    ]
    assert len(files) >= 13
    assert not [
        path
        for path in files
        if "my_course" in path.read_text("utf-8") or "my_course" in str(path.relative_to(course[0]))
    ]


def test_a_name_that_cannot_be_a_course_is_refused(tmp_path, capsys):
    (tmp_path / "here").mkdir()
    for name, said in [
        ("My Course", "small letters, digits and underscores; got 'My Course'. Try: my_course"),
        ("class", "small letters, digits and underscores; got 'class'"),
        ("math", "must not be that of another package; got 'math'. Try: math_course"),
        ("here", "does not exist yet"),
    ]:
        assert main(["new-course", str(tmp_path / name)]) == 2
        assert said in capsys.readouterr().err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["here"]


def test_the_workflow_of_the_template_builds_the_site_as_its_readme_does():
    text = (TEMPLATE / ".github/workflows/site.yml").read_text("utf-8")
    assert re.findall(r"- run: (.+)", text)[2:] == [line.removeprefix(".venv/bin/") for line in SITE[1:]]
    assert "'.[instructor,site]'" in text
