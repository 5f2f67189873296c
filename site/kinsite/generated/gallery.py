"""The gallery: each robot and linkage of the course as an interactive figure, with axes, screws, DH tables and source."""

import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kincourse.text.joint_table import joint_table
from kinlib import linkages, robots
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.view import drive, explore
from kinlib.view.drawing.figure_colours import follow_theme
from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.svg import GREEK
from kinlib.view.figures.arm import draw_arm
from kinlib.view.figures.bodies import body_of
from kinlib.view.figures.linkage import draw_linkage
from kinsite.markdown import escape, prose

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
    "slider_crank": [1, -1.5, 0.5, 0.5],
    "bennett": [-1.94, 2.2, 1.94, -2.2],
    "ten_links": [1.9, -0.5, -0.4, -0.4, -0.3, 1.2, 0.5, 0.4, 0.4, 0.3, 0],
}
"""The guesses from which linkages are assembled that do not close at 0, or that look flat there."""

LEADING = ("youbot", "puma560", "ur5e", "panda", "scara")
"""What the gallery begins with: arms that readers know."""


@dataclass(frozen=True, eq=False)
class Entry:
    """One page of the gallery: the name of the function, the robot that it makes, its docstring, where it is drawn, the drawing."""

    function: str
    robot: Chain | Mechanism
    docstring: str
    q: Array
    picture: Picture


def pages() -> Iterator[tuple[str, str]]:
    """Yield one page and one picture for each robot and linkage, and an overview."""
    # the functions arm and pose make no robot of the course
    arms = [entry(name, make) for name, make in public_functions(robots) if name not in ("arm", "pose")]
    mechanisms = [entry(name, make) for name, make in public_functions(linkages)]
    for one in arms + mechanisms:
        yield f"robots/{one.function}.svg", follow_theme(one.picture.svg)
        yield f"robots/{one.function}.md", page(one)
    yield "robots/index.md", overview(arms, mechanisms)


def public_functions(module: Any) -> list[tuple[str, Callable[..., Any]]]:
    """List the public functions of a module, in the order of the file."""
    functions = inspect.getmembers(module, inspect.isfunction)
    own = [(name, make) for name, make in functions if make.__module__ == module.__name__ and not name.startswith("_")]
    return sorted(own, key=lambda pair: pair[1].__code__.co_firstlineno)


def entry(name: str, make: Callable[..., Chain | Mechanism]) -> Entry:
    """Make the entry of a robot, which must have a source; an arm is drawn where its shape is seen, a linkage where it closes."""
    robot = make(**LENGTHS.get(name, {}))
    if not robot.source.strip():
        raise ValueError(f"{name} must have a source; got none. Name the document that it comes from.")
    if isinstance(robot, Chain):
        q = body_of(robot).pose
        return Entry(name, robot, inspect.getdoc(make) or "", q, draw_arm(robot, q, show={"tool"}))
    found = robot.assemble(START_CONFIGURATIONS.get(name, np.zeros(robot.n)))
    if not found.converged:
        raise ValueError(f"{name} must close from its guess in START_CONFIGURATIONS. Try another guess.")
    return Entry(name, robot, inspect.getdoc(make) or "", found.q, draw_linkage(robot, found.q))


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
    items = []
    for one in entries:
        robot = one.robot
        joints = f"{robot.n} joints, {robot.joint_types}" if isinstance(robot, Chain) else f"{len(robot.joints)} joints"
        picture = f"![{escape(one.picture.alt)}]({one.function}.svg)"
        items.append(f"- [{picture} **{escape(robot.name)}** {joints}]({one.function}.md)")
    return f"{{.cards{f' .{size}' if size else ''}}}\n" + "\n".join(items)


def page(entry: Entry) -> str:
    """Write the page of one robot: the figure, the source and the tables."""
    # the reference says what the function raises, and the source follows below
    paragraphs = [text for text in entry.docstring.split("\n\n") if not text.startswith(("Raises", "Source:"))]
    text = re.sub(rf"\b({'|'.join(GREEK)})\b", lambda found: GREEK[found[0]], "\n\n".join(paragraphs))
    module = robots if isinstance(entry.robot, Chain) else linkages
    short = module.__name__.rpartition(".")[2]
    function = f"{{py:func}}`kl.{short}.{entry.function} <{module.__name__}.{entry.function}>`"
    source = f"**Source.** {escape(entry.robot.source)}. In Python it is {function}."
    tables = arm_tables(entry.robot) if isinstance(entry.robot, Chain) else linkage_tables(entry.robot, entry.q)
    return "\n\n".join([f"# {escape(entry.robot.name)}", prose(text), raw_html(figure(entry)), source, tables]) + "\n"


def figure(entry: Entry) -> str:
    """Show a robot in the viewer or, if a linkage has more than one degree of freedom, as a drawing."""
    if isinstance(entry.robot, Chain):
        return explore(entry.robot, start=entry.q).html()
    if entry.robot.mobility(entry.q).finite == 1:
        curve = entry.robot.trace(entry.q, points=160).q
        return drive(entry.robot, entry.q, curves=[curve], labels=["as it is assembled"]).html()
    return entry.picture.html()


def arm_tables(chain: Chain) -> str:
    """Write the axes, the screws and both DH tables of an arm, these as a notebook shows them."""
    parts = ["## Axes at home", joint_table(chain), "## Screw axes", shown(chain)]
    if "H" in chain.joint_types:
        note = "A helical joint has no row in a DH table, because a row cannot couple a rotation with a translation."
        return "\n\n".join([*parts, "## DH tables", note])
    for convention in ("standard", "modified"):
        parts += [f"## A {convention} DH table", shown(assign_frames(chain, convention=convention))]
    return "\n\n".join([*parts, "These are the tables that `kl.assign_frames` finds. Other tables can be right, too."])


def linkage_tables(mechanism: Mechanism, q: Array) -> str:
    """Write the joints of a linkage, and count its degrees of freedom."""
    found = mechanism.mobility(q)
    counts = (
        f"It has {mechanism.n} joint values. Degrees of freedom by the Grübler-Kutzbach formula: {found.kutzbach}; "
        f"infinitesimal (first-order) mobility in this configuration: {found.infinitesimal}; finite mobility: {found.finite}."
    )
    return "\n\n".join(["## Joints", shown(mechanism), "## Mobility", counts])


def shown(value: Any) -> str:
    """Write a value as a notebook shows it, as a table of this site."""
    return raw_html(value._repr_html_().replace("<table>", '<table class="docutils">'))


def raw_html(html: str) -> str:
    """Put HTML into a page without change."""
    return f"````{{raw}} html\n{html}\n````"
