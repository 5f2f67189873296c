"""Run jobs on an executor, a few at a time, and yield each result as soon as it is there."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import TypeVar

Job = TypeVar("Job")
Outcome = TypeVar("Outcome")


def run_bounded(
    submit: Callable[[Job], Future[Outcome]], jobs: Iterable[Job], max_pending: int
) -> Iterator[tuple[Job, Outcome | BaseException]]:
    """Each job with its outcome, or with the error that it raised, in the order in which they finish.

    submit       gives a job to an executor
    max_pending  how many jobs the executor may have at a time. A job is made when there is room for it, so that a thousand
                 notebooks are never in memory together

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> with ThreadPoolExecutor(1) as pool:
    ...     dict(run_bounded(lambda x: pool.submit(abs, x), [-1, -2], max_pending=1))
    {-1: 1, -2: 2}
    """
    pending: dict[Future[Outcome], Job] = {}
    remaining = iter(jobs)
    try:
        while True:
            while len(pending) < max_pending and (job := next(remaining, None)) is not None:
                pending[submit(job)] = job
            if not pending:
                return
            for future in wait(pending, return_when=FIRST_COMPLETED).done:
                yield pending.pop(future), future.exception() or future.result()
    finally:
        for future in pending:
            future.cancel()
