"""Show an arm or a picture with one call: in a notebook, or, from a script, in the web browser."""

from __future__ import annotations

import sys
import webbrowser
from os import PathLike
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

from kinlib.arrays.validation import JointValues, describe
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment
from kinlib.dh.table import DHTable, table_frames
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.urdf.robot_tree import Tree
from kinlib.view.drawing.picture import Gallery, Picture
from kinlib.view.figures.bodies import body_of
from kinlib.view.figures.linkage import draw_linkage
from kinlib.view.viewer.meshes import Packages
from kinlib.view.viewer.viewer import Viewer, explore


def show(
    shown: Chain | DHTable | FrameAssignment | Tree | Mechanism | Picture | Gallery | Viewer,
    q: JointValues | None = None,
    *,
    path: str | PathLike[str] = "",
    packages: Packages = (),
) -> None:
    """Show a robot in three dimensions with sliders, a closed chain as a drawing, or anything that this package draws.

    In a notebook it is displayed below the cell. Elsewhere the web browser opens it as a page in a temporary folder.

    shown  a chain, a table or a frame assignment, which are drawn with their frames, a tree, a closed chain, or what a function of
           kinlib.view returns
    q      (n,) joint values, or a mapping from joint names to values; by default some that show the shape of an arm, and
            some within the limits of a tree. A closed chain needs them
    path   the file to save to instead of showing it: .html, or a drawing as .svg or .png
    packages  a folder or folders of packages, or {name: folder}, in which the meshes of a tree are looked for, see `kinlib.view.explore`

    Raises ValueError if q does not have n values or is given without a robot, for anything else to show, for another ending, and
    for a folder that does not exist.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     show(kl.robots.youbot(), [0, 0, 1, 0, 0], path=f"{folder}/youbot.html")
    ...     Path(folder, "youbot.html").read_text("utf-8")[:15]
    '<!DOCTYPE html>'
    """
    if isinstance(shown, DHTable | FrameAssignment):
        table = shown if isinstance(shown, DHTable) else shown.table
        chain = table.to_chain()
        start = chain.in_order(body_of(chain).pose if q is None else q)
        frames = table_frames(table, start)
        shown = explore(chain, start=start, frames=frames, show=["axes", *(f"frame {name}" for name in frames)])
    elif isinstance(shown, Chain):
        shown = explore(shown, start=body_of(shown).pose if q is None else q)
    elif isinstance(shown, Tree):
        shown = explore(shown, start=q, packages=packages)
    elif isinstance(shown, Mechanism):
        if q is None:
            raise ValueError(
                f"q must be given with a closed chain, the values of {', '.join(shown.names)}, because at 0 its loops need not "
                "close. Pass one of its assembly_modes(hold={...}), or .q of what assemble returns."
            )
        shown = draw_linkage(shown, q)
    elif q is not None:
        raise ValueError(
            f"q must be given with a robot only; got it with a {type(shown).__name__}, which has been drawn already."
        )
    if not isinstance(shown, Picture | Gallery | Viewer):
        raise ValueError(
            f"show takes a Chain, DHTable, FrameAssignment, Tree or Mechanism, or what a function of kinlib.view returns; got "
            f"{describe(shown)}."
        )
    if path:
        shown.save(path)
    elif _is_notebook():
        from IPython.display import display

        display(shown)
    else:
        page = Path(mkdtemp(prefix="kinlib-")) / "shown.html"
        shown.save(page)
        if not webbrowser.open(page.as_uri()):
            print(f"No web browser was found. Open this file in one: {page}")


def _is_notebook() -> bool:
    """Whether this runs in a kernel, which displays HTML, and not in a script or a terminal."""
    shell: Any = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return shell is not None and type(shell).__name__ != "TerminalInteractiveShell"
