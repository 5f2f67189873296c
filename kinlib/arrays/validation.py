"""Input validation: arrays of the right shape, finite numbers, unit axes, rotations, poses.

Every public function validates its arguments here. A wrong argument is refused with a ValueError that says what must hold,
what was given and the likely cause, so the formulas behind it can stay as short as in the book.
"""

from __future__ import annotations

import reprlib
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays.tolerances import MAX_ROTATION_RAD, ORTHONORMALITY_TOL, UNIT_LENGTH_TOL

Array = NDArray[np.float64]

JointValues = ArrayLike | Mapping[str, ArrayLike]
"""The values q (..., n) of n joints, or the value (...) of each of them by its name."""


def array(x: ArrayLike, name: str) -> Array:
    """Read x as an array of finite real numbers; ValueError for anything else. Copy it before you write to it: it may be x itself."""
    values = real_array(x, name)
    if not np.isfinite(values).all():
        place = f" at index {np.argwhere(~np.isfinite(values))[0].tolist()}" if values.ndim else ""
        raise ValueError(f"{name} contains NaN or infinity{place}. Was there a division by zero before this step?")
    return values


def real_array(x: ArrayLike, name: str) -> Array:
    """Read x as an array of real numbers, for values where infinity has a meaning; ValueError for anything else."""
    try:
        values = np.asarray(x)
        if values.dtype.kind not in "biufO":
            raise TypeError(f"{values.dtype} is not a real number type")
        if values.dtype != float:
            # astype alone would read None as NaN and "1" as 1; adding zero refuses both.
            values = np.asarray(values + 0.0).astype(float, copy=False)
    except (TypeError, ValueError, OverflowError) as error:
        advice = "Does it contain None, a symbol, a string or a row of another length?"
        if isinstance(x, np.ndarray) and x.dtype.kind == "c":
            advice = "Pass its real part, x.real, if its imaginary part is 0, as after np.linalg.eig."
        raise ValueError(f"{name} must be an array of real numbers; got {describe(x)}. {advice}") from error
    return values


def vectors(x: ArrayLike, name: str, size: int) -> Array:
    """Read x as vectors of one size, shape (..., size); ValueError for another one, and a hint if the transpose would fit."""
    values = array(x, name)
    if values.shape[-1:] != (size,):
        fits = values.ndim > 1 and values.shape[-2] == size
        advice = f"Components go in the last dimension: try {name}.T" if fits else f"One vector has {size} components"
        raise ValueError(f"{name} must have shape (..., {size}); got {values.shape}. {advice}.")
    return values


def single(values: Array, name: str) -> Array:
    """Return one configuration (n,) unchanged; ValueError for several of them."""
    if values.ndim != 1:
        raise ValueError(f"{name} must have shape ({values.shape[-1]},); got {values.shape}. Try {name}[0].")
    return values


def unit_vectors(x: ArrayLike, name: str) -> Array:
    """Read x as unit vectors (..., 3), and scale them to length 1 exactly; ValueError if they are not about that long."""
    values = vectors(x, name, 3)
    length = np.linalg.norm(values, axis=-1)
    if (wrong := np.abs(length - 1) > UNIT_LENGTH_TOL).any():
        first = length[wrong].flat[0]
        advice = "Divide it by its norm" if first else "The zero vector has no direction"
        raise ValueError(f"{name} must be a unit vector; its length is {first:.10g}. {advice}.")
    return divide_by_length(values, length)


def divide_by_length(values: Array, length: Array) -> Array:
    """Scale vectors whose length is about 1 to length 1; vectors that were scaled before are kept to the last bit.

    values (..., n), length (...) -> (..., n). So a stored axis is the same when it is read again.
    """
    return np.asarray(values / np.where(np.abs(length - 1) <= 1e-15, 1.0, length)[..., None])


def rotation_angles(angle: Array) -> Array:
    """Return rotation angles in radians unchanged, if double precision can resolve them; ValueError if not."""
    if (np.abs(angle) > MAX_ROTATION_RAD).any():
        raise ValueError(
            f"A rotation angle must be at most {MAX_ROTATION_RAD:.0e} rad; got {np.abs(angle).max():.3g} rad. Did a computation diverge?"
        )
    return angle


