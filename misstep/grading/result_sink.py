"""The desk: where a result goes as soon as it is there, to the student's page and into the gradebook, while others run.

What writes the pages and keeps the gradebook takes a second to import. It is imported while the sandbox starts.
"""

from contextlib import ExitStack, suppress
from functools import cached_property
from importlib import import_module
from pathlib import Path
from threading import Thread
from types import TracebackType
from typing import TYPE_CHECKING

from misstep.grading.collect.gather import Handed
from misstep.grading.collect.submission import Master
from misstep.grading.judging.result import Result

if TYPE_CHECKING:
    from misstep.grading.nbgrader.gradebook import Ledger

PAGES, GRADEBOOK = "misstep.grading.publish.publish", "misstep.grading.nbgrader.gradebook"


class Desk:
    """Takes results, one after the other, each for its page and, where there is a course of nbgrader, for its gradebook.

    done  the students whose results were taken
    """

    def __init__(self, out: Path, sheet: Master, course: Path | None, is_anew: bool) -> None:
        self._out, self._sheet, self._course, self._is_anew = out, sheet, course, is_anew
        self._open = ExitStack()
        self.done: set[str] = set()
        Thread(target=_import, args=[PAGES, *([GRADEBOOK] if course else [])]).start()

    def __enter__(self) -> "Desk":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._open.close()

    def take(self, handed: Handed, result: Result) -> None:
        """Write down what there is to say of a result. Raises ValueError for a course that is none, or not ready."""
        from misstep.grading.publish.publish import publish_page

        publish_page(self._out, result)
        if self._ledger:
            self._ledger.enter(handed, result)
        self.done.add(handed.student)

    def remarks(self) -> list[str]:
        """What could not be written down."""
        if not self._ledger or not self._ledger.unfit:
            return []
        return [f"Not in the gradebook, for their ids cannot name a folder: {', '.join(self._ledger.unfit)}."]

    @cached_property
    def _ledger(self) -> "Ledger | None":
        if self._course is None:
            return None
        from misstep.grading.nbgrader.gradebook import ledger

        return self._open.enter_context(ledger(self._course, self._sheet, self._is_anew))


def _import(*modules: str) -> None:
    for module in modules:
        with suppress(ImportError):  # whoever needs it next says what is missing
            import_module(module)
