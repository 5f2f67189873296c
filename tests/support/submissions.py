"""Submissions to grade: sheets as Jupyter saves them after all cells were run, made without a kernel."""

import json
import zipfile
from copy import deepcopy
from functools import cache
from io import BytesIO
from pathlib import Path

from kincourse import open_sheet
from misstep.storage import MIME

ROOT = Path(__file__).parents[2]
SHEET = "01_frames"
NAME = f"{SHEET}.ipynb"
OPEN = 11
"""The number of the open problem of this sheet."""

opened = cache(open_sheet)


def released(name=SHEET):
    """The sheet as students get it."""
    return json.loads((ROOT / "exercises" / name / f"{name}.ipynb").read_text("utf-8"))


@cache
def _answered(student, wrong, skip, name, text):
    notebook, sheet = released(name), opened(name, student)
    for count, cell in enumerate((cell for cell in notebook["cells"] if cell["cell_type"] == "code"), start=1):
        kind, _, number = cell["id"].partition("-")
        if kind == "check" and int(number) in skip:
            continue
        cell["execution_count"] = count
        cell["source"] = "".join(cell["source"]).replace("your id", student)
        if kind == "check":
            problem = sheet.problem(int(number))
            value = problem.known_mistakes[0].value if int(number) in wrong else problem.answer.value
            value = None if int(number) == OPEN and not text else value
            bundle = sheet.check(int(number), value)._repr_mimebundle_()
            cell["outputs"] = [
                {"output_type": "execute_result", "data": bundle, "metadata": {}, "execution_count": count}
            ]
    return notebook


def answered(student, wrong=(), skip=(), name=SHEET, text=False):
    """A sheet with right answers, with one of the known mistakes in the problems `wrong`, and without running those in `skip`.

    text  whether the open problem is answered too
    """
    return deepcopy(_answered(student, tuple(wrong), tuple(skip), name, text))


def emissions(notebook):
    """The stored answers of a notebook, which may be changed in place."""
    return [
        output["data"][MIME]
        for cell in notebook["cells"]
        for output in cell.get("outputs", [])
        if MIME in output.get("data", {})
    ]


def as_bytes(notebook):
    return notebook if isinstance(notebook, bytes) else json.dumps(notebook, indent=1).encode()


def write(folder, **files):
    """Write files below a folder, each newer than the one before; a path has __ for a slash."""
    for name, content in files.items():
        path = folder / name.replace("__", "/")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(as_bytes(content))
    return folder


def zipped(members):
    """The bytes of a zip file."""
    buffer = BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, as_bytes(content))
    return buffer.getvalue()
