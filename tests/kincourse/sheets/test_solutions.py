"""The official solutions solve: each of them, run as it is, has all marks that a check gives."""

import json
from pathlib import Path

import pytest

from kincourse import find_sheet, sheets

SOLUTIONS = Path(__file__).parents[3] / "solutions"


@pytest.mark.parametrize("name", sheets())
def test_every_official_solution_has_full_marks(name):
    """Where a problem is read off a drawing, the solution has what the drawing of SAMPLE_ID shows: update it with the drawing."""
    cells = json.loads((SOLUTIONS / name / f"{name}.ipynb").read_text("utf-8"))["cells"]
    names = {}
    for cell in cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "code" and not source.startswith("sheet.show("):
            exec(source, names)
    verdicts, sheet = names["sheet"].verdicts, find_sheet(name)
    for k, template in enumerate(sheet.problems, start=1):
        assert verdicts[k].judgement.state == ("open" if template.level == "Open" else "right"), template.number
