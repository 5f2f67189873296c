"""What a check is given for an answer that its cell has not set, because the value of an earlier run would be judged otherwise."""

import re
import sys
from dataclasses import dataclass
from typing import Any

ANSWER = re.compile(r"^(\w+_\d+)\s*(?::[^=\n]+)?=(?!=)", re.MULTILINE)
"""The name of an answer of a sheet, such as screws_1, where a cell sets it."""


_answers: dict[str, dict[str, Any]] = {}
"""For each cell that has run, the answers that it has set."""


@dataclass(frozen=True)
class FailedAnswer:
    """Takes the place of an answer that its cell has not set, and says why."""

    why: str


def replace_failed_answers(result: Any) -> None:
    """Replace the answers that a cell sets, if it ended with an error, and those that it has set before and does not set now.

    IPython calls this with the result of each cell.
    """
    shell, error = current_shell(), result.error_before_exec or result.error_in_exec
    if shell is None:
        return
    names = ANSWER.findall(result.info.raw_cell)
    if error:
        told = f"{error_name(error)}: {getattr(error, 'msg', None) or error}"
        failed = FailedAnswer(
            f"The cell with this answer ended with an error ({told}), so there is no answer to check."
        )
        shell.user_ns.update(dict.fromkeys(names, failed))
    if cell := result.info.cell_id:
        for name, value in _answers.get(cell, {}).items():
            if name not in names and shell.user_ns.get(name) is value:
                shell.user_ns[name] = FailedAnswer(
                    f"Your lines do not set `{name}` any more. Give your answer this name."
                )
        _answers[cell] = {name: shell.user_ns.get(name) for name in names}


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
