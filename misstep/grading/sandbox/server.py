"""The server from which a process is forked for each submission: it imports everything once, and knows no answer.

    python -m misstep.grading.sandbox.server DESCRIPTOR [--unsafe-no-sandbox]

Its setup is a CourseSetup. A child gets two pipes: it reads the redacted sheet and its cells from the first one, and writes to the second
one. The server reads neither, so no child inherits in its memory what another student submitted.
"""

import gc
import os
import signal
import socket
import sys
from contextlib import suppress
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from misstep.grading.fork_server import THREAD_VARIABLES, greet, run_server, serve
from misstep.grading.sandbox import libc_calls
from misstep.grading.sandbox.course_stub import CourseSetup, CourseStub, install_stub
from misstep.grading.sandbox.limits import UNSAFE_OPTION, SandboxUnavailable
from misstep.grading.sandbox.rootfs import SCRATCH, enter_namespaces, enter_root, readable_paths

if TYPE_CHECKING:
    from misstep.grading.sandbox.confine import Confinement
    from misstep.grading.sandbox.run_cells import SubmissionShell

SLOW_IMPORTS = ("matplotlib.pyplot", "sympy")
"""What submissions may use and what takes longer to import than everything else together."""

ENVIRONMENT = {
    **dict.fromkeys(("HOME", "TMPDIR", "MPLCONFIGDIR", "IPYTHONDIR"), SCRATCH),
    "PATH": "/usr/local/bin:/usr/bin:/bin",
    "LANG": "C.UTF-8",
    "MPLBACKEND": "agg",
    **dict.fromkeys(THREAD_VARIABLES, "1"),
}
"""The environment variables of a submission: its scratch folder is its home, and nothing is of the grader."""


def main(parent: socket.socket, fields: dict[str, Any]) -> None:
    """Prepare, report that the server is ready or which layer is unavailable, and fork until the socket closes."""
    gc.disable()  # next to nothing of what is imported becomes garbage
    setup = CourseSetup(**fields)
    try:
        confinement = None if UNSAFE_OPTION in sys.argv else _enter_sandbox(setup)
        shell, stub = _warm_up(setup)
        if confinement:
            enter_root(readable_paths(setup.readable), setup.hidden)
            _forget_paths()
    except SandboxUnavailable as error:
        greet(parent, unavailable=str(error))
        return
    gc.freeze()  # a collection in a child would touch every object, and so copy every page of memory
    gc.enable()
    greet(parent)
    from misstep.grading.sandbox.submission_process import run_child

    child = partial(run_child, confinement, shell, stub)
    if confinement:
        serve(parent, child, confinement.prepare_fork)
    else:
        serve(parent, child, kill=_kill_group)


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
    for module in SLOW_IMPORTS:
        with suppress(ModuleNotFoundError):  # not every course draws, or works with symbols
            import_module(module)
    from misstep.grading.sandbox.run_cells import new_shell

    return new_shell(setup.warm_up), stub


def _kill_group(child: int) -> None:
    """End a submission and what it has started; in the sandbox, its pid namespace does so."""
    for kill in (os.kill, os.killpg):
        with suppress(ProcessLookupError, PermissionError):
            kill(child, signal.SIGKILL)


if __name__ == "__main__":
    run_server(main)
