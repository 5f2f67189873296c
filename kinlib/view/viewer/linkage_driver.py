"""A closed chain in the viewer: one slider moves along its configuration curve, because all joints move together.

The curve of all configurations that can be reached is traced once by kinlib.mechanisms. Beside the picture the configuration space
is drawn: two joint values against each other.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array, JointValues
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import wrap_angle
from kinlib.rigid.screw import line
from kinlib.view.figures.bodies import solid_data
from kinlib.view.figures.linkage import draw_linkage, is_planar, linkage_body, linkage_geometry
from kinlib.view.viewer.scene import room, scene_of_parts
from kinlib.view.viewer.steps import Steps

POINTS_PER_CURVE = 240
"""The number of configurations of a curve; a full revolution has steps of one and a half degrees."""

ROUND_MS = 4000
"""The time in which Play goes along a curve."""

VIEW_MARGIN = 0.16
"""The room around what moves, as a share of the size of the linkage."""

PLANAR_VIEW_DEG, SPATIAL_VIEW_DEG = [-90.0, 52.0], [-60.0, 22.0]
"""The initial viewing direction, as azimuth and elevation: from above for a planar linkage, from the front for any other."""


def drive(
    mechanism: Mechanism,
    start: JointValues,
    *,
    across: tuple[str, str] | None = None,
    curves: Sequence[ArrayLike] | None = None,
    labels: Sequence[str] = (),
    after: Any = None,
) -> Steps:
    """Move a closed chain of one degree of freedom along its curves, and show them in its configuration space.

    start   (n,) the first configuration, or a mapping from joint names to values, in which the loops are closed
    across  the names of two joint values, drawn against each other; by default the first two
    curves  arrays (m, n) of closed configurations, such as the traced curve of each assembly mode; by default the one through start
    labels  the name of each curve
    after   a question; the linkage stays covered until a prediction is committed

    Raises ValueError if the loops are not closed at start, if the linkage does not have one degree of freedom there, if it
    has no joint value of a given name, or if a curve does not have shape (m, n).

    >>> linkage = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
    >>> modes = linkage.assembly_modes(hold={"A": 1.0})
    >>> shown = drive(linkage, modes[0], curves=[linkage.trace(q, points=240).q for q in modes])
    >>> list(shown.mode["variants"]), len(shown.q)
    (['curve 1', 'curve 2'], 4)
    """
    validation.instance(mechanism, "mechanism", Mechanism)
    first = validation.single(mechanism.in_order(start, "start"), "start")
    named = list(across or mechanism.names[:2])
    if unknown := [name for name in named if name not in mechanism.names]:
        raise ValueError(f"{mechanism.name} has joint values {', '.join(mechanism.names)}; got {unknown[0]!r}.")
    given = [mechanism.trace(first, points=POINTS_PER_CURVE).q] if curves is None else curves
    traced = [validation.vectors(curve, "curves", mechanism.n) for curve in given]
    gaps = [np.where(mechanism.is_angle, wrap_angle(curve[-1] - curve[0]), curve[-1] - curve[0]) for curve in traced]
    which = int(np.argmin([np.linalg.norm(curve - first, axis=1).min() for curve in traced]))
    at = int(np.argmin(np.linalg.norm(traced[which] - first, axis=1)))
    variants = list(labels) or [f"curve {k + 1}" for k in range(len(traced))]
    mode = {
        "variants": {
            name: {"stops": [{"q": q} for q in curve.tolist()], "closed": bool(np.allclose(gap, 0))}
            for name, curve, gap in zip(variants, traced, gaps, strict=True)
        },
        "name": "configuration",
        "label": "place on the curve",
        "choice": "curve",
        "pace": ROUND_MS / POINTS_PER_CURVE,
        "map": {
            "columns": [mechanism.names.index(name) for name in named],
            "all": list(mechanism.names),
            "angles": mechanism.is_angle.tolist(),
        },
    }
    return Steps(
        _scene(mechanism, np.concatenate(traced), traced[which][at]),
        mode,
        lambda player: draw_linkage(mechanism, player.stop["q"]),
        variant=variants[which],
        at=float(at),
        shown=[] if is_planar(mechanism) else ["axes"],
        after=after,
    )


def _scene(mechanism: Mechanism, configurations: Array, begin: Array) -> dict[str, Any]:
    """Return a linkage as data: for each body an arm that leads to it, the solids at its end, and the joints with names."""
    on = {name: {"arm": k, "body": "tool"} for k, name in enumerate(mechanism.bodies)}
    some = configurations[:: max(1, len(configurations) // 60)]
    stations = np.concatenate([linkage_geometry(mechanism, q).all for q in some])
    size = max(float(np.ptp(linkage_geometry(mechanism, begin).all, axis=0).max()), 1e-3)
    look = PLANAR_VIEW_DEG if is_planar(mechanism) else SPATIAL_VIEW_DEG
    body = linkage_body(mechanism, np.concatenate([begin[None], configurations]))
    shown = np.concatenate([stations, stations * (1, 1, 0) + (0, 0, body.lowest)])
    ground = scene_of_parts(mechanism.name, shown, size)
    return ground | {
        "bodies": list(mechanism.bodies),
        "planar": is_planar(mechanism),
        "arms": ground["arms"]
        + [
            {
                "columns": arm.columns.tolist(),
                "joints": [{"screw": screw} for screw in arm.chain.screws.tolist()],
                "home": arm.chain.home.ravel().tolist(),
            }
            for arm in [*mechanism.paths.values()][1:]
        ],
        "offered": ["axes"],
        "solids": [
            {**on[name], "parts": parts} for name, parts in zip(mechanism.bodies, solid_data(body.links), strict=True)
        ],
        "pins": [
            {
                **on[joint.bodies[0]],
                "name": joint.name,
                "joins": list(joint.bodies),
                "at": joint.point.tolist(),
                "axis": line(joint.screws[0]).axis.tolist() if joint.dof == 1 else None,
            }
            for joint in mechanism.joints
        ],
        "room": room(shown, VIEW_MARGIN * size, look) | {"look": look},
        "floor": body.lowest,
    }
