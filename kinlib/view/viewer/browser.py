"""Show an arm or a picture with one call: in a notebook, or, from a script, in the web browser."""

import sys
import webbrowser
from os import PathLike
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

from numpy.typing import ArrayLike

from kinlib.arrays.validation import describe
from kinlib.chains.chain import Chain
from kinlib.view.drawing.picture import Gallery, Picture
from kinlib.view.viewer.viewer import ViewerBase, explore


def show(
    shown: Chain | Picture | Gallery | ViewerBase, q: ArrayLike | None = None, *, path: str | PathLike[str] = ""
) -> None:
    """Show an arm in three dimensions with sliders, or anything that this package draws.

    In a notebook it is displayed below the cell. Elsewhere it is saved as a page in a temporary folder, which the web browser
    opens; where there is no browser, the name of the file is printed.

    shown  a chain, or what a function of kinlib.view returns
    q      (n,) the joint values of a chain, home by default
    path   the file to save to, .html or .svg, instead of showing it

    Raises ValueError if q does not have n values or is given without a chain, for anything else to show, and for another ending.

    >>> from kinlib.chains.robots import youbot
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     show(youbot(), [0, 0, 1, 0, 0], path=f"{folder}/youbot.html")
    ...     Path(folder, "youbot.html").read_text("utf-8")[:15]
    '<!DOCTYPE html>'
    """
    if isinstance(shown, Chain):
        shown = explore(shown, start=q)
    elif q is not None:
        raise ValueError(
            f"q must be given with a chain only; got it with a {type(shown).__name__}, which has been drawn already."
        )
    if not isinstance(shown, Picture | Gallery | ViewerBase):
        raise ValueError(
            f"show takes a Chain, or what a function of kinlib.view returns; got {describe(shown)}. "
            "Of a DHTable, show table.to_chain(); of a Mechanism, kinlib.view.draw_linkage(mechanism, q)."
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
