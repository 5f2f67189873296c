"""A new course: what its README says is done line by line, in an environment in which only the engine and the course exist."""

import json
import os
import re
import shlex
import subprocess
import sys

import pytest

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
SUBJECTS = {
    "alternating-current": ("01_ohm", {"voltage_2": "given.peak * np.sin(given.degrees)"}, "degrees"),
    "probability": ("01_dice", {"interval_3": "f'({given.face}, {given.face + 1}]'"}, "ends of an interval"),
    "linear-algebra": ("01_eigenvalues", {"eigenvalues_3": "np.diag(given.A)"}, "diagonal"),
}
"""For each subject its sheet, a wrong answer of a student, and the mistake that feedback names."""

SOLUTION = re.compile(r"^(\w+_\d+) = \.\.\.\n### BEGIN SOLUTION\n(.*)\n### END", re.DOTALL | re.MULTILINE)


@pytest.fixture(scope="module", params=SUBJECTS)
def course(request, tmp_path_factory):
    """The subject, a new course called circuits on it, and a function that runs a line of its README."""
    folder = tmp_path_factory.mktemp("new") / "circuits"
    write_course(folder, request.param)
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

    return request.param, folder, run


def lines_of(readme):
    """The lines that a README tells the reader to run, in order."""
    blocks = re.findall(r"^ *```\n(.*?)^ *```", readme.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    return [line.strip() for block in blocks for line in block.splitlines()]


def hand_in(course, sheet, student, answers):
    """Hand in the released sheet of a student, with the code that takes the place of each line `name = ...`."""
    notebook = json.loads((course / "exercises" / sheet / f"{sheet}.ipynb").read_text("utf-8"))
    for cell in notebook["cells"]:
        source = "".join(cell["source"]).replace('"your id"', repr(student))
        for name, lines in answers.items():
            source = source.replace(f"{name} = ...", lines)
        cell["source"] = source
    file = course / "submissions" / student / f"{sheet}.ipynb"
    file.parent.mkdir(parents=True)
    file.write_text(json.dumps(notebook), "utf-8")


def test_a_new_course_has_the_name_of_its_folder_everywhere(course):
    files = [
        path
        for path in course[1].rglob("*")
        if path.is_file() and path.suffix in {".py", ".md", ".toml", ".ipynb", ".yml", ".json"}
    ]
    assert len(files) >= 13
    assert not [
        path
        for path in files
        if "my_course" in path.read_text("utf-8") or "my_course" in str(path.relative_to(course[1]))
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
