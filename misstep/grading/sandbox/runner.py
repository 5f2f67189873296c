"""Run submissions from outside the sandbox: one server, any number of children at a time, time and output limits for each."""

import json
import os
import select
import signal
import sys
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from misstep.grading.fork_server import MESSAGE_BYTES, ForkServer, ProcessEnded
from misstep.grading.sandbox.course_stub import CourseSetup
from misstep.grading.sandbox.limits import BYTES_PER_MB, UNSAFE_OPTION, Limits, SandboxUnavailable
from misstep.grading.sandbox.rootfs import NAMESPACES_REMEDY

LIMIT_STATUSES = {-signal.SIGKILL, -signal.SIGXCPU} if sys.platform == "linux" else set[int]()
"""The exit statuses of a process that exceeded its memory or processor time."""

CLOCK_TOLERANCE = 0.2
"""By how many seconds the kernel's limit of processor time and its report may differ."""


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

    Raises SandboxUnavailable if this machine lacks a layer of the sandbox, unless is_safe is False.
    """

    def __init__(self, setup: CourseSetup, is_safe: bool = True) -> None:
        self._is_safe = is_safe
        options = [] if is_safe else [UNSAFE_OPTION]
        self.server = ForkServer("misstep.grading.sandbox.server", asdict(setup), *options)
        try:
            self._wait_until_ready()
        except BaseException:
            self.close()
            raise

    def run(self, sheet: str, cells: Sequence[str], limits: Limits) -> RunOutcome:
        """Run cells in a new child process.

        sheet  the redacted sheet, as redacted_sheet.redact writes it

        Raises ProcessEnded if the server has ended.
        """
        return self._run({"sheet": sheet, "cells": list(cells)}, limits)

    def close(self) -> None:
        """End the server and every process in it. Runs that have not ended raise ProcessEnded."""
        self.server.close()

    def _wait_until_ready(self) -> None:
        """Wait for the server, and let a child process that is confined completely try what must be impossible."""
        try:
            self.server.wait_until_ready()
        except ProcessEnded as error:
            raise SandboxUnavailable(str(error)) from error
        if not self._is_safe:
            return
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
        with os.fdopen(inbox, "wb") as stream, os.fdopen(outbox, "rb", 0) as outputs:
            try:
                child = self.server.fork(child_inbox, child_outbox)
            finally:
                os.close(child_inbox)
                os.close(child_outbox)
            try:
                stream.write(json.dumps({**message, "limits": asdict(limits)}).encode())
                stream.close()
            except BrokenPipeError:
                pass  # the child has ended already; its output, if any, says why
            output, end_reason = _read_output(outputs.fileno(), limits)
            usage = self.server.end(child)
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


def _read_output(descriptor: int, limits: Limits) -> tuple[bytes, str]:
    """The output of a process, until it ends or reaches a limit; and the limit, in words."""
    output, max_bytes = bytearray(), limits.output_mb * BYTES_PER_MB
    deadline = time.monotonic() + limits.wall_seconds
    while select.select([descriptor], [], [], max(0, deadline - time.monotonic()))[0]:
        chunk = os.read(descriptor, MESSAGE_BYTES)
        output += chunk[: max_bytes - len(output)]
        if not chunk:
            return bytes(output), ""
        if len(output) >= max_bytes:
            return bytes(output), f"it wrote more than {limits.output_mb} MB of output"
    return bytes(output), f"it ran longer than {limits.wall_seconds:g} s"


def _describe_status(status: int) -> str:
    """What an exit status says about the end: 0 is the normal end, all others are not."""
    if status < 0:
        return f"the process was ended by {signal.Signals(-status).name}"
    return f"the code ended the process itself, with status {status}" if status else ""
