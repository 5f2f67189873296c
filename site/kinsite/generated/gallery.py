"""The gallery: each robot and linkage of the course as an interactive figure, with axes, screws, DH tables and source."""

import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kincourse.text.joint_table import joint_table
from kinlib import linkages, robots
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment, assign_frames
from kinlib.dh.formatting import headings, in_latex, markdown_table
from kinlib.dh.table import Convention, format_rows
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.view import drive, explore
from kinlib.view.drawing.figure_colours import follow_theme
from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.svg import GREEK
from kinlib.view.figures.arm import draw_arm
from kinlib.view.figures.linkage import draw_linkage
from kinsite.markdown import escape, prose, table
from misstep.display.text import matrix, number

NOT_ROBOTS = {"arm", "pose"}
"""Public functions of kl.robots that do not make a robot of the course."""

LENGTHS: dict[str, dict[str, Any]] = {
    "four_bar": {"ground": 0.4, "crank": 0.1, "coupler": 0.35, "rocker": 0.3},
    "slider_crank": {"crank": 0.2, "rod": 0.5},
    "five_bar": {"ground": 0.4, "left": (0.3, 0.4), "right": (0.3, 0.4)},
}
"""Arguments for the linkages whose lengths have no default."""

START_CONFIGURATIONS: dict[str, ArrayLike] = {
    "bricard": [1, -2, 1, -2, 1, -2],
    "four_bar": [1, 0, 2, 0],
    "five_bar": [1.8, -1, 1.3, 1, 0],
    "bennett": [1, 2, 1, 2],
    "ten_links": [1.9, -0.5, -0.4, -0.4, -0.3, 1.2, 0.5, 0.4, 0.4, 0.3, 0],
}
"""The guesses from which linkages are assembled that do not close at 0, or that look flat there."""

POSES: dict[str, ArrayLike] = {
    "youbot": [0.5, 1.3, -1.1, -0.9, 0],
    "puma560": [0.4, -0.9, 0.5, 0, 0.6, 0],
    "ur5e": [-2.3, -1.1, 1.3, -1.7, -1.57, 0],
    "panda": [0.5, -0.3, 0, -2.1, 0, 1.9, 0.8],
    "scara": [-0.5, 0.9, 0.15, 0],
    "rprr": [0.6, 0.15, 0.4, 0.5],
    "rpr_lecture7": [0.4, 0.25, 0.5],
    "plain_arm": [0.5, 0.5, 0.1, 0],
    "angled_arm": [0.4, 0.5, 0.15, 0.3],
    "mid_formula_arm": [0.4, -0.4, 0.3, 0.6],
    "hrr": [2.0, -0.8, 1.0],
}
"""Where the gallery shows an arm; every other arm is shown at home, where some look flat."""

LEADING = ("youbot", "puma560", "ur5e", "panda", "scara")
"""What the gallery begins with: arms that readers know."""

PARAGRAPH_BREAK = "\n\n"
GREEK_NAME = re.compile(rf"\b({'|'.join(GREEK)})\b")
"""The name of a Greek letter, as it stands in a docstring."""

CURVE_POINTS = 160
"""Configurations along the curve of a linkage with one degree of freedom."""


@dataclass(frozen=True, eq=False)
class Entry:
    """One page of the gallery: the name of the function, the robot that it makes, its docstring, where it is drawn."""

    function: str
    robot: Chain | Mechanism
    docstring: str
    q: Array

    @cached_property
    def picture(self) -> Picture:
        """The drawing of the robot."""
        if isinstance(self.robot, Chain):
            return draw_arm(self.robot, self.q, show={"tool"})
        return draw_linkage(self.robot, self.q)

    @property
    def kind(self) -> str:
        """The line below the name in the gallery."""
        if isinstance(self.robot, Chain):
            return f"{self.robot.n} joints, {self.robot.joint_types}"
        return f"{len(self.robot.joints)} joints"

    @property
    def name(self) -> str:
        """The function, as the reference lists it."""
        return f"{(robots if isinstance(self.robot, Chain) else linkages).__name__}.{self.function}"


