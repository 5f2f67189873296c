"""Handing out: exercises/ is what solutions/ releases, and nothing of a solution is in it."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("nbgrader", reason="exercises/ is made with nbgrader")

ROOT = Path(__file__).parents[1]
SOURCES = sorted((ROOT / "solutions").glob("*/*.ipynb"))


def command(*options):
    run = [sys.executable, "-m", "kinlib.practice.handout", *options]
    return subprocess.run(run, capture_output=True, text=True, check=False)


def test_every_sheet_in_exercises_is_fresh():
    done = command("--check", "--root", str(ROOT))
    assert done.returncode == 0, f"run python -m kinlib.practice.handout\n{done.stdout}{done.stderr}"


def test_a_changed_source_is_noticed_and_written(tmp_path):
    source = tmp_path / "solutions" / "03" / "03.ipynb"
    source.parent.mkdir(parents=True)
    source.write_bytes(SOURCES[0].read_bytes())
    target = tmp_path / "exercises" / "03" / "03.ipynb"
    assert command("--check", "--root", str(tmp_path)).returncode == 1
    assert command("--root", str(tmp_path)).stdout.startswith("written")
    assert command("--check", "--root", str(tmp_path)).returncode == 0
    target.write_text(target.read_text(encoding="utf-8").replace("your lines here", "no"), encoding="utf-8")
    assert command("--check", "--root", str(tmp_path)).returncode == 1


def test_a_folder_without_solutions_is_refused(tmp_path):
    done = command("--root", str(tmp_path))
    assert done.returncode == 2
    assert "no solutions" in done.stderr


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.stem)
def test_no_line_of_a_solution_is_handed_out(source):
    released = (ROOT / "exercises" / source.relative_to(ROOT / "solutions")).read_text(encoding="utf-8")
    hidden = []
    for cell in json.loads(source.read_text(encoding="utf-8"))["cells"]:
        text = "".join(cell["source"])
        if "### BEGIN SOLUTION" in text:
            hidden += text.split("### BEGIN SOLUTION")[1].split("### END SOLUTION")[0].strip().splitlines()
    assert len(hidden) >= 6
    assert not [line for line in hidden if len(line.strip()) > 12 and line.strip() in released]
