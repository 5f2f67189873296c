"""The folder that submissions live in: the interpreter, its packages, kinlib without sheets, and nothing else.

The server moves there once, before the first submission, and all that it forks is born there.
"""

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from misstep.grading.sandbox import syscalls
from misstep.grading.sandbox.limits import layer
from misstep.grading.sandbox.syscalls import BIND, NODEV, NOSUID, PRIVATE, READ_ONLY, RECURSIVE, REMOUNT

SYSTEM = ("/usr", "/lib", "/lib32", "/lib64", "/bin", "/sbin", "/etc/ld.so.cache", "/etc/localtime")
DEVICES = ("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")

SCRATCH = "/scratch"
"""The one folder that can be written to: each submission's own, in memory, gone with it."""

COMMON = "/tmp"  # noqa: S108
"""Everybody's folder: for us the place where the new root is built, for a submission another name of its own folder."""

NAMESPACES = (
    "As root in a container, start it with --cap-add SYS_ADMIN --security-opt seccomp=unconfined --security-opt "
    "apparmor=unconfined. As a user, let user namespaces in: sysctl user.max_user_namespaces=10000, and on Ubuntu "
    "sysctl syscalls.apparmor_restrict_unprivileged_userns=0."
)


def leave_session() -> None:
    """Enter namespaces of users (unless we are the machine's root), of mounts and, from the next fork on, of processes.

    Raises Missing where the kernel does not let us.
    """
    with layer("namespaces", NAMESPACES if sys.platform == "linux" else "Grade on Linux, or in a Linux container."):
        user, group = os.geteuid(), os.getegid()
        try:
            syscalls.unshare(syscalls.NEWNS | syscalls.NEWPID)
        except PermissionError:  # not root, or root of a container only: inside a user namespace anybody may
            syscalls.unshare(syscalls.NEWUSER | syscalls.NEWNS | syscalls.NEWPID)
            for name, text in {"setgroups": "deny", "uid_map": f"0 {user} 1", "gid_map": f"0 {group} 1"}.items():
                Path(f"/proc/self/{name}").write_text(text)


def readable(required: Sequence[str]) -> list[str]:
    """What the interpreter needs of the disk: itself, its packages, those that the course requires, the system's libraries."""
    packages = [path for path in sys.path if Path(path).name in {"site-packages", "dist-packages"}]
    wanted = {*SYSTEM, sys.prefix, sys.base_prefix, sys.exec_prefix, *packages, *required}
    found = [path for path in sorted(wanted) if Path(path).exists()]
    return [path for path in found if not any(Path(other) in Path(path).parents for other in found)]


def move_in(paths: list[str], hidden: Sequence[str]) -> None:
    """Make a root folder of these paths and the devices, all read-only, and forget the rest of the disk.

    hidden  folders with right answers, and the engine: where one of them lies below a path, an empty folder covers it

    Raises Missing where the kernel refuses a mount.
    """
    with layer("namespaces", NAMESPACES):
        links = {path: Path(path).readlink() for path in paths if Path(path).is_symlink()}
        syscalls.mount("none", "/", flags=RECURSIVE | PRIVATE)
        syscalls.mount("none", COMMON, "tmpfs", NOSUID, "mode=755,size=1m")
        Path(f"{COMMON}/.old").mkdir()
        syscalls.pivot_root(COMMON, f"{COMMON}/.old")
        os.chdir("/")
        for path, target in links.items():
            Path(path).parent.mkdir(parents=True, exist_ok=True)
            Path(path).symlink_to(target)
        for path in [path for path in (*paths, *DEVICES) if path not in links]:
            _cover(Path(path), Path(f"/.old{path}"))
        for folder in hidden:
            if Path(folder).is_dir():
                syscalls.mount("none", folder, "tmpfs", NOSUID | NODEV | READ_ONLY, "mode=755,size=4k")
        Path(SCRATCH).mkdir()
        if not Path(COMMON).exists():  # an interpreter may live there
            Path(COMMON).symlink_to(SCRATCH)
        syscalls.detach("/.old")
        Path("/.old").rmdir()
        syscalls.mount("none", "/", flags=REMOUNT | BIND | READ_ONLY | NOSUID)


def _cover(target: Path, source: Path) -> None:
    """Show the source at the target, read-only unless it is a device; everybody may pass through the folders above."""
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.is_dir():
        target.mkdir(exist_ok=True)
    else:
        target.touch()
    syscalls.mount(str(source), str(target), flags=BIND | RECURSIVE)
    if str(target) not in DEVICES:
        syscalls.mount(
            "none", str(target), flags=REMOUNT | BIND | READ_ONLY | NOSUID | syscalls.locked_flags(str(target))
        )
