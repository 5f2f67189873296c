"""Grade every attack, and write what it gained and what it cost others: `nox -s attacks` writes site/pages/attacks.md.

Exits with 1 if an attack gains a point, changes a file, reads a secret, costs another student a point, or holds more memory
than the limit. Times depend on the machine, and are only written.
"""

import json
import re
import socket
import sqlite3
import statistics
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "site" / "pages" / "attacks.md"

sys.path[:0] = [str(ROOT / "tests" / "support")]

from attacks import ATTACKS, ENDLESS, HOARD, LIMITS, SHORT, WAYS_TO_HOLD_MEMORY, source  # noqa: E402
from submissions import as_bytes, attacking, code, handed_in, names, released, right  # noqa: E402

from misstep.grading.collect.run_plan import read_released_sheet  # noqa: E402
from misstep.grading.judging.grader import Grader  # noqa: E402
from misstep.grading.sandbox.limits import Limits  # noqa: E402

FORMULA_SHEET, FORMULA_PROBLEM = "10_one_robot_four_ways", 5
SLOW_FORMULAS = ["sin(exp(exp(30)))**2", "sign(sin(exp(exp(exp(4)))))", "log(exp(exp(exp(9))))", "9**9**9**9"]
HONEST, ROUNDS = 9, 3


def attack_rows() -> Iterator[tuple[str, bool]]:
    """Each attack: its points, whether it reached what it was after, and the points of an honest submission after it."""
    honest = as_bytes(handed_in("neighbour", right("neighbour")))
    replayed = "{" + ", ".join(f"{k}: {line.partition(' = ')[2]}" for k, line in right("bob").items()) + "}"
    with (
        tempfile.TemporaryDirectory() as name,
        socket.create_server(("127.0.0.1", 0)) as server,
        Grader(read_released_sheet(released()), LIMITS) as grader,
    ):
        folder = Path(name)
        folder.chmod(0o777)
        server.setblocking(False)
        for file in ("secret.txt", "solutions.ipynb"):
            (folder / file).write_text("SECRET-CANARY")
        with sqlite3.connect(folder / "gradebook.db") as book:
            book.execute("create table grade (score real)")
        before = {path.name: path.read_bytes() for path in folder.iterdir()}
        for attack in ATTACKS:
            grader._limits = SHORT if attack in ENDLESS else LIMITS
            text = source(attack, folder=folder, port=server.getsockname()[1], replayed=replayed)
            result = grader.grade("ada", as_bytes(attacking("ada", text)))
            outputs = json.dumps([cell.outputs for cell in result.cells])
            is_held = "SECRET-CANARY" not in outputs
            is_held &= before == {path.name: path.read_bytes() for path in folder.iterdir()} and not _is_reached(server)
            grader._limits = LIMITS
            after = grader.grade("neighbour", honest).points
            fine = is_held and result.points == 0 and after == 24
            reached = "nothing" if is_held else "something"
            yield f"| {attack} | {result.points:g} of {result.max:g} | {reached} | {after:g} of 24 |", fine


def _is_reached(server: socket.socket) -> bool:
    try:
        server.accept()
    except BlockingIOError:
        return False
    return True


def memory_rows() -> Iterator[tuple[str, bool]]:
    """Each way to hold memory, with the default limit: what was asked for, and what was held."""
    limits = Limits(cell_seconds=100.0, seconds=200.0, processor_seconds=100)  # so that memory, not time, is the limit
    with Grader(read_released_sheet(released()), limits) as grader:
        for name, way in WAYS_TO_HOLD_MEMORY.items():
            notebook = handed_in("ada")
            hoard = HOARD.replace("{most}", str(2 * limits.memory_mb))
            notebook["cells"].append(code(f"{hoard}\n{way}\nprint('held', held // MB, 'MB')"))
            result = grader.grade("ada", as_bytes(notebook))
            found = re.search(r"held (\d+) MB", json.dumps([cell.outputs for cell in result.cells]))
            held = int(found[1]) if found else 0
            told = f"{held} MB" if found else "ended before it could count"
            yield f"| {name} | {2 * limits.memory_mb} MB | {told} | {limits.memory_mb} MB |", held < limits.memory_mb


def formula_rows() -> Iterator[tuple[str, bool]]:
    """Each slow formula beside nine honest submissions: its state, and their time compared with the same nine alone."""
    students = [f"student {k}" for k in range(HONEST)]
    contents = {name: as_bytes(handed_in(name, right(name, FORMULA_SHEET), name=FORMULA_SHEET)) for name in students}
    variable = names(FORMULA_SHEET)[FORMULA_PROBLEM]
    with Grader(read_released_sheet(released(FORMULA_SHEET))) as grader, ThreadPoolExecutor(2) as pool:

        def seconds_of_honest(tenth: bytes) -> tuple[float, float, str]:
            other = pool.submit(grader.grade, "eve", tenth)
            results = [*pool.map(grader.grade, students, contents.values())]
            points = min(result.points for result in results)
            return sum(result.seconds for result in results), points, other.result().problems[FORMULA_PROBLEM - 1].state

        blank = as_bytes(handed_in("eve", name=FORMULA_SHEET))
        _, full, _ = seconds_of_honest(blank)
        for formula in SLOW_FORMULAS:
            slow = {FORMULA_PROBLEM: f"{variable} = [{formula!r}, {formula!r}, {formula!r}]"}
            attack = as_bytes(handed_in("eve", slow, name=FORMULA_SHEET))
            ratios = []
            for _ in range(ROUNDS):
                alone, _, _ = seconds_of_honest(blank)
                beside, points, state = seconds_of_honest(attack)
                ratios.append(beside / alone)
            yield (
                f"| `{formula}` | {state} | {statistics.median(ratios):.2f} | {points:g} of {full:g} |",
                points == full,
            )


TABLES = {"attack": attack_rows, "way to hold memory": memory_rows, "formula": formula_rows}
"""By the first word of the table's head, the function that makes its rows."""


def main() -> int:
    page, is_fine = PAGE.read_text("utf-8"), True
    for head, rows in TABLES.items():
        done = []
        for text, fine in rows():
            print(text, "" if fine else "FAILED", flush=True)
            done.append(text)
            is_fine &= fine
        pattern = rf"(?<=^\| {head} \|)(.*\n\|[ -|]*\n)(\|.*\n)*"
        page = re.sub(pattern, lambda found, rows=done: found[1] + "\n".join(rows) + "\n", page, flags=re.MULTILINE)
    PAGE.write_text(page, "utf-8")
    return int(not is_fine)


if __name__ == "__main__":
    sys.exit(main())
