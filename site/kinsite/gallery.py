"""The gallery: each robot and linkage of the course to turn, with its axes, its screws, its tables and its source."""

import inspect
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kincourse.text.joint_table import joint_table
from kinlib import linkages, robots
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment, assign_frames
from kinlib.dh.formatting import format_rows, markdown_table
from kinlib.dh.table import Convention
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.view import draw_arm, drive, explore
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.linkage import draw_linkage
from kinsite.reference import escape, prose
from misstep.text import matrix, number

NO_ROBOTS = {"arm", "pose"}
"""What kl.robots offers that is no robot."""

LENGTHS: dict[str, dict[str, Any]] = {
    "four_bar": {"ground": 0.4, "crank": 0.1, "coupler": 0.35, "rocker": 0.3},
    "slider_crank": {"crank": 0.2, "rod": 0.5},
    "five_bar": {"ground": 0.4, "left": (0.3, 0.4), "right": (0.3, 0.4)},
}
"""Lengths for the linkages that have none of their own."""

POSTURES: dict[str, ArrayLike] = {
    "bricard": [1, -2, 1, -2, 1, -2],
    "four_bar": [1, 0, 2, 0],
    "five_bar": [1.8, -1, 1.3, 1, 0],
    "bennett": [1, 2, 1, 2],
    "ten_links": [1.9, -0.5, -0.4, -0.4, -0.3, 1.2, 0.5, 0.4, 0.4, 0.3, 0],
}
"""From where the linkages are assembled that are drawn open, or that their drawing does not show well."""

BETWEEN = "\n\n"
"""What stands between paragraphs."""

POINTS = 160
"""Postures along the curve of a linkage that is driven."""


@dataclass(frozen=True, eq=False)
class Entry:
    """One page of the gallery: the function's name, what it makes, and its picture."""

    function: str
    made: Chain | Mechanism
    words: str
    picture: Picture

    @property
    def kind(self) -> str:
        """What stands below its name in the gallery."""
        if isinstance(self.made, Chain):
            return self.made.joint_types
        return f"{len(self.made.joints)} joints"


def pages() -> Iterator[tuple[str, str]]:
    """One page a robot or linkage, its picture, and one page that leads to them.

    Raises ValueError for a robot without a source.
    """
    arms = [arm(name, make) for name, make in offered(robots) if name not in NO_ROBOTS]
    loops = [loop(name, make) for name, make in offered(linkages)]
    for entry in arms + loops:
        if not entry.made.source.strip():
            raise ValueError(f"{entry.function} names no source: say which document it comes from.")
        yield f"robots/{entry.function}.svg", entry.picture.svg
        yield f"robots/{entry.function}.md", page(entry)
    yield "robots/index.md", overview(arms, loops)


def offered(module: Any) -> list[tuple[str, Callable[..., Any]]]:
    """The public functions of a module, in the order in which they stand there."""
    found = inspect.getmembers(module, inspect.isfunction)
    own = [(name, made) for name, made in found if made.__module__ == module.__name__ and not name.startswith("_")]
    return sorted(own, key=lambda pair: pair[1].__code__.co_firstlineno)


def arm(name: str, make: Callable[..., Chain]) -> Entry:
    """The entry of an arm, drawn at home."""
    made = make()
    return Entry(name, made, inspect.getdoc(make) or "", draw_arm(made))


def loop(name: str, make: Callable[..., Mechanism]) -> Entry:
    """The entry of a linkage, drawn in a posture in which it closes.

    Raises ValueError where none is found from the guess in POSTURES.
    """
    made = make(**LENGTHS.get(name, {}))
    return Entry(name, made, inspect.getdoc(make) or "", draw_linkage(made, posture(name, made)))


def posture(name: str, made: Mechanism) -> Any:
    """A posture in which a linkage closes.

    Raises ValueError where none is found.
    """
    found = made.assemble(POSTURES.get(name, np.zeros(made.n)))
    if not found.converged:
        raise ValueError(f"{name} does not close from the guess in POSTURES: give it another one.")
    return found.q


def overview(arms: list[Entry], loops: list[Entry]) -> str:
    """The page that leads to all others."""
    names = "\n".join(entry.function for entry in arms + loops)
    return f"""\
# Gallery of robots

Every robot of the course, with the document that it comes from. Open one to turn its joints, to switch its screw axes
on, and to read its screws and both of its tables.

## Arms

{cards(arms)}

## Linkages

{cards(loops)}

```{{toctree}}
:hidden:

{names}
```
"""


def cards(entries: list[Entry]) -> str:
    """A list of entries, each with its picture."""
    listed = (
        f"- [![{escape(entry.picture.alt)}]({entry.function}.svg) **{escape(entry.made.name)}** {entry.kind}]({entry.function}.md)"
        for entry in entries
    )
    return "{.cards}\n" + "\n".join(listed)


