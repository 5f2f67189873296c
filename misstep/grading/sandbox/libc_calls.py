"""The Linux system calls that a sandbox needs and that Python's library does not have, called through libc."""

import ctypes
import os
from typing import Any

NEWNS, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET = 0x20000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000
"""Flags for namespaces: mounts, host name, shared memory, users, processes, network."""

READ_ONLY, NOSUID, NODEV, NOEXEC, REMOUNT, BIND, RECURSIVE, PRIVATE = 1, 2, 4, 8, 32, 4096, 16384, 1 << 18
"""Flags of mount."""

MNT_DETACH = 2
PR_SET_PDEATHSIG = 1
CAPABILITY_VERSION_3 = 0x20080522


def call(name: str, *arguments: Any) -> None:
    """Call a function of libc.

    Raises OSError with the name of the function if it fails.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    if getattr(libc, name)(*arguments) != 0:
        error = ctypes.get_errno()
        raise OSError(error, f"{name}: {os.strerror(error)}")


def unshare(flags: int) -> None:
    """Move this process into new namespaces. A new pid namespace starts with the next fork."""
    call("unshare", flags)


def mount(source: str, target: str, kind: str = "none", flags: int = 0, options: str = "") -> None:
    """Mount source on target."""
    texts = (text.encode() for text in (source, target, kind))
    call("mount", *texts, ctypes.c_ulong(flags), options.encode() or None)


def pivot_root(new: str, old: str) -> None:
    """Make the folder `new` the root, and move the old root to the folder `old`."""
    call("pivot_root", new.encode(), old.encode())


def detach(target: str) -> None:
    """Unmount lazily: the mount disappears at once, and is released when it is no longer used."""
    call("umount2", target.encode(), MNT_DETACH)


def locked_flags(path: str) -> int:
    """The flags that a mount already has, which cannot be removed inside a user namespace."""
    flags = os.statvfs(path).f_flag
    mount_flags = {os.ST_NOSUID: NOSUID, os.ST_NODEV: NODEV, os.ST_NOEXEC: NOEXEC}
    return sum(mount_flag for stat_flag, mount_flag in mount_flags.items() if flags & stat_flag)


def end_with_parent(signal: int) -> None:
    """Let the kernel send this signal to this process when its parent ends."""
    call("prctl", PR_SET_PDEATHSIG, signal, 0, 0, 0)


def drop_capabilities() -> None:
    """Give up every capability (special right) of this process."""
    header = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
    call("capset", header, (ctypes.c_uint32 * 6)())
