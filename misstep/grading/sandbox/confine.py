"""The confinement of one submission: what a process gives up before it runs code that is not trusted."""

import os
import socket
from collections.abc import Callable, Mapping, Sequence
from math import ceil
from pathlib import Path
from typing import Any

from misstep.grading.sandbox import libc_calls
from misstep.grading.sandbox.allowed_syscalls import syscall_filter
from misstep.grading.sandbox.course_stub import CourseSetup
from misstep.grading.sandbox.limits import BYTES_PER_MB, Limits, sandbox_layer
from misstep.grading.sandbox.rootfs import DEVICES, NAMESPACES_REMEDY, SCRATCH, readable_paths

LANDLOCK_REMEDY = (
    "The kernel must be 5.13 or newer, with landlock in the list /sys/kernel/security/lsm. "
    "If it is not there, start the kernel with lsm=landlock before the other names of that list."
)


class Confinement:
    """All layers of a submission's sandbox. The server prepares it once, and each process that it forks applies it.

    Raises SandboxUnavailable for a layer that this machine cannot provide.
    """

    def __init__(self, setup: CourseSetup) -> None:
        self.hidden = setup.hidden
        self._readable = [path for path in readable_paths(setup.readable) if not Path(path).is_symlink()]
        self._fork_count = 0
        with sandbox_layer("namespaces", NAMESPACES_REMEDY):
            self._own_pid_namespace = os.open("/proc/self/ns/pid", os.O_RDONLY | os.O_CLOEXEC)
            self._user_count = sum(int(line.split()[2]) for line in Path("/proc/self/uid_map").read_text().splitlines())
        with sandbox_layer("landlock", "Install it with: pip install 'misstep[grading]'."):
            import landlock
        with sandbox_layer("landlock", LANDLOCK_REMEDY):
            if landlock.landlock_abi_version() < 1:
                raise OSError("the kernel was started without it")
            self._landlock = landlock
        with sandbox_layer(
            "seccomp", "Install it with: pip install 'misstep[grading]', and libseccomp2 (apt install libseccomp2)."
        ):
            self._filter = syscall_filter()

    def prepare_fork(self) -> None:
        """Let the next fork start a pid namespace of its own."""
        self._fork_count += 1
        libc_calls.call("setns", self._own_pid_namespace, libc_calls.NEWPID)
        libc_calls.unshare(libc_calls.NEWPID)

    def apply(self, limits: Limits) -> None:
        """Give up everything that an answer does not need.

        Raises SandboxUnavailable for a layer that cannot be applied.
        """
        with sandbox_layer("namespaces", NAMESPACES_REMEDY):
            libc_calls.unshare(libc_calls.NEWNS | libc_calls.NEWIPC | libc_calls.NEWUTS | libc_calls.NEWNET)
            options = f"size={limits.scratch_mb}m,nr_inodes=4096,mode=1777"
            libc_calls.mount("none", SCRATCH, "tmpfs", libc_calls.NOSUID | libc_calls.NODEV, options)
            os.chdir(SCRATCH)
        limit_resources(limits)
        with sandbox_layer("user", "This needs the right to change the user id, or a user namespace."):
            if self._user_count > 1:  # a namespace of one user has no other id; without capabilities it has no rights
                user = self._user_count // 4 + self._fork_count % (self._user_count // 4)
                os.setgroups([])
                os.setresgid(user, user, user)
                os.setresuid(user, user, user)
            libc_calls.drop_capabilities()
            set_resource_limits({"NPROC": limits.threads})
        with sandbox_layer("landlock", LANDLOCK_REMEDY):
            self._restrict_files()
        with sandbox_layer("seccomp", "The kernel must be built with CONFIG_SECCOMP_FILTER."):
            self._filter.load()

    def _restrict_files(self) -> None:
        access = self._landlock.FSAccess
        rules = self._landlock.Ruleset()
        folders = [path for path in self._readable if Path(path).is_dir()]
        rules.allow(*folders, rules=access.READ_FILE | access.READ_DIR)
        rules.allow(*(path for path in self._readable if path not in folders), rules=access.READ_FILE)
        rules.allow(*DEVICES, rules=access.READ_FILE | access.WRITE_FILE)
        rules.allow(SCRATCH)
        rules.apply()


def limit_resources(limits: Limits) -> None:
    """Set the limits that the kernel itself enforces: processor time, memory, files."""
    set_resource_limits(
        {
            "CPU": ceil(limits.seconds),
            "AS": (limits.memory_mb - limits.scratch_mb) * BYTES_PER_MB,  # files in the scratch folder are memory, too
            "FSIZE": limits.file_mb * BYTES_PER_MB,
            "NOFILE": 256,
            "CORE": 0,
        }
    )


def set_resource_limits(maxima: Mapping[str, int]) -> None:
    """Set resource limits of this process, by the names that the kernel has for them."""
    import resource  # Windows has no such module, and this file can be imported there all the same

    for name, value in maxima.items():
        resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (value, value))


def find_leaks(hidden: Sequence[str]) -> list[str]:
    """Try what a confined process must not be able to do, and list what succeeds. The list is empty if every layer works.

    hidden  folders that must look empty
    """
    attempts: dict[str, Callable[[], Any]] = {
        "open a socket": socket.socket,
        "keep memory in sockets": socket.socketpair,
        "make a file in memory": lambda: os.memfd_create(""),
        "start a process": lambda: os.fork() or os._exit(0),
        "write to the root folder": lambda: Path("/written").write_text(""),
        "write beside the packages": lambda: Path(os.__file__).with_name("written").write_text(""),
        "read /etc/passwd": Path("/etc/passwd").read_text,
        "read a sheet": lambda: next(
            file for folder in hidden for kind in ("*.py", "*.ipynb", "lecture_*/*") for file in Path(folder).glob(kind)
        ),
        "see other processes": lambda: next(Path("/proc").glob("[0-9]*")),
        # In a namespace of one user, every id is root's; what root may do there depends on its capabilities.
        "become root": lambda: os.setresuid(0, 0, 0) if os.getuid() else os.chroot(SCRATCH),
    }
    leaks = []
    for name, attempt in attempts.items():
        try:
            attempt()
        except (OSError, StopIteration):
            continue
        leaks.append(name)
    return leaks
