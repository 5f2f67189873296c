"""The memory of one submission: what all its processes hold together, read from /proc while it runs.

Inside, RLIMIT_AS limits the address space of a process, the scratch folder has a size, and nothing else holds memory, because
neither new processes nor sockets nor files in memory are allowed. This is the second layer, and it counts.
"""

import os
import re
from contextlib import suppress
from pathlib import Path

from misstep.grading.sandbox.rootfs import SCRATCH

PROC = Path("/proc")
BYTES_PER_MB = 1 << 20


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
