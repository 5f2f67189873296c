"""What the tests of courses share: the wheel of the engine, and handing in a sheet."""

import json
import subprocess
import sys

import pytest
import submissions


@pytest.fixture(scope="session")
def wheel(tmp_path_factory):
    """The wheel of misstep, built from its own pyproject.toml without a network."""
    out = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-P", "-m", "hatchling", "build", "-t", "wheel", "-d", str(out)]
    subprocess.run(command, cwd=submissions.ROOT / "misstep", check=True, capture_output=True)
    return next(out.glob("*.whl"))


@pytest.fixture(scope="session")
def hand_in():
    """A function that hands in a released sheet of a student, with the code that takes the place of each line `name = ...`."""

    def handed_in(course, sheet, student, code):
        notebook = json.loads((course / "exercises" / sheet / f"{sheet}.ipynb").read_text("utf-8"))
        for cell in notebook["cells"]:
            source = "".join(cell["source"]).replace('"your id"', repr(student))
            for name, lines in code.items():
                source = source.replace(f"{name} = ...", lines)
            cell["source"] = source
        file = course / "submissions" / student / f"{sheet}.ipynb"
        file.parent.mkdir(parents=True)
        file.write_text(json.dumps(notebook), "utf-8")

    return handed_in
