"""The process of one submission: it reads what to run, confines itself, runs the cells, and writes their outputs.

The server forks it with two pipes. The function `run_child` never returns.
"""

import json
import os
import signal
import socket
import sys
import tempfile
from functools import partial

from misstep.grading.redacted_sheet import load_redacted
from misstep.grading.sandbox import libc_calls
from misstep.grading.sandbox.confine import Confinement, find_leaks, limit_resources
from misstep.grading.sandbox.course_stub import CourseStub
from misstep.grading.sandbox.limits import Limits, SandboxUnavailable
from misstep.grading.sandbox.run_cells import SubmissionShell, run_cells, write_all

PIPE_DESCRIPTOR = 250
"""The first descriptor of the two pipes: above those that a notebook opens, below the limit of open files."""


def run_child(
    confinement: Confinement | None, shell: SubmissionShell, stub: CourseStub, inbox: int, outbox: int
) -> None:
    """Read the message, confine this process, run the cells, write the outputs, and exit.

    confinement  None without a sandbox; then there are still resource limits, and a session of its own
    inbox        the descriptor of the pipe with the message
    outbox       the descriptor of the pipe for the outputs
    """
    if not confinement and sys.platform == "linux":
        libc_calls.end_with_parent(signal.SIGKILL)
    os.setsid()  # signals to a process group cross pid namespaces, so this process must not share the grader's group
    inbox, outbox = _keep_only(inbox, outbox)
    with os.fdopen(inbox, "rb") as stream:
        message = json.loads(stream.read())
    limits = Limits(**message["limits"])
    try:
        if confinement:
            confinement.apply(limits)
        else:
            limit_resources(limits)
            os.chdir(tempfile.mkdtemp())
    except SandboxUnavailable as error:
        write_all(outbox, json.dumps({"unavailable": str(error)}).encode())
        os._exit(0)
    os.closerange(3, PIPE_DESCRIPTOR)  # Landlock leaves one open
    if "probe" in message:
        write_all(outbox, json.dumps({"leaks": find_leaks(confinement.hidden) if confinement else []}).encode())
        os._exit(0)
    socket.socketpair = _pipe_pair  # type: ignore[assignment]
    stub.set_sheet(load_redacted(message.pop("sheet")))
    run_cells(shell, message.pop("cells"), limits, partial(write_all, outbox))
    os._exit(0)


def _keep_only(*descriptors: int) -> list[int]:
    """Close every other open file, connect the standard streams to /dev/null, and move these descriptors out of the way."""
    moved = [os.dup2(descriptor, PIPE_DESCRIPTOR + k, inheritable=False) for k, descriptor in enumerate(descriptors)]
    os.closerange(3, PIPE_DESCRIPTOR)
    os.closerange(PIPE_DESCRIPTOR + len(moved), os.sysconf("SC_OPEN_MAX"))
    null = os.open("/dev/null", os.O_RDWR)
    for standard in range(3):
        os.dup2(null, standard)
    os.close(null)
    return moved


class _PipeEnd:
    """One end of a pipe, with the methods of a socket that asyncio uses to wake its event loop."""

    def __init__(self, descriptor: int) -> None:
        self.fileno, self.close = lambda: descriptor, lambda: os.close(descriptor)
        self.recv, self.send = partial(os.read, descriptor), partial(os.write, descriptor)
        self.setblocking = partial(os.set_blocking, descriptor)


def _pipe_pair() -> tuple[_PipeEnd, _PipeEnd]:
    """Stand in for socket.socketpair, because a submission has no sockets: memory could be kept in their queues."""
    receiver, sender = os.pipe()
    return _PipeEnd(receiver), _PipeEnd(sender)
