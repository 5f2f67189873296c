"""Notebooks as they come out of a cold kernel, kept until the notebook, kinlib or what kinlib stands on changes.

Only outputs are kept: words between the cells may change, and nothing runs again.
"""

import hashlib
import json
import os
import re
import subprocess
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from functools import cache
from importlib.metadata import version
from pathlib import Path
from platform import python_version
from typing import Any

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode

from kinlib.view.drawing.static_export import ENVIRONMENT_VARIABLE

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "build" / "executed"
UNDER = ("anywidget", "ipykernel", "ipywidgets", "matplotlib", "mpmath", "numpy", "sympy", "traitlets")
"""What can change an output although no line of ours has changed."""

PACKAGES = ("kinlib", "misstep", "kincourse")
"""The packages of this repository, each with a pyproject.toml of its own."""

NOT_IN_NOTEBOOKS = ("misstep/grading/", "misstep/release/", "kinlib/view/js/")
"""Folders of the packages that no notebook loads."""

KEY = 16
"""Letters of the names by which outputs are kept."""

SECONDS = 120
"""How long a cell may take. Students wait for less, and another test sees to that; builds run on busy machines."""


class NotebookRaised(Exception):
    """A notebook of the course that does not run without a complaint."""


def execute_all(paths: Iterable[Path], kept: Path = KEPT) -> dict[Path, NotebookNode]:
    """Execute notebooks two at a time, those that are kept not at all.

    Raises NotebookRaised that names the notebook and the cell, for the first one that raises or complains.
    """
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as pool:
        paths = list(paths)
        return dict(zip(paths, pool.map(lambda path: execute(path, kept), paths), strict=True))


def execute(path: Path, kept: Path = KEPT) -> NotebookNode:
    """Execute one notebook, or take the outputs that its cells gave last time.

    Raises NotebookRaised that names the notebook and the cell.
    """
    notebook: NotebookNode = nbformat.read(path, as_version=4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    name = f"{path.relative_to(ROOT).parts[0]}-{path.stem}"  # a lecture and its sheet are called alike
    found = kept / f"{name}-{key(cell.source for cell in code)}.json"
    if not found.exists():
        # a copy runs: what a kernel writes beside the outputs would make the page another one than the next time
        ran = deepcopy(notebook)
        run(ran, path)
        keep(found, [cell.outputs for cell in ran.cells if cell.cell_type == "code"], name)
    kept_outputs = json.loads(found.read_text("utf-8"))
    for number, (cell, outputs) in enumerate(zip(code, kept_outputs, strict=True), start=1):
        cell.outputs = [nbformat.from_dict(output) for output in outputs]
        cell.execution_count = number
    return notebook


def made(name: str, make: Callable[[], Iterable[tuple[str, str]]], *sources: str) -> dict[str, str]:
    """Pages that are made from kinlib, or those that were made last time from the same.

    sources  what else they depend on
    """
    found = KEPT / f"{name}-{key(sources)}.json"
    if not found.exists():
        keep(found, dict(make()), name)
    pages: dict[str, str] = json.loads(found.read_text("utf-8"))
    return pages


def keep(path: Path, data: Any, name: str) -> None:
    """Write what was made, at once, so that nobody reads half of it; what was kept of the same name goes."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(f".{os.getpid()}")
    part.write_text(json.dumps(data), "utf-8")
    part.replace(path)
    for old in path.parent.glob(f"{name}-{'?' * KEY}.json"):
        if old != path:
            old.unlink(missing_ok=True)


def run(notebook: NotebookNode, path: Path) -> None:
    """Run a notebook in a cold kernel that knows that its outputs are for a page."""
    client = NotebookClient(notebook, timeout=SECONDS, resources={"metadata": {"path": path.parent}})
    try:
        # What the kernel itself has to say while it starts is not for whoever builds; what cells say is among the outputs.
        client.execute(env={**os.environ, ENVIRONMENT_VARIABLE: "1"}, stderr=subprocess.DEVNULL)
    except CellExecutionError as error:
        raise NotebookRaised(f"{path.relative_to(ROOT)} raises:\n{plain(str(error))}") from None
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            if output.get("name") == "stderr":
                raise NotebookRaised(f"{path.relative_to(ROOT)}, cell {cell.id!r}, complains:\n{plain(output.text)}")


def key(sources: Iterable[str]) -> str:
    """What the outputs of these cells depend on, as one short name."""
    return hashlib.sha256("\0".join([library(), *sources]).encode()).hexdigest()[:KEY]


@cache
def library() -> str:
    """Hash the packages of the course and the versions of what they depend on: any change of a file changes the hash."""
    digest = hashlib.sha256(python_version().encode() + Path(__file__).read_bytes())
    for name in UNDER:
        digest.update(f"{name} {version(name)}\0".encode())
    for path in sorted(path for package in PACKAGES for path in (ROOT / package).rglob("*")):
        inside = path.relative_to(ROOT).as_posix()
        if path.suffix in (".py", ".toml", ".js") and not inside.startswith(NOT_IN_NOTEBOOKS):
            digest.update(inside.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def plain(text: str) -> str:
    """A traceback without the colours of a terminal."""
    return re.sub(r"\x1b\[[\d;]*m", "", text)
