"""The server from which a process is forked for each submission: it imports everything once, and knows no answer.

    python -m misstep.grading.sandbox.server DESCRIPTOR [--unsafe-no-sandbox]

DESCRIPTOR is a Unix socket. The first message is a CourseSetup; it is no argument, because submissions can read the arguments
of their process, and it names folders. Then there are two messages. "fork" has two pipes with it: the
child reads the redacted sheet and its cells from the first one, and writes to the second one; the answer is the id of
the child, with a descriptor of its process, because outside of the namespace it has another id. "end ID" kills that child;
the answer has its exit status, its processor time in seconds, and its memory in MB.
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
from pathlib import Path
from typing import TYPE_CHECKING

from misstep.grading.rpc import THREAD_VARIABLES, receive_message
from misstep.grading.sandbox import libc_calls
from misstep.grading.sandbox.course_stub import CourseSetup, CourseStub, install_stub
from misstep.grading.sandbox.limits import UNSAFE_OPTION, SandboxUnavailable
from misstep.grading.sandbox.rootfs import SCRATCH, enter_namespaces, enter_root, readable_paths

if TYPE_CHECKING:
    from misstep.grading.sandbox.confine import Confinement
    from misstep.grading.sandbox.run_cells import SubmissionShell

ENVIRONMENT = {
    **dict.fromkeys(("HOME", "TMPDIR", "MPLCONFIGDIR", "IPYTHONDIR"), SCRATCH),
    "PATH": "/usr/local/bin:/usr/bin:/bin",
    "LANG": "C.UTF-8",
    "MPLBACKEND": "agg",
    **dict.fromkeys(THREAD_VARIABLES, "1"),
}
"""The environment variables of a submission: its scratch folder is its home, and nothing is of the grader."""


def main(descriptor: int, is_safe: bool) -> None:
    """Prepare, report that the server is ready or which layer is unavailable, and fork until the socket closes."""
    gc.disable()  # next to nothing of what is imported becomes garbage
    with socket.socket(fileno=descriptor) as parent:
        with parent.makefile("rb") as stream:
            setup = CourseSetup(**(receive_message(stream) or {}))
        try:
            confinement = _enter_sandbox(setup) if is_safe else None
            shell, stub = _warm_up(setup)
            if confinement:
                enter_root(readable_paths(setup.readable), setup.hidden)
                _forget_paths()
        except SandboxUnavailable as error:
            parent.send(json.dumps({"unavailable": str(error)}).encode())
            return
        gc.freeze()  # a collection in a child would touch every object, and so copy every page of memory
        gc.enable()
        parent.send(b'{"unavailable": null}')
        _serve(parent, confinement, shell, stub)


def _forget_paths() -> None:
    """Remove the paths and the environment of the grader from where a program looks for them."""
    os.environ.clear()
    os.environ.update(ENVIRONMENT)
    sys.argv[:], sys.orig_argv[:] = [""], []
    sys.path[:] = [path for path in sys.path if Path(path).exists()]
    sys.path_importer_cache.clear()
    for name, module in sys.modules.items():
        if name.partition(".")[0] in {"misstep", "__main__"}:
            vars(module).update(__file__=None, __cached__=None, __spec__=None)
            if hasattr(module, "__path__"):
                module.__path__ = []


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
    import_module("misstep.grading.sandbox.submission_process")
    for module in setup.imports:
        with suppress(ModuleNotFoundError):  # not every course draws, or works with symbols
            import_module(module)
    from misstep.grading.sandbox.run_cells import new_shell

    return new_shell(setup.warm_up), stub


def _serve(
    parent: socket.socket, confinement: "Confinement | None", shell: "SubmissionShell", stub: CourseStub
) -> None:
    is_supervised = not confinement and sys.platform == "linux"
    while True:
        message, descriptors, _, _ = socket.recv_fds(parent, 100, 2)
        match message.decode().split():
            case ["fork"]:
                child = _fork(parent, confinement)
                if not child:
                    _run_child(confinement, shell, stub, descriptors)
                with suppress(AttributeError, OSError):  # a system without it counts no memory from outside
                    descriptors.append(os.pidfd_open(child))
                socket.send_fds(parent, [str(child).encode()], descriptors[2:])
            case ["end", child_id]:
                parent.send(json.dumps(_end_child(int(child_id), is_supervised)).encode())
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
        from misstep.grading.sandbox.submission_process import run_child

        run_child(confinement, shell, stub, *descriptors)
    finally:
        os._exit(1)


def _end_child(child: int, is_supervised: bool) -> dict[str, float]:
    """End a child and all that it started: its pid namespace ends with it, or without a sandbox its supervisor sees to it."""
    for kill in (os.kill,) if is_supervised else (os.kill, os.killpg):
        try:
            kill(child, signal.SIGTERM if is_supervised else signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            continue
    _, status, usage = os.wait4(child, 0)
    return {
        "status": os.waitstatus_to_exitcode(status),
        "processor_seconds": usage.ru_utime + usage.ru_stime,
        "memory_mb": usage.ru_maxrss / 1024,
    }


if __name__ == "__main__":
    with suppress(BrokenPipeError, ConnectionResetError, KeyboardInterrupt):  # the process that grades has ended
        main(int(sys.argv[1]), UNSAFE_OPTION not in sys.argv)
