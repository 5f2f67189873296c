"""Execute the notebooks in new kernels, and cache their outputs until the code in their cells or a package changes.

Only outputs are cached: a change of the text between the cells does not execute a notebook again.
"""

import hashlib
import json
import os
import re
import subprocess
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from functools import cache
from importlib.metadata import version
from pathlib import Path
from platform import python_version

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode
from tqdm import tqdm

from kinlib.view.drawing.picture import ENVIRONMENT_VARIABLE

ROOT = Path(__file__).resolve().parents[2]
CACHE = ROOT / "build" / "executed"

PACKAGES = ("kinlib", "misstep", "kincourse")
"""The packages of this repository."""

NOT_IN_NOTEBOOKS = ("misstep/grading/", "misstep/release/", "kinlib/view/js/")
"""Folders of the packages that no notebook loads."""

DEPENDENCIES = ("anywidget", "ipykernel", "ipywidgets", "matplotlib", "mpmath", "numpy", "sympy", "traitlets")
"""Packages of others whose version can change an output."""

HASH_LENGTH = 16
"""Characters of the hash in the name of a cached file."""

TIMEOUT_S = 1200
"""How long a cell may run. It is much more than a student waits, because builds run on busy machines."""


class NotebookError(Exception):
    """A cell of a notebook raises, or writes to stderr."""


def execute_all(paths: Iterable[Path]) -> dict[Path, NotebookNode]:
    """Execute notebooks, as many at a time as there are processors.

    Raises NotebookError with the name of the notebook and the cell, for the first cell that raises or writes to stderr.
    """
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as pool:
        paths = list(paths)
        return dict(zip(paths, tqdm(pool.map(execute, paths), "Notebooks", len(paths)), strict=True))


def execute(path: Path, folder: Path = CACHE) -> NotebookNode:
    """Execute one notebook, or read its outputs from the folder of cached outputs.

    Raises NotebookError with the name of the notebook and the cell.
    """
    notebook: NotebookNode = nbformat.read(path, as_version=4)
    cached = cache_path(notebook, path, folder)
    if not cached.exists():
        # execute a copy: a kernel writes more than outputs into a notebook, so the page would differ from the next build's
        executed = deepcopy(notebook)
        run(executed, path)
        cache_outputs(executed, path, folder)
    kept = nbformat.from_dict(json.loads(cached.read_text("utf-8")))
    for number, (cell, outputs) in enumerate(zip(code_cells(notebook), kept, strict=True), start=1):
        cell.outputs, cell.execution_count = outputs, number
    return notebook


def code_cells(notebook: NotebookNode) -> list[NotebookNode]:
    """List the cells of a notebook that are executed."""
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def cache_path(notebook: NotebookNode, path: Path, folder: Path) -> Path:
    """Name the file of the outputs of a notebook. A lecture and its sheet have the same file name, in other folders."""
    sources = "\0".join([package_hash(), *(cell.source for cell in code_cells(notebook))])
    name = hashlib.sha256(sources.encode()).hexdigest()[:HASH_LENGTH]
    return folder / f"{path.relative_to(ROOT).parts[0]}-{path.stem}-{name}.json"


def cache_outputs(executed: NotebookNode, path: Path, folder: Path = CACHE) -> None:
    """Cache the outputs of a notebook that was executed with ENVIRONMENT_VARIABLE set, and delete older ones.

    The file is written in one step, so that nothing reads half of it.
    """
    outputs = [cell.outputs for cell in code_cells(executed)]
    file = cache_path(executed, path, folder)
    folder.mkdir(parents=True, exist_ok=True)
    part = file.with_suffix(f".{os.getpid()}")
    part.write_text(json.dumps(outputs), "utf-8")
    part.replace(file)
    for old in folder.glob(f"{file.stem[:-HASH_LENGTH]}{'?' * HASH_LENGTH}.json"):
        if old != file:
            old.unlink(missing_ok=True)


def run(notebook: NotebookNode, path: Path) -> None:
    """Run a notebook in a new kernel, in which figures and viewers write their static form."""
    place, name = {"metadata": {"path": path.parent}}, path.relative_to(ROOT)
    client = NotebookClient(notebook, timeout=TIMEOUT_S, startup_timeout=TIMEOUT_S, resources=place)
    try:
        # only what cells write to stderr matters, and that is among their outputs: hide what the kernel writes at its start
        client.execute(env={**os.environ, ENVIRONMENT_VARIABLE: "1"}, stderr=subprocess.DEVNULL)
    except CellExecutionError as error:
        raise NotebookError(f"{name} raises:\n{without_colours(str(error))}") from None
    for cell in code_cells(notebook):
        if wrong := [output.text for output in cell.outputs if output.get("name") == "stderr"]:
            raise NotebookError(f"{name}, cell {cell.id!r}, writes to stderr:\n{without_colours(wrong[0])}")


@cache
def package_hash() -> str:
    """Hash the packages of the course and the versions of what they depend on: any change of a file changes the hash."""
    digest = hashlib.sha256(python_version().encode() + Path(__file__).read_bytes())
    for name in DEPENDENCIES:
        digest.update(f"{name} {version(name)}\0".encode())
    for path in sorted(path for package in PACKAGES for path in (ROOT / package).rglob("*")):
        inside = path.relative_to(ROOT).as_posix()
        if path.suffix in (".py", ".toml", ".js") and not inside.startswith(NOT_IN_NOTEBOOKS):
            digest.update(inside.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def without_colours(text: str) -> str:
    """Remove a terminal's colour codes from a traceback."""
    return re.sub(r"\x1b\[[\d;]*m", "", text)
