"""The player of steps: a list of stops that the reader goes through, forwards and back, in three dimensions.

A stop is {"texts", "alt", "parts", ...}: what it says, and what is drawn there (figures.parts). Where stops have joint values "q",
the page interpolates between them; where they have "poses", the frames jump. All stops are sent at once, so the page needs no Python.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import traitlets

from kinlib.view.viewer.viewer import ViewerBase

Stop = dict[str, Any]


class Steps(ViewerBase):
    """Stops on the page. Make one with `play_row`, `play_walk`, `play_assignment`, `slide_frames` or `drive`.

    at       the stop that is shown, from 0; a fraction is the share of the way to the next one
    variant  which of several lists of stops is shown, such as a convention

    The mode has "variants", {name: {"stops": [stop, ...], ...}}, with as many stops each, and what all stops share: "kind",
    "name" of a stop, "pace" in milliseconds from one to the next, and further data of its player.
    """

    at = traitlets.Float(0.0).tag(sync=True)
    variant = traitlets.Unicode("").tag(sync=True)
    set_by_reader = ("at", "variant")

    def __init__(self, scene: dict[str, Any], mode: Mapping[str, Any], *, variant: str = "", **settings: Any) -> None:
        mode = {"kind": "steps", "pace": 0, **mode}
        self._variants: dict[str, Any] = mode["variants"]
        variant = variant or next(iter(self._variants))
        start = self._variants[variant]["stops"][0].get("q", [0.0])
        super().__init__(scene, settings.pop("start", start), mode=mode, variant=variant, **settings)

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
        return f"{'On the way to the next stop. ' if passed else ''}{self.stop['alt']}"

    @traitlets.validate("at", "variant")
    def _validate_stop(self, proposal: Any) -> Any:
        name, value = proposal["trait"].name, proposal["value"]
        last = max(len(variant["stops"]) for variant in self._variants.values()) - 1
        if name == "variant" and value not in self._variants:
            raise ValueError(f"variant must be one of {', '.join(self._variants)}; got {value!r}.")
        if name == "at" and not 0 <= value <= last:
            raise ValueError(f"at must be the number of a stop, 0 to {last}; got {value!r}.")
        return value


def motion_scene(
    name: str, arms: list[dict[str, Any]], room: dict[str, Any], floor: float, size: float
) -> dict[str, Any]:
    """Return a scene of frames that move: for each an arm, whose tool it is, with the joints that move it."""
    return {"name": name, "size": size, "arms": arms, "room": room, "floor": floor, "offered": []}


def frame_arm(T: Any, screws: Sequence[Any] = ()) -> dict[str, Any]:
    """Return a frame that starts at the pose T and is moved by screws (n, 6), as an arm without links.

    >>> frame_arm(np.eye(4))["joints"]
    []
    """
    joints = [{"screw": np.asarray(screw).tolist(), "point": [0.0, 0.0, 0.0]} for screw in screws]
    return {"columns": list(range(len(joints))), "joints": joints, "home": (np.asarray(T) + 0.0).ravel().tolist()}