def rotations_or_poses(x: ArrayLike, name: str) -> Array:
    """Read x as rotations (..., 3, 3) or poses (..., 4, 4); ValueError for anything else, with the likely cause."""
    values = real_array(x, name)
    if values.shape[-2:] not in {(3, 3), (4, 4)}:
        raise ValueError(f"{name} must be a rotation (..., 3, 3) or a pose (..., 4, 4); got shape {values.shape}.")
    if not (rigid := _are_rigid(values)).all():
        raise ValueError(_describe_fault(values, tuple(np.argwhere(~rigid)[0].tolist()), name))
    return values


def poses(x: ArrayLike, name: str) -> Array:
    """Read x as poses, shape (..., 4, 4); ValueError for anything that is not an element of SE(3)."""
    values = rotations_or_poses(x, name)
    if values.shape[-1] != 4:
        raise ValueError(f"{name} must be a pose (..., 4, 4); got a rotation {values.shape}. Where is its origin?")
    return values


def single_pose(x: ArrayLike, name: str) -> Array:
    """Read x as one pose, (4, 4); ValueError for anything else."""
    if (pose := poses(x, name)).ndim != 2:
        raise ValueError(f"{name} must be a single pose, (4, 4); got {pose.shape}.")
    return pose


def joint_limits(limits: ArrayLike, n: int) -> Array:
    """Read limits as an array (n, 2), lower and upper, which may be infinite; ValueError for limits that are swapped or NaN."""
    if isinstance(limits, list):  # `to_dict` writes None for infinity
        limits = [[(-np.inf, np.inf)[k] if x is None else x for k, x in enumerate(row)] for row in limits]
    limits = real_array(limits, "limits")
    if limits.shape != (n, 2):
        raise ValueError(f"limits must have one row (lower, upper) per joint, shape ({n}, 2); got {limits.shape}.")
    for i, (lower, upper) in enumerate(limits.tolist(), start=1):
        if not lower <= upper:  # also for NaN
            raise ValueError(f"The limits of joint {i} must be (lower, upper); got {[lower, upper]}. Are they swapped?")
    return limits


ADVICE = {
    ("DHTable", "Chain"): "Try table.to_chain()",
    ("Chain", "DHTable"): "Try assign_frames(chain, convention=...).table",
    ("Tree", "Chain"): "Try tree.chain(base, tip), the arm between two of its links",
    ("str", "Chain"): "Try load_urdf(...) with a file, or kl.robots",
    **dict.fromkeys([(kind, "DHTable") for kind in ("list", "ndarray", "str")], "Try DHTable(..., convention=...)"),
    ("str", "Mapping"): "Try {'A': 1.0}, with the value of each name",
}
"""What to try if something of one type is given where another one is needed."""


def instance(x: object, name: str, *kinds: type) -> None:
    """Check that an argument is of one of these types; ValueError for another one, with what can be made of it."""
    if isinstance(x, kinds):
        return
    needed = [kind.__name__ for kind in kinds]
    articles = [f"an {name}" if name[0] in "AEIOU" else f"a {name}" for name in needed]
    advice = next((ADVICE[pair] for kind in needed if (pair := (type(x).__name__, kind)) in ADVICE), "")
    if callable(x):
        advice = f"Is it a function that makes one? Then call it, {getattr(x, '__name__', 'function')}()"
    raise ValueError(
        f"{name} must be {' or '.join(articles)}; got {describe(x)}. {advice or f'It is described in help({needed[0]})'}."
    )


