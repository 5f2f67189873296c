"""Parse the output of a run: lines that untrusted code may have written, so everything but the expected form is refused."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from misstep.grading.collect.run_plan import RunPlan
from misstep.grading.judging.result import RanCell
from misstep.storage.deserialize import MIME

MAX_ANSWER_CHARACTERS = 256_000
"""The longest answer, as JSON, in characters."""


@dataclass(frozen=True)
class ParsedOutput:
    """The cells that ran, the last answer to each problem (by its number as text), and the id typed in the sheet."""

    cells: Sequence[RanCell]
    answers: Mapping[str, Any]
    typed_id: str

    def remarks(self, student: str) -> list[str]:
        """What an instructor who grades by hand would notice: another id, or cells that failed."""
        notes = []
        if self.typed_id and self.typed_id.strip().casefold() != student.strip().casefold():
            notes.append(f"The sheet was opened for {self.typed_id!r}, and graded with the numbers of {student!r}.")
        errors = [error for cell in self.cells if cell.problem is None for error in _errors(cell)]
        if errors:
            cells = "One cell" if len(errors) == 1 else f"{len(errors)} cells failed. The first of them"
            notes.append(f"{cells} failed with {errors[0]}")
        return notes

    def check_errors(self, problem: int) -> list[str]:
        """Why the check cell of a problem gave no answer; an empty list if it gave one."""
        if str(problem) in self.answers:
            return []
        errors = [error for cell in self.cells if cell.problem == problem for error in _errors(cell)]
        return [f"Its check cell failed with {error}" for error in errors[-1:]]


def parse_output(sheet: str, plan: RunPlan, output: bytes) -> ParsedOutput:
    """Parse the output of a run, up to the first line that does not have the expected form.

    An answer counts if it comes from the check cell of its problem. Of several answers, the last one counts.
    """
    cells: list[RanCell] = []
    answers: dict[str, Any] = {}
    typed_id = ""
    for planned, line in zip(plan.cells, output.split(b"\n"), strict=False):
        outputs = _parse_line(line, len(cells))
        if outputs is None:
            break
        displayed = [
            {**output, "data": _without_answer(output["data"])} if "data" in output else output for output in outputs
        ]
        cells.append(RanCell(planned.source, planned.problem, planned.index, displayed))
        for cell_output in outputs:
            emission = cell_output.get("data", {}).get(MIME)
            if planned.problem and _is_emission(emission, sheet, planned.problem):
                answers[str(planned.problem)] = emission["answer"]
                typed_id = emission["student"][:200]
    return ParsedOutput(cells, answers, typed_id)


def _errors(cell: RanCell) -> list[str]:
    return [
        f"{output['ename']}: {output['evalue']}"[:300] for output in cell.outputs if output["output_type"] == "error"
    ]


def _parse_line(line: bytes, number: int) -> list[dict[str, Any]] | None:
    """The outputs of the cell with this number, or None if the line does not have this form."""
    try:
        record = json.loads(line)
        # Encoding it again finds what must not be passed on: infinities, lone surrogates, JSON that is nested too deeply.
        json.dumps(record, allow_nan=False, ensure_ascii=False).encode()
    except (ValueError, RecursionError):
        return None
    match record:
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


def _is_emission(emission: Any, sheet: str, problem: int) -> bool:
    """Whether this is what the check cell of this problem emits."""
    if not isinstance(emission, dict) or set(emission) != {"sheet", "problem", "student", "answer"}:
        return False
    if not isinstance(emission["student"], str) or len(json.dumps(emission["answer"])) > MAX_ANSWER_CHARACTERS:
        return False
    return bool(emission["sheet"] == sheet and emission["problem"] == problem)


def _without_answer(data: Mapping[str, Any]) -> dict[str, Any]:
    return {kind: value for kind, value in data.items() if kind != MIME}
