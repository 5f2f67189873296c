"""Each lecture has one folder with its files, and the docstring of the folder names its notebooks."""

import importlib
import re
from pathlib import Path

import pytest

from kincourse import COURSE, sheets

ROOT = Path(__file__).parents[2]
FOLDERS = sorted(COURSE.folder.glob("lecture_*"))


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_a_lecture_folder_holds_its_files_and_names_its_notebooks(folder):
    name = folder.name.removeprefix("lecture_")
    assert (folder / "blanks.py").is_file()
    assert (folder / "questions.toml").is_file()
    assert (folder / "problems.py").is_file() == (name in sheets())
    paths = re.findall(r"\S+\.ipynb", importlib.import_module(f"kincourse.{folder.name}").__doc__)
    expected = [f"notebooks/{name}.ipynb"]
    if name in sheets():
        expected += [f"solutions/{name}/{name}.ipynb", f"exercises/{name}/{name}.ipynb"]
    assert paths == expected
    assert all((ROOT / path).is_file() for path in paths)


def test_every_lecture_has_a_folder():
    notebooks = {path.stem for path in (ROOT / "notebooks").glob("[0-9]*.ipynb")}
    assert {folder.name.removeprefix("lecture_") for folder in FOLDERS} == notebooks
