"""The memory of one submission: what all its processes hold together, and its limit, which is enforced from outside.

Inside, RLIMIT_AS limits the address space of a process, the scratch folder has a size, and nothing else holds memory, because
neither new processes nor sockets nor files in memory are allowed. This is the second layer, and it counts. Where a cgroup
(version 2) is delegated to the instructor, the kernel does so; otherwise the memory is read from /proc while the submission
runs.
"""

import itertools
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from misstep.grading.sandbox.rootfs import SCRATCH

PROC, CGROUPS = Path("/proc"), Path("/sys/fs/cgroup")
BYTES_PER_MB = 1 << 20
GROUP_NUMBERS = itertools.count()


class MemoryLimit:
    """Counts the memory of a process and its descendants.

    process  the id of a process that has not yet run any code of the submission; 0 if the system has no such id
    group    the cgroup of this submission; None if there is none, or if the process cannot be moved into it
    """

    def __init__(self, process: int, megabytes: int, group: Path | None = None) -> None:
        self.group = None
        self._process, self._max_bytes = process, megabytes * BYTES_PER_MB
        if group and process:
            with suppress(OSError):  # then the memory is read from /proc
                (group / "memory.max").write_text(str(self._max_bytes))
                with suppress(OSError):  # without swap there is no such file
                    (group / "memory.swap.max").write_text("0")
                (group / "cgroup.procs").write_text(str(process))
                self.group = group

    def is_exceeded(self) -> bool:
        """Whether the processes hold more than they may, or were ended because they asked for more."""
        if self.group is None:
            return held_bytes(self._process) > self._max_bytes
        events = (self.group / "memory.events").read_text()
        return re.search(r"^oom_kill [1-9]", events, re.MULTILINE) is not None


@contextmanager
def limit_memory(process: int, megabytes: int) -> Iterator[MemoryLimit]:
    """Limit the memory of a process and its descendants. All of them must have ended when the context is left."""
    parent = delegated_cgroup()
    group = parent / f"misstep-{os.getpid()}-{next(GROUP_NUMBERS)}" if parent else None
    try:
        if group:
            group.mkdir()
        yield MemoryLimit(process, megabytes, group)
    finally:
        if group:
            with suppress(OSError):
                group.rmdir()


def delegated_cgroup(proc: Path = PROC, cgroups: Path = CGROUPS) -> Path | None:
    """The nearest cgroup above this process in which it may make others with a limit of memory; None if there is none.

    systemd delegates such a group to every user who is logged in, and root has one anyway. Most containers have none.
    """
    with suppress(OSError):
        own = re.search(r"^0::/(.*)$", (proc / "self" / "cgroup").read_text(), re.MULTILINE)
        path = cgroups / (own[1] if own else "")
        for group in (path, *path.parents) if own else ():
            files = (group / "cgroup.procs", group / "cgroup.subtree_control")
            if not group.is_relative_to(cgroups) or not all(os.access(file, os.W_OK) for file in (group, *files)):
                continue
            if "memory" in files[1].read_text().split():
                return group
    return None


def held_bytes(process: int, proc: Path = PROC) -> int:
    """The memory that a process and its descendants hold, with their open files in memory and those in their scratch folder.

    Pages that several processes share are counted once, if the kernel lets this process see which they are.
    """
    total, files = 0, dict[int, int]()
    for number in process_tree(process, proc):
        folder = proc / str(number)
        with suppress(OSError, IndexError):  # it has ended meanwhile
            try:
                pages = re.findall(r"^(?:Pss|Swap):\s+(\d+) kB$", (folder / "smaps_rollup").read_text(), re.MULTILINE)
                total += 1024 * sum(map(int, pages))
            except PermissionError:
                total += os.sysconf("SC_PAGE_SIZE") * int((folder / "statm").read_text().split()[1])
            for link in (folder / "fd").iterdir():
                if str(link.readlink()).startswith("/memfd:"):
                    files[link.stat().st_ino] = 512 * link.stat().st_blocks
    with suppress(OSError):
        scratch = os.statvfs(f"{proc}/{process}/root{SCRATCH}")
        total += scratch.f_frsize * (scratch.f_blocks - scratch.f_bfree)
    return total + sum(files.values())


def process_tree(process: int, proc: Path = PROC) -> list[int]:
    """A process and all its descendants, by their ids."""
    children: list[int] = []
    with suppress(OSError):
        for task in (proc / str(process) / "task").iterdir():
            children += map(int, (task / "children").read_text().split())
    return [process, *(number for child in children for number in process_tree(child, proc))]
