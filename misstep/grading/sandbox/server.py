"""The server that submissions are forked from: it imports once, and then knows nothing of anybody.

    python -m misstep.grading.sandbox.server FD SETUP [--unsafe-no-sandbox]

FD is a Unix socket, SETUP a CourseSetup as JSON. "fork" comes with two pipes, one that the child reads its paper and its cells from and one that it
writes to; the answer is the child's id. "end ID" kills that child and answers with its status, the seconds that it
computed, and its memory in MB. The server itself reads neither pipe: so no child inherits, in its memory, what another
student sent or answered.
"""

import gc
import json
import os
import signal
import socket
import sys
from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING

from misstep.grading.sandbox import syscalls
from misstep.grading.sandbox.course_stub import CourseSetup, CourseStub, install
from misstep.grading.sandbox.limits import UNSAFE, Missing
from misstep.grading.sandbox.rootfs import SCRATCH, leave_session, move_in, readable

if TYPE_CHECKING:
    from misstep.grading.sandbox.confine import Cage
    from misstep.grading.sandbox.run_cells import Shell

HOME = dict.fromkeys(("HOME", "TMPDIR", "MPLCONFIGDIR", "IPYTHONDIR"), SCRATCH)
"""Where a submission finds its home."""


def main(descriptor: int, setup: CourseSetup, is_safe: bool) -> None:
    """Prepare, say that all is ready or what is missing, and fork until the socket closes."""
    with socket.socket(fileno=descriptor) as parent:
        try:
            cage = _prepared(setup) if is_safe else None
            shell, stub = _warm_shell(setup)
            if cage:
                move_in(readable(setup.readable), setup.hidden)
                os.environ.update(HOME)
        except Missing as missing:
            parent.send(json.dumps({"missing": str(missing)}).encode())
            return
        gc.collect()
        gc.freeze()  # a collection in a child would touch every object, and so copy every page of memory
        parent.send(b'{"missing": null}')
        _serve(parent, cage, shell, stub)


def _prepared(setup: CourseSetup) -> "Cage":
    """Leave the session of whoever started us, and go on as the first process of a pid namespace."""
    leave_session()
    if child := os.fork():
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        # To wait needs no NumPy: another program takes our place, with a third of our memory.
        os.execv(sys.executable, [sys.executable, "-ISc", f"import os; os.waitpid({child}, 0)"])  # noqa: S606
    syscalls.end_with_parent(signal.SIGKILL)
    from misstep.grading.sandbox.confine import Cage

    return Cage(setup)


def _warm_shell(setup: CourseSetup) -> "tuple[Shell, CourseStub]":
    """Import, once for all, what sheets use."""
    for module in ("matplotlib.pyplot", "sympy"):
        with suppress(ModuleNotFoundError):  # not every course draws, or works with symbols
            import_module(module)
    import misstep.grading.sandbox.child  # from now on the engine is out of reach
    from misstep.grading.sandbox.run_cells import new_shell

    shell = new_shell(setup.warm_up)
    return shell, install(setup.package)


def _serve(parent: socket.socket, cage: "Cage | None", shell: "Shell", stub: CourseStub) -> None:
    while True:
        message, descriptors, _, _ = socket.recv_fds(parent, 100, 2)
        match message.decode().split():
            case ["fork"]:
                parent.send(str(_forked(parent, cage, shell, stub, *descriptors)).encode())
            case ["end", child]:
                parent.send(json.dumps(_ended(int(child))).encode())
            case _:
                return
        for descriptor in descriptors:
            os.close(descriptor)


def _forked(
    parent: socket.socket, cage: "Cage | None", shell: "Shell", stub: CourseStub, inbox: int, outbox: int
) -> int:
    if cage:
        cage.before_fork()
    if child := os.fork():
        return child
    try:
        parent.detach()
        from misstep.grading.sandbox.child import live

        live(cage, shell, stub, inbox, outbox)
    finally:
        os._exit(1)


def _ended(child: int) -> dict[str, float]:
    """Kill a child, and all that it started; with it goes its pid namespace, or without a sandbox its session."""
    for kill in (os.kill, os.killpg):
        try:
            kill(child, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            continue
    _, status, usage = os.wait4(child, 0)
    seconds = usage.ru_utime + usage.ru_stime
    return {"status": os.waitstatus_to_exitcode(status), "processor_seconds": seconds, "memory": usage.ru_maxrss / 1024}


if __name__ == "__main__":
    main(int(sys.argv[1]), CourseSetup(**json.loads(sys.argv[2])), UNSAFE not in sys.argv)
