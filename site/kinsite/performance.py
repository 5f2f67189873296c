"""The page on performance: what `python -m benchmarks --save` has kept, as tables and curves.

No number stands here, and no sentence that a new measurement could make wrong.
"""

import ast
import re
import sys
from collections.abc import Iterator, Sequence

import numpy as np

from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.plot import plot
from kinsite.execute import ROOT
from kinsite.reference import escape

sys.path.insert(0, str(ROOT))  # the benchmarks are no part of kinlib

from benchmarks.measure import Curve, Row
from benchmarks.results import Run, amount, load, times, told

HEADS = ("what", "kinlib", "peer's", "peer", "ratio", "before", "wanted", "result")

TOP = """\
# Performance

How fast kinlib is, how soon, and how right, beside what others use. Every number on this page was measured by one command
that anybody can repeat. Nobody wrote one by hand.

```text
python -m benchmarks --all --save
```

One of them is measured by its name: `python -m benchmarks frames`.

**Where.** {machine}. **When.** {days}. **With.** {versions}.

**How.** In each round everybody has a turn, in another order each time, for a machine is never quiet. Times and ratios are
medians of the rounds. A ratio says how many times better kinlib is than the peer; in brackets, between which ratios the
middle half of the rounds lies; then the ratio of the run before. Where "at most" is wanted of a ratio, it says how many
times as long kinlib takes. Times are those of this kind of machine; ratios travel better, and a small one may change sides.
"""

GROWTH = """\
## How it grows

A time that grows with the size to the power 1 doubles where the size doubles. The power is the slope of the line on
logarithmic axes, by least squares over the upper half of the sizes: below, what is done once for every call hides it.
"""


def pages() -> Iterator[tuple[str, str]]:
    """The page, and a picture for each curve.

    Raises FileNotFoundError where nothing has been measured yet.
    """
    results = load()
    kind = {name: value for name, value in results.machine.items() if value != "not installed"}
    versions = [f"{name} {kind.pop(name)}" for name in list(kind)[3:]]
    machine = f"{kind['processor']}, {kind['cores']} cores, {kind['system']}"
    days = sorted({runs[0].day for runs in results.runs.values()})
    parts = [TOP.format(machine=escape(machine), days=" and ".join(days), versions=escape(", ".join(versions)))]
    curves = []
    for name, runs in results.runs.items():
        parts.append(section(name, runs))
        curves += [(f"performance/{name}-{number}.svg", curve) for number, curve in enumerate(runs[0].curves, start=1)]
    drawn = [(path, curve, drawing(curve)) for path, curve in curves]
    parts += [GROWTH, growth_table([curve for _, curve in curves])]
    parts += [f"![{escape(shown.alt)}]({path})" for path, _, shown in drawn]
    yield from ((path, shown.svg) for path, _, shown in drawn)
    yield "performance.md", "\n\n".join(parts) + "\n"


def section(name: str, runs: tuple[Run, ...]) -> str:
    """One benchmark: what it measures, in the words of its module, and its table."""
    text = ast.get_docstring(ast.parse((ROOT / "benchmarks" / f"{name}.py").read_text("utf-8"))) or ""
    said = [block for block in re.split(r"\n\s*\n", text) if not block.startswith("    ")][:2]
    before = {(row.what, row.peer): row for run in runs[1:] for row in run.rows}
    table = [cells(row, before.get((row.what, row.peer))) for row in runs[0].rows]
    heads = [head for head in HEADS if any(line[head] for line in table)]
    shown = grid(heads, [[line[head] for head in heads] for line in table])
    return "\n\n".join([f"## {name.replace('_', ' ').capitalize()}", *map(escape, said), shown])


def cells(row: Row, before: Row | None) -> dict[str, str]:
    """A row of the table, with the ratio of the run before."""
    earlier = "" if before is None else times(before.figure) if before.peer and before.figure else ""
    if before and not before.peer:
        earlier = amount(before.ours, before.unit)
    return {**told(row), "before": earlier}


def growth_table(curves: list[Curve]) -> str:
    """What grows, over which sizes, and with which power."""
    rows = []
    for c in curves:
        first, last = (amount(seconds, "s") for seconds in (c.seconds[0], c.seconds[-1]))
        rows.append([c.what, c.of, f"{c.sizes[0]:,.0f} to {c.sizes[-1]:,.0f}", first, last, f"{c.exponent:.2f}"])
    return grid(("what", "grows with", "sizes", "from", "to", "power"), rows)


def drawing(curve: Curve) -> Picture:
    """A curve on logarithmic axes, with the line of its power, in words too."""
    x, y = np.array(curve.sizes), np.array(curve.seconds)
    upper = x >= np.sqrt(x[0] * x[-1])
    middle = np.exp(np.log(y[upper]).mean() - curve.exponent * np.log(x[upper]).mean())
    line = np.where(upper, middle * x**curve.exponent, np.nan)
    ends = f"from {amount(y[0], 's')} for {x[0]:,.0f} to {amount(y[-1], 's')} for {x[-1]:,.0f} {curve.of}"
    alt = f"The time of {curve.what} against {curve.of}, both logarithmic: {ends}; in the upper half with the power {curve.exponent:.2f}."
    named = {"measured": y, f"power {curve.exponent:.2f}": line}
    return plot(x, named, xlabel=curve.of, ylabel=f"{curve.what}: seconds", log="xy", alt=alt)


def grid(heads: Sequence[str], rows: list[list[str]]) -> str:
    """A table."""
    lines = [heads, ["---"] * len(heads), *([escape(cell) for cell in row] for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
