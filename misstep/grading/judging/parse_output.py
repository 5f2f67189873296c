"""Parse the output of a run: lines that untrusted code may have written, so everything but the expected form is refused."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from misstep.grading.collect.run_plan import PASSED_OVER, RERUN_SOURCE, RunPlan
from misstep.grading.judging.result import RanCell
from misstep.grading.sandbox.limits import MAX_ANSWER_CHARACTERS, SHOWN_KINDS, TOO_LARGE
from misstep.storage.deserialize import MIME

MAX_ANSWER_DEPTH = 50
"""How deeply the JSON of an answer may be nested. Answers that can be read take 20 levels."""

MAX_PASSED_OVER = 5
"""How many of the lines that were passed over a note names."""


@dataclass(frozen=True)
class ParsedRun:
    """What was read of the output of a run.

    cells         the cells that ran
    answers       the last answer to each problem
    typed_id      the id that is typed in the sheet
    remarks       what an instructor would notice when grading by hand: another id, or cells that failed
    check_errors  by problem without an answer, why its check cell gave none
    has_timeout   whether a cell reached its limit of time
    """

    cells: Sequence[RanCell]
    answers: Mapping[int, Any]
    typed_id: str
    remarks: Sequence[str]
    check_errors: Mapping[int, str]
    has_timeout: bool


def parse_output(sheet: str, plan: RunPlan, output: bytes, student: str) -> ParsedRun:
    """Parse the output of a run, up to the first line that does not have the expected form.

    An answer counts if it comes from the check cell of its problem, or from a check cell in the second pass. Of several
    answers, the last one counts. A blank one does not replace another, and that of a fallback replaces only a blank one.
    """
    cells: list[RanCell] = []
    answers: dict[int, Any] = {}
    typed_id = ""
    for planned, line in zip(plan.cells, output.split(b"\n"), strict=False):
        outputs = _parse_line(line, len(cells))
        if outputs is None:
            break
        displayed = [{**output, "data": _shown(output["data"])} if "data" in output else output for output in outputs]
        cells.append(RanCell(planned.source, planned.problem, planned.index, displayed))
        is_second_pass = planned.source == RERUN_SOURCE
        given: dict[int, Any] = {}
        for cell_output in outputs:
            emission = cell_output.get("data", {}).get(MIME)
            for number in plan.problems if is_second_pass else [planned.problem]:
                if number and _is_emission(emission, sheet, number):
                    typed_id = emission["student"][:200]
                    given[number] = emission["answer"]
        for k, answer in given.items():
            if answers.get(k) is None or not (answer is None or is_second_pass or planned.is_fallback):
                answers[k] = answer
    errors = {cell.problem: f"Its check cell failed with {error}" for cell in cells for error in _errors(cell)}
    check_errors = {k: errors[k] for k in plan.problems if k in errors and k not in answers}
    has_timeout = any(error.startswith("CellTimeout: ") for cell in cells for error in _errors(cell))
    remarks = _remarks_on_id(answers, typed_id, student) + _remarks_on_cells(cells)
    return ParsedRun(cells, answers, typed_id, remarks, check_errors, has_timeout)


def _remarks_on_id(answers: Mapping[int, Any], typed_id: str, student: str) -> list[str]:
    if typed_id and typed_id.strip().casefold() != student.strip().casefold():
        return [f"The sheet was opened for {typed_id!r}, and graded with the numbers of {student!r}."]
    if answers and not typed_id:
        return ["No id was found in the sheet: its opening cell is missing, failed, or asks for the id."]
    return []


def _remarks_on_cells(cells: Sequence[RanCell]) -> list[str]:
    notes = []
    own = [cell for cell in cells if cell.problem is None]
    failed = [errors[0] for cell in own if cell.source != RERUN_SOURCE and (errors := _errors(cell))]
    again = [_errors(cell) for cell in own if cell.source == RERUN_SOURCE]
    if again and len(again[0]) < len(failed):
        notes.append(f"{_count_cells(len(failed))} failed at first. The cells that failed were run again at the end.")
        failed = again[0]
    if failed:
        which = "with" if len(failed) == 1 else "the first of them with"
        end = "" if failed[0].endswith("?") else "."
        notes.append(f"{_count_cells(len(failed))} failed, {which} {failed[0].rstrip('.')}{end}")
    if passed := list(dict.fromkeys(what for cell in cells for what in _passed_over(cell))):
        more = f"; and {len(passed) - MAX_PASSED_OVER} more" if len(passed) > MAX_PASSED_OVER else ""
        notes.append(f"{PASSED_OVER}{'; '.join(passed[:MAX_PASSED_OVER])}{more}.")
    return notes


def _count_cells(count: int) -> str:
    return "One cell" if count == 1 else f"{count} cells"


def _passed_over(cell: RanCell) -> list[str]:
    texts = [output["text"] for output in cell.outputs if output["output_type"] == "stream"]
    lines = [line for text in texts if PASSED_OVER in text for line in text.splitlines()]
    return [line.removeprefix(PASSED_OVER)[:200].rstrip(".") for line in lines if line.startswith(PASSED_OVER)]


def _errors(cell: RanCell) -> list[str]:
    errors = [(output["ename"], output["evalue"]) for output in cell.outputs if output["output_type"] == "error"]
    return [f"{name}: {text or (TOO_LARGE if name == 'MemoryError' else '')}"[:300] for name, text in errors]


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
    if not _is_shallow(emission["answer"]):
        return False
    return bool(emission["sheet"] == sheet and emission["problem"] == problem)


def _is_shallow(answer: Any) -> bool:
    """Whether the lists and mappings of an answer are nested at most MAX_ANSWER_DEPTH levels, so that recursion can read it."""
    level = [answer]
    for _ in range(MAX_ANSWER_DEPTH):
        level = [
            part
            for parts in level
            if isinstance(parts, dict | list)
            for part in (parts.values() if isinstance(parts, dict) else parts)
        ]
    return not level


def _shown(data: Mapping[str, Any]) -> dict[str, str]:
    return {kind: value for kind, value in data.items() if kind in SHOWN_KINDS and isinstance(value, str)}
