"""The page on performance: what `nox -s benchmarks -- --keep` has written into evidence/benchmarks/results.json, as tables.

This module contains no number, and no sentence that a new measurement could make wrong.
"""

import json
import sys
from collections.abc import Iterator, Sequence
from typing import Any

from kinsite.execute import ROOT
from kinsite.markdown import escape, table

sys.path.insert(0, str(ROOT / "evidence" / "benchmarks"))  # they are not an installed package

from library_rows import ROWS

RESULTS = ROOT / "evidence" / "benchmarks" / "results.json"

Result = dict[str, Any]

TOP = """\
# Performance

How long kinlib takes, beside other packages. Each number was measured by one command, which you can repeat and shorten:

```text
.venv/bin/python -m nox -s benchmarks
.venv/bin/python -m nox -s benchmarks -- -k "fk and kinlib"
```

Times depend on the machine, and on what else runs on it; the ratio of two times depends on it less, but a ratio close to 1 may be above
1 on one machine and below 1 on another. Below each table is the set-up in which it was measured: a figure holds for this set-up only.
"""

OPERATIONS = {
    "exp": "Exponentials of twists",
    "log": "Logarithms of poses",
    "fk": "Forward kinematics of a PUMA 560",
    "jacobian": "Space Jacobians of a PUMA 560",
}

BATCHES = """\
## The library

In these tables, each cell is the processor time, of the thread that calls, **for one element** of a batch: first in a
**fresh** process, which has run nothing but the lines above the table, then in a **warmed** one, which has computed the
larger batches before. Both are medians: of five calls in each of some fresh processes, and of at least five calls in
the warmed one. The warmed time of a peer is followed by how many times that of kinlib it is. Every library is given one
NumPy array and must give one back; where it computes one element in a call, the loop is part of its time. A loop takes
the same time for each element of a larger batch, so it is not measured there.
"""

COURSE = {
    "import": ("Importing", "Processor time from the start of a new Python to its end, median of 21."),
    "check": (
        "A check in a notebook",
        "Processor time of one check, with its feedback as HTML: the median of five in a fresh process, and of many in one process.",
    ),
    "grading": (
        "Grading a class",
        "Time from start to end for all submissions of sheet 03. misstep also writes pages of feedback, and nbgrader does not.",
    ),
    "first answer": (
        "First checked answer in the browser",
        "From opening a page, with nothing stored, to the feedback of a first answer of a script; median of three, without downloads.",
    ),
    "student": (
        "Memory of a student on a Hub",
        "The server of a student and the kernels of two notebooks that have run; memory that processes share counts once.",
    ),
}
"""The other sections: title and what is measured."""

GRADING_MARK = "<!-- The site adds here what was measured. -->"
"""Where the guide for instructors says how long grading took."""


def load() -> tuple[list[Result], list[Result]]:
    """Load the rows and the set-ups to which they refer."""
    data = json.loads(RESULTS.read_text("utf-8"))
    return data["rows"], data["set_ups"]


def pages() -> Iterator[tuple[str, str]]:
    """Yield the page."""
    rows, set_ups = load()
    parts = [TOP, BATCHES]
    for operation, title in OPERATIONS.items():
        kinlib = next(row for row in ROWS if row.operation == operation)
        lines = kinlib.setup.format(batch="100, ") + kinlib.call
        own = [row for row in rows if row["section"] == operation]
        if not own:
            continue
        parts += [
            f"### {title}",
            f"For example, of 100 elements, and likewise for the other sizes:\n\n```python\n{lines}\n```",
        ]
        parts += [batch_table(own), set_up_text(own, set_ups)]
    for section, (title, text) in COURSE.items():
        own = [row for row in rows if row["section"] == section]
        if not own:
            continue
        parts += [f"## {title}", text, course_table(own), set_up_text(own, set_ups)]
    yield "performance.md", "\n\n".join(parts) + "\n"


