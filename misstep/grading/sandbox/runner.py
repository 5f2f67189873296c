"""Run submissions from outside the sandbox: one server, any number of children at a time, time and output limits for each."""

import json
import os
import re
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, cast

from misstep.grading.rpc import ProcessEnded, child_environment, encode_message
from misstep.grading.sandbox.course_stub import CourseSetup
from misstep.grading.sandbox.limits import UNSAFE_OPTION, Limits, SandboxUnavailable
from misstep.grading.sandbox.memory import BYTES_PER_MB, MemoryLimit, limit_memory
from misstep.grading.sandbox.rootfs import NAMESPACES_REMEDY

CHUNK_BYTES = 1 << 20

LIMIT_STATUSES = {-signal.SIGKILL, -signal.SIGXCPU} if sys.platform == "linux" else set[int]()
"""The exit statuses of a process that exceeded its memory or processor time."""

LOOK_SECONDS = 0.1
"""How often the memory of a submission is read."""

CLOCK_TOLERANCE = 0.2
"""By how many seconds the kernel's limit of processor time and its report may differ."""

START_SECONDS = 120.0
"""How long the server may take to import everything. The first import of matplotlib also indexes all fonts."""

SLOW_IMPORTS = {"matplotlib.pyplot": re.compile("matplotlib|pylab"), "sympy": re.compile("sympy")}
"""Modules that take longer to import than everything else together, and what is in the source of a cell that imports one.

If a cell hides it, it still runs, and imports the module in its own time."""


@dataclass(frozen=True)
class RunOutcome:
    """How a run of a submission ended, and what it wrote.

    output      the bytes that the child wrote, not yet parsed
    end_reason  what ended it; "" if it ran to its end, or if the reason is unknown
    processor_seconds, memory_mb   what it used
    ended_by_itself  whether its own code ended it, and no limit
    """

    output: bytes
    end_reason: str
    processor_seconds: float
    memory_mb: float
    ended_by_itself: bool = False


