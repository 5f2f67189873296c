"""What a reader has set in a widget survives running its cell again: sliders, placed frames, the step of a player.

A notebook makes a new widget each time a cell is run. JupyterLab, VS Code and JupyterLite name the cell in each request, so a
widget that is made again, in the same cell and from the same data, begins where the reader has left the last one.
"""

import sys
from collections.abc import Sequence
from typing import Any

import traitlets

_kept: dict[tuple[Any, ...], dict[str, Any]] = {}
_made: dict[str, list[Any]] = {}
"""For each cell the request that runs it, and how many widgets it has made."""


def keep_in_cell(widget: traitlets.HasTraits, names: Sequence[str], made_of: Any) -> None:
    """Set the traits as the reader has left them when the cell was last run, and keep their changes from now on.

    If what the widget is made of has changed, nothing is restored; outside of a notebook that names its cells, nothing is kept.
    """
    place = _place()
    if place is None:
        return
    kept = _kept.setdefault((*place, type(widget).__name__, repr(made_of)), {})
    for name, value in kept.items():
        setattr(widget, name, value)
    widget.observe(lambda change: kept.__setitem__(change.name, change.new), list(names))


def _place() -> tuple[str, int] | None:
    """Return the cell that runs, and how many widgets it has made before this one."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    kernel: Any = getattr(shell, "kernel", None)
    request: dict[str, Any] = (kernel.get_parent() if hasattr(kernel, "get_parent") else None) or {}
    cell = request.get("metadata", {}).get("cellId")
    if not cell:
        return None
    run = _made.setdefault(cell, [None, 0])
    if run[0] != request["header"]["msg_id"]:
        run[:] = [request["header"]["msg_id"], 0]
    run[1] += 1
    return cell, run[1]
