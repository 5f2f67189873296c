"""Grade on more than one machine: the same submissions, graded by the workers of a running Dask cluster.

Each worker process keeps one grader for each sheet, with a server and a judge of its own. If a worker dies, the scheduler
gives its submissions to another worker. Each result is written once, by the process that started the grading.
"""

import atexit
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from threading import Lock

from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.judging.grader import Grader
from misstep.grading.judging.result import Result
from misstep.grading.sandbox.limits import Limits

GRADERS: dict[str, Grader] = {}
GRADERS_LOCK = Lock()

CONNECT_TIMEOUT = "10s"
"""How long a scheduler may take to answer."""


class ClusterUnreachable(RuntimeError):
    """No cluster answers at the address, or it has no workers."""


def grade_on_worker(
    setting: tuple[ReleasedSheet, Limits, bool], student: str, content: bytes | None, seed_id: str
) -> Result:
    """Grade a submission in this worker process.

    setting  the sheet, the limits, and whether submissions run in the sandbox

    Raises SandboxUnavailable if this machine cannot provide the sandbox.
    """
    sheet, limits, is_safe = setting
    key = repr((sheet, sheet.key, limits, is_safe))
    with GRADERS_LOCK:
        if key not in GRADERS:
            GRADERS[key] = Grader(sheet, limits, is_safe)
            atexit.register(GRADERS[key].close)
    return GRADERS[key].grade(student, content, seed_id)


@contextmanager
def connect(address: str) -> Iterator[tuple[Executor, int]]:
    """The executor of a running cluster, and how many jobs it runs at a time.

    Raises ClusterUnreachable if no scheduler answers at the address, or if it has no workers.
    """
    try:
        from distributed import Client
    except ImportError as error:
        raise ClusterUnreachable("--cluster needs the package distributed: pip install distributed.") from error
    try:
        client = Client(address, timeout=CONNECT_TIMEOUT, set_as_default=False)
    except (OSError, ValueError) as error:
        raise ClusterUnreachable(
            f"No Dask scheduler answers at {address}: {error}. Is it started, and reachable from here?"
        ) from error
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            raise ClusterUnreachable(f"The scheduler at {address} has no workers. Start one: dask worker {address}.")
        yield client.get_executor(), threads
