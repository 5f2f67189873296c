"""IPython for cells outside Jupyter: on a page of the site, and where submissions are graded."""

import builtins
import sys
from types import TracebackType
from typing import Any, ClassVar, Self

from IPython.core.displayhook import DisplayHook
from IPython.core.interactiveshell import InteractiveShell
from traitlets import Type
from traitlets.config import Config


class PublishingDisplayHook(DisplayHook):
    """Publishes the value of a cell's last line like any other display."""

    def write_output_prompt(self) -> None:
        pass

    def write_format_data(self, format_dict: dict[str, Any], md_dict: dict[str, Any] | None = None) -> None:
        InteractiveShell.instance().display_pub.publish(format_dict, md_dict)


class CellShell(InteractiveShell):
    """An IPython shell without a kernel, a window and a keyboard, which passes each error to `report_error`."""

    displayhook_class = Type(PublishingDisplayHook)
    no_input: ClassVar[str] = "input() cannot be used here."
    """The message of the EOFError that `input` raises."""

    @classmethod
    def start(cls) -> Self:
        """Return the only shell of this process. From then on, `input` raises EOFError."""
        shell = cls.instance(config=Config({"HistoryManager": {"enabled": False}}))
        builtins.input = shell.refuse_input
        return shell

    def refuse_input(self, *_: object) -> str:
        """Raise EOFError, because there is no keyboard."""
        raise EOFError(self.no_input)

    def enable_gui(self, gui: str | None = None) -> None:
        """Do nothing, because there is no window."""

    def showtraceback(self, *_: Any, **__: Any) -> None:
        """Pass on the current error, with its traceback from the cell on; that of a syntax error is None.

        IPython would print it in colours, which takes a second for a deep recursion.
        """
        error = sys.exception()
        if error is None:
            return
        trace = error.__traceback__
        while trace and trace.tb_frame.f_globals is not self.user_ns:
            trace = trace.tb_next
        self.report_error(error, trace)

    showsyntaxerror = showindentationerror = showtraceback

    def report_error(self, error: BaseException, trace: TracebackType | None) -> None:
        """Report an error of a cell."""
        raise NotImplementedError
