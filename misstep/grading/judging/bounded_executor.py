"""Work: submissions handed to an executor, a few at a time, each graded once and given back as soon as it is."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import TypeVar

Task = TypeVar("Task")
Done = TypeVar("Done")


def as_done(
    submit: Callable[[Task], Future[Done]], tasks: Iterable[Task], ahead: int
) -> Iterator[tuple[Task, Done | BaseException]]:
    """Each task with what came of it, or with the error that kept anything from coming, as they are done.

    submit  hands a task to an executor
    ahead   how many may be with the executor: a task is made when its turn comes, so that a thousand notebooks are never in
            memory together

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> with ThreadPoolExecutor(1) as pool:
    ...     dict(as_done(lambda x: pool.submit(abs, x), [-1, -2], ahead=1))
    {-1: 1, -2: 2}
    """
    waiting: dict[Future[Done], Task] = {}
    coming = iter(tasks)
    try:
        while True:
            while len(waiting) < ahead and (task := next(coming, None)) is not None:
                waiting[submit(task)] = task
            if not waiting:
                return
            for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                yield waiting.pop(future), future.exception() or future.result()
    finally:
        for future in waiting:
            future.cancel()
