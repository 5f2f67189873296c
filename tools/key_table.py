"""Grade each sheet with a key, and write which problems it covers into the instructor's guide: `nox -s key`.

Each sheet is handed in twice: its official solution, and the right answers typed in, as a student reads them in the installed
course. Exits with 1 if the solution loses a point, or if a typed answer earns one in a problem that the key covers.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
GUIDE = ROOT / "site" / "instructors.md"

sys.path[:0] = [str(ROOT / "tests" / "support")]

from habits import SHEETS, solution, solved  # noqa: E402
from submissions import as_bytes, handed_in, right  # noqa: E402

from misstep.grading.collect.run_plan import read_released_sheet  # noqa: E402
from misstep.grading.judging.grader import Grader  # noqa: E402
from misstep.sheet import SAMPLE_ID  # noqa: E402

STUDENT = "ada"
HEAD = (
    "| sheet | problems with other numbers | graded with the own numbers | points of the solution | typed answers, without a key "
    "| typed answers, with a key |\n| --- | --- | --- | --- | --- | --- |\n"
)


def row(sheet: str) -> tuple[str, bool]:
    """The row of a sheet, and whether the key does what it should."""
    with Grader(read_released_sheet(solution(sheet), key="a key for this table")) as grader:
        honest = grader.grade(SAMPLE_ID, as_bytes(solved(sheet)))
        typed = grader.grade(STUDENT, as_bytes(handed_in(STUDENT, right(STUDENT, sheet), name=sheet)))
    covered = [one.own_points is not None for one in typed.problems]
    others = ", ".join(one.number for one, is_covered in zip(typed.problems, covered, strict=True) if not is_covered)
    own = sum(one.points if one.own_points is None else one.own_points for one in typed.problems)
    is_kept = honest.points == honest.max and not any(
        one.points for one, is_covered in zip(typed.problems, covered, strict=True) if is_covered
    )
    cells = [
        sheet[:2],
        f"{sum(covered)} of {len(covered)}",
        others or "-",
        f"{honest.points:g} of {honest.max:g}",
        f"{own:g}",
    ]
    return f"| {' | '.join(cells)} | {typed.points:g} |", is_kept


def main() -> int:
    rows = []
    for sheet in SHEETS:
        rows.append(row(sheet))
        print(*rows[-1], flush=True)
    table = HEAD + "\n".join(text for text, _ in rows) + "\n"
    guide = GUIDE.read_text("utf-8")
    GUIDE.write_text(re.sub(r"^\| sheet \| problems with(.*\n)(\|.*\n)*", table, guide, flags=re.MULTILINE), "utf-8")
    return int(not all(is_kept for _, is_kept in rows))


if __name__ == "__main__":
    sys.exit(main())
