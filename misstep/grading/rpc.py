"""Messages between processes: JSON with its length in front, and a worker process that answers them."""

import itertools
import json
import os
import signal
import struct
import subprocess
import sys
import threading
from collections.abc import Mapping
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeout
from contextlib import suppress
from pathlib import Path
from typing import IO, Any, cast

LENGTH_HEADER = struct.Struct(">I")

MAX_MESSAGE_BYTES = 256 << 20
"""The longest message in bytes. A longer length means that the stream is corrupt."""

INHERITED_VARIABLES = ("PATH", "LANG", "LC_ALL", "HOME", "TMPDIR", "PYTHONPATH", "SYSTEMROOT")
"""The environment variables that a new process inherits. The instructor's keys and tokens are not among them."""

THREAD_VARIABLES = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


class ProcessEnded(RuntimeError):
    """The other process ended, or was ended because it took too long."""


def child_environment() -> dict[str, str]:
    """The environment of a new process: one thread for BLAS, no window, no secrets."""
    variables = {name: os.environ[name] for name in INHERITED_VARIABLES if name in os.environ}
    paths = [str(Path(__file__).parents[2]), *filter(None, variables.get("PYTHONPATH", "").split(os.pathsep))]
    # The process may start in another folder, so its paths must be absolute.
    variables["PYTHONPATH"] = os.pathsep.join(str(Path(path).resolve()) for path in paths)
    return {**variables, **dict.fromkeys(THREAD_VARIABLES, "1"), "MPLBACKEND": "agg"}


def encode_message(message: Mapping[str, Any]) -> bytes:
    """The bytes of a message: its length, then its JSON."""
    body = json.dumps(message, allow_nan=False).encode()
    return LENGTH_HEADER.pack(len(body)) + body


def receive_message(stream: IO[bytes]) -> dict[str, Any] | None:
    """Read the next message; None at the end of the stream."""
    header = stream.read(LENGTH_HEADER.size)
    if len(header) < LENGTH_HEADER.size:
        return None
    (size,) = LENGTH_HEADER.unpack(header)
    body = stream.read(size) if size <= MAX_MESSAGE_BYTES else b""
    return dict(json.loads(body)) if len(body) == size else None


class Worker:
    """A Python module that runs in a process of its own and answers messages. Any thread may send requests.

    The process is started by exec, so nothing of this process is in its memory. It has one thread for BLAS and an
    environment without secrets. Each message gets an id, so answers may arrive in any order,
    and the number of the thread that sends it.
    """

    def __init__(self, module: str, folder: Path, *arguments: str) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-P", "-m", module, *arguments],
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=child_environment(),
            start_new_session=True,
        )
        self._outbox, self._inbox = cast("IO[bytes]", self._process.stdin), cast("IO[bytes]", self._process.stdout)
        self._pending: dict[int, Future[dict[str, Any]]] = {}
        self._ids = itertools.count()
        self._send_lock = threading.Lock()
        threading.Thread(target=self._receive_answers, daemon=True).start()

    @property
    def pid(self) -> int:
        """The id of the process."""
        return self._process.pid

    @property
    def exit_code(self) -> int | None:
        """How the process ended: negative for a signal; None while it runs."""
        return self._process.poll()

    def send(self, message: Mapping[str, Any]) -> Future[dict[str, Any]]:
        """Send a message. The answer will be in the future that is returned, or the error ProcessEnded."""
        with self._send_lock:
            number, answer = next(self._ids), Future[dict[str, Any]]()
            self._pending[number] = answer
            try:
                self._outbox.write(encode_message({**message, "id": number, "thread": threading.get_ident()}))
                self._outbox.flush()
            except (OSError, ValueError):  # the pipe is broken, or closed already
                del self._pending[number]
                answer.set_exception(ProcessEnded("The process has ended."))
        return answer

    def request(self, message: Mapping[str, Any], seconds: float) -> dict[str, Any]:
        """Send a message and wait for its answer.

        Raises ProcessEnded if no answer arrives in time; then the process is ended too.
        """
        try:
            return self.send(message).result(seconds)
        except FutureTimeout as error:
            self.stop()
            raise ProcessEnded(f"The process gave no answer within {seconds:g} s.") from error

    def stop(self) -> None:
        """End the process and those that it forked. Every pending request raises ProcessEnded."""
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        with suppress(OSError), self._send_lock:  # what is still in the buffer can no longer be sent
            self._outbox.close()

    def _receive_answers(self) -> None:
        while (message := receive_message(self._inbox)) is not None:
            if (answer := self._pending.pop(message.pop("id", None), None)) is not None:
                answer.set_result(message)
        self._inbox.close()
        while self._pending:
            self._pending.popitem()[1].set_exception(ProcessEnded("The process has ended."))
