"""The player of steps: a list of stops that the reader goes through, forwards and back, in three dimensions.

A stop is {"text", "alt", "parts", ...}: what it says, and what is drawn there (figures.parts). Where stops have joint values "q",
the page interpolates between them; where they have a "pose" and a "motion", a frame moves by it about and along its own x or z to
the next stop. All stops are sent at once, so the page needs no Python.
"""

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import traitlets
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import frame_text
from kinlib.view.figures.parts import draw_parts_about, frame_part, line_part, tips
from kinlib.view.viewer.pictures import value_text
from kinlib.view.viewer.scene import room, scene_of_parts
from kinlib.view.viewer.viewer import Viewer

Stop = dict[str, Any]

AXIS_SHARE, SMALLEST_M = 0.3, 0.3
"""The length of the axes as a share of the extent of the origins, and the least extent, if the frames share an origin."""


class Steps(Viewer):
    """Stops on the page. Make one with `play_row`, `play_assignment`, `slide_frames` or `drive`.

    at       the stop that is shown, from 0; a fraction is the share of the way to the next one
    variant  which of several lists of stops is shown, such as a convention
    q        the joint values of that stop, if it has some

    The mode has "variants", {name: {"stops": [stop, ...], ...}}, with as many stops each, and what all stops share: "kind",
    "name" of a stop, "pace" in milliseconds from one to the next, and further data of its player. `draw` makes the picture of the
    stop that is shown; it also has the text alternative of a stop that has none.
    """

    at = traitlets.Float(0.0).tag(sync=True)
    variant = traitlets.Unicode("").tag(sync=True)
    set_by_reader = ("at", "variant")

    def __init__(
        self,
        scene: dict[str, Any],
        mode: Mapping[str, Any],
        draw: Callable[["Steps"], Picture],
        *,
        variant: str = "",
        **settings: Any,
    ) -> None:
        mode = {"kind": "steps", "pace": 0, **mode}
        self._variants: dict[str, Any] = mode["variants"]
        variant = variant or next(iter(self._variants))
        start = self._variants[variant]["stops"][0].get("q", [0.0])
        super().__init__(scene, draw, settings.pop("start", start), mode=mode, variant=variant, **settings)
        self.observe(self._follow, ["at", "variant"])
        self._follow(None)

    def _follow(self, _: Any) -> None:
        self.q = self.stop.get("q", self.q)

    @property
    def stops(self) -> list[Stop]:
        """The stops of the variant that is shown."""
        stops: list[Stop] = self._variants[self.variant]["stops"]
        return stops

    @property
    def stop(self) -> Stop:
        """The stop that is shown, or the last one that was passed."""
        return self.stops[max(0, min(int(self.at + 1e-9), len(self.stops) - 1))]

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        passed = self.at > int(self.at + 1e-9) + 1e-9
        said: str = self.stop["alt"] if "alt" in self.stop else self.picture().alt
        return f"{'On the way to the next stop. ' if passed else ''}{said}"


def slide_frames(
    frames_at: Callable[[Any], Mapping[str, ArrayLike]],
    label: str,
    values: Sequence[Any],
    *,
    caption: Callable[[Any], str] = lambda _: "",
    arrows: bool = False,
    after: Any = None,
) -> Steps:
    """Show frames in three dimensions, with one slider that moves them.

    frames_at  a function from a value to {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame; always the same names
    label      what the values are
    values     the values of the slider, in order
    caption    a function from a value to the caption
    arrows     whether an arrow leads from the origin of each frame to that of the next
    after      a question; the picture stays covered until a prediction is committed

    Raises ValueError if there are no values, or if a frame is not a pose.

    >>> from kinlib.rigid.lie import homogeneous
    >>> shown = slide_frames(lambda x: {"s": np.eye(4), "b": homogeneous(np.eye(3), (x, 0, 0))}, "x (m)", [0.0, 0.5, 1.0])
    >>> shown.at = 1
    >>> shown.alt[-58:]
    'Frame {b} at (0.5, 0, 0), x along x, y along y, z along z.'
    """
    if len(values) == 0:
        raise ValueError("values must contain at least one value; got none.")
    frames = [frames_at(value) for value in values]
    names = list(frames[0])
    poses = np.array([[validation.poses(T, f"frame {name}") for name, T in one.items()] for one in frames]) + 0.0
    origins = poses[..., :3, 3].reshape(-1, 3)
    length = AXIS_SHARE * max(float(np.ptp(origins, axis=0).max()), SMALLEST_M)
    points = np.concatenate([origins, tips(poses, length)])
    size = room(points, 0.0)["radius"]
    stops = []
    for value, shown in zip(values, poses, strict=True):
        said, ends = caption(value), pairwise(shown[:, :3, 3] if arrows else [])
        lines = [line_part(a, b, "quiet", tip=True) for a, b in ends if np.linalg.norm(b - a) > 1e-6 * size]
        told, named = [said], zip(names, shown, strict=True)
        for name, T in named:
            lines.append(frame_part(T, "Oxyz", sub=name if len(name) < 3 else "", name=name, length=length / size))
            told.append(frame_text((name, T)))
        stops.append({"title": value_text(value), "text": said, "alt": " ".join(told).strip(), "parts": lines})

    def draw(player: Steps) -> Picture:
        return draw_parts_about(points, player.stop["parts"], size, player.alt, player.stop["text"])

    mode = {"variants": {"": {"stops": stops}}, "label": label}
    return Steps(scene_of_parts("frames", points, size), mode, draw, after=after)
