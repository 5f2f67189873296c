"""The root folder of submissions: the interpreter, its packages, what the course requires, and nothing else.

The server enters this root folder once, before the first submission. Every process that it forks starts inside.
"""

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from misstep.grading.sandbox import libc_calls
from misstep.grading.sandbox.libc_calls import BIND, NODEV, NOSUID, PRIVATE, READ_ONLY, RECURSIVE, REMOUNT
from misstep.grading.sandbox.limits import sandbox_layer

PREFIX_FOLDERS = ("bin", "sbin", "lib", "lib32", "lib64", "libexec", "share", "pyvenv.cfg")
"""What is read of a prefix such as /usr or a virtual environment. Its other folders may hold a project, with solutions."""

SYSTEM_PREFIXES = ("/", "/usr", "/usr/local")
SYSTEM_FILES = ("/etc/ld.so.cache", "/etc/localtime")
DEVICES = ("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")

SCRATCH = "/scratch"
"""The only folder that a submission can write to. Each submission has its own, in memory, and it is deleted with it."""

TEMPORARY = "/tmp"  # noqa: S108
"""The new root is built here. Inside the new root, this is another name of the scratch folder."""

NAMESPACES_REMEDY = (
    "As root in a container, start it with --cap-add SYS_ADMIN --security-opt seccomp=unconfined --security-opt "
    "apparmor=unconfined. As a user, allow user namespaces: sudo sysctl -w user.max_user_namespaces=10000, and on Ubuntu "
    "23.10 or newer also: sudo sysctl -w kernel.apparmor_restrict_unprivileged_userns=0."
)


def enter_namespaces() -> None:
    """Enter new namespaces of mounts, of users (unless this process is root), and, from the next fork on, of processes.

    Raises SandboxUnavailable if the kernel does not permit it.
    """
    with sandbox_layer(
        "namespaces", NAMESPACES_REMEDY if sys.platform == "linux" else "Grade on Linux, or in a Linux container."
    ):
        user, group = os.geteuid(), os.getegid()
        try:
            libc_calls.unshare(libc_calls.NEWNS | libc_calls.NEWPID)
        except PermissionError:  # not root, or only root of a container: inside a user namespace it is permitted
            libc_calls.unshare(libc_calls.NEWUSER | libc_calls.NEWNS | libc_calls.NEWPID)
            for name, text in {"setgroups": "deny", "uid_map": f"0 {user} 1", "gid_map": f"0 {group} 1"}.items():
                Path(f"/proc/self/{name}").write_text(text)


def readable_paths(required: Sequence[str]) -> list[str]:
    """The paths that the interpreter needs: itself, its packages, those that the course requires, the system's libraries."""
    prefixes = {*SYSTEM_PREFIXES, sys.prefix, sys.base_prefix, sys.exec_prefix}
    inside_prefixes = {str(Path(prefix, name)) for prefix in prefixes for name in PREFIX_FOLDERS} - {"/share"}
    packages = {path for path in sys.path if Path(path).name in {"site-packages", "dist-packages"}}
    paths = [path for path in sorted({*SYSTEM_FILES, *inside_prefixes, *packages, *required}) if Path(path).exists()]
    return [path for path in paths if not any(Path(other) in Path(path).parents for other in paths)]


def enter_root(paths: Sequence[str], hidden: Sequence[str]) -> None:
    """Make a root folder of these paths and the devices, all read-only, and detach the rest of the disk.

    hidden  folders with right answers, and the engine; where one of them is inside a path, an empty folder covers it

    Raises SandboxUnavailable if the kernel refuses a mount.
    """
    with sandbox_layer("namespaces", NAMESPACES_REMEDY):
        links = {path: Path(path).readlink() for path in paths if Path(path).is_symlink()}
        folders = [path for path in paths if path not in links]
        libc_calls.mount("none", "/", flags=RECURSIVE | PRIVATE)
        libc_calls.mount("none", TEMPORARY, "tmpfs", NOSUID, "mode=755,size=1m")
        Path(f"{TEMPORARY}/.old").mkdir()
        libc_calls.pivot_root(TEMPORARY, f"{TEMPORARY}/.old")
        os.chdir("/")
        for path, target in links.items():
            Path(path).parent.mkdir(parents=True, exist_ok=True)
            Path(path).symlink_to(target)
        for path in [*folders, *DEVICES]:
            _bind(Path(path), Path(f"/.old{path}"))
        for folder in hidden:
            if is_inside(folder, folders) and Path(folder).is_dir():
                libc_calls.mount("none", folder, "tmpfs", NOSUID | NODEV | READ_ONLY, "mode=755,size=4k")
        Path(SCRATCH).mkdir()
        if not Path(TEMPORARY).exists():  # an interpreter may be installed there
            Path(TEMPORARY).symlink_to(SCRATCH)
        libc_calls.detach("/.old")
        Path("/.old").rmdir()
        libc_calls.mount("none", "/", flags=REMOUNT | BIND | READ_ONLY | NOSUID)


def is_inside(folder: str, paths: Sequence[str]) -> bool:
    """Whether a folder is one of the paths, or inside one of them.

    >>> is_inside("/usr/lib/course", ["/usr/lib"]), is_inside("/srv", ["/srv/environment"])
    (True, False)
    """
    return any(Path(path) in [Path(folder), *Path(folder).parents] for path in paths)


def _bind(target: Path, source: Path) -> None:
    """Show the source at the target, read-only unless it is a device. The folders above are accessible to every user."""
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.is_dir():
        target.mkdir(exist_ok=True)
    else:
        target.touch()
    libc_calls.mount(str(source), str(target), flags=BIND | RECURSIVE)
    if str(target) not in DEVICES:
        libc_calls.mount(
            "none", str(target), flags=REMOUNT | BIND | READ_ONLY | NOSUID | libc_calls.locked_flags(str(target))
        )
