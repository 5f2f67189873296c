"""What a check is given where the cell of its answer ended with an error: no value of an earlier run, which would be judged."""

import re
import sys
from dataclasses import dataclass
from typing import Any

ANSWER = re.compile(r"^(\w+_\d+)\s*(?::[^=\n]+)?=(?!=)", re.MULTILINE)
"""The name of an answer of a sheet, such as screws_1, where a cell sets it."""


@dataclass(frozen=True)
class FailedAnswer:
    """Takes the place of an answer whose cell ended with an error, of which it has the name and the message."""

    error: str


def replace_failed_answers(result: Any) -> None:
    """Replace the answers that a cell sets, if it ended with an error; IPython calls this with the result of each cell."""
    error = result.error_before_exec or result.error_in_exec
    shell = current_shell()
    if error is None or shell is None:
        return
    for name in ANSWER.findall(result.info.raw_cell):
        shell.user_ns[name] = FailedAnswer(f"{error_name(error)}: {getattr(error, 'msg', None) or error}")


def error_name(error: BaseException) -> str:
    """Return the name of an error that a student can look up: the kinds of SyntaxError have private names in Python 3.13."""
    return "SyntaxError" if isinstance(error, SyntaxError) else type(error).__name__


def watch_cells() -> None:
    """Let IPython replace the answers of cells that end with an error; outside of IPython, do nothing."""
    shell = current_shell()
    if shell is not None and replace_failed_answers not in shell.events.callbacks["post_run_cell"]:
        shell.events.register("post_run_cell", replace_failed_answers)


def current_shell() -> Any:
    """Return the IPython that runs, or None: a sheet also works in a plain interpreter."""
    return sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
