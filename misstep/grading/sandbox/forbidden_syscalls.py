"""The system calls that a submission may not make, and the seccomp filter that refuses them."""

import errno
from typing import Any

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


def syscall_filter() -> Any:
    """Return the seccomp filter that refuses the forbidden calls, and new processes; threads are allowed."""
    import pyseccomp

    rules = pyseccomp.SyscallFilter(pyseccomp.ALLOW)
    for name in FORBIDDEN_SYSCALLS:
        if pyseccomp.resolve_syscall(pyseccomp.system_arch(), name) != -1:  # older libraries lack the newest calls
            rules.add_rule(pyseccomp.ERRNO(errno.EPERM), name)
    # clone3 passes its flags in memory, which a filter cannot read. libc falls back to clone if there is no clone3.
    rules.add_rule(pyseccomp.ERRNO(errno.ENOSYS), "clone3")
    rules.add_rule(pyseccomp.ERRNO(errno.EPERM), "clone", pyseccomp.Arg(0, pyseccomp.MASKED_EQ, CLONE_THREAD, 0))
    return rules
