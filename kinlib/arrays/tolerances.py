"""Named tolerances: how large a difference may be before kinlib treats it as one.

Lengths are in metres, for arms that are a few metres long, and angles are in radians. Tolerances of the numerical solvers are
in their own modules, in `kinlib.mechanisms`.
"""

UNIT_LENGTH_TOL = 1e-9
"""How far the length of an axis may differ from 1. Data printed with nine digits pass; an unnormalized (1, 1, 0) does not."""

ORTHONORMALITY_TOL = 1e-6
"""How far x . x, y . y and x . y of a rotation's columns may differ from 1, 1 and 0, and z from x x y. Single precision passes;
four printed decimals do not."""

MAX_ROTATION_RAD = 1e8
"""The largest rotation angle that is still meaningful: beyond it, rounding alone changes the result by 1e-8."""

ROUNDING_ERROR = 1e-9
"""A number smaller than this is treated as the rounding error of one computation, and is written as 0."""

TYPED_PI_ERROR = 1e-5
"""The same for numbers from files or from people: pi / 2 typed with six digits is off by 4e-6."""

PARALLEL_TOL_RAD = 1e-12
"""Axes that differ in direction by at most this angle are parallel."""

INTERSECTION_TOL_M = 1e-12
"""Axes whose distance is at most this length intersect."""

NEARLY_PARALLEL_RAD = 1e-5
"""Axes at a smaller angle are nearly parallel, where DH is ill-conditioned: the feet of their normal move away like 1 / angle."""

EQUIVALENCE_TOL = 1e-8
"""How far two mechanisms may differ, in an entry of a pose, and still be the same."""

SAME_DISTANCE_RAD = 1e-9
"""Axes at a smaller angle have the same distance everywhere, to within a micrometre along a kilometre."""
