"""What viewers and films share: the script of the page, a cover until a prediction is committed, and what the reader has set.

A notebook makes a new widget each time a cell is run. JupyterLab, VS Code and JupyterLite name the cell in each request, so a
widget that is made again, in the same cell and from the same data, begins where the reader has left the last one.
"""

import base64
import html
import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from kinlib.view.drawing.picture import is_without_kernel

STATIC = Path(__file__).parents[1] / "static"
"""The bundle viewer.js, built from kinlib/view/js by `npm run build`, and loader.js, which loads it if a page has a viewer."""

COVER_TEXT = "Commit to your prediction first; then the picture appears here."

_kept: dict[tuple[str, ...], dict[str, Any]] = {}
"""What readers have set, by cell, kind and data of the widget."""


class Covered(anywidget.AnyWidget):
    """The base of viewers and films.

    covered  whether the picture is covered until the question given as `after` is committed

    made_of is the data of which the widget is made: if the cell is run again with the same, the widget is shown as the reader has
    left it; outside of a notebook that names its cells, nothing is kept.
    """

    # The bundle defines one global object, so that a page without modules can run it too; a widget needs a default export.
    _esm = (STATIC / "viewer.js").read_text("utf-8") + "\nexport default kinlib.widget;"

    covered = traitlets.Bool(False).tag(sync=True)
    set_by_reader: Sequence[str] = ()
    """The traits that survive running the cell again."""

    def __init__(self, made_of: Any, *, after: Any = None, **traits: Any) -> None:
        super().__init__(**traits)
        if cell := _cell():
            kept = _kept.setdefault((cell, type(self).__name__, repr(made_of)), {})
            for name, value in kept.items():
                setattr(self, name, value)
            self.observe(lambda change: kept.__setitem__(change.name, change.new), list(self.set_by_reader))
        self._after = ""  # the name of the question that uncovers the picture; the page has that question too
        if after is not None and not after.committed:
            self.covered = True
            self._after = getattr(after, "name", "")
            after.observe(lambda _: self.set_trait("covered", False), "committed")

    @property
    def alt(self) -> str:
        """The text alternative of what is shown."""
        raise NotImplementedError

    def html(self, whole: bool = True) -> str:
        """Return the widget for a page without a kernel."""
        raise NotImplementedError

    def on_page(self, kind: str, state: Mapping[str, Any], drawing: str) -> str:
        """Return the element of a viewer or a film: its state as JSON, and the drawing that loader.js replaces, or its cover."""
        if self.covered and is_without_kernel():  # a click opens it
            drawing = f"<details><summary>{COVER_TEXT}</summary>{drawing}</details>"
        elif self.covered:
            drawing = f"<p>{COVER_TEXT}</p>"
        after = f' data-kinlib-after="{html.escape(self._after)}"' if self._after else ""
        return f"<div data-kinlib-{kind}{after}>{as_script(state)}<div data-kinlib-drawing>{drawing}</div></div>"

    def _repr_mimebundle_(self, **options: Any) -> Any:
        data, metadata = super()._repr_mimebundle_(**options) or ({}, {})
        # A notebook with a kernel need not save the megabytes of meshes as HTML too.
        return {**data, "text/plain": self.alt, "text/html": self.html(whole=is_without_kernel())}, metadata


def _cell() -> str:
    """Return the cell that runs, or ""."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    kernel: Any = getattr(shell, "kernel", None)
    request: dict[str, Any] = (kernel.get_parent() if hasattr(kernel, "get_parent") else None) or {}
    return request.get("metadata", {}).get("cellId") or ""


def as_script(state: Mapping[str, Any]) -> str:
    """Return the state of a widget as JSON in an element of HTML, from which a script on the page reads it."""
    data = json.dumps(
        state, separators=(",", ":"), allow_nan=False, default=lambda data: base64.b64encode(data).decode()
    )
    # a "<" could end the script or begin another one; JSON allows this escape for it
    safe = data.replace("<", "\\u003c")
    return f'<script type="application/json">{safe}</script>'
