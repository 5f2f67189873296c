"""The server from which a process is forked for each submission: it imports everything once, and knows no answer.

    python -m misstep.grading.sandbox.server DESCRIPTOR SETUP [--unsafe-no-sandbox]

DESCRIPTOR is a Unix socket, and SETUP a CourseSetup as JSON. There are two messages. "fork" has two pipes with it: the
child reads the redacted sheet and its cells from the first one, and writes to the second one; the answer is the id of
the child. "end ID" kills that child; the answer has its exit status, its processor time in seconds, and its memory in MB.
The server reads neither pipe, so no child inherits in its memory what another student submitted.
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

from misstep.grading.sandbox import libc_calls
from misstep.grading.sandbox.course_stub import CourseSetup, CourseStub, install_stub
from misstep.grading.sandbox.limits import UNSAFE_OPTION, SandboxUnavailable
from misstep.grading.sandbox.rootfs import SCRATCH, enter_namespaces, enter_root, readable_paths

if TYPE_CHECKING:
    from misstep.grading.sandbox.confine import Confinement
    from misstep.grading.sandbox.run_cells import SubmissionShell

HOME_VARIABLES = dict.fromkeys(("HOME", "TMPDIR", "MPLCONFIGDIR", "IPYTHONDIR"), SCRATCH)
"""Environment variables with which a submission uses its scratch folder as home."""


def main(descriptor: int, setup: CourseSetup, is_safe: bool) -> None:
    """Prepare, report that the server is ready or which layer is unavailable, and fork until the socket closes."""
    with socket.socket(fileno=descriptor) as parent:
        try:
            confinement = _enter_sandbox(setup) if is_safe else None
            shell, stub = _warm_up(setup)
            if confinement:
                enter_root(readable_paths(setup.readable), setup.hidden)
                os.environ.update(HOME_VARIABLES)
        except SandboxUnavailable as error:
            parent.send(json.dumps({"unavailable": str(error)}).encode())
            return
        gc.collect()
        gc.freeze()  # a collection in a child would touch every object, and so copy every page of memory
        parent.send(b'{"unavailable": null}')
        _serve(parent, confinement, shell, stub)


def _enter_sandbox(setup: CourseSetup) -> "Confinement":
    """Enter new namespaces, and continue as the first process of a pid namespace."""
    enter_namespaces()
    if child := os.fork():
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        # Waiting needs no NumPy: replacing this process by a small one frees two thirds of its memory.
        os.execv(sys.executable, [sys.executable, "-ISc", f"import os; os.waitpid({child}, 0)"])  # noqa: S606
    libc_calls.end_with_parent(signal.SIGKILL)
    from misstep.grading.sandbox.confine import Confinement

    return Confinement(setup)


def _warm_up(setup: CourseSetup) -> "tuple[SubmissionShell, CourseStub]":
    """Import what sheets use, once for all submissions, and everything of the engine that a submission needs.

    The stub replaces the course first: so nothing of the course is ever loaded into this process, and no answer can be
    found in its memory. After enter_root, the engine cannot be imported any more.
    """
    stub = install_stub(setup.package)
    import_module("misstep.grading.sandbox.child")
    for module in ("matplotlib.pyplot", "sympy"):
        with suppress(ModuleNotFoundError):  # not every course draws, or works with symbols
            import_module(module)
    from misstep.grading.sandbox.run_cells import new_shell

    return new_shell(setup.warm_up), stub


def _serve(
    parent: socket.socket, confinement: "Confinement | None", shell: "SubmissionShell", stub: CourseStub
) -> None:
    while True:
        message, descriptors, _, _ = socket.recv_fds(parent, 100, 2)
        match message.decode().split():
            case ["fork"]:
                child = _fork(parent, confinement)
                if not child:
                    _run_child(confinement, shell, stub, descriptors)
                parent.send(str(child).encode())
            case ["end", child_id]:
                parent.send(json.dumps(_end_child(int(child_id))).encode())
            case _:
                return
        for descriptor in descriptors:
            os.close(descriptor)


def _fork(parent: socket.socket, confinement: "Confinement | None") -> int:
    """Fork; the id of the child in the server, and 0 in the child, which forgets the socket."""
    if confinement:
        confinement.prepare_fork()
    child = os.fork()
    if not child:
        parent.detach()
    return child


def _run_child(
    confinement: "Confinement | None", shell: "SubmissionShell", stub: CourseStub, descriptors: list[int]
) -> None:
    """Run a submission in this forked process, and never return."""
    try:
        from misstep.grading.sandbox.child import run_child

        run_child(confinement, shell, stub, *descriptors)
    finally:
        os._exit(1)


def _end_child(child: int) -> dict[str, float]:
    """Kill a child and all that it started: its pid namespace ends with it, or without a sandbox its session."""
    for kill in (os.kill, os.killpg):
        try:
            kill(child, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            continue
    _, status, usage = os.wait4(child, 0)
    return {
        "status": os.waitstatus_to_exitcode(status),
        "processor_seconds": usage.ru_utime + usage.ru_stime,
        "memory_mb": usage.ru_maxrss / 1024,
    }


if __name__ == "__main__":
    main(int(sys.argv[1]), CourseSetup(**json.loads(sys.argv[2])), UNSAFE_OPTION not in sys.argv)
