"""The page on performance: the results that `python -m benchmarks --save` has written, as tables and curves.

This module contains no number, and no sentence that a new measurement could make wrong.
"""

import ast
import re
import sys
from collections.abc import Iterator, Sequence

import numpy as np

from kinlib.view.drawing.dark_theme import follow_theme
from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.plot import plot
from kinsite.execute import ROOT
from kinsite.generated.reference import escape

sys.path.insert(0, str(ROOT))  # the benchmarks are not an installed package

from benchmarks.measure import Curve, Row
from benchmarks.results import Run, format_quantity, format_ratio, format_row, load

HEADS = ("measurement", "kinlib", "peer's value", "peer", "ratio", "previous run", "target", "result")

TOP = """\
# Performance

How fast and how accurate kinlib is, compared with other packages. Every number on this page was measured by one command,
which you can repeat:

```text
python -m benchmarks --all --save
```

A single benchmark is run by its name: `python -m benchmarks frames`.

**Where.** {machine}. **When.** {days}. **With.** {versions}.

**How.** In each round every package is measured once, in another order each time, because other programs disturb the
measurement. Times and ratios are medians over the rounds. A ratio says how many times better kinlib is than its peer; the
brackets contain the middle half of the rounds; then follows the ratio of the previous run. Where the target of a ratio is
"at most", the ratio says how many times as long kinlib takes. Times depend on the machine. Ratios depend on it less, but a
ratio close to 1 may be above 1 on one machine and below 1 on another.
"""

BATCHES = """\
### Every size of a batch

kinlib computes a batch in one call. A peer named as a loop, or as bare calls, takes one element per call, so it was timed
for one size, of 10,000 at most, and this time for one element is shown for every size. Bare calls leave each result in an
object of the peer. All times below are for one element of the batch; a size of 1 is a call with a single element.
"""

GRADING_MARK = "<!-- The site adds here what was measured. -->"
"""Where the guide for instructors says how long grading took."""

GROWTH = """\
## How it grows

If a time grows with the size to the power 1, it doubles when the size doubles. The power is the slope of the line on
logarithmic axes, fitted by least squares to the upper half of the sizes: at smaller sizes, the constant cost of each call
dominates.
"""


def pages() -> Iterator[tuple[str, str]]:
    """Yield the page, and a picture for each curve.

    Raises FileNotFoundError if nothing has been measured yet.
    """
    results = load()
    about = {name: value for name, value in results.machine.items() if value != "not installed"}
    versions = [f"{name} {about.pop(name)}" for name in list(about)[3:]]
    machine = f"{about['processor']}, {about['cores']} cores, {about['system']}"
    days = sorted({runs[0].day for runs in results.runs.values()})
    parts = [TOP.format(machine=escape(machine), days=" and ".join(days), versions=escape(", ".join(versions)))]
    curves = []
    for name, runs in results.runs.items():
        parts.append(section(name, runs))
        paths = [f"performance/{name}-{number}.svg" for number in range(1, len(runs[0].curves) + 1)]
        compared = [(path, curve) for path, curve in zip(paths, runs[0].curves, strict=True) if curve.peers]
        parts += [BATCHES] * bool(compared)
        for path, curve in compared:
            picture = draw_batches(curve)
            yield path, follow_theme(picture.svg)
            parts += [
                f"**{escape(curve.name[0].upper() + curve.name[1:])}.** {escape(comparison(curve))}",
                image(path, picture),
            ]
            parts.append(batch_table(curve))
        curves += [(path, curve) for path, curve in zip(paths, runs[0].curves, strict=True) if not curve.peers]
    parts += [GROWTH, growth_table([curve for _, curve in curves])]
    for path, curve in curves:
        picture = draw(curve)
        yield path, follow_theme(picture.svg)
        parts.append(image(path, picture))
    yield "performance.md", "\n\n".join(parts) + "\n"


def with_grading_times(guide: str) -> str:
    """Add to the guide for instructors how long grading took, each time with that of nbgrader, if it has been measured."""
    results = load()
    if "grading" not in results.runs:
        return guide.replace(GRADING_MARK, "")
    run = results.runs["grading"][0]
    times = [
        f"{row.name}: {format_quantity(row.value, row.unit)}, {row.peer}: {format_quantity(row.peer_value, row.unit)}"
        for row in run.rows
        if row.peer_value is not None
    ]
    machine = f"{escape(results.machine['processor'])} with {results.machine['cores']} cores"
    text = f"On {machine}, {run.day}: {escape('; '.join(times))}. [Performance](performance.md#grading) has more."
    return guide.replace(GRADING_MARK, text)


def section(name: str, runs: tuple[Run, ...]) -> str:
    """Write the section of one benchmark: what it measures, from the docstring of its module, and its table."""
    (module,) = (ROOT / "benchmarks").glob(f"*/{name}.py")
    text = ast.get_docstring(ast.parse(module.read_text("utf-8"))) or ""
    paragraphs = [block for block in re.split(r"\n\s*\n", text) if not block.startswith("    ")][:2]
    before = {(row.name, row.peer): row for run in runs[1:] for row in run.rows}
    table = [cells(row, before.get((row.name, row.peer))) for row in runs[0].rows]
    heads = [head for head in HEADS if any(line[head] for line in table)]
    rows = markdown_table(heads, [[line[head] for head in heads] for line in table])
    return "\n\n".join([f"## {name.replace('_', ' ').capitalize()}", *map(escape, paragraphs), rows])


