"""Messages between processes: JSON with its length in front, and a process to talk to."""

import itertools
import json
import os
import struct
import subprocess
import sys
import threading
from collections.abc import Mapping
from concurrent.futures import Future
from concurrent.futures import TimeoutError as Late
from contextlib import suppress
from pathlib import Path
from typing import IO, Any, cast

HEAD = struct.Struct(">I")

LARGEST = 256 << 20
"""No message is longer, in bytes: what claims to be has lost its place in the stream."""

KEPT = ("PATH", "LANG", "LC_ALL", "HOME", "TMPDIR", "PYTHONPATH", "SYSTEMROOT")
"""What a process that we start inherits of the environment. Keys and tokens of whoever grades stay behind."""

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


class Gone(RuntimeError):
    """The other process ended, or was ended because it took too long."""


def environment() -> dict[str, str]:
    """The environment of a process that we start: one thread for BLAS, no window, no secrets."""
    kept = {name: os.environ[name] for name in KEPT if name in os.environ}
    paths = [str(Path(__file__).parents[3]), *filter(None, kept.get("PYTHONPATH", "").split(os.pathsep))]
    kept["PYTHONPATH"] = os.pathsep.join(str(Path(path).resolve()) for path in paths)  # it may start in another folder
    return {**kept, **dict.fromkeys(THREADS, "1"), "MPLBACKEND": "agg", "PYTHONDONTWRITEBYTECODE": "1"}


def pack(message: Mapping[str, Any]) -> bytes:
    """Write a message as it travels."""
    body = json.dumps(message, allow_nan=False).encode()
    return HEAD.pack(len(body)) + body


def receive(stream: IO[bytes]) -> dict[str, Any] | None:
    """Read the next message; None at the end of the stream."""
    head = stream.read(HEAD.size)
    if len(head) < HEAD.size:
        return None
    (size,) = HEAD.unpack(head)
    body = stream.read(size) if size <= LARGEST else b""
    return dict(json.loads(body)) if len(body) == size else None


class Peer:
    """A Python module that runs in a process of its own and answers messages. Any thread may ask.

    It is started by exec, so that nothing of this process is in its memory, with one thread for BLAS and an environment
    without secrets. Each message gets an id; answers come in any order.
    """

    def __init__(self, module: str, folder: Path, *arguments: str) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-P", "-m", module, *arguments],
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=environment(),
        )
        self._outbox, self._inbox = cast("IO[bytes]", self._process.stdin), cast("IO[bytes]", self._process.stdout)
        self._waiting: dict[int, Future[dict[str, Any]]] = {}
        self._ids = itertools.count()
        self._writing = threading.Lock()
        threading.Thread(target=self._listen, daemon=True).start()

    @property
    def pid(self) -> int:
        """The id of the process."""
        return self._process.pid

    def ask(self, message: Mapping[str, Any], seconds: float) -> dict[str, Any]:
        """Send a message and wait for its answer. Raises Gone if none comes in time; then the process is ended too."""
        with self._writing:
            number, answer = next(self._ids), Future[dict[str, Any]]()
            self._waiting[number] = answer
            try:
                self._outbox.write(pack({**message, "id": number}))
                self._outbox.flush()
            except (OSError, ValueError) as error:  # the pipe is broken, or closed already
                del self._waiting[number]
                raise Gone("The process has ended.") from error
        try:
            return answer.result(seconds)
        except Late as error:
            self.end()
            raise Gone(f"No answer within {seconds:g} s.") from error

    def end(self) -> None:
        """End the process, and everything that waits for it."""
        self._process.kill()
        self._process.wait()
        with suppress(OSError), self._writing:  # what is still in the buffer has nobody to go to
            self._outbox.close()

    def _listen(self) -> None:
        while (message := receive(self._inbox)) is not None:
            if (answer := self._waiting.pop(message.pop("id", None), None)) is not None:
                answer.set_result(message)
        self._inbox.close()
        while self._waiting:
            self._waiting.popitem()[1].set_exception(Gone("The process has ended."))
