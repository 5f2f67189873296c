"""A planar arm to move by hand: sine and cosine, sums of angles, and rotations about fixed points, in one picture.

planar_arm.js moves it in a notebook and on a page of the site; Python gives the scene, keeps what was done, and draws a still
picture for print and for pages without a script. `kinlib` does not know this arm: it belongs to the course.
"""

from itertools import accumulate, pairwise
from pathlib import Path
from typing import Any

import anywidget
import numpy as np
import traitlets

from kinlib.arrays.validation import Array
from kinlib.view.drawing.picture import Picture
from kinlib.view.viewer.widget import as_script

HERE = Path(__file__).parent
LINK_COLOURS = ("#1666b0", "#b94a00", "#0b7a5b")
SCENES: dict[str, tuple[tuple[float, ...], tuple[float, ...], tuple[float, ...]]] = {
    # name: lengths, joint values at the start, joint values of the goal, in degrees
    "drag": ((3, 2), (100, -70), ()),
    "terms": ((3, 2), (50, 40), ()),
    "reference": ((3, 2, 1), (60, 40, -75), ()),
    "pins": ((3, 2, 1), (0, 0, 0), (50, 40, 60)),
    "space": ((1.8, 2.4, 1.8), (90, -90, 0), (65, -50, 80)),  # seen from the side, at home
    "wall": ((3, 2, 1), (120, -80, -70), ()),
}
"""What the reader may do: drag, see the terms, answer and see the ghost, rotate about pins or axes, write on a wall."""


class PlanarArm(anywidget.AnyWidget):
    """A planar arm in one of SCENES: q are its joint values in degrees, done is what the reader has tried.

    Raises ValueError for an unknown scene.

    >>> arm = PlanarArm("pins")
    >>> arm.alt
    'A planar arm of 3 links, with its base at the origin, at 0, 0, 0 degrees. Its tool is at (6.00, 0.00).'
    >>> arm.html()[:41]
    '<div data-planar-arm><script type="applic'
    >>> PlanarArm("pin")
    Traceback (most recent call last):
    ValueError: scene must be drag, terms, reference, pins, space or wall; got 'pin'.
    """

    _esm = (HERE / "planar_arm.js").read_text("utf-8") + "\nexport default planarArm.widget;"
    _css = (HERE / "planar_arm.css").read_text("utf-8")

    scene = traitlets.Unicode().tag(sync=True)
    lengths = traitlets.List(traitlets.Float()).tag(sync=True)
    goal = traitlets.List(traitlets.Float()).tag(sync=True)
    q = traitlets.List(traitlets.Float()).tag(sync=True)
    done = traitlets.List(traitlets.Unicode()).tag(sync=True)

    def __init__(self, scene: str) -> None:
        if scene not in SCENES:
            *names, last = SCENES
            raise ValueError(f"scene must be {', '.join(names)} or {last}; got {scene!r}.")
        lengths, q, goal = SCENES[scene]
        super().__init__(scene=scene, lengths=[*lengths], q=[*q], goal=[*goal])

    @property
    def alt(self) -> str:
        """The text alternative of the still picture."""
        x, y = joints(self.q, self.lengths)[-1]
        if self.scene == "space":
            return (
                "A spatial arm at home, seen from the side: axis 1 is vertical, axes 2 and 3 are perpendicular to the picture. "
                f"Its tool is {x:.1f} in front of axis 1, at the height {y:.1f}."
            )
        values = ", ".join(f"{q:g}" for q in self.q)
        return (
            f"A planar arm of {len(self.q)} links, with its base at the origin, at {values} degrees. "
            f"Its tool is at ({x:.2f}, {y:.2f})."
        )

    def picture(self) -> Picture:
        """Draw the arm as it is now."""
        points = joints(self.q, self.lengths) * (40, -40)
        left, top = points.min(axis=0) - 50
        width, height = np.ptp(points, axis=0) + 100
        parts = [f'<path d="M{left} 0H{left + width}M0 {top}V{top + height}" stroke="#9aa1b3" fill="none"/>']
        for i, (a, b) in enumerate(pairwise(points)):
            ends = f'x1="{a[0]:.1f}" y1="{a[1]:.1f}" x2="{b[0]:.1f}" y2="{b[1]:.1f}"'
            parts.append(f'<line {ends} stroke="{LINK_COLOURS[i]}" stroke-width="14" stroke-linecap="round"/>')
            x, y = (a + b) / 2
            parts.append(f'<text x="{x:.1f}" y="{y + 5:.1f}" text-anchor="middle" fill="#fff">{i + 1}</text>')
        box = f'viewBox="{left:.1f} {top:.1f} {width:.1f} {height:.1f}" width="{width:.0f}" height="{height:.0f}"'
        style = 'font-family="sans-serif" font-size="14" font-weight="bold"'
        return Picture(f'<svg xmlns="http://www.w3.org/2000/svg" {box} {style}>{"".join(parts)}</svg>', self.alt)

    def html(self) -> str:
        """Return the arm for a page without a kernel: its state as JSON, and the still picture."""
        state = {name: getattr(self, name) for name in ("scene", "lengths", "goal", "q", "done")}
        return f"<div data-planar-arm>{as_script(state)}{self.picture().html()}</div>"

    def _repr_mimebundle_(self, **options: Any) -> Any:
        data, metadata = super()._repr_mimebundle_(**options) or ({}, {})
        return {**data, "text/plain": self.alt, "text/html": self.html()}, metadata


def joints(q: list[float], lengths: list[float]) -> Array:
    """Compute the base, the joints and the tool of a planar arm: x = l_1 cos q_1 + l_2 cos(q_1 + q_2) + ...

    Joint values in degrees -> (n + 1, 2), in the unit of the lengths.

    >>> joints([90, -90], [3, 2]).round(6) + 0.0
    array([[0., 0.],
           [0., 3.],
           [2., 3.]])
    """
    headings = np.radians([*accumulate(q)])
    steps = np.array(lengths)[:, None] * np.stack([np.cos(headings), np.sin(headings)], axis=-1)
    return np.concatenate([[[0.0, 0.0]], np.cumsum(steps, axis=0)])