class TakesJointValues(ABC):
    """A robot with n joint values, which its methods take as an array in order or as a mapping by name."""

    name: str

    @property
    @abstractmethod
    def n(self) -> int:
        """The number of joint values."""

    @property
    def _value_names(self) -> Sequence[str]:
        return tuple(getattr(self, "joint_names", ()))

    def in_order(self, q: JointValues, argument: str = "q") -> Array:
        """Read joint values as an array (..., n) in the order of the joints, from an array or a mapping by name.

        argument  its name, for messages

        Raises ValueError for joint values of another size, for NaN, for a missing or an unknown name, and for an angle that double
        precision cannot resolve.

        >>> kl.DHTable([[0.4, 0, 0, 0], [0.3, 0, 0, 0]], "standard").in_order({"q2": 0.5, "q1": 1})
        array([1. , 0.5])
        """
        names = self._value_names
        if isinstance(q, Mapping):
            if not names or {*q} != {*names}:
                needed = _listed(names) or "they have no names, so pass an array"
                given = _listed([*map(str, q)]) or "none"
                raise ValueError(f"q must have a value for each joint of {self.name}: {needed}; got {given}.")
            # single numbers are repeated for every configuration
            q = np.stack(np.broadcast_arrays(*(array(q[name], f"q[{name!r}]") for name in names)), axis=-1)
        q = array(q, argument)
        if q.shape[-1:] != (self.n,):
            advice = f"Pass one value for each of {_listed(names)}" if names else "Pass one value per joint"
            if q.ndim > 1 and q.shape[-2] == self.n:
                advice = f"Joints go in the last dimension: try {argument}.T"
            raise ValueError(
                f"{self.name} has {self.n} joint value{'s'[: self.n != 1]}, so {argument} must have shape (..., {self.n}); got "
                f"{q.shape}. {advice}."
            )
        return rotation_angles(q)


class TakesLimitedValues(TakesJointValues):
    """A robot whose joint values have limits."""

    limits: Any

    @property
    def _limits(self) -> Array:
        return np.tile([-np.inf, np.inf], (self.n, 1)) if self.limits is None else np.asarray(self.limits)

    def within_limits(self, q: JointValues) -> NDArray[np.bool_]:
        """Return for each configuration whether all its joint values are within the limits: q (..., n) -> (...).

        >>> kl.Chain([[0, 0, 1, 0, 0, 0]], np.eye(4), limits=[[-1, 1]]).within_limits([[0.5], [1.5]])
        array([ True, False])
        """
        lower, upper = self._limits.T
        q = self.in_order(q)
        return np.asarray(((lower <= q) & (q <= upper)).all(axis=-1))

    def random_configurations(self, count: int, seed: int = 0) -> Array:
        """Draw configurations within the limits, the same ones for the same seed: (count, n).

        A joint without limits takes values between -pi and pi, in radians or metres; one with a single limit, up to 2 pi from it.
        A limit beyond MAX_ROTATION_RAD, as some files have for a joint that rotates without end, is none.

        >>> kl.Chain([[0, 0, 1, 0, 0, 0]], np.eye(4), limits=[[0, 1]]).random_configurations(1).round(2)
        array([[0.64]])
        """
        lower, upper = self._limits.T
        has_lower, has_upper = (np.abs(limit) < MAX_ROTATION_RAD for limit in (lower, upper))
        low = np.where(has_lower, lower, np.where(has_upper, upper - 2 * np.pi, -np.pi))
        high = np.where(has_upper, upper, np.where(has_lower, lower + 2 * np.pi, np.pi))
        return np.random.default_rng(seed).uniform(low, high, (count, self.n))


def suggest_name(name: object, names: Sequence[str], what: str) -> str:
    """Return a sentence with the name that a wrong one may mean, or with all names if none is similar."""
    from difflib import get_close_matches

    close = get_close_matches(str(name), names, n=1)
    return f" Did you mean {close[0]}?" if close else f" The {what} are {_listed(names)}."


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:12]) + f" and {len(names) - 12} more" * (len(names) > 12)


def read_only_copy(values: ArrayLike) -> Array:
    """Copy values into a read-only array, because a frozen dataclass does not protect the contents of its arrays."""
    copy = np.array(values, dtype=float)
    copy.flags.writeable = False
    return copy


