"""The player of steps: a list of stops that the reader goes through, forwards and back, in three dimensions.

A stop is {"texts", "alt", "parts", ...}: what it says, and what is drawn there (figures.parts). Where stops have joint values "q",
the page interpolates between them; where they have "poses", the frames jump. All stops are sent at once, so the page needs no Python.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import traitlets

from kinlib.arrays.validation import Array
from kinlib.view.drawing.picture import Picture
from kinlib.view.viewer.viewer import ViewerBase

Stop = dict[str, Any]


class Steps(ViewerBase):
    """Stops on the page. Make one with `play_row`, `play_walk`, `play_assignment`, `slide_frames` or `drive`.

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
        self._draw = draw
        variant = variant or next(iter(self._variants))
        start = self._variants[variant]["stops"][0].get("q", [0.0])
        super().__init__(scene, settings.pop("start", start), mode=mode, variant=variant, **settings)
        self.observe(self._follow, ["at", "variant"])
        self._follow(None)

    def _follow(self, _: Any) -> None:
        self.q = self.stop.get("q", self.q)

    def picture(self) -> Picture:
        """Draw the stop that is shown."""
        return self._draw(self)

    @property
    def stops(self) -> list[Stop]:
        """The stops of the variant that is shown."""
        stops: list[Stop] = self._variants[self.variant]["stops"]
        return stops

    @property
    def stop(self) -> Stop:
        """The stop that is shown, or the last one that was passed."""
        return self.stops[min(int(self.at + 1e-9), len(self.stops) - 1)]

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        passed = self.at > int(self.at + 1e-9) + 1e-9
        said: str = self.stop["alt"] if "alt" in self.stop else self.picture().alt
        return f"{'On the way to the next stop. ' if passed else ''}{said}"

    @traitlets.validate("at", "variant")
    def _validate_stop(self, proposal: Any) -> Any:
        name, value = proposal["trait"].name, proposal["value"]
        last = max(len(variant["stops"]) for variant in self._variants.values()) - 1
        if name == "variant" and value not in self._variants:
            raise ValueError(f"variant must be one of {', '.join(self._variants)}; got {value!r}.")
        if name == "at" and not 0 <= value <= last:
            raise ValueError(f"at must be the number of a stop, 0 to {last}; got {value!r}.")
        return value


def frame_arm(T: Array, screws: Sequence[Array] | Array = (), first: int = 0) -> dict[str, Any]:
    """Return a frame at T that screws (n, 6) move, as an arm without links, whose first joint value is in the column `first` of q."""
    joints = [{"screw": np.asarray(screw).tolist(), "point": [0.0, 0.0, 0.0]} for screw in screws]
    columns = [first + i for i in range(len(joints))]
    return {"columns": columns, "joints": joints, "home": (np.asarray(T) + 0.0).ravel().tolist()}
