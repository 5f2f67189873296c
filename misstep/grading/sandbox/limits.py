"""The limits of the sandbox, its layers, and the error that names a layer which this machine cannot provide.

    namespaces    a root folder with the interpreter and the packages of the course, but without any sheet and without the
                  rest of the disk; for each submission a scratch folder of its own, no network, and no view of other processes
    user          a user id of its own, without privileges
    limits        on processor time, memory, threads, open files and file size; the wall-clock time is limited from outside,
                  and the memory of all processes together once more
    landlock      may read what the interpreter needs, may write to the scratch folder, and nothing else
    seccomp       only the system calls that computing needs: no sockets, no new programs, no new processes, no files in memory

Each layer is effective on its own, so that a weakness in one of them is covered by another. No layer is left out silently.
"""

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

UNSAFE_OPTION = "--unsafe-no-sandbox"
"""The option that switches the sandbox off. Every result and page that it affects says so."""


@dataclass(frozen=True)
class Limits:
    """What one submission may use.

    cell_seconds       for one cell; after that the cell is interrupted, and the next cell runs
    seconds            for the whole submission, measured from outside; after that its process is killed
    processor_seconds  processor time
    memory_mb          all memory, files included, in MB
    file_mb, scratch_mb, output_mb   size of one file, of all files, of all output, in MB
    threads            threads at the same time
    """

    cell_seconds: float = 10.0
    seconds: float = 60.0
    processor_seconds: int = 60
    memory_mb: int = 2048
    file_mb: int = 32
    scratch_mb: int = 64
    output_mb: int = 4
    threads: int = 64


class SandboxUnavailable(RuntimeError):
    """This machine cannot provide a layer of the sandbox. The message names the layer and the remedy."""


@contextmanager
def sandbox_layer(name: str, remedy: str) -> Iterator[None]:
    """Turn any error inside into SandboxUnavailable, with the name of the layer and the remedy."""
    ctypes.set_errno(0)  # the package landlock would otherwise report an older error as its own
    try:
        yield
    except Exception as error:
        why = getattr(error, "strerror", None) or error  # the package landlock would print a tuple
        raise SandboxUnavailable(
            f"The sandbox cannot provide its layer '{name}' on this machine: {why}. {remedy} Nothing was run. "
            f"({UNSAFE_OPTION} runs submissions with your own rights; use it only for code that you trust.)"
        ) from error
