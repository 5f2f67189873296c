"""Read what students wrote: the one place outside of the sandbox through which their bytes go, in processes with limits.

    python -m misstep.grading.reading

The process of the instructor passes bytes on and never looks into them. Each of STEPS is a function that does: it gets and returns
JSON, and runs in a process that the kernel ends if the step takes more processor time or memory than it may. So bytes that are slow
to read cost their own submission, and the others are read by other processes meanwhile.
"""

import os
import signal
import sys
import threading
from base64 import b64encode
from importlib import import_module
from pathlib import Path
from types import TracebackType
from typing import Any

from misstep.grading.collect.notebook import UnusableNotebook
from misstep.grading.rpc import ProcessEnded, Worker, encode_message, receive_message
from misstep.grading.sandbox.confine import set_resource_limits

STEPS = {
    "plan": "misstep.grading.collect.run_plan:plan_step",
    "parse": "misstep.grading.judging.parse_output:parse_step",
    "page": "misstep.grading.publish.publish:page_step",
    "autograded notebook": "misstep.grading.nbgrader.autograded:notebook_step",
    "tables": "misstep.grading.publish.publish:tables_step",
}
"""By step, the module and the function that does it: a notebook is planned, the output of a run is parsed, a page is written, a
notebook for formgrader is written, and the answers of a class are compared and written into tables."""

STEP_SECONDS = 5.0
"""Processor time of a step. The largest notebook that is accepted takes a fifth of it."""

MEMORY_BYTES = 2 << 30
"""The most memory of a process that reads."""

KEPT_MEMORY_KB = 400_000
"""A process that has used more memory than this is not used again."""

WAIT_SECONDS = 600.0
"""How long a step may wait for a processor. Its own time is limited by STEP_SECONDS; this is for a fault in the process."""


class StepFailed(RuntimeError):
    """What a student wrote could not be read within the limits. The message says which limit was reached."""


class Reader:
    """Does steps in processes that it starts when it needs one more. Any thread may use it. Close it after use."""

    def __init__(self) -> None:
        self._lock, self._idle, self._all, self._is_closed = threading.Lock(), list[Worker](), set[Worker](), False
        self._idle.append(self._start())

    def __enter__(self) -> "Reader":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def do(self, step: str, *, seconds: float = STEP_SECONDS, **arguments: Any) -> Any:
        """Do a step. Bytes among its arguments arrive there as base64.

        Raises StepFailed if it reaches a limit, UnusableNotebook, with a sentence for the student, if the step does, and OSError
        if the disk takes no more.
        """
        sendable = {
            name: b64encode(value).decode() if isinstance(value, bytes) else value for name, value in arguments.items()
        }
        worker = self._take()
        try:
            answer = worker.request({"step": step, "seconds": seconds, "arguments": sendable}, WAIT_SECONDS)
        except ProcessEnded as error:
            worker.stop()
            with self._lock:
                self._all.discard(worker)
            is_slow = worker.exit_code == -signal.SIGPROF
            raise StepFailed(
                f"it takes more than {seconds:g} s of processor time to read" if is_slow else "it ends what reads it"
            ) from error
        self._give_back(worker, is_spent=answer["memory_kb"] > KEPT_MEMORY_KB)
        if "unusable" in answer:
            raise UnusableNotebook(answer["unusable"])
        if "os_error" in answer:
            raise OSError(*answer["os_error"])
        if "failed" in answer:
            raise StepFailed(answer["failed"])
        return answer["done"]

    def close(self) -> None:
        """End all processes. Steps that have not ended raise StepFailed."""
        with self._lock:
            self._is_closed = True
            workers, self._all = self._all, set()
        for worker in workers:
            worker.stop()

    def _start(self) -> Worker:
        worker = Worker("misstep.grading.reading", Path())
        self._all.add(worker)
        return worker

    def _take(self) -> Worker:
        with self._lock:
            if self._is_closed:
                raise StepFailed("nothing is read any more")
            return self._idle.pop() if self._idle else self._start()

    def _give_back(self, worker: Worker, is_spent: bool) -> None:
        with self._lock:
            if not is_spent:
                self._idle.append(worker)
                return
            self._all.discard(worker)
        worker.stop()


def do_step(step: str, arguments: dict[str, Any]) -> dict[str, Any]:
    """The answer to a request: what the step returns, why the notebook cannot be used, or why the step failed."""
    module, _, function = STEPS[step].partition(":")
    try:
        return {"done": getattr(import_module(module), function)(**arguments)}
    except UnusableNotebook as error:
        return {"unusable": str(error)}
    except OSError as error:  # of the disk to which a page is written
        return {"os_error": [error.errno, error.strerror, error.filename and str(error.filename)]}
    except MemoryError:
        return {"failed": f"it takes more than {MEMORY_BYTES >> 20} MB of memory to read"}
    except Exception as error:  # whatever is wrong with this submission, the next one is another
        return {"failed": f"reading it raises {type(error).__name__}: {error}"[:500]}


def main() -> None:
    """Answer requests until stdin ends."""
    import resource

    inbox, outbox = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints is no answer
    set_resource_limits({"AS": MEMORY_BYTES})
    while (message := receive_message(inbox)) is not None:
        signal.setitimer(signal.ITIMER_PROF, message["seconds"])
        answer = do_step(message["step"], message["arguments"])
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        encoded = encode_message({**answer, "memory_kb": memory, "id": message["id"]})
        signal.setitimer(signal.ITIMER_PROF, 0)
        outbox.write(encoded)
        outbox.flush()


if __name__ == "__main__":
    try:
        main()
    except (BrokenPipeError, KeyboardInterrupt):  # whoever asked has ended
        os._exit(1)
