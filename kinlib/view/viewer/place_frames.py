"""Frames placed by hand: only the joint axes of an arm are drawn, and the reader chooses z, origin and x of each frame.

The page keeps the frames in a trait, so placing them also works without a kernel. Checking them by the rules needs Python.
"""

from typing import Any

import numpy as np
import traitlets

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment
from kinlib.dh.rules import Breach, check_frames
from kinlib.dh.table import Convention, DHTable, validate_convention
from kinlib.rigid.lie import inverse
from kinlib.view.figures.arm import describe_arm, draw_joints, frame_text
from kinlib.view.viewer.dh_players import table_cells
from kinlib.view.viewer.frame_candidates import frame_candidates
from kinlib.view.viewer.scene import bare_scene
from kinlib.view.viewer.viewer import Viewer

TWO_FRAME_RULES = {"x perpendicular to z", "x meets z"}
"""The rules about two consecutive frames; all others are about one frame."""


class ByHand(Viewer):
    """Frames that are placed on the page. Make one with `assign`.

    frames   (n + 1, 4, 4) frames 0 to n in {s} at home; NaN for what is not placed yet. The page and Python can both set it
    asked    how often the reader has asked for a check
    verdict  the result of the last check, for the page
    """

    frames = traitlets.Any().tag(
        sync=True, to_json=lambda frames, _: np.where(np.isnan(frames), np.array(None), frames).tolist()
    )
    asked = traitlets.Int(0).tag(sync=True)
    verdict = traitlets.Dict().tag(sync=True)
    set_by_reader = ("frames",)

    def __init__(self, chain: Chain, convention: Convention, frames: Array) -> None:
        features = frame_candidates(chain)
        ends = np.array([line[end] for line in features["axes"] for end in ("from", "to")])
        scene = bare_scene(chain, ends)
        self.convention, self.chain = convention, chain
        super().__init__(
            {**scene, "offered": ["base", "tool"]},
            lambda _: draw_joints(chain),  # without the frames
            np.zeros(chain.n),
            robot=chain,
            shown=["base", "tool"],
            mode={"kind": "assign", "convention": convention, **features},
            frames=frames,
        )
        self.observe(self._judge, "asked")

    @property
    def breaches(self) -> list[Breach]:
        """The rules that are broken by the frames placed so far; rules about an incomplete frame are not checked yet."""
        whole, other = np.isfinite(self.frames.sum(axis=(1, 2))), -1 if self.convention == "standard" else 1
        filled = np.where(whole[:, None, None], self.frames, np.eye(4))
        found = [breach for breach in check_frames(self.chain, filled, self.convention) if whole[breach.frame]]
        return [breach for breach in found if breach.rule not in TWO_FRAME_RULES or whole[breach.frame + other]]

    @property
    def table(self) -> DHTable | None:
        """The table of the frames, or None until all are placed and no rule is broken. Its joint variables are about the frames' own z."""
        if np.isnan(self.frames).any() or self.breaches:
            return None
        return _table(self.chain, self.frames, self.convention)

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        whole = [frame_text((str(i), T)) for i, T in enumerate(self.frames) if not np.isnan(T).any()]
        return f"{describe_arm(self.chain, self.q)} {' '.join(whole) or 'No frame is placed yet.'}"

    @traitlets.validate("frames")
    def _validate_frames(self, proposal: Any) -> Array:
        frames = np.array(proposal["value"], dtype=float)  # null from the page becomes NaN
        if frames.shape != (self.chain.n + 1, 4, 4):
            raise ValueError(
                f"frames must have shape ({self.chain.n + 1}, 4, 4), frames 0 to {self.chain.n} of {self.chain.name}; "
                f"got {frames.shape}."
            )
        return frames

    def _judge(self, _: Any) -> None:
        table = self.table
        if table is not None:
            z = (self.frames[:-1] if self.convention == "standard" else self.frames[1:])[:, :3, 2]
            table = table.changed(signs=np.where((z * self.chain.lines.axis).sum(axis=1) < 0, -1.0, 1.0))
        breaches = [
            {"frame": b.frame, "rule": b.rule, "text": b.text, "joint": _joint(b, self.convention, self.chain.n)}
            for b in self.breaches
        ]
        self.verdict = {
            "asked": self.asked,
            "breaches": breaches,
            "table": [] if table is None else table_cells(table),
            "off": 0.0 if table is None else FrameAssignment(self.chain, table, self.frames, ()).accuracy,
        }


def assign(chain: Chain, convention: Convention) -> ByHand:
    """Place DH frames 0 to n on an arm by hand, and check them by the rules of the convention.

    The frames are in `.frames`, the rules that they break in `.breaches`, and their table, once it is right, in `.table`.

    Raises ValueError if the convention is unknown.

    >>> by_hand = assign(kl.robots.rpr(), "standard")
    >>> by_hand.frames = kl.assign_frames(kl.robots.rpr(), convention="standard").frames
    >>> by_hand.breaches
    []
    """
    bare = np.full((chain.n + 1, 4, 4), np.nan)
    bare[:, 3] = 0.0, 0.0, 0.0, 1.0
    return ByHand(chain, validate_convention(convention), bare)


def _table(chain: Chain, frames: Array, convention: Convention) -> DHTable:
    """Compute the table of frames that satisfy the rules. Frame 0 is its base, and what follows frame n its tool."""
    T = inverse(frames[:-1]) @ frames[1:]
    if convention == "standard":
        a, d = (T[:, :3, 0] * T[:, :3, 3]).sum(axis=1), T[:, 2, 3]
        alpha, theta = np.arctan2(T[:, 2, 1], T[:, 2, 2]), np.arctan2(T[:, 1, 0], T[:, 0, 0])
    else:
        a, d = T[:, 0, 3], (T[:, :3, 2] * T[:, :3, 3]).sum(axis=1)
        alpha, theta = np.arctan2(-T[:, 1, 2], T[:, 2, 2]), np.arctan2(-T[:, 0, 1], T[:, 0, 0])
    rows = np.stack([a, alpha, d, theta], axis=1)
    tool = inverse(frames[-1]) @ chain.home
    return DHTable(rows, convention=convention, joints=chain.joint_types, base=frames[0], tool=tool, name=chain.name)


def _joint(breach: Breach, convention: Convention, n: int) -> int:
    """Return the joint, counted from 1, at which a rule is broken: the one whose z the rule is about."""
    i = breach.frame
    if breach.rule in TWO_FRAME_RULES:
        return i if convention == "standard" else i + 1
    return min(i + 1, n) if convention == "standard" else max(i, 1)
