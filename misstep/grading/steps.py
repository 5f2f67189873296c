"""Steps: whatever reads what students wrote, or judges it, is a step, and is done in a process with limits.

The process of the instructor passes bytes on and never looks into them. A step is a function; it runs in a process that the kernel ends
if the step takes more processor time or memory than it may. So bytes that are slow to read cost their own submission, and the others
are read by other processes meanwhile. No step runs the code of a student.
"""

import resource
import signal
import socket
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import partial
from multiprocessing.connection import Connection
from typing import Any

from misstep.grading.collect.notebook import UnusableNotebook
from misstep.grading.fork_server import Child, ForkServer, ProcessEnded, serve
from misstep.grading.sandbox.confine import set_resource_limits

Steps = Mapping[str, Callable[..., Any]]
"""By name, the function that does a step. It gets and returns what pickle can hold."""

MEMORY_BYTES = 2 << 30
"""The most memory of a process that does steps."""

KEPT_MEMORY_KB = 400_000
"""A process that has used more memory than this is not used again."""

LEASES_PER_PROCESS = 8
"""After so many submissions a process ends, and another one is forked. The kernel copies each page of memory to which a new process
writes, and with one process for each submission this took 40 of 160 ms."""

WAIT_SECONDS = 600.0
"""How long a step may wait for a processor. Its own time is limited; this is for a fault in the process."""


class StepFailed(RuntimeError):
    """A step could not be done within its limits. The message says why: "it takes more than 5 s of processor time"."""


class StepProcesses:
    """Does steps in processes that it forks when it needs one more. Any thread may use it. Close it after use.

    module  the server from which they are forked, which calls `serve_steps`
    setup   what it needs to know
    """

    def __init__(self, module: str, setup: Mapping[str, Any]) -> None:
        self.server = ForkServer(module, setup)
        self._lock, self._idle = threading.Lock(), list[StepProcess]()

    def __enter__(self) -> "StepProcesses":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @contextmanager
    def process(self) -> Iterator["StepProcess"]:
        """A process that nobody else uses meanwhile."""
        with self._lock:
            process = self._idle.pop() if self._idle else StepProcess(self.server)
        try:
            yield process
        finally:
            process.finish_lease()
            with self._lock:
                self._idle.append(process)

    def do(self, step: str, *, seconds: float = 60.0, **arguments: Any) -> Any:
        """Do one step; see `StepProcess.do`."""
        with self.process() as process:
            return process.do(step, seconds=seconds, **arguments)

    def close(self) -> None:
        """End all processes. Steps that have not ended raise StepFailed."""
        self.server.close()


class StepProcess:
    """Does one step after the other in one process; if that has ended, the next step starts another one.

    is_spoiled  whether what was done may have left something behind, so that the process is not used for another submission
    """

    def __init__(self, server: ForkServer) -> None:
        self._server = server
        self._child: Child | None = None
        self._lease_count, self.is_spoiled = 0, False

    def do(self, step: str, *, seconds: float, **arguments: Any) -> Any:
        """Do a step with so much processor time.

        Raises StepFailed if it reaches a limit, UnusableNotebook, with a sentence for the student, if the step does, and OSError
        if the disk takes no more.
        """
        try:
            if self._child is None:
                self._start()
            self._connection.send((step, seconds, arguments))
            if not self._connection.poll(WAIT_SECONDS):
                raise EOFError
            outcome, value, memory_kb = self._connection.recv()
        except ProcessEnded as error:
            raise StepFailed(str(error)) from error
        except (EOFError, ConnectionError) as error:
            is_slow = self._end() == -signal.SIGPROF
            why = f"takes more than {seconds:g} s of processor time" if is_slow else "ends the process"
            raise StepFailed(f"it {why}") from error
        self.is_spoiled |= memory_kb > KEPT_MEMORY_KB
        if outcome == "failed":
            raise StepFailed(f"it {value}")
        if outcome == "raised":
            raise value
        return value

    def finish_lease(self) -> None:
        """Give the process back; it is ended if the next submission should have another one."""
        self._lease_count += 1
        if self.is_spoiled or self._lease_count >= LEASES_PER_PROCESS:
            self._end()

    def _start(self) -> None:
        ours, theirs = socket.socketpair()
        with ours, theirs:
            self._child = self._server.fork(theirs.fileno())
            self._connection = Connection(ours.detach())
        self._lease_count, self.is_spoiled = 0, False

    def _end(self) -> int:
        """End the process; its exit status, which is 0 if it has none."""
        child, self._child = self._child, None
        if child is None:
            return 0
        self._connection.close()
        with suppress(ProcessEnded):
            return int(self._server.end(child)["status"])
        return 0


def serve_steps(parent: socket.socket, steps: Steps) -> None:
    """In a server that is ready: fork processes that do these steps."""
    set_resource_limits({"AS": MEMORY_BYTES})
    serve(parent, partial(_answer, steps))


def _answer(steps: Steps, descriptor: int) -> None:
    connection = Connection(descriptor)
    with suppress(EOFError, ConnectionError):  # the process that grades needs no more
        while True:
            step, seconds, arguments = connection.recv()
            signal.setitimer(signal.ITIMER_PROF, seconds)
            outcome, value = do_step(steps, step, arguments)
            memory_kb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            connection.send((outcome, value, memory_kb))
            signal.setitimer(signal.ITIMER_PROF, 0)


def do_step(steps: Steps, step: str, arguments: Mapping[str, Any]) -> tuple[str, Any]:
    """The outcome of a step, which is "done", "raised" or "failed", and what it returned, raised, or why it failed."""
    try:
        return "done", steps[step](**arguments)
    except UnusableNotebook as error:
        return "raised", UnusableNotebook(str(error))
    except OSError as error:  # of the disk to which a page is written
        return "raised", OSError(error.errno, error.strerror, error.filename and str(error.filename))
    except MemoryError:
        return "failed", f"takes more than {MEMORY_BYTES >> 20} MB of memory"
    except Exception as error:  # whatever is wrong with this submission, the next one is another
        return "failed", f"raises {type(error).__name__}: {error}"[:500]
