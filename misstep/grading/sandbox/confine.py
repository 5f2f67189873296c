"""The confinement of one submission: what a process gives up before it runs code that is not trusted."""

import errno
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from misstep.grading.sandbox import syscalls
from misstep.grading.sandbox.course_stub import CourseSetup
from misstep.grading.sandbox.limits import Limits, sandbox_layer
from misstep.grading.sandbox.rootfs import DEVICES, NAMESPACES_REMEDY, SCRATCH, readable_paths

FORBIDDEN_SYSCALLS = (
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
"""System calls that no answer needs. They give access to the network, programs, other processes and the kernel itself."""

CLONE_THREAD = 0x10000
"""The flag with which clone makes a thread. Without it, clone makes a process."""

BYTES_PER_MB = 1 << 20


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
        with sandbox_layer(
            "landlock", "Install it with: pip install 'misstep[grading]'. The kernel must be 5.13 or newer."
        ):
            import landlock

            if landlock.landlock_abi_version() < 1:
                raise OSError("the kernel was started without it")
            self._landlock = landlock
        with sandbox_layer(
            "seccomp", "Install it with: pip install 'misstep[grading]', and libseccomp2 (apt install libseccomp2)."
        ):
            self._filter = _syscall_filter()

    def prepare_fork(self) -> None:
        """Let the next fork start a pid namespace of its own."""
        self._fork_count += 1
        syscalls.call("setns", self._own_pid_namespace, syscalls.NEWPID)
        syscalls.unshare(syscalls.NEWPID)

    def apply(self, limits: Limits) -> None:
        """Give up everything that an answer does not need.

        Raises SandboxUnavailable for a layer that cannot be applied.
        """
        with sandbox_layer("namespaces", NAMESPACES_REMEDY):
            syscalls.unshare(syscalls.NEWNS | syscalls.NEWIPC | syscalls.NEWUTS | syscalls.NEWNET)
            options = f"size={limits.scratch_mb}m,nr_inodes=4096,mode=1777"
            syscalls.mount("none", SCRATCH, "tmpfs", syscalls.NOSUID | syscalls.NODEV, options)
            os.chdir(SCRATCH)
        limit_resources(limits)
        with sandbox_layer("user", "This needs the right to change the user id, or a user namespace."):
            if self._user_count > 1:  # a namespace of one user has no other id; without capabilities it has no rights
                user = self._user_count // 4 + self._fork_count % (self._user_count // 4)
                os.setgroups([])
                os.setresgid(user, user, user)
                os.setresuid(user, user, user)
            syscalls.drop_capabilities()
            set_resource_limits({"NPROC": limits.threads})
        with sandbox_layer("landlock", "The kernel must be 5.13 or newer, with landlock among its security modules."):
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
            "CPU": limits.processor_seconds,
            "AS": limits.memory_mb * BYTES_PER_MB,
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
        "open a socket": _open_socket,
        "start a process": _start_process,
        "write to the root folder": lambda: Path("/written").write_text(""),
        "write beside the engine": lambda: Path(__file__).with_name("written").write_text(""),
        "read /etc/passwd": Path("/etc/passwd").read_text,
        "read a sheet": lambda: next(
            file for folder in hidden for kind in ("*.py", "*.ipynb", "lecture_*/*") for file in Path(folder).glob(kind)
        ),
        "see other processes": lambda: next(Path("/proc").glob("[0-9]*")),
        "become root": lambda: os.setresuid(0, 0, 0) if os.getuid() else _use_capability(),
    }
    leaks = []
    for name, attempt in attempts.items():
        try:
            attempt()
        except (OSError, StopIteration):
            continue
        leaks.append(name)
    return leaks


def _open_socket() -> None:
    import socket

    socket.socket().close()


def _start_process() -> None:
    if os.fork() == 0:
        os._exit(0)


def _use_capability() -> None:
    """In a namespace of one user, every id is root's; what root may do there depends on its capabilities."""
    os.chroot(SCRATCH)


def _syscall_filter() -> Any:
    import pyseccomp

    rules = pyseccomp.SyscallFilter(pyseccomp.ALLOW)
    for name in FORBIDDEN_SYSCALLS:
        if pyseccomp.resolve_syscall(pyseccomp.system_arch(), name) != -1:  # older libraries lack the newest calls
            rules.add_rule(pyseccomp.ERRNO(errno.EPERM), name)
    # clone3 passes its flags in memory, which a filter cannot read. libc falls back to clone if there is no clone3.
    rules.add_rule(pyseccomp.ERRNO(errno.ENOSYS), "clone3")
    rules.add_rule(pyseccomp.ERRNO(errno.EPERM), "clone", pyseccomp.Arg(0, pyseccomp.MASKED_EQ, CLONE_THREAD, 0))
    return rules
