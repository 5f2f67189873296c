"""Tasks: what is to be graded, each with the mark of all that its result will come from."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from misstep.grading.collect.files import Refused
from misstep.grading.collect.gather import Handed, typed_id
from misstep.grading.collect.submission import Master
from misstep.grading.judging.result import Result
from misstep.grading.publish.result_store import mark


class Task(NamedTuple):
    """A submission on its way: who, whose numbers, the notebook, why there is none, and the mark of all this."""

    handed: Handed
    drawn_for: str
    content: bytes | None
    fault: str
    mark: str

    def signed(self, result: Result) -> Result:
        """The result in the name of who handed it in, with what was odd about the files."""
        notes = [*self.handed.notes, *result.notes]
        return replace(result, student=self.handed.student, reason=self.fault or result.reason, notes=notes)


def tasks(
    handed: Sequence[Handed], sheet: Master, is_safe: bool, is_done: Callable[[str, str], bool]
) -> Iterator[Task | None]:
    """A task for each submission, read when its turn comes; None for one whose result is there.

    is_done  whether there is a result for a student and a mark
    """
    for each in handed:
        content, fault = None, ""
        try:
            content = each.content()
        except Refused as refused:
            fault = str(refused)
        drawn_for = each.drawn_for or (typed_id(content) if content else "") or each.student
        parts = [each.student, drawn_for, content, fault, *each.notes]
        task = Task(each, drawn_for, content, fault, mark(sheet, is_safe, parts))
        yield None if is_done(each.student, task.mark) else task
