"""Running the cells of a submission as a notebook would: IPython, magics, displays, one cell after the other.

What comes out is a line of JSON for each cell, as soon as the cell has run: if a later one ends the process, the answers
before it are out. All of it is in the hands of the code that runs, and whoever reads it knows that.
"""

import builtins
import io
import json
import os
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from traceback import format_exception
from typing import Any, cast

from IPython.core.displayhook import DisplayHook
from IPython.core.displaypub import CapturingDisplayPublisher
from IPython.core.interactiveshell import InteractiveShell
from traitlets import Type
from traitlets.config import Config

SETTINGS = Config(
    {
        "HistoryManager": {"enabled": False},
    }
)

FIRST_CELLS = (
    "import numpy as np\nnp.eye(4)",
    "from IPython.display import Markdown\ndisplay(Markdown('$x$'))\nprint('text')",
    "%time 1 + 1",
    "def fails():\n    1 / 0\nfails()",
    "this is no Python",
    "%matplotlib inline\nimport matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.close('all')",
)

DEEPEST = 20
"""So many calls of an error's trace are kept, the last ones."""

AGAIN = 1.0
"""Seconds after which a cell that swallowed its interrupt is interrupted again."""

PRINTED = 100_000
"""So many characters of what a cell prints are kept."""


class CellLimit(BaseException):
    """A cell took too long. Not an Exception, so that `except Exception` does not swallow it."""


class Hook(DisplayHook):
    """The value of a cell's last line goes where all displays go."""

    def write_output_prompt(self) -> None:
        pass

    def write_format_data(self, format_dict: dict[str, Any], md_dict: dict[str, Any] | None = None) -> None:
        InteractiveShell.instance().display_pub.publish(format_dict, md_dict)


class Shell(InteractiveShell):
    """IPython that remembers displays and errors in place of printing them."""

    displayhook_class = Type(Hook)
    display_pub_class = Type(CapturingDisplayPublisher)
    errors: Sequence[dict[str, Any]] = ()

    def enable_gui(self, gui: str | None = None) -> None:
        """Nobody looks: there is no window to care for."""

    def showtraceback(self, *_: Any, **__: Any) -> None:
        """Remember the error that is being handled. IPython's own words for it take a second where recursion ran deep."""
        kind, error, trace = sys.exc_info()
        if kind is None or error is None:
            return
        while trace and not trace.tb_frame.f_code.co_filename.startswith("<ipython-input"):
            trace = trace.tb_next
        lines = "".join(format_exception(kind, error, trace, limit=-DEEPEST)).splitlines()
        name, value = kind.__name__[:200], str(error)[:2000]
        told = {"output_type": "error", "ename": name, "evalue": value, "traceback": [line[:1000] for line in lines]}
        self.errors = [*self.errors, told]

    showsyntaxerror = showindentationerror = showtraceback


class Bounded(io.StringIO):
    """A stream that takes everything and keeps the beginning."""

    def write(self, text: str) -> int:
        if self.tell() < PRINTED:
            super().write(text[: PRINTED - self.tell()])
            if self.tell() >= PRINTED:
                super().write("\n[the rest is left out]\n")
        return len(text)


def new_shell(warm_up: Sequence[str] = ()) -> Shell:
    """A shell, made once and forked for each submission. It has run a few cells, for first times are slow."""
    shell = Shell.instance(config=SETTINGS)
    builtins.input = _nobody_answers
    for source in (*FIRST_CELLS, *warm_up):
        _run(shell, source)
    shell.reset(new_session=True)
    return shell


def run_cells(shell: Shell, sources: Sequence[str], seconds: float, tell: Callable[[dict[str, Any]], None]) -> None:
    """Run the cells in order, each for so many seconds, and tell what each gave."""
    signal.signal(signal.SIGALRM, _interrupt)
    for number, source in enumerate(sources):
        signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
        try:
            outputs = _run(shell, source)
        except CellLimit:  # it came between two steps of ours
            outputs = []
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
        tell({"cell": number, "outputs": outputs})


def _run(shell: Shell, source: str) -> list[dict[str, Any]]:
    publisher = cast("CapturingDisplayPublisher", shell.display_pub)
    publisher.outputs, shell.errors = [], []
    printed = {"stdout": Bounded(), "stderr": Bounded()}
    kept = sys.stdout, sys.stderr
    sys.stdout, sys.stderr = printed.values()
    try:
        shell.run_cell(source, store_history=False)
    finally:
        sys.stdout, sys.stderr = kept
    streams = [
        {"output_type": "stream", "name": name, "text": text}
        for name, stream in printed.items()
        if (text := stream.getvalue())
    ]
    displays = [{"output_type": "display_data", "metadata": {}, "data": output["data"]} for output in publisher.outputs]
    return [*streams, *displays, *shell.errors]


def line(told: Mapping[str, Any]) -> bytes:
    """One line of JSON for a cell; outputs that JSON cannot hold are left out."""
    try:
        text = json.dumps(told, allow_nan=False, skipkeys=True, ensure_ascii=False)
    except (TypeError, ValueError, RecursionError):
        text = json.dumps({**told, "outputs": []})
    return text.encode(errors="replace") + b"\n"


def write(descriptor: int, data: bytes) -> None:
    """Write all of it."""
    while data:
        data = data[os.write(descriptor, data) :]


def _interrupt(*_: Any) -> None:
    raise CellLimit("This cell took too long, and was interrupted. Does a loop never end?")


def _nobody_answers(*_: object) -> str:
    raise EOFError("input() has nobody to answer it while a sheet is graded. Give the value in the cell.")
