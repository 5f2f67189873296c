"""The kernel's calls that make a sandbox and have no name in Python's library, through libc."""

import ctypes
import os
from typing import Any

NEWNS, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET = 0x20000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000
"""Namespaces: of mounts, host name, shared memory, users, processes, network."""

READ_ONLY, NOSUID, NODEV, NOEXEC, REMOUNT, BIND, RECURSIVE, PRIVATE = 1, 2, 4, 8, 32, 4096, 16384, 1 << 18
"""How to mount."""

DETACH = 2
PARENT_DIED = 1
CAPABILITIES_3 = 0x20080522


def call(name: str, *arguments: Any) -> None:
    """Call a function of libc. Raises OSError with its name when it fails."""
    libc = ctypes.CDLL(None, use_errno=True)
    if getattr(libc, name)(*arguments) != 0:
        error = ctypes.get_errno()
        raise OSError(error, f"{name}: {os.strerror(error)}")


def unshare(kinds: int) -> None:
    """Leave namespaces for new ones. A new pid namespace begins with the next fork."""
    call("unshare", kinds)


def mount(source: str, target: str, kind: str = "none", flags: int = 0, options: str = "") -> None:
    """Mount source on target."""
    texts = (text.encode() for text in (source, target, kind))
    call("mount", *texts, ctypes.c_ulong(flags), options.encode() or None)


def pivot_root(new: str, old: str) -> None:
    """Make the folder new the root; the old root goes to the folder old."""
    call("pivot_root", new.encode(), old.encode())


def detach(target: str) -> None:
    """Take a mount out of sight, and away as soon as nobody uses it."""
    call("umount2", target.encode(), DETACH)


def locked_flags(path: str) -> int:
    """The flags that a mount has already: inside a user namespace they cannot be taken away."""
    flags = os.statvfs(path).f_flag
    kept = {os.ST_NOSUID: NOSUID, os.ST_NODEV: NODEV, os.ST_NOEXEC: NOEXEC}
    return sum(mount_flag for stat_flag, mount_flag in kept.items() if flags & stat_flag)


def end_with_parent(signal: int) -> None:
    """Get this signal when the parent ends."""
    call("prctl", PARENT_DIED, signal, 0, 0, 0)


def drop_capabilities() -> None:
    """Give up every special right."""
    header = (ctypes.c_uint32 * 2)(CAPABILITIES_3, 0)
    call("capset", header, (ctypes.c_uint32 * 6)())
