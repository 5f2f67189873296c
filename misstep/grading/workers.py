"""Workers: each thread of an executor has a process of its own that grades, and that is ended if it takes too long.

So one submission costs no other one time, memory or points, whatever its bytes are. Any executor of concurrent.futures can run
`grade_within`: a pool of threads here, or Dask's on other machines.
"""

import multiprocessing
import signal
import sys
import threading
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from misstep.grading import result as states
from misstep.grading.judging import Request, grade, ungraded
from misstep.grading.result import Result

MEMORY_BYTES = 6_000_000_000
"""The address space of a process that grades, where the system can limit it."""
START_SECONDS = 600.0
"""How long a new process may take to import the course, which no student is to blame for."""
CONTEXT: Any = multiprocessing.get_context("forkserver" if sys.platform != "win32" else "spawn")

_own = threading.local()


class _Worker:
    """A process that grades one submission after the other."""

    def __init__(self, request: Request) -> None:
        if multiprocessing.current_process().daemon:
            raise ValueError(
                "A worker of the cluster must be able to start processes; this one is started by a nanny, which forbids it. "
                "Start it with `dask worker --no-nanny`."
            )
        self._pipe, theirs = CONTEXT.Pipe()
        self._process = CONTEXT.Process(target=_serve, args=(theirs, request), daemon=True)
        self._process.start()
        theirs.close()  # so that each side notices when the other one has ended
        self._wait(START_SECONDS)

    def grade(self, request: Request, seconds: float) -> Any:
        self._pipe.send((request, seconds))
        return self._wait(seconds)

    def _wait(self, seconds: float) -> Any:
        if not self._pipe.poll(seconds):
            raise TimeoutError(f"It took longer than {seconds:g} s. Clear all outputs, run all cells, and save.")
        return self._pipe.recv()

    def end(self) -> None:
        self._process.kill()
        self._process.join()
        self._pipe.close()


def _serve(pipe: Connection, first: Request) -> None:
    """Import the course, and then grade what arrives, until the process that asks has ended."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that asks ends this one
    with suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    first.sheet.find()
    with suppress(EOFError, BrokenPipeError, ConnectionResetError):
        pipe.send("ready")
        while True:
            request, seconds = pipe.recv()
            if hasattr(signal, "alarm"):
                signal.alarm(int(2 * seconds) + 1)  # if the process that asks has been killed
            pipe.send(grade(request))
            if hasattr(signal, "alarm"):
                signal.alarm(0)


def grade_within(request: Request, seconds: float) -> Result:
    """Grade one student in the process of this thread. One that ends or takes longer is replaced, and the result says why."""
    worker = _own.worker = getattr(_own, "worker", None) or _Worker(request)
    try:
        graded: Result = worker.grade(request, seconds)
        return graded
    except TimeoutError as error:
        reason = str(error)
    except (EOFError, OSError):
        reason = "It ended the process that reads it. Clear all outputs, run all cells, and save."
    worker.end()
    _own.worker = None
    return ungraded(request, states.UNREADABLE, reason, "not graded")


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
