"""More than one machine: the same submissions, graded by the workers of a running Dask cluster.

Each process of a worker keeps one grader for each sheet: a server of forks and a judge of its own. A worker that dies loses
what it had in hand; the scheduler gives that to another, and each result is written down once, here.
"""

import atexit
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from threading import Lock

from misstep.grading.collect.submission import Master
from misstep.grading.judging.grader import Grader
from misstep.grading.judging.result import Result
from misstep.grading.sandbox.limits import Limits

GRADERS: dict[str, Grader] = {}
STARTING = Lock()

PATIENCE = "10s"
"""How long a scheduler may take to answer."""


class Unreachable(RuntimeError):
    """No cluster answers."""


def grade_here(sheet: Master, limits: Limits, is_safe: bool, student: str, content: bytes | None) -> Result:
    """Grade a submission in this process, whichever it is.

    Raises misstep.grading.sandbox.limits.Missing where this machine cannot give the sandbox.
    """
    # The folder is one of whoever grades. Only the sheet of a robot needs it, and says so if its file is not here.
    sheet = sheet if sheet.folder.is_dir() else replace(sheet, folder=Path.cwd())
    key = repr((sheet, limits, is_safe))
    with STARTING:
        if key not in GRADERS:
            GRADERS[key] = Grader(sheet, limits, is_safe)
            atexit.register(GRADERS[key].close)
    return GRADERS[key].grade(student, content)


@contextmanager
def cluster(address: str) -> Iterator[tuple[Executor, int]]:
    """The executor of a running cluster, and how many tasks it takes at a time.

    Raises Unreachable when nothing answers at the address, or has no workers.
    """
    try:
        from distributed import Client
    except ImportError as error:
        raise Unreachable("--cluster needs the package distributed: pip install distributed.") from error
    try:
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise Unreachable(f"No Dask scheduler answers at {address}: {error}. Is it started, and reachable?") from error
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            raise Unreachable(f"The scheduler at {address} has no workers. Start some: dask worker {address}.")
        yield client.get_executor(), threads
