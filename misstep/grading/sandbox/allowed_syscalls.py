"""The system calls that a submission may make, and the seccomp filter that refuses all others.

The list is what CPython, NumPy, SymPy, matplotlib and IPython use once they are loaded, on x86-64 and on aarch64. A call that
is not listed, or that a newer kernel adds, does not exist (ENOSYS), so that libraries fall back to an older one. There is
nothing to share memory with: no sockets, so no descriptors in flight, no memfd, no System V or POSIX queues and segments.
"""

import errno
from typing import Any

ALLOWED_SYSCALLS = (
    # files: Landlock and the root folder decide which
    *("open", "openat", "close", "close_range", "read", "write", "readv", "writev", "pread64", "pwrite64", "lseek"),
    *("stat", "fstat", "lstat", "newfstatat", "statx", "statfs", "fstatfs", "access", "faccessat", "faccessat2"),
    *("getdents", "getdents64", "getcwd", "chdir", "fchdir", "readlink", "readlinkat", "umask", "flock"),
    *("mkdir", "mkdirat", "rmdir", "unlink", "unlinkat", "rename", "renameat", "renameat2", "link", "linkat"),
    *("symlink", "symlinkat", "truncate", "ftruncate", "fallocate", "fsync", "fdatasync", "fadvise64"),
    *("chmod", "fchmod", "fchmodat", "utime", "utimes", "futimesat", "utimensat", "sendfile", "copy_file_range"),
    *("getxattr", "lgetxattr", "fgetxattr", "listxattr", "llistxattr", "flistxattr"),
    # descriptors inside the process
    *("dup", "dup2", "dup3", "pipe", "pipe2", "eventfd2", "poll", "ppoll", "select", "pselect6"),
    *("epoll_create", "epoll_create1", "epoll_ctl", "epoll_wait", "epoll_pwait"),
    # memory of the process, which RLIMIT_AS counts
    *("brk", "mmap", "munmap", "mremap", "mprotect", "madvise", "msync", "mincore", "membarrier"),
    # threads
    *("futex", "set_robust_list", "get_robust_list", "set_tid_address", "rseq", "gettid", "exit", "exit_group"),
    *("sched_yield", "sched_getaffinity", "sched_getparam", "sched_getscheduler", "getcpu"),
    *("sched_get_priority_max", "sched_get_priority_min", "getpriority", "setpriority"),
    # clocks and signals
    *("clock_gettime", "clock_getres", "clock_nanosleep", "nanosleep", "gettimeofday", "time", "times"),
    *("setitimer", "getitimer", "alarm", "pause", "timerfd_create", "timerfd_settime", "timerfd_gettime"),
    *("rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "rt_sigtimedwait", "rt_sigsuspend"),
    *("sigaltstack", "restart_syscall", "kill", "tkill", "tgkill", "wait4", "waitid"),
    # what the process is told about itself and the machine
    *("getpid", "getppid", "getpgid", "getpgrp", "getsid", "getuid", "geteuid", "getgid", "getegid", "getgroups"),
    *("getresuid", "getresgid", "getrusage", "getrlimit", "prlimit64", "uname", "sysinfo", "getrandom"),
)
"""What a submission may call, with any arguments."""

ALLOWED_COMMANDS = {
    # F_DUPFD, F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_GETLK, F_SETLK, F_SETLKW, the same of open files, F_DUPFD_CLOEXEC;
    # not F_SETPIPE_SZ, which makes a pipe a store of memory, and not F_SETOWN, which sends signals
    "fcntl": (0, 1, 2, 3, 4, 5, 6, 7, 36, 37, 38, 1030),
    # TCGETS (is it a terminal?), TIOCGWINSZ (its size), FIONREAD, FIONBIO, FIONCLEX, FIOCLEX
    "ioctl": (0x5401, 0x5413, 0x541B, 0x5421, 0x5450, 0x5451),
}
"""Calls of which only some commands (the second argument) may be made. The numbers are the same on x86-64 and aarch64."""

REFUSED_SYSCALLS = ("execve", "execveat", "fork", "vfork", "socket", "socketpair")
"""What a notebook may well try, for which "Operation not permitted" is the better message."""

CLONE_THREAD = 0x10000
"""The flag with which clone makes a thread. Without it, clone makes a process."""


def syscall_filter() -> Any:
    """Return the seccomp filter that allows these calls and threads, and refuses all others. A call by the numbers of another
    machine, such as i386 or x32, ends the process.
    """
    import pyseccomp as seccomp

    rules = seccomp.SyscallFilter(seccomp.ERRNO(errno.ENOSYS))
    for names, action in ((ALLOWED_SYSCALLS, seccomp.ALLOW), (REFUSED_SYSCALLS, seccomp.ERRNO(errno.EPERM))):
        for name in names:
            if seccomp.resolve_syscall(seccomp.system_arch(), name) >= 0:  # some exist on x86-64 only
                rules.add_rule(action, name)
    for name, commands in ALLOWED_COMMANDS.items():
        for command in commands:
            rules.add_rule(seccomp.ALLOW, name, seccomp.Arg(1, seccomp.EQ, command))
    # clone3 passes its flags in memory, which a filter cannot read. libc falls back to clone if there is no clone3.
    for action, flag in ((seccomp.ALLOW, CLONE_THREAD), (seccomp.ERRNO(errno.EPERM), 0)):
        rules.add_rule(action, "clone", seccomp.Arg(0, seccomp.MASKED_EQ, CLONE_THREAD, flag))
    return rules
