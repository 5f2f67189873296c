"""Copy one notebook from the folder of each student, as it is now, for `misstep grade`.

    sudo python3 deploy/collect.py /home sheets/exercises/03_poe_space/03_poe_space.ipynb submissions

A student may put a link in the place of the notebook, and this runs with the rights to read everybody's files. Therefore no
link is followed, and only a regular file is copied.
"""

import os
import shutil
import stat
import sys
from pathlib import Path

MAX_BYTES = 50_000_000
"""No larger file is copied; a solved sheet has less than one million bytes."""


def collect(homes: Path, notebook: Path, out: Path) -> dict[str, str]:
    """Copy the notebook of each student to out/<student>/<notebook>. Returns for each student what was not copied, and why."""
    missing = {}
    for student in sorted(path.name for path in homes.iterdir() if path.is_dir() and not path.is_symlink()):
        target = out / student / notebook.name
        try:
            with open_without_links(homes / student, notebook) as source:
                target.parent.mkdir(parents=True, exist_ok=True)
                with target.open("wb") as copy:
                    shutil.copyfileobj(source, copy)
                status = os.fstat(source.fileno())
                os.utime(target, ns=(status.st_mtime_ns, status.st_mtime_ns))
        except OSError as error:
            missing[student] = error.strerror or str(error)
    return missing


def open_without_links(folder: Path, path: Path):
    """Open a regular file below a folder for reading.

    Raises OSError if a part of the path is a link or does not exist, or if the file is no regular file or too large.
    """
    current = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    for depth, part in enumerate(path.parts, start=1):
        kind = os.O_DIRECTORY if depth < len(path.parts) else os.O_NONBLOCK  # a pipe must not make this wait
        try:
            inner = os.open(part, os.O_RDONLY | os.O_NOFOLLOW | kind, dir_fd=current)
        finally:
            os.close(current)
        current = inner
    file = os.fdopen(current, "rb")
    status = os.fstat(current)
    if not stat.S_ISREG(status.st_mode) or status.st_size > MAX_BYTES:
        file.close()
        raise OSError(f"it must be a regular file of at most {MAX_BYTES} bytes")
    return file


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    homes, notebook, out = map(Path, sys.argv[1:])
    missing = collect(homes, notebook, out)
    for student, reason in missing.items():
        print(f"{student}: not collected. {reason}")
    print(f"{len(list(out.iterdir())) if out.is_dir() else 0} notebooks are in {out}")
