"""Work: submissions handed to an executor, a few at a time, each graded once and written down as soon as it is."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from typing import TypeVar

Task = TypeVar("Task")
Done = TypeVar("Done")


def as_done(
    executor: Executor, call: Callable[[Task], Done], tasks: Iterable[Task], ahead: int
) -> Iterator[tuple[Task, Done | BaseException]]:
    """Each task with what its call gave, or with the error that kept it from giving anything, as they are done.

    ahead  how many may wait in the executor: a task is made when its turn comes, so that a thousand notebooks are never
           in memory together
    """
    waiting: dict[Future[Done], Task] = {}
    coming = iter(tasks)
    try:
        while True:
            while len(waiting) < ahead and (task := next(coming, None)) is not None:
                waiting[executor.submit(call, task)] = task
            if not waiting:
                return
            for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                yield waiting.pop(future), future.exception() or future.result()
    finally:
        for future in waiting:
            future.cancel()
