"""Plant each habit in each official solution, grade it, and write the table of points: `nox -s habits`.

The points before the grader was lenient are kept from the table. Exits with 1 if a habit costs a point.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "site" / "pages" / "habits.md"

sys.path[:0] = [str(ROOT / "tests" / "support")]

from habits import HABITS, SHEETS, graders  # noqa: E402


def main() -> int:
    page = PAGE.read_text("utf-8")
    before = {row[0]: re.findall(r"(\S+) → ", row[1]) for row in re.findall(r"^\| `(.*?)` \|(.*)$", page, re.MULTILINE)}
    cells = {habit: [] for habit in HABITS}
    lost = 0
    with graders() as grade:
        for k, sheet in enumerate(SHEETS):
            for habit in HABITS:
                result = grade(habit, sheet)
                lost += result.points < result.max
                old = before[habit][k] if habit in before else "-"
                cells[habit].append(f"{old} → {result.points:g} of {result.max:g}")
            print(sheet, f"{lost} lost so far", flush=True)
    rows = [f"| `{habit}` | {' | '.join(points)} |" for habit, points in cells.items()]
    head = f"| habit | {' | '.join(name[:2] for name in SHEETS)} |\n| --- |{' --- |' * len(SHEETS)}\n"
    PAGE.write_text(page[: page.index("| habit |")] + head + "\n".join(rows) + "\n", "utf-8")
    return int(lost > 0)


if __name__ == "__main__":
    sys.exit(main())