class ReadOnly:
    """A frozen dataclass that is equal to another one with equal fields."""

    def changed(self, **fields: Any) -> Self:
        """Copy it with some fields replaced; ValueError for the same reasons as a new one.

        >>> kl.robots.rpr().changed(joint_names=["lift", "slide", "tilt"]).fk({"lift": 0, "slide": 0.5, "tilt": 0})[:3, 3] + 0.0
        array([0. , 0. , 1.5])
        """
        return replace(self, **fields)  # type: ignore[type-var]

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, type(self)) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def to_dict(self) -> dict[str, Any]:
        """Convert it to plain JSON types; an infinite limit is None, because JSON has no infinity.

        >>> kl.robots.rpr().to_dict()["screws"][1]
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
        """

        def plain(x: Any) -> Any:
            return np.where(np.isfinite(x), x, np.array(None)).tolist() if isinstance(x, np.ndarray) else x

        return {name: plain(x) for name, x in self._fields().items()}

    @classmethod
    def from_dict(cls, data: Any) -> Self:
        """Read what `to_dict` wrote, for example from a JSON or a YAML file that other people can edit.

        Raises ValueError for a missing or an unknown key, and for the same reasons as a new one.

        >>> arm = kl.Chain.from_dict(kl.robots.youbot().to_dict())
        >>> bool((arm.fk([1, 2, 3, 4, 5]) == kl.robots.youbot().fk([1, 2, 3, 4, 5])).all())
        True
        """
        try:
            return cls(**data)
        except TypeError as error:
            raise ValueError(f"The data must have the fields of a {cls.__name__} as keys: {error}.") from error

    def _fields(self) -> dict[str, Any]:
        return {each.name: getattr(self, each.name) for each in fields(self)}  # type: ignore[arg-type]

    def _key(self) -> tuple[Any, ...]:
        """The fields that are compared, arrays as their shape and their bytes."""
        values = self._fields().values()
        return tuple((x.shape, (x + 0.0).tobytes()) if isinstance(x, np.ndarray) else x for x in values)


def describe(x: Any) -> str:
    """Describe a value briefly, for an error message: its type and the beginning of its repr."""
    return f"{type(x).__name__} {reprlib.repr(x)}"


def _are_rigid(X: Array) -> NDArray[np.bool_]:
    """Whether each of (..., 3, 3) is a rotation, or each of (..., 4, 4) a pose."""
    R = X[..., :3, :3]
    # A value that overflows is far from rigid, and so is NaN: a comparison with NaN is false.
    with np.errstate(over="ignore", invalid="ignore"):
        defect = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max(axis=(-2, -1))
        rigid: NDArray[np.bool_] = (defect <= ORTHONORMALITY_TOL) & (np.linalg.det(R) > 0)
        if X.shape[-1] == 4:
            rigid &= (np.abs(X[..., 3, :] - [0, 0, 0, 1]) <= ORTHONORMALITY_TOL).all(axis=-1)
            rigid &= np.isfinite(X[..., :3, 3]).all(axis=-1)
    return rigid


def _describe_fault(values: Array, index: tuple[int, ...], name: str) -> str:
    """Say why the matrix at this index of the batch is not a rotation or not a pose."""
    X, place = values[index], f" at index {list(index)}" if index else ""
    array(values, name)
    if len(X) == 4 and (np.abs(X[3] - [0, 0, 0, 1]) > ORTHONORMALITY_TOL).any():
        return (
            f"{name} is not a pose{place}: its last row must be 0 0 0 1; got {X[3]}. "
            "Is the translation in the last row instead of the last column? Try the transpose."
        )
    R = np.clip(X[:3, :3], -1e150, 1e150)  # the square of a huge number would overflow
    defect = np.abs(R.T @ R - np.eye(3)).max()
    if defect <= ORTHONORMALITY_TOL:
        return f"{name} is a reflection{place} (det R = -1), not a rotation. Are two axes swapped? Is y = z x x?"
    return (
        f"{name} is not rigid{place}: R^T R differs from the identity by {defect:.2g}. "
        "Were its entries rounded? Then take its nearest_rotation. Or is an axis not of unit length?"
    )