def page(entry: Entry) -> str:
    """One robot: to turn, to read, and to call."""
    call = f"kl.{'robots' if isinstance(entry.made, Chain) else 'linkages'}.{entry.function}"
    # what it raises is for who calls it, and its source stands below
    said = [part for part in entry.words.split(BETWEEN) if not part.startswith(("Raises", "Source:"))]
    head = f"# {escape(entry.made.name)}\n\n{prose(BETWEEN.join(said))}\n"
    source = f"**Source.** {escape(entry.made.source)}. In Python it is {{py:func}}`{call} <kinlib.{call[3:]}>`."
    tables = arm_tables(entry.made) if isinstance(entry.made, Chain) else loop_tables(entry.function, entry.made)
    return "\n\n".join([head, raw(shown(entry)), source, tables]) + "\n"


def shown(entry: Entry) -> str:
    """The viewer, or where a linkage has more freedoms than a slider, its drawing."""
    if isinstance(entry.made, Chain):
        return explore(entry.made).html()
    q = posture(entry.function, entry.made)
    if entry.made.mobility(q).finite == 1:
        curve = entry.made.trace(q, points=POINTS).q
        return drive(entry.made, q, curves=[curve], labels=["as it is assembled"]).html()
    return entry.picture.html()


def arm_tables(made: Chain) -> str:
    """Axes, screws, home pose and both tables of an arm."""
    parts = ["## Axes at home", joint_table(made), "## Screw axes", screw_table(made)]
    parts += [f"The home pose is\n\n$$M = {matrix(made.home)}.$$"]
    if "H" in made.joint_types:
        return "\n\n".join(
            [*parts, "## DH tables", "A helical joint has no row in a table: nothing in it can both turn and climb."]
        )
    conventions: tuple[Convention, Convention] = ("standard", "modified")
    for convention in conventions:
        parts += [f"## A {convention} DH table", dh_table(assign_frames(made, convention=convention))]
    return "\n\n".join(parts)


def screw_table(made: Chain) -> str:
    """Space and body screws, one row a joint."""
    rows = [
        f"| {i} | ${sixfold(S)}$ | ${sixfold(B)}$ |"
        for i, (S, B) in enumerate(zip(made.screws, made.body_screws, strict=True), start=1)
    ]
    head = "| joint | in {s}: $S_i = (\\omega, v)$ | in {b}: $B_i = (\\omega, v)$ |\n| --- | --- | --- |"
    return "\n".join([head, *rows])


def sixfold(S: ArrayLike) -> str:
    """A screw in a row, its halves told apart."""
    words = [number(value) for value in np.asarray(S, dtype=float)]
    return f"({', '.join(words[:3])},\\; {', '.join(words[3:])})"


def dh_table(found: FrameAssignment) -> str:
    """A table as kl.assign_frames finds it, with its base and its tool."""
    table = found.table
    link = "i-1" if table.convention == "modified" else "i"
    names = (f"length $a_{{{link}}}$", f"twist $\\alpha_{{{link}}}$", "offset $d_i$", "angle $\\theta_i$")
    rows = format_rows(table, length=number, angle=angle, variable="q_{{{}}}".format)
    printed = markdown_table([[f"${cell}$" for cell in row] for row in rows], ["row", *names])
    ends = f"The base and the tool are\n\n$${matrix(table.base)} \\qquad \\text{{and}} \\qquad {matrix(table.tool)}.$$"
    remark = "Any other right table is as good: this is the one that `kl.assign_frames` finds."
    return f"{printed}\n\n{remark}\n\n{ends}"


def angle(x: float) -> str:
    r"""An angle in radians, as a share of pi where it is one.

    >>> angle(-np.pi / 2), angle(0.3)
    ('-\\pi/2', '0.3')
    """
    share = Fraction(x / np.pi).limit_denominator(12)
    if share == 0 or abs(float(share) * np.pi - x) > 1e-9:
        return number(x)
    top = {1: "", -1: "-"}.get(share.numerator, str(share.numerator))
    return f"{top}\\pi" + (f"/{share.denominator}" if share.denominator > 1 else "")


def loop_tables(function: str, made: Mechanism) -> str:
    """What can be counted of a linkage, and its joints at the drawing."""
    mobility = made.mobility(posture(function, made))
    loops = len(made.loops)
    return "\n".join(
        [
            "## Mobility",
            "",
            "| what | how many |",
            "| --- | --- |",
            f"| bodies, with the ground | {len(made.bodies)} |",
            f"| joints | {len(made.joints)} |",
            f"| joint values | {made.n} |",
            f"| loops | {loops} |",
            f"| counted, by Kutzbach | {mobility.kutzbach} |",
            f"| infinitesimal (first-order), in this configuration | {mobility.infinitesimal} |",
            f"| finite | {mobility.finite} |",
        ]
    )


def raw(html: str) -> str:
    """HTML as it stands."""
    return f"````{{raw}} html\n{html}\n````"
