"""Run the cells of a submission as a notebook would: IPython, magics, displays, one cell after the other.

The output is one line of JSON for each cell, written as soon as the cell has run: if a later cell ends the process, the
answers before it are already written. The submission's code can write to the same pipe, so its reader trusts no line.
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

SHELL_CONFIG = Config(
    {
        "HistoryManager": {"enabled": False},
    }
)

WARM_UP_CELLS = (
    "import numpy as np\nnp.eye(4)",
    "from IPython.display import Markdown\ndisplay(Markdown('$x$'))\nprint('text')",
    "%time 1 + 1",
    "def fails():\n    1 / 0\nfails()",
    "this is no Python",
    "%matplotlib inline\nimport matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.close('all')",
)

MAX_TRACEBACK_FRAMES = 20
"""How many frames of a traceback are kept, the last ones."""

REPEAT_INTERRUPT_SECONDS = 1.0
"""Seconds after which a cell that caught its interrupt is interrupted again."""

MAX_PRINTED_CHARACTERS = 100_000
"""How many characters of what a cell prints are kept."""


class CellTimeout(BaseException):
    """A cell took too long. It is not an Exception, so that `except Exception` does not catch it."""


class CapturingDisplayHook(DisplayHook):
    """Publishes the value of a cell's last line like any other display."""

    def write_output_prompt(self) -> None:
        pass

    def write_format_data(self, format_dict: dict[str, Any], md_dict: dict[str, Any] | None = None) -> None:
        InteractiveShell.instance().display_pub.publish(format_dict, md_dict)


class SubmissionShell(InteractiveShell):
    """An IPython shell that records displays and errors instead of printing them."""

    displayhook_class = Type(CapturingDisplayHook)
    display_pub_class = Type(CapturingDisplayPublisher)
    errors: Sequence[dict[str, Any]] = ()

    def enable_gui(self, gui: str | None = None) -> None:
        """Do nothing, because there is no window."""

    def showtraceback(self, *_: Any, **__: Any) -> None:
        """Record the current error. IPython's own formatting takes a second for a deep recursion, so it is not used."""
        kind, error, trace = sys.exc_info()
        if kind is None or error is None:
            return
        while trace and not trace.tb_frame.f_code.co_filename.startswith("<ipython-input"):
            trace = trace.tb_next
        lines = "".join(format_exception(kind, error, trace, limit=-MAX_TRACEBACK_FRAMES)).splitlines()
        output = {
            "output_type": "error",
            "ename": kind.__name__[:200],
            "evalue": str(error)[:2000],
            "traceback": [line[:1000] for line in lines],
        }
        self.errors = [*self.errors, output]

    showsyntaxerror = showindentationerror = showtraceback


class TruncatedStream(io.StringIO):
    """A stream that accepts any amount of text and keeps its beginning."""

    def write(self, text: str) -> int:
        if self.tell() < MAX_PRINTED_CHARACTERS:
            super().write(text[: MAX_PRINTED_CHARACTERS - self.tell()])
            if self.tell() >= MAX_PRINTED_CHARACTERS:
                super().write("\n[the rest of this output is left out]\n")
        return len(text)


def new_shell(warm_up: Sequence[str] = ()) -> SubmissionShell:
    """Make the shell that is forked for each submission. It has already run some cells, because first calls are slow."""
    shell = SubmissionShell.instance(config=SHELL_CONFIG)
    builtins.input = _refuse_input
    for source in (*WARM_UP_CELLS, *warm_up):
        _run_cell(shell, source)
    shell.reset(new_session=True)
    return shell


def run_cells(
    shell: SubmissionShell, sources: Sequence[str], seconds: float, report: Callable[[dict[str, Any]], None]
) -> None:
    """Run the cells in order, each for at most so many seconds, and report the outputs of each."""
    signal.signal(signal.SIGALRM, _interrupt)
    for number, source in enumerate(sources):
        signal.setitimer(signal.ITIMER_REAL, seconds, REPEAT_INTERRUPT_SECONDS)
        try:
            outputs = _run_cell(shell, source)
        except CellTimeout:  # the signal arrived outside of the cell's own code
            outputs = []
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
        report({"cell": number, "outputs": outputs})


def _run_cell(shell: SubmissionShell, source: str) -> list[dict[str, Any]]:
    publisher = cast("CapturingDisplayPublisher", shell.display_pub)
    publisher.outputs, shell.errors = [], []
    captured = {"stdout": TruncatedStream(), "stderr": TruncatedStream()}
    originals = sys.stdout, sys.stderr
    sys.stdout, sys.stderr = captured.values()
    try:
        shell.run_cell(source, store_history=False)
    finally:
        sys.stdout, sys.stderr = originals
    streams = [
        {"output_type": "stream", "name": name, "text": text}
        for name, stream in captured.items()
        if (text := stream.getvalue())
    ]
    displays = [{"output_type": "display_data", "metadata": {}, "data": output["data"]} for output in publisher.outputs]
    return [*streams, *displays, *shell.errors]


def encode_line(record: Mapping[str, Any]) -> bytes:
    """One line of JSON. Outputs that JSON cannot hold are left out."""
    try:
        text = json.dumps(record, allow_nan=False, skipkeys=True, ensure_ascii=False)
    except (TypeError, ValueError, RecursionError):
        text = json.dumps({**record, "outputs": []})
    return text.encode(errors="replace") + b"\n"


def write_all(descriptor: int, data: bytes) -> None:
    """Write all of the data to a descriptor, in as many steps as it takes."""
    while data:
        data = data[os.write(descriptor, data) :]


def _interrupt(*_: Any) -> None:
    raise CellTimeout("This cell took too long and was interrupted. Does it contain an endless loop?")


def _refuse_input(*_: object) -> str:
    raise EOFError("input() cannot be used while a sheet is graded. Write the value into the cell instead.")
