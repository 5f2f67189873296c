"""Processes that are forked from a server, which has imported everything once: a new one costs some milliseconds.

A server is a Python module, started by exec, so nothing of the process that grades is in its memory. Its first argument is the
descriptor of a Unix socket. The first message is the setup; it is no argument, because submissions can read the arguments of their
process, and it names folders. The answer says whether the server is ready. Then there are two messages. "fork" has descriptors with
it, for a new process; the answer is its id. "end ID" kills that process; the answer has its exit status, its processor time in seconds,
and its memory in MB.
"""

import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

INHERITED_VARIABLES = ("PATH", "LANG", "LC_ALL", "HOME", "TMPDIR", "PYTHONPATH", "SYSTEMROOT")
"""The environment variables that a server inherits. The instructor's keys and tokens are not among them."""

THREAD_VARIABLES = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")

START_SECONDS = 120.0
"""How long a server may take to import everything. The first import of matplotlib also indexes all fonts."""

MESSAGE_BYTES = 1 << 20


class ProcessEnded(RuntimeError):
    """The other process ended, or could not start."""


class Child(NamedTuple):
    """A forked process: the server that knows it, and its id there, which is another one outside of a pid namespace."""

    server: subprocess.Popen[bytes]
    number: int


def child_environment() -> dict[str, str]:
    """The environment of a new process: one thread for BLAS, no window, no secrets."""
    variables = {name: os.environ[name] for name in INHERITED_VARIABLES if name in os.environ}
    paths = [str(Path(__file__).parents[2]), *filter(None, variables.get("PYTHONPATH", "").split(os.pathsep))]
    # The process may start in another folder, so its paths must be absolute.
    variables["PYTHONPATH"] = os.pathsep.join(str(Path(path).resolve()) for path in paths)
    return {**variables, **dict.fromkeys(THREAD_VARIABLES, "1"), "MPLBACKEND": "agg"}


class ForkServer:
    """A server, which starts while this process goes on. Any thread may use it. If it has ended, it is started anew, once for each fork.

    module     the module that calls `serve`
    setup      what JSON can hold of what it needs to know
    arguments  further arguments of the module
    """

    def __init__(self, module: str, setup: Mapping[str, Any], *arguments: str) -> None:
        self._command, self._setup = ["-P", "-m", module], json.dumps(setup).encode()
        self._arguments, self._lock, self._is_closed, self._unavailable = arguments, threading.Lock(), False, ""
        self._scratch = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._start()

    def wait_until_ready(self) -> None:
        """Raises ProcessEnded with the reason if the server cannot start."""
        with self._lock:
            self._wait()

    def fork(self, *descriptors: int) -> Child:
        """Fork a process that gets these descriptors.

        Raises ProcessEnded if the server ended or was closed meanwhile.
        """
        with self._lock:
            try:
                return self._fork(descriptors)
            except ProcessEnded:
                if self._is_closed:
                    raise
            self._start()
            return self._fork(descriptors)

    def end(self, child: Child) -> dict[str, Any]:
        """End a process; what it used, and its exit status, which is negative for a signal.

        Raises ProcessEnded if the server has ended.
        """
        with self._lock:
            if child.server is not self.process:
                raise ProcessEnded("The server of this process has ended.")
            return dict(json.loads(self._request(b"end %d" % child.number)))

    def close(self) -> None:
        """End the server and all that it has forked. A thread that waits for it gets ProcessEnded."""
        self._is_closed = True
        self._stop()  # so that nobody waits for it
        with self._lock:
            self._stop()  # one that was started meanwhile
        self._scratch.cleanup()

    def _start(self) -> None:
        self._socket, server_socket = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        descriptor, folder = server_socket.fileno(), self._scratch.name
        with server_socket:
            self.process = subprocess.Popen(
                [sys.executable, *self._command, str(descriptor), *self._arguments],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                pass_fds=[descriptor],
                env={**child_environment(), "TMPDIR": folder, "IPYTHONDIR": folder},
                start_new_session=True,
            )
        self._is_ready = False
        self._socket.settimeout(START_SECONDS)
        with suppress(OSError):  # it has ended already, and the next call that waits for it says so
            self._socket.sendall(self._setup)

    def _wait(self) -> None:
        if not self._is_ready:
            self._unavailable = self._unavailable or json.loads(self._receive())["unavailable"]
            if self._unavailable:
                self._is_closed = True  # starting it anew would not help
                self._stop()
                raise ProcessEnded(self._unavailable)
            self._is_ready = True

    def _fork(self, descriptors: Sequence[int]) -> Child:
        self._wait()
        return Child(self.process, int(self._request(b"fork", descriptors)))

    def _request(self, message: bytes, descriptors: Sequence[int] = ()) -> bytes:
        with suppress(OSError):  # receiving says that it has ended
            socket.send_fds(self._socket, [message], descriptors)
        return self._receive()

    def _receive(self) -> bytes:
        try:
            answer = self._socket.recv(MESSAGE_BYTES)
        except OSError:
            answer = b""
        if not answer:
            self._stop()  # a late answer must not be taken for that to a later message
            raise ProcessEnded("The server of processes has ended.")
        return answer

    def _stop(self) -> None:
        with suppress(ProcessLookupError):
            if self.process.poll() is None:
                os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self._socket.close()


def run_server(main: Callable[[socket.socket, dict[str, Any]], None]) -> None:
    """In a server: call its main function with the socket and the setup, until the process that grades has ended."""
    with (
        suppress(BrokenPipeError, ConnectionResetError, KeyboardInterrupt),
        socket.socket(fileno=int(sys.argv[1])) as parent,
    ):
        if message := parent.recv(MESSAGE_BYTES):
            main(parent, json.loads(message))


def greet(parent: socket.socket, unavailable: str = "") -> None:
    """In a server: say that it is ready, or why it cannot be."""
    parent.send(json.dumps({"unavailable": unavailable}).encode())


def serve(
    parent: socket.socket,
    run_child: Callable[..., Any],
    prepare_fork: Callable[[], None] | None = None,
    kill: Callable[[int], None] = lambda child: os.kill(child, signal.SIGKILL),
) -> None:
    """In a server: fork until the socket closes.

    run_child     what a forked process does, with its descriptors; then it ends
    prepare_fork  what is done before each fork
    kill          ends a process, which may have ended already
    """
    while True:
        message, descriptors, _, _ = socket.recv_fds(parent, 100, 2)
        match message.decode().split():
            case ["fork"]:
                if prepare_fork:
                    prepare_fork()
                if not (child := os.fork()):
                    _end_with(run_child, parent, descriptors)
                parent.send(b"%d" % child)
            case ["end", child_id]:
                with suppress(ProcessLookupError):
                    kill(int(child_id))
                _, status, usage = os.wait4(int(child_id), 0)
                used = {"processor_seconds": usage.ru_utime + usage.ru_stime, "memory_mb": usage.ru_maxrss / 1024}
                parent.send(json.dumps({"status": os.waitstatus_to_exitcode(status), **used}).encode())
            case _:
                return
        for descriptor in descriptors:
            os.close(descriptor)


def _end_with(run_child: Callable[..., Any], parent: socket.socket, descriptors: Sequence[int]) -> None:
    """In a forked process: forget the server's socket, do what is to be done, and end without cleaning up what is the server's."""
    try:
        parent.close()
        run_child(*descriptors)
        os._exit(0)
    finally:
        os._exit(1)
