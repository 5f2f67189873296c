"""The cage of one submission: what a process gives up before it runs code that it does not know."""

import errno
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from misstep.grading.sandbox import syscalls
from misstep.grading.sandbox.course_stub import CourseSetup
from misstep.grading.sandbox.limits import Limits, layer
from misstep.grading.sandbox.rootfs import DEVICES, NAMESPACES, SCRATCH, readable

FORBIDDEN = (
    *("socket", "connect", "bind", "listen", "accept", "accept4"),
    *("execve", "execveat", "fork", "vfork"),
    *("ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "kcmp", "pidfd_open", "pidfd_getfd"),
    *("mount", "umount2", "pivot_root", "chroot", "unshare", "setns", "open_tree", "move_mount", "fsopen", "fsmount"),
    *("fsconfig", "fspick", "mount_setattr", "name_to_handle_at", "open_by_handle_at", "fanotify_init", "quotactl"),
    *("bpf", "perf_event_open", "userfaultfd", "io_uring_setup", "io_uring_enter", "io_uring_register"),
    *("add_key", "request_key", "keyctl", "syslog", "reboot", "kexec_load", "init_module", "finit_module", "acct"),
    *("delete_module", "swapon", "swapoff", "sethostname", "setdomainname", "settimeofday", "clock_settime"),
    *("adjtimex", "personality", "iopl", "ioperm", "vhangup", "msgget", "semget", "shmget", "mq_open"),
)
"""System calls that no answer needs: doors to the network, to programs, to other processes, to the kernel itself."""

THREAD = 0x10000
"""The flag by which clone makes a thread. Without it, clone makes a process."""

MB = 1 << 20


class Cage:
    """Every layer of one submission's sandbox. The server builds it once; each child that it forks enters.

    Raises Missing for a layer that this machine lacks.
    """

    def __init__(self, setup: CourseSetup) -> None:
        self.hidden = setup.hidden
        self._readable = [path for path in readable(setup.readable) if not Path(path).is_symlink()]
        self._count = 0
        with layer("namespaces", NAMESPACES):
            self._own_pids = os.open("/proc/self/ns/pid", os.O_RDONLY | os.O_CLOEXEC)
            self._users = sum(int(line.split()[2]) for line in Path("/proc/self/uid_map").read_text().splitlines())
        with layer("landlock", "Install it with: pip install 'misstep[grading]'. The kernel must be 5.13 or newer."):
            import landlock

            if landlock.landlock_abi_version() < 1:
                raise OSError("the kernel was started without it")
            self._landlock = landlock
        with layer(
            "seccomp", "Install it with: pip install 'misstep[grading]', and libseccomp2 (apt install libseccomp2)."
        ):
            self._filter = _filter()

    def before_fork(self) -> None:
        """Let the next fork begin a pid namespace of its own."""
        self._count += 1
        syscalls.call("setns", self._own_pids, syscalls.NEWPID)
        syscalls.unshare(syscalls.NEWPID)

    def enter(self, limits: Limits) -> None:
        """Give up everything that an answer does not need."""
        with layer("namespaces", NAMESPACES):
            syscalls.unshare(syscalls.NEWNS | syscalls.NEWIPC | syscalls.NEWUTS | syscalls.NEWNET)
            options = f"size={limits.scratch}m,nr_inodes=4096,mode=1777"
            syscalls.mount("none", SCRATCH, "tmpfs", syscalls.NOSUID | syscalls.NODEV, options)
            os.chdir(SCRATCH)
        restrict(limits)
        with layer("user", "This needs the right to change the user id, or a user namespace."):
            if self._users > 1:  # in a namespace of our own there is only us, and without capabilities we are nobody
                stranger = self._users // 4 + self._count % (self._users // 4)
                os.setgroups([])
                os.setresgid(stranger, stranger, stranger)
                os.setresuid(stranger, stranger, stranger)
            syscalls.drop_capabilities()
            set_limits({"NPROC": limits.threads})
        with layer("landlock", "The kernel must be 5.13 or newer, with landlock among its security modules."):
            self._confine()
        with layer("seccomp", "The kernel must be built with CONFIG_SECCOMP_FILTER."):
            self._filter.load()

    def _confine(self) -> None:
        access = self._landlock.FSAccess
        rules = self._landlock.Ruleset()
        folders = [path for path in self._readable if Path(path).is_dir()]
        rules.allow(*folders, rules=access.READ_FILE | access.READ_DIR)
        rules.allow(*(path for path in self._readable if path not in folders), rules=access.READ_FILE)
        rules.allow(*DEVICES, rules=access.READ_FILE | access.WRITE_FILE)
        rules.allow(SCRATCH)
        rules.apply()


def restrict(limits: Limits) -> None:
    """Set what the kernel counts: time, memory, files."""
    set_limits(
        {
            "CPU": limits.processor_seconds,
            "AS": limits.memory * MB,
            "FSIZE": limits.files * MB,
            "NOFILE": 256,
            "CORE": 0,
        }
    )


def set_limits(most: Mapping[str, int]) -> None:
    """Set limits of this process, by the names that the kernel has for them."""
    import resource  # there is none on Windows, where this module can be read all the same

    for name, value in most.items():
        resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (value, value))


def holes(hidden: Sequence[str]) -> list[str]:
    """What can be done here that nobody in a cage should be able to do. Empty, if every layer holds."""
    tries: dict[str, Callable[[], Any]] = {
        "open a socket": _open_socket,
        "start a process": _start_process,
        "write to the root folder": lambda: Path("/written").write_text(""),
        "write beside the engine": lambda: Path(__file__).with_name("written").write_text(""),
        "read /etc/passwd": Path("/etc/passwd").read_text,
        "read a sheet": lambda: next(file for folder in hidden for file in Path(folder).rglob("*.py")),
        "see other processes": lambda: next(Path("/proc").glob("[0-9]*")),
        "become root": lambda: os.setresuid(0, 0, 0) if os.getuid() else _gain(),
    }
    found = []
    for name, attempt in tries.items():
        try:
            attempt()
        except (OSError, StopIteration):
            continue
        found.append(name)
    return found


def _open_socket() -> None:
    import socket

    socket.socket().close()


def _start_process() -> None:
    if os.fork() == 0:
        os._exit(0)


def _gain() -> None:
    """Root in a namespace of one user: what it may do there hangs on capabilities."""
    os.chroot(SCRATCH)


def _filter() -> Any:
    import pyseccomp

    rules = pyseccomp.SyscallFilter(pyseccomp.ALLOW)
    for name in FORBIDDEN:
        if pyseccomp.resolve_syscall(pyseccomp.system_arch(), name) != -1:  # older libraries do not know the newest
            rules.add_rule(pyseccomp.ERRNO(errno.EPERM), name)
    # clone3 hides its flags in memory, where a filter cannot look. libc falls back to clone when there is none.
    rules.add_rule(pyseccomp.ERRNO(errno.ENOSYS), "clone3")
    rules.add_rule(pyseccomp.ERRNO(errno.EPERM), "clone", pyseccomp.Arg(0, pyseccomp.MASKED_EQ, THREAD, 0))
    return rules
