"""Run the cells of a page in IPython, and report each output as soon as it exists. worker.js loads this file in Pyodide."""

import io
import json
import logging
import os
import sys
import time
from collections.abc import Callable
from traceback import format_exception
from types import TracebackType
from typing import Any

os.environ["NOTEBOOK_STATIC_PAGE"] = "1"  # questions, sliders and viewers in the form that the page's own scripts run
os.environ["MPLBACKEND"] = "agg"
sys.modules["jedi"] = None  # type: ignore[assignment]  # only completion needs it, and its import takes a second
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)  # "building the font cache"

from IPython.core.displaypub import DisplayPublisher  # noqa: E402
from traitlets import Type  # noqa: E402

from misstep.display.shell import CellShell  # noqa: E402

Report = Callable[[str], None]

FLUSH_S = 0.1
"""How long printed text is collected before it is reported."""


def report(**output: Any) -> None:
    """Report an output to the page, after what was printed before it. `post` is a function of worker.js."""
    for stream in (sys.stdout, sys.stderr):
        stream.flush()
    post(json.dumps(output, default=str))  # type: ignore[name-defined]  # noqa: F821


class PageStream(io.TextIOBase):
    """A stream that reports its text."""

    def __init__(self, name: str) -> None:
        self.name, self.text, self.reported = name, "", 0.0

    def write(self, text: str) -> int:
        self.text += text
        if time.monotonic() - self.reported > FLUSH_S:
            self.flush()
        return len(text)

    def flush(self) -> None:
        text, self.text, self.reported = self.text, "", time.monotonic()
        if text:
            post(json.dumps({"kind": "stream", "name": self.name, "text": text}))  # type: ignore[name-defined]  # noqa: F821


class PagePublisher(DisplayPublisher):
    """Reports what a cell displays."""

    def publish(self, data: dict[str, Any], metadata: Any = None, source: Any = None, **_: Any) -> None:
        report(kind="display", data=data)


class PageShell(CellShell):
    """An IPython shell whose displays and errors are reported to the page."""

    display_pub_class = Type(PagePublisher)
    no_input = "input() cannot ask on this page. Write the value into the cell, for example name = 'Ada'."

    def report_error(self, error: BaseException, trace: TracebackType | None) -> None:
        """Report an error: its text, the line of the cell that led to it, and the traceback from there on."""
        own, frame = trace, trace
        while frame:
            own, frame = (frame if frame.tb_frame.f_globals is self.user_ns else own), frame.tb_next
        report(
            kind="error",
            name=type(error).__name__,
            text=getattr(error, "msg", "") or str(error),
            line=own.tb_lineno if own else getattr(error, "lineno", None),
            traceback="".join(format_exception(type(error), error, trace)),
        )


def display_figures() -> None:
    """Display the figures of pyplot that are open, and close them, as a notebook does at the end of a cell."""
    if pyplot := sys.modules.get("matplotlib.pyplot"):
        for number in pyplot.get_fignums():
            shell.display_pub.publish({"image/svg+xml": save_as_svg(pyplot.figure(number))})
        pyplot.close("all")


def save_as_svg(figure: Any) -> str:
    """Save a figure of pyplot as SVG."""
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches="tight")
    return text.getvalue()


async def run(source: str) -> None:
    """Run one cell; its outputs are reported while it runs."""
    await shell.run_cell_async(source, transformed_cell=shell.transform_cell(source))
    display_figures()
    report(kind="end")


shell = PageShell.start()
sys.stdout, sys.stderr = PageStream("stdout"), PageStream("stderr")