def cells(row: Row, before: Row | None) -> dict[str, str]:
    """Write the cells of one row, with the ratio of the previous run."""
    earlier = ""
    if before and not before.peer:
        earlier = format_quantity(before.value, before.unit)
    elif before and before.ratio_or_value is not None:
        earlier = format_ratio(before.ratio_or_value)
    return {**format_row(row), "previous run": earlier}


def comparison(curve: Curve) -> str:
    """Say for each peer at which sizes kinlib takes less time, and where the curves cross."""
    sentences = []
    for peer, seconds in curve.peers.items():
        pairs = zip(curve.sizes, curve.seconds, seconds, strict=True)
        less = [size for size, own, other in pairs if own < other]
        more = [size for size in curve.sizes if size not in less]
        at = [f"about {float(f'{size:.2g}'):,g}" for size in curve.crossings(peer)]
        if not less or not more:
            sentences.append(f"kinlib takes {'less' if less else 'no less'} time than “{peer}” at every measured size.")
            continue
        sizes = f"{', '.join(f'{size:,.0f}' for size in less)} {curve.size_name}"
        if len(at) == 1 and less[0] > more[0]:
            sizes = f"each measured size from {less[0]:,.0f} {curve.size_name} on"
        elif len(at) == 1:
            sizes = f"each measured size up to {less[-1]:,.0f} {curve.size_name}"
        sentences.append(f"kinlib takes less time than “{peer}” for {sizes}; the curves cross at {' and '.join(at)}.")
    return " ".join(sentences)


def batch_table(curve: Curve) -> str:
    """Write the table of a batch: the times for one element, and how many times faster kinlib is."""
    heads = [curve.size_name, "kinlib", *(part for peer in curve.peers for part in (peer, "ratio"))]
    rows = []
    for i, size in enumerate(curve.sizes):
        row = [f"{size:,.0f}", format_quantity(curve.seconds[i] / size, "s")]
        for seconds in curve.peers.values():
            row += [format_quantity(seconds[i] / size, "s"), format_ratio(seconds[i] / curve.seconds[i])]
        rows.append(row)
    return markdown_table(heads, rows)


def draw_batches(curve: Curve) -> Picture:
    """Draw the times for one element against the size of the batch, for kinlib and its peers, and describe them in words."""
    sizes = np.array(curve.sizes)
    named = {name: np.array(seconds) / sizes for name, seconds in {"kinlib": curve.seconds, **curve.peers}.items()}
    ends = [f"{name} from {format_quantity(y[0], 's')} to {format_quantity(y[-1], 's')}" for name, y in named.items()]
    axes = f"The time of one of the {curve.name} against the size of the batch, both logarithmic"
    range_text = f"from {sizes[0]:,.0f} to {sizes[-1]:,.0f} {curve.size_name}"
    alt = f"{axes}, {range_text}: {'; '.join(ends)}. {comparison(curve)}"
    return plot(sizes, named, xlabel=f"{curve.size_name} in the batch", ylabel="seconds for one", log="xy", alt=alt)


def image(path: str, picture: Picture) -> str:
    """Write a picture in Markdown, with its text alternative."""
    return f"![{escape(picture.alt)}]({path})"


def growth_table(curves: list[Curve]) -> str:
    """Write the table of the curves: what grows, over which sizes, and with which power."""
    rows = []
    for c in curves:
        first, last = (format_quantity(seconds, "s") for seconds in (c.seconds[0], c.seconds[-1]))
        rows.append([c.name, c.size_name, f"{c.sizes[0]:,.0f} to {c.sizes[-1]:,.0f}", first, last, f"{c.exponent:.2f}"])
    return markdown_table(("measurement", "grows with", "sizes", "from", "to", "power"), rows)


def draw(curve: Curve) -> Picture:
    """Draw a curve on logarithmic axes with the fitted line, and describe both in words."""
    x, y = np.array(curve.sizes), np.array(curve.seconds)
    upper = x >= np.sqrt(x[0] * x[-1])
    middle = np.exp(np.log(y[upper]).mean() - curve.exponent * np.log(x[upper]).mean())
    line = np.where(upper, middle * x**curve.exponent, np.nan)
    first, last = (format_quantity(seconds, "s") for seconds in (y[0], y[-1]))
    ends = f"from {first} for {x[0]:,.0f} to {last} for {x[-1]:,.0f} {curve.size_name}"
    power = f"power {curve.exponent:.2f}"
    axes = f"The time of {curve.name} against {curve.size_name}, both logarithmic"
    alt = f"{axes}: {ends}; in the upper half with the {power}."
    named = {"measured": y, power: line}
    return plot(x, named, xlabel=curve.size_name, ylabel=f"{curve.name}: seconds", log="xy", alt=alt)


def markdown_table(heads: Sequence[str], rows: list[list[str]]) -> str:
    """Write a table in Markdown."""
    lines = [heads, ["---"] * len(heads), *([escape(cell) for cell in row] for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