def pages() -> Iterator[tuple[str, str]]:
    """Yield one page and one picture for each robot and linkage, and an overview.

    Raises ValueError for a robot without a source.
    """
    arms = [entry(name, make) for name, make in public_functions(robots) if name not in NOT_ROBOTS]
    mechanisms = [entry(name, make) for name, make in public_functions(linkages)]
    for one in arms + mechanisms:
        if not one.robot.source.strip():
            raise ValueError(f"{one.function} must have a source; got none. Name the document that it comes from.")
        yield f"robots/{one.function}.svg", follow_theme(one.picture.svg)
        yield f"robots/{one.function}.md", page(one)
    yield "robots/index.md", overview(arms, mechanisms)


def public_functions(module: Any) -> list[tuple[str, Callable[..., Any]]]:
    """List the public functions of a module, in the order of the file."""
    functions = inspect.getmembers(module, inspect.isfunction)
    own = [(name, make) for name, make in functions if make.__module__ == module.__name__ and not name.startswith("_")]
    return sorted(own, key=lambda pair: pair[1].__code__.co_firstlineno)


def entry(name: str, make: Callable[..., Chain | Mechanism]) -> Entry:
    """Make the entry of a robot, and choose where it is drawn."""
    robot = make(**LENGTHS.get(name, {}))
    return Entry(name, robot, inspect.getdoc(make) or "", configuration(name, robot))


def configuration(name: str, robot: Chain | Mechanism) -> Array:
    """Return where an arm is drawn, at home or as POSES says, or where a linkage closes.

    Raises ValueError if a linkage does not close from the guess in START_CONFIGURATIONS.
    """
    if isinstance(robot, Chain):
        return np.array(POSES.get(name, np.zeros(robot.n)), dtype=float)
    assembly = robot.assemble(START_CONFIGURATIONS.get(name, np.zeros(robot.n)))
    if not assembly.converged:
        raise ValueError(
            f"{name} must close from its guess in START_CONFIGURATIONS, but it does not. Try another guess."
        )
    return assembly.q


def overview(arms: list[Entry], mechanisms: list[Entry]) -> str:
    """Write the page that lists all others."""
    leading = sorted((arm for arm in arms if arm.function in LEADING), key=lambda arm: LEADING.index(arm.function))
    others = [arm for arm in arms if arm.function not in LEADING]
    names = "\n".join(entry.function for entry in leading + others + mechanisms)
    return f"""\
# Gallery of robots

Every robot of the course, with the document that it comes from. Open one to move its joints, to show its screw axes,
and to read its screws and both of its DH tables.

## Arms in use

{cards(leading, "large")}

## Arms of the lectures

{cards(others)}

## Linkages

{cards(mechanisms)}

```{{toctree}}
:hidden:

{names}
```
"""


def cards(entries: list[Entry], size: str = "") -> str:
    """Write a list of entries, each with its picture."""
    items = (
        f"- [![{escape(entry.picture.alt)}]({entry.function}.svg) **{escape(entry.robot.name)}** {entry.kind}]({entry.function}.md)"
        for entry in entries
    )
    return f"{{.cards{f' .{size}' if size else ''}}}\n" + "\n".join(items)


def page(entry: Entry) -> str:
    """Write the page of one robot: the figure, the source and the tables."""
    call = f"kl.{'.'.join(entry.name.split('.')[-2:])}"
    # the reference says what the function raises, and the source follows below
    paragraphs = [text for text in entry.docstring.split(PARAGRAPH_BREAK) if not text.startswith(("Raises", "Source:"))]
    text = GREEK_NAME.sub(lambda found: GREEK[found[0]], PARAGRAPH_BREAK.join(paragraphs))
    head = f"# {escape(entry.robot.name)}\n\n{prose(text)}\n"
    source = f"**Source.** {escape(entry.robot.source)}. In Python it is {{py:func}}`{call} <{entry.name}>`."
    tables = arm_tables(entry.robot) if isinstance(entry.robot, Chain) else linkage_table(entry.robot, entry.q)
    return "\n\n".join([head, raw_html(figure(entry)), source, tables]) + "\n"


