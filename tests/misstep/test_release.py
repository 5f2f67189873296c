"""`misstep release`: the students' notebooks, made from the instructors' notebooks."""

import numpy as np
import pytest

from misstep.answers.number import Numbers
from misstep.cli import main
from misstep.problem import Problem, problem
from misstep.release.instructor_notebook import Entry, notebook
from misstep.sheet import Sheet

pytest.importorskip("nbgrader", reason="students' notebooks are made with nbgrader")


@problem("01.1", "A current", points=2, lecture="01_ohm#Currents")
def current(sampler):
    return Problem("Give it.", Numbers(np.array(1.0)), [])


SHEET = Sheet("01_ohm", "Ohm's law", [current])
ENTRY = Entry("current", "In amperes.", "current_1 = 6 / 6")


@pytest.fixture
def source(tmp_path):
    """An instructor's notebook below tmp_path / "solutions"."""
    path = tmp_path / "solutions" / "01" / "01.ipynb"
    path.parent.mkdir(parents=True)
    path.write_text(notebook(SHEET, [ENTRY], "About currents.", "import numpy as np"), encoding="utf-8")
    return path


@pytest.mark.usefixtures("source")
def test_a_stale_notebook_is_listed_and_written_without_the_solution(tmp_path, capsys):
    root = ["--root", str(tmp_path)]
    target = tmp_path / "exercises" / "01" / "01.ipynb"
    assert main(["release", "--check", *root]) == 1
    assert capsys.readouterr().out.startswith("stale")
    assert main(["release", *root]) == 0
    assert capsys.readouterr().out.startswith("written")
    assert main(["release", "--check", *root]) == 0
    released = target.read_text("utf-8")
    assert "6 / 6" not in released
    assert "current_1 = ..." in released
    target.write_text(released.replace("your lines here", "no"), encoding="utf-8")
    assert main(["release", "--check", *root]) == 1


def test_a_folder_without_solutions_is_refused(tmp_path, capsys):
    assert main(["release", "--root", str(tmp_path)]) == 2
    assert "no solutions" in capsys.readouterr().err
    with pytest.raises(ValueError, match="longer"):
        notebook(SHEET, [ENTRY, ENTRY], "", "")
