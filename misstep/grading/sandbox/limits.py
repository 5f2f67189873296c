"""The limits of the sandbox, its layers, and the error that names a layer which this machine cannot provide.

    namespaces    a root folder with the interpreter and the packages of the course, but without any sheet and without the
                  rest of the disk; for each submission a scratch folder of its own, no network, and no view of other processes
    user          a user id of its own, without privileges
    limits        on processor time, memory, threads, open files and file size; from outside, on the wall-clock time
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

BYTES_PER_MB = 1 << 20

SHOWN_KINDS = {"text/plain", "text/markdown", "image/png"}
"""The kinds of displays that pages show. The others are not kept."""

MAX_ANSWER_CHARACTERS = 256_000
"""The longest answer, as JSON, in characters."""

MAX_PRINTED_CHARACTERS = 100_000
"""How many characters of what a cell prints are kept."""

MAX_CELL_BYTES = 1_000_000
"""How many bytes of the output of a cell are kept, as JSON."""

MAX_BYTES = 4_000_000
"""How many bytes of the output of all cells are kept, as JSON."""

TOO_SLOW = "This cell took too long and was interrupted. Does it contain an endless loop?"
"""What a page says of a cell that exceeds its time."""

TOO_LARGE = "This cell needed more memory than a submission may use. Does a list grow without end?"
"""What a page says of a cell that exceeds the memory, if Python itself says nothing."""


@dataclass(frozen=True)
class Limits:
    """What one submission may use. Times are processor time, so that neither the load of the machine nor the number of jobs
    changes a point; the two wall-clock times are for code that waits, and generous.

    cell_seconds       processor time of one cell; after that the cell is interrupted, and the next cell runs
    cell_wall_seconds  wall-clock time of one cell
    seconds            processor time of the whole submission; after that its process is killed
    wall_seconds       wall-clock time of the whole submission
    answer_seconds     processor time for judging one answer, reading included
    reading_seconds    processor time for reading its notebook, and then what it wrote
    memory_mb          all memory, files included, in MB
    file_mb, scratch_mb, output_mb   size of one file, of all files, of all output, in MB
    threads            threads at the same time

    Raises ValueError for a limit that is not positive.
    """

    cell_seconds: float = 10.0
    cell_wall_seconds: float = 60.0
    seconds: float = 60.0
    wall_seconds: float = 300.0
    answer_seconds: float = 4.0
    reading_seconds: float = 5.0
    memory_mb: int = 2048
    file_mb: int = 32
    scratch_mb: int = 64
    output_mb: int = 16
    threads: int = 64

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not 0 < value < float("inf"):
                raise ValueError(f"The limit {name} must be a positive number; got {value:g}.")

    def __str__(self) -> str:
        return ", ".join(f"{name} {value:g}" for name, value in vars(self).items())


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