def figure(entry: Entry) -> str:
    """Show a robot in the viewer or, if a linkage has more than one degree of freedom, as a drawing."""
    if isinstance(entry.robot, Chain):
        return explore(entry.robot).html()
    if entry.robot.mobility(entry.q).finite == 1:
        curve = entry.robot.trace(entry.q, points=CURVE_POINTS).q
        return drive(entry.robot, entry.q, curves=[curve], labels=["as it is assembled"]).html()
    return entry.picture.html()


def arm_tables(chain: Chain) -> str:
    """Write the axes, the screws, the home pose and both DH tables of an arm."""
    parts = ["## Axes at home", joint_table(chain), "## Screw axes", screw_table(chain)]
    parts += [f"The home pose is\n\n$$M = {matrix(chain.home)}.$$"]
    if "H" in chain.joint_types:
        note = "A helical joint has no row in a DH table, because a row cannot couple a rotation with a translation."
        return "\n\n".join([*parts, "## DH tables", note])
    conventions: tuple[Convention, Convention] = ("standard", "modified")
    for convention in conventions:
        parts += [f"## A {convention} DH table", dh_table(assign_frames(chain, convention=convention))]
    return "\n\n".join(parts)


def screw_table(chain: Chain) -> str:
    """Write the space and body screws, one row for each joint."""
    rows = [[f"${screw_text(S)}$", f"${screw_text(B)}$"] for S, B in zip(chain.screws, chain.body_screws, strict=True)]
    return markdown_table(rows, ["joint", "in {s}: $S_i = (\\omega, v)$", "in {b}: $B_i = (\\omega, v)$"])


def screw_text(S: ArrayLike) -> str:
    """Write a screw in one line, with a space between omega and v."""
    numbers = [number(value) for value in np.asarray(S, dtype=float)]
    return f"({', '.join(numbers[:3])},\\; {', '.join(numbers[3:])})"


def dh_table(assignment: FrameAssignment) -> str:
    """Write the table of a frame assignment, with its base and its tool."""
    table = assignment.table
    words = zip(["length", "twist", "offset", "angle"], headings(table.convention)[1:], strict=True)
    names = [f"{word} ${in_latex(heading)}$" for word, heading in words]
    rows = format_rows(table, length=number, angle=angle, variable="q_{{{}}}".format)
    printed = markdown_table([[f"${cell}$" for cell in row] for row in rows], ["row", *names])
    ends = f"The base and the tool are\n\n$${matrix(table.base)} \\qquad \\text{{and}} \\qquad {matrix(table.tool)}.$$"
    remark = "This is the table that `kl.assign_frames` finds. Other tables can be right, too."
    return f"{printed}\n\n{remark}\n\n{ends}"


def angle(x: float) -> str:
    r"""Write an angle in radians, as a fraction of pi if it is one with a small denominator.

    >>> angle(-np.pi / 2), angle(0.3)
    ('-\\pi/2', '0.3')
    """
    fraction = Fraction(x / np.pi).limit_denominator(12)
    if fraction == 0 or abs(float(fraction) * np.pi - x) > 1e-9:
        return number(x)
    factor = {1: "", -1: "-"}.get(fraction.numerator, str(fraction.numerator))
    return f"{factor}\\pi" + (f"/{fraction.denominator}" if fraction.denominator > 1 else "")


def linkage_table(mechanism: Mechanism, q: Array) -> str:
    """Count the bodies, joints, loops and degrees of freedom of a linkage."""
    mobility = mechanism.mobility(q)
    counts = {
        "bodies, including the ground": len(mechanism.bodies),
        "joints": len(mechanism.joints),
        "joint values": mechanism.n,
        "loops": len(mechanism.loops),
        "degrees of freedom by the Grübler-Kutzbach formula": mobility.kutzbach,
        "infinitesimal (first-order) mobility in this configuration": mobility.infinitesimal,
        "finite mobility": mobility.finite,
    }
    return f"## Mobility\n\n{table(['what', 'how many'], [(what, str(count)) for what, count in counts.items()])}"


def raw_html(html: str) -> str:
    """Put HTML into a page without change."""
    return f"````{{raw}} html\n{html}\n````"
