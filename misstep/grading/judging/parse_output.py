"""Hearing what a run said: lines that untrusted code wrote, read as strictly as such lines deserve."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from misstep.grading.collect.submission import Plan
from misstep.grading.judging.result import RanCell
from misstep.storage.deserialize import MIME

KINDS = {"stream", "display_data", "error"}

LARGEST = 256_000
"""No answer is longer, as JSON, in characters."""


@dataclass(frozen=True)
class Heard:
    """The cells as they ran, the last answer of each problem (by its number as text), and the id in the sheet."""

    cells: Sequence[RanCell]
    answers: Mapping[str, Any]
    typed_id: str

    def remarks(self, student: str) -> list[str]:
        """What whoever graded by hand would have noticed."""
        notes = []
        if self.typed_id and self.typed_id.strip().casefold() != student.strip().casefold():
            notes.append(f"The sheet was opened for {self.typed_id!r}, and graded with the numbers of {student!r}.")
        errors = [error for cell in self.cells if cell.problem is None for error in _errors(cell)]
        if errors:
            cells = "One cell" if len(errors) == 1 else f"{len(errors)} cells, one of them"
            notes.append(f"{cells} failed with {errors[0]}")
        return notes

    def faults(self, problem: int) -> list[str]:
        """Why the check cell of a problem gave no answer, if it gave none."""
        if str(problem) in self.answers:
            return []
        errors = [error for cell in self.cells if cell.problem == problem for error in _errors(cell)]
        return [f"Its check cell failed with {error}" for error in errors[-1:]]


def hear(sheet: str, planned: Plan, said: bytes) -> Heard:
    """Read what a run said, up to the first line that is none of ours.

    An answer counts where it comes from the check cell of its problem; the last one counts.
    """
    cells: list[RanCell] = []
    answers: dict[str, Any] = {}
    typed_id = ""
    for step, line in zip(planned.steps, said.split(b"\n"), strict=False):
        outputs = _outputs(line, len(cells))
        if outputs is None:
            break
        shown = [
            {**output, "data": _without_answer(output["data"])} if "data" in output else output for output in outputs
        ]
        cells.append(RanCell(step.source, step.problem, step.place, shown))
        for output in outputs:
            emission = output.get("data", {}).get(MIME)
            if step.problem and _is_ours(emission, sheet, step.problem):
                answers[str(step.problem)] = emission["answer"]
                typed_id = emission["student"][:200]
    return Heard(cells, answers, typed_id)


def _errors(cell: RanCell) -> list[str]:
    return [
        f"{output['ename']}: {output['evalue']}"[:300] for output in cell.outputs if output["output_type"] == "error"
    ]


def _outputs(line: bytes, number: int) -> list[dict[str, Any]] | None:
    """The outputs of the cell with this number, or None if the line is not about it."""
    try:
        told = json.loads(line)
        # Written again, it shows what nobody should have to pass on: infinities, halves of characters, endless nests.
        json.dumps(told, allow_nan=False, ensure_ascii=False).encode()
    except (ValueError, RecursionError):
        return None
    match told:
        case {"cell": int() as cell, "outputs": list() as outputs} if cell == number:
            return [output for output in outputs if _is_output(output)]
    return None


def _is_output(output: Any) -> bool:
    match output:
        case {"output_type": "stream", "name": "stdout" | "stderr", "text": str()}:
            return True
        case {"output_type": "display_data", "data": dict() as data, "metadata": dict()}:
            return all(isinstance(kind, str) for kind in data)
        case {"output_type": "error", "ename": str(), "evalue": str(), "traceback": list() as lines}:
            return all(isinstance(line, str) for line in lines)
    return False


def _is_ours(emission: Any, sheet: str, problem: int) -> bool:
    if not isinstance(emission, dict) or set(emission) != {"sheet", "problem", "student", "answer"}:
        return False
    if not isinstance(emission["student"], str) or len(json.dumps(emission["answer"])) > LARGEST:
        return False
    return bool(emission["sheet"] == sheet and emission["problem"] == problem)


def _without_answer(data: Mapping[str, Any]) -> dict[str, Any]:
    return {kind: value for kind, value in data.items() if kind != MIME}