class Runner:
    """Starts the server and requests runs from it. Any thread may call it.

    If a submission imports one of SLOW_IMPORTS that this server has not, it runs in a second server, which imports all of
    them, and is started for the first such submission.

    Raises SandboxUnavailable if this machine lacks a layer of the sandbox, unless is_safe is False.
    """

    def __init__(
        self, setup: CourseSetup, is_safe: bool = True, register: "Callable[[Runner], None] | None" = None
    ) -> None:
        self._lock, self._second_lock, self._is_closed = threading.Lock(), threading.Lock(), False
        self._setup, self._is_safe, self._second = setup, is_safe, cast("Runner | None", None)
        self._started: list[Runner] = []
        self._scratch = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._socket, server_socket = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        with server_socket:
            self._process = subprocess.Popen(
                [
                    sys.executable,
                    "-P",
                    "-m",
                    "misstep.grading.sandbox.server",
                    str(server_socket.fileno()),
                    *([] if is_safe else [UNSAFE_OPTION]),
                ],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                pass_fds=[server_socket.fileno()],
                env={**child_environment(), "TMPDIR": self._scratch.name, "IPYTHONDIR": self._scratch.name},
                start_new_session=True,
            )
        if register:
            register(self)  # so that it can be closed while it starts
        try:
            self._wait_until_ready()
        except BaseException:
            self.close()
            raise

    def _wait_until_ready(self) -> None:
        self._socket.settimeout(START_SECONDS)
        with suppress(OSError):  # it has ended already, and the greeting says so
            self._socket.sendall(encode_message(asdict(self._setup)))
        try:
            greeting = json.loads(
                self._socket.recv(CHUNK_BYTES) or b'{"unavailable": "The server ended while starting."}'
            )
        except OSError as error:
            raise SandboxUnavailable(f"The server of submissions did not start within {START_SECONDS:g} s.") from error
        if greeting["unavailable"]:
            raise SandboxUnavailable(greeting["unavailable"])
        if self._is_safe:
            self._probe()

    def run(self, sheet: str, cells: Sequence[str], limits: Limits) -> RunOutcome:
        """Run cells in a new child process.

        sheet  the redacted sheet, as redacted_sheet.redact writes it

        Raises ProcessEnded if the server has ended.
        """
        if slow_imports(*cells) - {*self._setup.imports}:
            return self._second_server().run(sheet, cells, limits)
        return self._run({"sheet": sheet, "cells": list(cells)}, limits)

    def close(self) -> None:
        """End the servers and every process in them. Runs that have not ended raise ProcessEnded."""
        self._is_closed = True
        for second in self._started:
            second.close()
        self._process.kill()
        self._process.wait()
        self._socket.close()
        self._scratch.cleanup()

    def _second_server(self) -> "Runner":
        with self._second_lock:
            if not self._second:
                setup = replace(self._setup, imports=list(SLOW_IMPORTS))
                try:
                    self._second = Runner(setup, self._is_safe, self._started.append)
                except SandboxUnavailable as error:
                    raise ProcessEnded(str(error)) from error
            return self._second

    def _probe(self) -> None:
        """Confine a child process completely, and let it try what must be impossible."""
        try:
            outcome = self._run({"probe": True}, Limits())
        except ProcessEnded as error:
            raise SandboxUnavailable(
                f"The sandbox cannot start a process in namespaces of its own on this machine. {NAMESPACES_REMEDY} "
                "Nothing was run."
            ) from error
        answer = json.loads(outcome.output or b'{"unavailable": "A first confined process ended without an answer."}')
        if "unavailable" in answer or answer["leaks"]:
            raise SandboxUnavailable(
                answer.get("unavailable") or f"Inside the sandbox it is possible to {', '.join(answer['leaks'])}."
            )

    def _run(self, message: dict[str, Any], limits: Limits) -> RunOutcome:
        (child_inbox, inbox), (outbox, child_outbox) = os.pipe(), os.pipe()
        try:
            child, process = self._fork([child_inbox, child_outbox])
        finally:
            os.close(child_inbox)
            os.close(child_outbox)
        with (
            os.fdopen(inbox, "wb") as stream,
            os.fdopen(outbox, "rb", 0) as outputs,
            limit_memory(process, limits.memory_mb) as memory,
        ):
            try:
                stream.write(json.dumps({**message, "limits": asdict(limits)}).encode())
                stream.close()
            except BrokenPipeError:
                pass  # the child has ended already; its output, if any, says why
            try:
                output, end_reason = self._read_output(outputs.fileno(), limits, memory)
            except ProcessEnded:
                if process and not self._is_safe:  # in the sandbox, it ends with the server
                    os.kill(process, signal.SIGTERM)
                raise
            usage = json.loads(self._request(b"end " + child)[0])
        ended_by_itself = not end_reason and usage["status"] not in LIMIT_STATUSES
        if not (end_reason or ended_by_itself) and usage["processor_seconds"] > limits.seconds - CLOCK_TOLERANCE:
            end_reason = f"it used more than {limits.seconds:g} s of processor time"
        return RunOutcome(
            output,
            end_reason or _describe_status(usage["status"]),
            usage["processor_seconds"],
            usage["memory_mb"],
            ended_by_itself,
        )

    def _read_output(self, descriptor: int, limits: Limits, memory: MemoryLimit) -> tuple[bytes, str]:
        """Read until the end of the stream, until a limit is reached, or until the time is over; also what ended it."""
        output, max_bytes = bytearray(), limits.output_mb * BYTES_PER_MB
        deadline = time.monotonic() + limits.wall_seconds
        next_look = time.monotonic() + LOOK_SECONDS
        chunk = b"first"
        while chunk and (now := time.monotonic()) < deadline:
            if now > next_look:
                next_look = now + LOOK_SECONDS
                if self._is_closed:
                    raise ProcessEnded("The server that runs submissions was closed.")
                if memory.is_exceeded():
                    break
            if not select.select([descriptor], [], [], min(deadline, next_look) - now)[0]:
                continue
            chunk = os.read(descriptor, CHUNK_BYTES)
            output += chunk[: max_bytes - len(output)]
            if len(output) >= max_bytes:
                return bytes(output), f"it wrote more than {limits.output_mb} MB of output"
        if memory.is_exceeded():  # a cgroup also says why a process has ended
            return bytes(
                output
            ), f"it held more than {limits.memory_mb} MB of memory, all its processes and files together"
        return bytes(output), f"it ran longer than {limits.wall_seconds:g} s" if chunk else ""

    def _fork(self, descriptors: Sequence[int]) -> tuple[bytes, int]:
        """Request a fork: the id of the child in its namespace, and in this one (0 if the system cannot tell)."""
        answer, handles = self._request(b"fork", descriptors)
        number = 0
        for handle in handles:
            number = int(
                re.findall(r"^Pid:\s*(-?\d+)", Path(f"/proc/self/fdinfo/{handle}").read_text(), re.MULTILINE)[0]
            )
            os.close(handle)
        return answer, number

    def _request(self, message: bytes, descriptors: Sequence[int] = ()) -> tuple[bytes, list[int]]:
        with self._lock:
            try:
                socket.send_fds(self._socket, [message], descriptors)
                answer, handles, _, _ = socket.recv_fds(self._socket, CHUNK_BYTES, 1)
            except OSError as error:
                raise ProcessEnded("The server that runs submissions has ended.") from error
        if not answer:
            raise ProcessEnded("The server that runs submissions has ended.")
        return answer, handles


def slow_imports(*sources: str) -> set[str]:
    """The SLOW_IMPORTS that cells with these sources import.

    >>> slow_imports("import numpy as np", "from sympy import Symbol")
    {'sympy'}
    """
    return {module for module, pattern in SLOW_IMPORTS.items() if any(map(pattern.search, sources))}


def _describe_status(status: int) -> str:
    """What an exit status says about the end: 0 is the normal end, all others are not."""
    if status < 0:
        return f"the process was ended by {signal.Signals(-status).name}"
    return f"the code ended the process itself, with status {status}" if status else ""
