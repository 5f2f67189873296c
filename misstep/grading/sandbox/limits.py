"""What the sandbox is made of, in words: its limits, and the error that names a layer which this machine lacks.

    namespaces    a root folder with the interpreter and kinlib, without sheets and without the rest of the disk;
                  for each submission its own scratch folder, no network, no other process in sight
    user          an id of its own, without rights
    limits        of processor time, memory, threads, open files, file size; a wall clock from outside
    landlock      reads what the interpreter needs, writes to scratch, nothing else
    seccomp       no sockets, no new programs, no new processes, no doors back out

Each holds by itself, so that a hole in one is covered by another. Nothing is skipped in silence.
"""

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

UNSAFE = "--unsafe-no-sandbox"
"""The option that leaves the sandbox out. Everything that it touches says so."""


@dataclass(frozen=True)
class Limits:
    """What one submission may use.

    cell_seconds       for one cell; then the cell is interrupted, and the next one runs
    seconds            for all of it, by a clock outside; then everything ends
    processor_seconds  of computing
    memory, files, scratch, output   in MB: address space, one file, all files, what is printed and shown
    threads            at the same time
    """

    cell_seconds: float = 10.0
    seconds: float = 60.0
    processor_seconds: int = 60
    memory: int = 2048
    files: int = 32
    scratch: int = 64
    output: int = 4
    threads: int = 64


class Missing(RuntimeError):
    """A layer that this machine cannot give, and what to do about it."""


@contextmanager
def layer(name: str, remedy: str) -> Iterator[None]:
    """Name the layer, and the remedy, in whatever goes wrong inside."""
    ctypes.set_errno(0)  # the package landlock would take an older error for its own
    try:
        yield
    except Exception as error:
        raise Missing(
            f"The sandbox cannot have its layer '{name}' here: {error}. {remedy} Nothing was run. "
            f"({UNSAFE} runs submissions with your own rights: only for code that you trust.)"
        ) from error
