"""Running submissions from outside: one server, any number of children at a time, a clock and a limit for each."""

import json
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from misstep.grading.sandbox.course_stub import CourseSetup
from misstep.grading.sandbox.limits import UNSAFE, Limits, Missing
from misstep.grading.sandbox.rpc import Gone, environment

CHUNK = 1 << 20

BY_LIMIT = {-signal.SIGKILL, -signal.SIGXCPU} if sys.platform == "linux" else set[int]()
"""The statuses of what had too much memory or time."""

STARTING = 120.0
"""Seconds that the server may take to import everything; a first start of matplotlib also looks at every font."""


@dataclass(frozen=True)
class Ran:
    """What became of a run.

    said       the bytes that the child wrote; nobody has looked at them yet
    ended      what ended it; "" where it came to its end, or nobody knows better
    processor_seconds, memory (MB)   what it used
    by_itself  whether it ended as its code wanted, and by no limit
    """

    said: bytes
    ended: str
    processor_seconds: float
    memory: float
    by_itself: bool = False


class Runner:
    """A server of forks, and the talk with it. Any thread may run something.

    Raises Missing when a layer of the sandbox is not to be had, unless is_safe is False.
    """

    def __init__(self, setup: CourseSetup, is_safe: bool = True) -> None:
        self._lock = threading.Lock()
        self._scratch = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._socket, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        with theirs:
            self._process = subprocess.Popen(
                [
                    sys.executable,
                    "-P",
                    "-m",
                    "misstep.grading.sandbox.server",
                    str(theirs.fileno()),
                    setup.to_json(),
                    *([] if is_safe else [UNSAFE]),
                ],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                pass_fds=[theirs.fileno()],
                env={**environment(), "TMPDIR": self._scratch.name, "IPYTHONDIR": self._scratch.name},
                start_new_session=True,
            )
        self._socket.settimeout(STARTING)
        greeting = json.loads(self._socket.recv(CHUNK) or b'{"missing": "The server ended before it was ready."}')
        if greeting["missing"]:
            self.close()
            raise Missing(greeting["missing"])
        if is_safe:
            self._probe()

    def run(self, paper: str, cells: Sequence[str], limits: Limits) -> Ran:
        """Run cells in a fresh child. Raises Gone when the server has ended."""
        return self._run({"paper": paper, "cells": list(cells)}, limits)

    def close(self) -> None:
        """End the server and all that runs in it."""
        self._socket.close()
        self._process.kill()
        self._process.wait()
        self._scratch.cleanup()

    def _probe(self) -> None:
        """Send a child through every layer, and let it try the doors."""
        ran = self._run({"probe": True}, Limits())
        told = json.loads(ran.said or b'{"missing": "A first process ended at once."}')
        if "missing" in told or told["holes"]:
            self.close()
            raise Missing(told.get("missing") or f"Inside the sandbox one can {', '.join(told['holes'])}.")

    def _run(self, message: dict[str, Any], limits: Limits) -> Ran:
        (inbox, paper), (said, outbox) = os.pipe(), os.pipe()
        try:
            child = self._ask(b"fork", [inbox, outbox])
        finally:
            os.close(inbox)
            os.close(outbox)
        with os.fdopen(paper, "wb") as stream, os.fdopen(said, "rb", 0) as voice:
            try:
                stream.write(json.dumps({**message, "limits": asdict(limits)}).encode())
                stream.close()
            except BrokenPipeError:
                pass  # it is gone already: what it said, if anything, says why
            heard, ended = _listen(voice.fileno(), limits)
        done = json.loads(self._ask(b"end " + child))
        by_itself = not ended and done["status"] not in BY_LIMIT
        return Ran(heard, ended or _end(done["status"]), done["processor_seconds"], done["memory"], by_itself)

    def _ask(self, message: bytes, descriptors: Sequence[int] = ()) -> bytes:
        with self._lock:
            try:
                socket.send_fds(self._socket, [message], descriptors)
                answer = self._socket.recv(CHUNK)
            except OSError as error:
                raise Gone("The server of forks has ended.") from error
        if not answer:
            raise Gone("The server of forks has ended.")
        return answer


def _listen(descriptor: int, limits: Limits) -> tuple[bytes, str]:
    """Hear until it is silent for good, says too much, or its time is over."""
    heard, most, deadline = bytearray(), limits.output * CHUNK, time.monotonic() + limits.seconds
    while (left := deadline - time.monotonic()) > 0:
        if not select.select([descriptor], [], [], left)[0]:
            break
        chunk = os.read(descriptor, CHUNK)
        if not chunk:
            return bytes(heard), ""
        heard += chunk[: most - len(heard)]
        if len(heard) >= most:
            return bytes(heard), f"it gave out more than {limits.output} MB"
    return bytes(heard), f"it ran longer than {limits.seconds:g} s"


def _end(status: int) -> str:
    """What a status says of the end: 0 is ours; all others are not."""
    if status < 0:
        return f"the process was ended by {signal.Signals(-status).name}"
    return f"the code ended the process itself, with status {status}" if status else ""
