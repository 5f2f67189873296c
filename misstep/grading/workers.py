"""Workers: each thread of an executor has a process of its own that grades, and that is ended if it takes too long.

So one submission costs no other one time, memory or points, whatever its bytes are. Any executor of concurrent.futures can run
`grade_within`: a pool of threads here, or Dask's on other machines.
"""

import multiprocessing
import sys
import threading
from concurrent.futures import Executor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import suppress
from typing import Any

from pebble import ProcessExpired, ProcessPool

from misstep.grading import result as states
from misstep.grading.judging import Request, SheetName, grade, ungraded
from misstep.grading.result import Result

MEMORY_BYTES = 6_000_000_000
"""The address space of a process that grades, where the system can limit it."""
CONTEXT: Any = multiprocessing.get_context("forkserver" if sys.platform != "win32" else "spawn")

_own = threading.local()


def _prepare(sheet: SheetName) -> None:
    """Limit the memory, and import the course, before the time of the first student begins."""
    with suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    sheet.find()


def grade_within(request: Request, seconds: float) -> Result:
    """Grade one student in the process of this thread. One that ends or takes longer is replaced, and the result says why."""
    reason = "It ended the process that reads it."
    for _ in range(2):
        if not hasattr(_own, "pool") or not _own.pool.active:
            _own.pool = ProcessPool(1, initializer=_prepare, initargs=(request.sheet,), context=CONTEXT)
        try:
            graded: Result = _own.pool.schedule(grade, [request], timeout=seconds).result()
            return graded
        except TimeoutError:
            reason = f"It took longer than {seconds:g} s."
            break
        except ProcessExpired:
            break
        except BrokenProcessPool:
            pass  # pebble gives a pool up if its process ends before it is known to have begun, and it may have been idle
    return ungraded(request, states.UNREADABLE, f"{reason} Clear all outputs, run all cells, and save.", "not graded")


def open_executor(workers: int, scheduler: str | None) -> Executor:
    """Return what runs `grade_within`: threads here, or the Dask cluster of a scheduler, which must see the same folders.

    Raises ValueError if the scheduler does not answer.
    """
    if not scheduler:
        return ThreadPoolExecutor(workers)
    from distributed import Client

    try:
        executor: Executor = Client(scheduler, timeout="10s").get_executor()
    except OSError as error:
        raise ValueError(f"No scheduler answers at {scheduler}. Start one with `dask scheduler`: {error}.") from error
    return executor