def batch_table(rows: Sequence[Result]) -> str:
    """Write a line for each size, and a column for each library: fresh and warmed time of one element."""
    libraries = list(dict.fromkeys(row["library"] for row in rows))
    by_key = {(row["size"], row["library"]): row for row in rows}
    lines = []
    for size in sorted({row["size"] for row in rows}):
        own = by_key.get((size, "kinlib"))
        cells = [batch_cell(by_key.get((size, library)), size, own) for library in libraries]
        lines.append([f"{size:,}", *cells])
    return table(["batch", *(f"{library}: fresh, warmed" for library in libraries)], lines)


def batch_cell(row: Result | None, size: int, own: Result | None) -> str:
    """Write the two times of a row, and for a peer the ratio to the time of kinlib."""
    if row is None:
        return "-"
    ratio = f" ({row['warmed'] / own['warmed']:.2g} x)" if own and row is not own else ""
    return f"{seconds(row['fresh'] / size)}, {seconds(row['warmed'] / size)}{ratio}"


def course_table(rows: Sequence[Result]) -> str:
    """Write a line for each row of a section, with those of its quantities that it has."""
    columns = {
        "of": lambda row: f"{row['size']:,} submissions" if row["section"] == "grading" else "",
        "fresh": lambda row: seconds(row["fresh"]) if "fresh" in row else "",
        "time": lambda row: seconds(row["warmed"]) if "megabytes" not in row else "",
        "for each submission": lambda row: seconds(row["warmed"] / row["size"]) if row["section"] == "grading" else "",
        "processor time": lambda row: seconds(row["processor"]) if "processor" in row else "",
        "memory": lambda row: f"{row['megabytes']:.0f} MB" if "megabytes" in row else "",
        "ratio to the first": lambda row: f"{row['warmed'] / rows[0]['warmed']:.2g}" if len(rows) > 1 else "",
    }
    used = {name: write for name, write in columns.items() if any(map(write, rows))}
    return table(["", *used], [[escape(row["library"]), *(write(row) for write in used.values())] for row in rows])


def set_up_text(rows: Sequence[Result], set_ups: Sequence[Result]) -> str:
    """Say where and when these rows were measured."""
    texts = []
    for index in dict.fromkeys(row["set_up"] for row in rows):
        one = set_ups[index]
        which = [row["library"] for row in rows if row["set_up"] == index]
        whose = "" if len(which) == len(rows) else f" ({', '.join(dict.fromkeys(which))})"
        packages = ", ".join(f"{name} {version}" for name, version in one["packages"].items())
        busy = (
            ""
            if one["load"] is None
            else f", of which {one['load']:g} were asked for by all programs (the load of one minute)"
        )
        texts.append(
            f"Measured{whose} on {one['date']}: {one['processor']}, {one['system']}, {one['cores']} cores{busy}; {packages}."
        )
    return "\n\n".join(escape(text) for text in texts)


def with_grading_times(guide: str) -> str:
    """Add to the guide for instructors how long grading took, with nbgrader beside it."""
    rows, set_ups = load()
    own = [row for row in rows if row["section"] == "grading"]
    if not own:
        return guide.replace(GRADING_MARK, "")
    times = "; ".join(f"`{row['library']}` {seconds(row['warmed'])}" for row in own)
    set_up = set_ups[own[0]["set_up"]]
    where = f"{set_up['processor']} with {set_up['cores']} cores and a load of {set_up['load']}"
    text = f"On {set_up['date']}, {own[0]['size']} submissions took on {where}: {times}. [Performance](performance.md) has more."
    return guide.replace(GRADING_MARK, text)


def seconds(value: float) -> str:
    """Write a time with three digits and the prefix that fits.

    >>> [seconds(x) for x in (0.75, 4.2e-6, 2.7e-7, 83.21)]
    ['750 ms', '4.2 µs', '270 ns', '83.2 s']
    """
    factor, unit = next((pair for pair in ((1, "s"), (1e3, "ms"), (1e6, "µs")) if value * pair[0] >= 1), (1e9, "ns"))
    return f"{value * factor:.3g} {unit}"
