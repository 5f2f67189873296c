"""`kincourse new-lecture` writes a lecture that passes the tests of the repository, and refuses what is no lecture."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from kincourse.new_lecture import new_lecture
from kincourse.table_of_lectures import in_words, lectures

ROOT = Path(__file__).parents[2]
PARTS = "kinlib misstep kincourse notebooks solutions exercises tests tools evidence paper site/pages site/kinsite"
FILES = ("README.md", "pyproject.toml", "conftest.py", "course.py")
TESTS = (
    *("tests/kincourse/test_lecture_folders.py", "tests/kincourse/test_lecture_questions.py"),
    *(
        "tests/kincourse/test_giveaways.py",
        "tests/kincourse/answers",
        "tests/kincourse/sheets/test_sheets.py",
        "tests/kincourse/sheets/test_exercises.py",
    ),
    *("tests/repository/test_notebooks.py", "tests/evidence/test_formulas.py", "tests/evidence/test_prose.py"),
    *("kincourse/lecture_11_dynamics", "notebooks/11_dynamics.ipynb", "solutions/11_dynamics/11_dynamics.ipynb"),
)


def test_a_new_lecture_is_found_everywhere_and_passes_the_tests_at_once(tmp_path):
    """In a copy of the repository, because the lecture is written beside the others."""
    ignored = shutil.ignore_patterns("__pycache__", ".ipynb_checkpoints")
    for part in PARTS.split():
        shutil.copytree(ROOT / part, tmp_path / part, ignore=ignored)
    for file in FILES:
        shutil.copy(ROOT / file, tmp_path)

    def run(*arguments):
        environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
        command = [sys.executable, "-m", *arguments]
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout[-6000:] + done.stderr[-2000:]
        return done.stdout

    run("kincourse", "new-lecture", "11_dynamics", "Dynamics", "Which torques move an arm?")
    readme = (tmp_path / "README.md").read_text("utf-8")
    assert f"It has {in_words(len(lectures()) + 1)} lectures" in readme
    assert (
        "| [11 Dynamics](notebooks/11_dynamics.ipynb) | Which torques move an arm? | [1 problem](exercises/" in readme
    )
    for check in (["ruff", "check"], ["ruff", "format", "--check"]):
        run(*check, "kincourse/lecture_11_dynamics", "notebooks/11_dynamics.ipynb", "solutions/11_dynamics")
    chosen = "11_dynamics or 11/ or 11- or 11.1 or 11.a or test_lecture or cells_and_its_points or stated_times"
    passed = run("pytest", "-q", "-n0", "-p", "no:cacheprovider", *TESTS, "-k", chosen)
    assert int(passed.rpartition(" passed")[0].split()[-1]) > 25


def test_a_wrong_name_is_refused():
    for name, title, says in [
        (
            "11-dynamics",
            "Dynamics",
            "two digits, a letter if .* such as 11_dynamics or 11b_dynamics; got '11-dynamics'",
        ),
        ("03_again", "Again", "03 is that of lecture_03_poe_space"),
        ("11_dynamics", 'The "first"', "one line of text without quotes"),
    ]:
        with pytest.raises(ValueError, match=says):
            new_lecture(name, title, "Why?", ROOT)
