"""What is kept of the output of a submission: enough to show on its page, and never so much that it costs a point.

How much this is, limits.py says.

Answers are always kept. Of the other output, what a cell or the whole notebook has too much of is left out, and a line in its
place says so.
"""

import base64
import io
import json
from collections.abc import Mapping, Sequence
from typing import Any

from IPython.core.displaypub import CapturingDisplayPublisher

from misstep.grading.sandbox.limits import (
    MAX_ANSWER_CHARACTERS,
    MAX_BYTES,
    MAX_CELL_BYTES,
    MAX_PRINTED_CHARACTERS,
    SHOWN_KINDS,
)
from misstep.storage.deserialize import MIME


class TruncatedStream(io.StringIO):
    """A stream that accepts any amount of text and keeps its beginning."""

    def write(self, text: str) -> int:
        if self.tell() < MAX_PRINTED_CHARACTERS:
            super().write(text[: MAX_PRINTED_CHARACTERS - self.tell()])
            if self.tell() >= MAX_PRINTED_CHARACTERS:
                super().write("\n[the rest of this output is left out]\n")
        return len(text)


class ShownDisplays(CapturingDisplayPublisher):
    """Records displays in the forms that pages show, and answers."""

    def publish(self, data: Mapping[str, Any], *_: Any, **__: Any) -> None:
        """Record a display."""
        shown: dict[str, Any] = {kind: _text(value) for kind, value in data.items() if kind in SHOWN_KINDS}
        if MIME in data:
            shown[MIME] = data[MIME]
        if shown:
            self.outputs.append({"output_type": "display_data", "metadata": {}, "data": shown})


def _text(value: Any) -> str:
    """A form of a display as JSON holds it: a picture that is bytes as base64."""
    return base64.b64encode(value).decode() if isinstance(value, bytes) else str(value)


class OutputBudget:
    """How much of the output of a submission can still be kept."""

    def __init__(self) -> None:
        self._left = MAX_BYTES

    def encode_cell(self, number: int, outputs: Sequence[Mapping[str, Any]]) -> bytes:
        """The outputs of a cell as a line of JSON. What JSON cannot hold is left out."""
        lines, dropped, left = list[bytes](), list[int](), min(self._left, MAX_CELL_BYTES)
        last_answers = {_problem(output): place for place, output in enumerate(outputs) if _problem(output)}
        for place, output in enumerate(outputs):
            line = _encode(output)
            if len(line) <= left:
                lines.append(line)
                left -= len(line)
                self._left -= len(line)
                continue
            dropped.append(len(line))
            if last_answers.get(_problem(output)) == place:
                answer = _encode({**output, "data": {MIME: output["data"][MIME]}})
                lines += [answer] if len(answer) < 2 * MAX_ANSWER_CHARACTERS else []
            elif output["output_type"] == "error":
                lines.append(_encode({**output, "traceback": []}))
        if dropped:
            lines.append(_encode({"output_type": "stream", "name": "stderr", "text": _note(dropped)}))
        return b'{"cell": %d, "outputs": [%b]}\n' % (number, b", ".join(filter(None, lines)))


def _problem(output: Mapping[str, Any]) -> str:
    """The problem that an output has an answer to; "" if none."""
    emission = output.get("data", {}).get(MIME)
    return str(emission.get("problem")) if isinstance(emission, dict) else ""


def _encode(output: Mapping[str, Any]) -> bytes:
    try:
        return json.dumps(output, allow_nan=False, skipkeys=True, ensure_ascii=False).encode(errors="replace")
    except (TypeError, ValueError, RecursionError):
        return b""


def _note(sizes: Sequence[int]) -> str:
    what = "One output" if len(sizes) == 1 else f"{len(sizes)} outputs"
    return (
        f"[{what} of this cell with {sum(sizes) / 1e6:.1f} MB left out here; this costs no points. "
        f"At most {MAX_CELL_BYTES / 1e6:g} MB of a cell and {MAX_BYTES / 1e6:g} MB of a notebook are shown.]\n"
    )
