"""The page of mistakes: for each sheet the ten that it recognises in the most problems, each with an example; all of them as data.

Messages and examples have the numbers that the pages of the sheets show, and no student's.
"""

import json
from collections.abc import Iterator, Sequence
from contextlib import suppress
from typing import Any

import numpy as np
from myst_parser.slugs import github_slugify

from kincourse import find_sheet, sheets
from kinlib.arrays.validation import Array, poses
from kinlib.view import draw_frames
from misstep.display.text import number
from misstep.problem import Template
from misstep.sheet import Sheet

STUDENT = "your id"
"""The id of the numbers that the pages of the sheets show."""

MAX_SHOWN = 10
MAX_ENTRIES = 24  # of an array that is shown as an example


def pages() -> Iterator[tuple[str, str]]:
    """Yield one page for each sheet, an overview, and the messages of all mistakes as JSON, by problem and name."""
    everything: dict[str, dict[str, str]] = {}
    for name in sheets():
        sheet = find_sheet(name)
        known = {template.number: template.variant(STUDENT).known_mistakes for template in sheet.problems}
        found = {number: {one.name: one.message for one in mistakes} for number, mistakes in known.items()}
        everything |= found
        yield f"mistakes/{name}.md", page(name, sheet, found)
    yield "files/mistakes.json", json.dumps(everything, ensure_ascii=False, indent=1)
    names = "\n".join(sheets())
    yield (
        "mistakes/index.md",
        f"""\
# Common mistakes

For each sheet, the mistakes that can be made in the most of its problems: what was done, what is true instead, and what it looks
like. If your wrong answer comes from one of them, the card of the problem names it.

```{{toctree}}
:maxdepth: 1

{names}
```

The sheets recognise {sum(len(named) for named in everything.values())} mistakes, counted for each problem.
<a href="../files/mistakes.json">All of them as data</a>: by problem and name, with the message for the numbers of the id "{STUDENT}".
""",
    )


def page(name: str, sheet: Sheet, found: dict[str, dict[str, str]]) -> str:
    """Write the page with the most frequent mistakes of one sheet."""
    places: dict[str, list[Template]] = {}
    for template in sheet.problems:
        for mistake in found[template.number]:
            places.setdefault(mistake, []).append(template)
    parts = [f"# Mistakes of sheet {name.partition('_')[0]}: {sheet.title}", f"[The sheet](../sheets/{name}.ipynb)"]
    for mistake in sorted(places, key=lambda mistake: -len(places[mistake]))[:MAX_SHOWN]:
        first, *others = places[mistake]
        lecture, _, heading = first.lecture.partition("#")
        link = f"../lectures/{lecture}.ipynb{'#' + github_slugify(heading) if heading else ''}"
        also = f" Also in {', '.join(template.number for template in others)}." if others else ""
        parts += [
            f"## {mistake[:1].upper()}{mistake[1:]}",
            f"In {first.number}, {first.title}: {found[first.number][mistake]}{also}",
            *example(places[mistake], mistake),
            f"Read again: [{heading or 'the lecture'}]({link}).",
        ]
    return "\n\n".join(parts) + "\n"


def example(templates: Sequence[Template], mistake: str) -> Iterator[str]:
    """Yield an answer as it is beside what is typed by this mistake, and for poses both frames as a drawing."""
    for template in templates:
        problem = template.variant(STUDENT)
        typed = next((entries(one.value) for one in problem.known_mistakes if one.name == mistake), None)
        right = entries(problem.answer.value)
        if right is None or typed is None or right.shape != typed.shape:
            continue
        yield f"| as it is, in {template.number} | as typed |\n| --- | --- |\n| ${marked(right, typed)}$ | ${marked(typed, right)}$ |"
        with suppress(ValueError):  # a mistake may lead to no rigid motion
            frames = {"as it is": poses(right, "right"), "as typed": poses(typed, "typed")}
            yield f"```{{raw}} html\n{draw_frames(frames).html()}\n```"
        return


def entries(value: Any) -> Array | None:
    """Return a value as a matrix of numbers, or None if it is none or has too many of them."""
    try:
        array = np.atleast_2d(np.asarray(getattr(value, "rows", value), dtype=float))
    except (TypeError, ValueError):
        return None
    return array if array.ndim == 2 and array.size <= MAX_ENTRIES else None


def marked(one: Array, other: Array) -> str:
    r"""Write a matrix in LaTeX, with a box around each entry that differs from another matrix.

    >>> marked(np.array([[0.5, 0.0]]), np.array([[-0.5, 0.0]]))
    '\\begin{pmatrix} \\boxed{0.5} & 0 \\end{pmatrix}'
    """
    differs = ~np.isclose(one, other, atol=1e-6)
    rows = r" \\ ".join(
        " & ".join(rf"\boxed{{{number(x)}}}" if boxed else number(x) for x, boxed in zip(*row, strict=True))
        for row in zip(one.tolist(), differs.tolist(), strict=True)
    )
    return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}"
