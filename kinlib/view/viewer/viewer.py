"""The 3-D viewer: an arm that turns in the page, in JupyterLab, in the browser lab and on a page without a kernel.

Python says what the arm is, once, as data (kinlib.view.viewer.scene). The page moves it by its screws and reads the pose off the
scene graph, so a slider answers without asking Python. Both sides share the traits below; whoever sets one, both follow.
"""

import html
import json
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

import anywidget
import numpy as np
import traitlets
from numpy.typing import ArrayLike

from kinlib.chains.chain import Chain
from kinlib.view.figures.arm import ARM_LAYERS, describe_arm, draw_arm
from kinlib.view.viewer.scene import LAYERS, scene

STATIC = Path(__file__).parents[1] / "static"
"""The bundle viewer.js, made from src by `npm run build`, and loader.js, which fetches it where a page holds a viewer."""


class Values(traitlets.List[float]):
    """Joint values, as anything that NumPy reads as numbers."""

    def validate(self, obj: Any, value: Any) -> list[float] | None:
        return super().validate(obj, np.asarray(value, dtype=float).tolist())


class ViewerBase(anywidget.AnyWidget):
    """What every viewer shares with the page: the traits below, and a form for pages without a kernel.

    q           (n,) joint values; the page and Python both set them
    start       (n,) where "Reset" goes
    ghost       (n,) another configuration in grey, or empty
    shown       which layers are drawn, any of kinlib.view.viewer.scene.LAYERS
    covered     whether the picture waits for a prediction
    prediction  {"text", "options"}: the question on the cover; empty where a question stands elsewhere
    choice      the option committed to on the cover, counted from 0; -1 before
    message     a line below the picture, for what Python has to say
    mode        {"kind", ...}: what a player of src/modes is given; empty for an arm with sliders

    >>> from traitlets import Bool, HasTraits
    >>> class Question(HasTraits):
    ...     committed = Bool(False)
    >>> from kinlib.chains.robots import rpr
    >>> arm = explore(rpr())
    >>> arm.html()[:25]
    '<div data-kinlib-viewer><'
    >>> arm.wait_for(question := Question())
    >>> question.committed = True
    >>> arm.covered
    False
    """

    # The bundle names one object, so that a page without modules can run it too; a module exports what it holds.
    _esm = (STATIC / "viewer.js").read_text("utf-8") + "\nexport default kinlib.widget;"

    scene = traitlets.Dict().tag(sync=True)
    q = Values(traitlets.Float()).tag(sync=True)
    start = Values(traitlets.Float()).tag(sync=True)
    ghost = Values(traitlets.Float()).tag(sync=True)
    shown = traitlets.List(traitlets.Unicode()).tag(sync=True)
    covered = traitlets.Bool(False).tag(sync=True)
    prediction = traitlets.Dict().tag(sync=True)
    choice = traitlets.Int(-1).tag(sync=True)
    message = traitlets.Unicode("").tag(sync=True)
    readout = traitlets.Bool(True).tag(sync=True)
    mode = traitlets.Dict().tag(sync=True)

    @traitlets.validate("q", "start", "ghost")
    def _fits(self, proposal: Any) -> list[float]:
        values: list[float] = proposal["value"]
        if values or proposal["trait"].name != "ghost":
            self._check(values)
        return values

    @traitlets.validate("shown")
    def _known(self, proposal: Any) -> list[str]:
        names: list[str] = proposal["value"]
        if unknown := set(names) - set(LAYERS):
            raise ValueError(f"show knows {', '.join(LAYERS)}; got {', '.join(map(repr, sorted(unknown)))}.")
        return names

    @property
    def alt(self) -> str:
        """What the picture shows, in words."""
        raise NotImplementedError

    _after = ""  # the name of the question that the picture waits for; a page has questions too

    def wait_for(self, question: Any) -> None:
        """Stay covered until a question is committed; None covers nothing."""
        if question is not None and not question.committed:
            self.covered = True
            self._after = getattr(question, "name", "")
            question.observe(lambda _: self.set_trait("covered", False), "committed")

    def _check(self, values: list[float]) -> None:
        """Refuse joint values of another size and NaN, in words."""
        raise NotImplementedError

    def _drawing(self) -> str:
        """What stands on the page, as HTML, before it wakes, and on paper."""
        raise NotImplementedError

    def html(self) -> str:
        """The viewer for a page without a kernel: its state as JSON, and a drawing until loader.js wakes it."""
        # What anywidget and ipywidgets synchronise for themselves is of no use to a page.
        own = set(self.trait_names(sync=True)) - set(anywidget.AnyWidget.class_trait_names(sync=True))
        state = self.get_state(sorted(name for name in own if not name.startswith("_")))
        # A "<" might end the script or begin another; in JSON it may be written so.
        data = json.dumps(state, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
        covered = f"<p>{html.escape(self.prediction.get('text', 'The picture waits for your prediction.'))}</p>"
        after = f' data-kinlib-after="{html.escape(self._after)}"' if self._after else ""
        return (
            f'<div data-kinlib-viewer{after}><script type="application/json">{data}</script>'
            f"<div data-kinlib-drawing>{covered if self.covered else self._drawing()}</div></div>"
        )

    def _repr_mimebundle_(self, **options: Any) -> Any:
        data, metadata = super()._repr_mimebundle_(**options) or ({}, {})
        return {**data, "text/plain": self.alt, "text/html": self.html()}, metadata


class Viewer(ViewerBase):
    """An arm on the page. Make one with `explore`."""

    def __init__(self, chain: Chain, **traits: Any) -> None:
        self.chain = chain
        super().__init__(**traits)

    @property
    def alt(self) -> str:
        """What the picture shows, in words."""
        return describe_arm(self.chain, np.array(self.q))

    def _check(self, values: list[float]) -> None:
        self.chain.fk(values)

    def _drawing(self) -> str:
        drawn = [name for name in self.shown if name in ARM_LAYERS]
        return draw_arm(self.chain, self.q, show=drawn, ghost=self.ghost or None).html()


def explore(
    chain: Chain,
    joints: Sequence[int] | None = None,
    *,
    show: Collection[str] = ("axes", "base", "tool"),
    after: Any = None,
    start: ArrayLike | None = None,
    span: tuple[float, float] | None = None,
    ghost: ArrayLike | None = None,
    readout: bool = True,
    predict: tuple[str, Sequence[str]] | None = None,
) -> Viewer:
    """Turn the joints of an arm in three dimensions, and read where its tool is.

    joints   which ones get a slider, counted from 1; all by default, but name the one that matters
    show     what is drawn at first, any of kinlib.view.viewer.scene.LAYERS; the reader may switch
    after    a question; the arm stays covered until it is committed
    start    (n,) joint values to begin with, home by default; afterwards `q` follows the page and leads it
    span     from where to where the sliders go, in radians or metres; by default the limits of the joints
    ghost    (n,) another configuration, in grey
    readout  whether the tool's pose stands beside the picture
    predict  a question (text, options) on the cover itself; `choice` is what was committed to

    Raises ValueError for a joint that the arm does not have, values of another size, NaN, a span that does not hold the
    start, and a layer that there is not.

    >>> from kinlib.chains.robots import youbot
    >>> arm = explore(youbot(), joints=[3])
    >>> arm.q = [0, 0, np.pi / 2, 0, 0]
    >>> arm.alt[-35:]
    'The tool is at (0.188, 0, 0.499) m.'
    """
    home = np.zeros(chain.n) if start is None else np.array(start, dtype=float)
    shade = None if ghost is None else np.array(ghost, dtype=float)
    text, options = predict or ("", ())
    made = Viewer(
        chain,
        scene=scene(chain, home, joints=joints, span=span, ghost=shade),
        q=home,
        start=home,
        ghost=[] if shade is None else shade,
        shown=list(show),
        readout=readout,
        covered=bool(text),
        prediction={"text": text, "options": list(options)} if text else {},
    )
    made.wait_for(after)
    return made
