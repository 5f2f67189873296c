"""Denavit-Hartenberg tables: an arm as four numbers per row, in the standard or the modified convention.

In general, six numbers describe one frame in another. If each x axis is along the common normal of two joint axes, four are
enough: the length a of the normal, the twist alpha about it, the offset d along the joint axis, and the angle theta about it.

    standard   A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i)                joint i moves about z_{i-1}
    modified   T_i = Rx(alpha_{i-1}) Tx(a_{i-1}) Rz(theta_i) Tz(d_i)        joint i moves about z_i

Both are the same product Z_1 X_1 Z_2 X_2 ... Z_n, divided into rows at different places. So a table in one convention is
converted into the other by moving alpha and a by one row, and the constants that remain at the ends go into base and tool.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, partial, reduce
from itertools import accumulate
from pathlib import Path
from typing import Any, Literal, cast, get_args

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.formatting import (
    SHOWN_DIGITS,
    aligned_table,
    format_degrees,
    format_matrix,
    format_number,
    html_table,
)
from kinlib.arrays.tolerances import ROUNDING_ERROR
from kinlib.arrays.validation import Array, JointValues, TakesJointValues
from kinlib.chains.chain import Chain
from kinlib.dh.parsing import ANGLE_COLUMNS, COLUMNS, MAX_LENGTH_M, is_plausible_angle, joint_entries
from kinlib.dh.table_text import read_rows
from kinlib.rigid.screw import screw

Convention = Literal["standard", "modified"]

PRINTED_DIGITS = 12
"""A printed table is read back with this many digits."""

TableRows = str | Sequence[Mapping[str, Any]] | ArrayLike
"""What a table is made from: text, dictionaries by column name, or numbers (m, 4)."""


def dh_transform(a: ArrayLike, alpha: ArrayLike, d: ArrayLike, theta: ArrayLike, *, convention: Convention) -> Array:
    """Compute the transform of one DH row: the pose of frame i in frame i-1.

    a, d in metres and alpha, theta in radians, any shapes that broadcast -> (..., 4, 4).
    In the modified convention a and alpha are those of the row, a_{i-1} and alpha_{i-1}.

    Source: EduFill manipulation module, "Computation with Denavit-Hartenberg table" (standard); DH example with n = 5
    and Kinematics under DH (modified).

    >>> dh_transform(0, 0, 0.2, 0, convention="standard")[:3, 3]
    array([0. , 0. , 0.2])
    """
    convention = validate_convention(convention)
    values = zip(COLUMNS, (a, alpha, d, theta), strict=True)
    a, alpha, d, theta = np.broadcast_arrays(*(validation.array(value, name) for name, value in values))
    ca, sa, ct, st = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    T = np.zeros((*a.shape, 4, 4))
    T[..., 3, 3] = 1.0
    if convention == "standard":
        rows = [[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st], [0 * st, sa, ca, d]]
    else:
        rows = [[ct, -st, 0 * st, a], [st * ca, ct * ca, -sa, -sa * d], [st * sa, ct * sa, ca, ca * d]]
    for i, row in enumerate(rows):
        T[..., i, :] = np.stack(row, axis=-1)
    return T


@dataclass(frozen=True, eq=False, repr=False, init=False)
class DHTable(TakesJointValues, validation.ReadOnly):
    r"""An open chain as a DH table, together with the base and the tool, which the rows cannot describe.

    rows        text as on a slide or in a CSV file, dictionaries by column name, or numbers (m, 4) in the order a, alpha, d, theta
    convention  "standard" or "modified"; there is no default, because a table has no meaning without its convention
    joints      a letter per row: R (theta varies), P (d varies), F (fixed); by default read from the variables in the rows
    signs       (m,) 1 or -1 per row: theta or d is the number in the row plus sign times q. By default they are read from the
                variables in the rows, where 0.5 - q1 has the sign -1; for rows of numbers they are 1
    base, tool  (4, 4), from {s} to frame 0 and from the last frame to {b}; text may have them below its rows, as `base = [[...]]`
    lengths     values of the names that the rows use

    Wherever q is an argument, it may also be a mapping from "q1", "q2", ... to values.

    Raises ValueError for a table that cannot be read; the message names the row and the column. Methods do for another size of q.
    Source: EduFill manipulation module (standard), DH example with n = 5 and Kinematics under DH (modified).

    >>> table = DHTable("a | alpha | d | theta \n 0.4 | 0 | 0 | q1 \n 0.3 | 0 | 0 | q2", convention="standard")
    >>> table.fk([np.pi / 2, 0])[:3, 3].round(3) + 0.0
    array([0. , 0.7, 0. ])
    """

    rows: Array
    convention: Convention
    joints: str
    signs: Array
    base: Array
    tool: Array
    name: str

    def __init__(
        self,
        rows: TableRows,
        convention: Convention,
        *,
        joints: str = "",
        signs: ArrayLike = (),
        base: ArrayLike = (),
        tool: ArrayLike = (),
        lengths: Mapping[str, float] | None = None,
        name: str = "table",
    ) -> None:
        numbers, joints, own_signs, ends = _read(rows, lengths, joints, validate_convention(convention))
        _validate_rows(numbers, joints)
        arrays = {"rows": numbers, "signs": _signs(signs, own_signs, len(numbers))}
        for end, given in (("base", base), ("tool", tool)):
            T = given if np.size(given) else np.eye(4)
            if end in ends and not np.array_equal(T, np.eye(4)):
                raise ValueError(f"{end} must be given once; got it in the text and as an argument. Remove one.")
            arrays[end] = validation.single_pose(ends.get(end, T), end)
        values = {key: validation.read_only_copy(array) for key, array in arrays.items()}
        for key, value in {**values, "convention": convention, "joints": joints, "name": name}.items():
            object.__setattr__(self, key, value)

    def __str__(self) -> str:
        r"""Write the table as text that DHTable reads back; the indices in the headings show the convention.

        Base and tool follow the rows, unless they are the identity.

        >>> lifted = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.3], [0, 0, 0, 1]]
        >>> print(DHTable("a | alpha | d | theta \n 0.4 | 90° | 0 | q1 - 90°", convention="modified", base=lifted))
        i | a_{i-1} | alpha_{i-1} | d_i | theta_i
        1 | 0.4     | 90°         | 0   | q1 - 90°
        base = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.3], [0, 0, 0, 1]]
        """
        return "\n".join([aligned_table([headings(self.convention), *self._numbered_rows()]), *self._ends()])

    def __repr__(self) -> str:
        rows = f"{len(self.rows)} row{'s'[: len(self.rows) != 1]}: {self.joints}"
        return f"DHTable({self.name!r}, {self.convention}, {', '.join([rows, *self._ends(digits=SHOWN_DIGITS)])})"

    def _repr_html_(self) -> str:
        caption = f"{self.name}, {self.convention} convention"
        table = html_table(caption, headings(self.convention), self._numbered_rows())
        return table + "".join(f"<p>{end}</p>" for end in self._ends(digits=SHOWN_DIGITS))

    def _ends(self, digits: int = PRINTED_DIGITS) -> list[str]:
        """Base and tool as text, those that are not the identity."""
        ends = {"base": self.base, "tool": self.tool}.items()
        shown = ((name, T) for name, T in ends if np.abs(T - np.eye(4)).max() > ROUNDING_ERROR)
        return [f"{name} = {format_matrix(T, digits)}" for name, T in shown]

    def _numbered_rows(self) -> list[list[str]]:
        length, angle = (partial(write, digits=PRINTED_DIGITS) for write in (format_number, format_degrees))
        return [[str(i), *row] for i, row in enumerate(format_rows(self, length=length, angle=angle), start=1)]

    @property
    def n(self) -> int:
        """The number of joints, that is, of rows that are not fixed."""
        return len(joint_entries(self.joints))

    @property
    def columns(self) -> dict[str, Array]:
        """The numbers by column name, (m,) each, with every joint at 0.

        >>> DHTable([[0.4, 0, 0, 0]], convention="standard").columns["a"]
        array([0.4])
        """
        return dict(zip(COLUMNS, self.rows.T, strict=True))

    @property
    def _value_names(self) -> list[str]:
        return [f"q{i + 1}" for i in range(self.n)]

    def link_transforms(self, q: JointValues, rows: Array | None = None) -> Array:
        """Compute the pose of each frame in the one before it: A_i or T_i, one for each row.

        q (..., n) in radians and metres -> (..., m, 4, 4). Here and below, rows (..., m, 4) may be given in place of those of the table.
        Source: DH example with n = 5, which prints them for its RPRR arm.

        >>> DHTable([[0.4, 0, 0, 0]], convention="standard").link_transforms([np.pi / 2])[0, :3, 3].round(3) + 0.0
        array([0. , 0.4, 0. ])
        """
        q, rows = self.in_order(q), self.rows if rows is None else rows
        moved = np.zeros((*np.broadcast_shapes(rows.shape[:-2], q.shape[:-1]), *rows.shape[-2:])) + rows
        moving, column = np.array(joint_entries(self.joints)).T
        moved[..., moving, column] += self.signs[moving] * q
        return dh_transform(*np.moveaxis(moved, -1, 0), convention=self.convention)

    def frames(self, q: JointValues, rows: Array | None = None) -> Array:
        """Compute the frames 0 to m in {s}: before each row, and after the last one.

        q (..., n) -> (..., m + 1, 4, 4).

        >>> DHTable([[0.4, 0, 0, 0], [0.3, 0, 0, 0]], convention="standard").frames([0, 0])[:, 0, 3]
        array([0. , 0.4, 0.7])
        """
        links = np.moveaxis(self.link_transforms(q, rows), -3, 0)
        return np.stack([*accumulate(links, np.matmul, initial=np.broadcast_to(self.base, links.shape[1:]))], axis=-3)

    def fk(self, q: JointValues, rows: Array | None = None) -> Array:
        """Compute the pose of the tool: base A_1(q_1) ... A_m tool.

        q (..., n) -> T_sb (..., 4, 4).
        Source: Chapter 4 review, step 7.

        >>> DHTable([[0.4, 0, 0, 0]], convention="modified").fk(np.zeros((1000, 1))).shape
        (1000, 4, 4)
        """
        links = np.moveaxis(self.link_transforms(q, rows), -3, 0)
        return reduce(np.matmul, [*links, self.tool], self.base)

    def to_chain(self) -> Chain:
        """Convert the table to screw axes and a home pose: the z of each joint, in {s} at home.

        >>> DHTable([[0.4, 0, 0, 0], [0.3, 0, 0, 0]], convention="standard").to_chain().screws[1] + 0.0
        array([ 0. ,  0. ,  1. ,  0. , -0.4,  0. ])
        """
        return self._chain

    @cached_property
    def _chain(self) -> Chain:
        z, points = joint_axes(self, self.rows)
        # The point nearest the origin keeps its digits where a distant normal has put the frame far along the axis.
        near = points - z * np.sum(z * points, axis=1, keepdims=True)
        pitches = [0.0 if self.joints[row] == "R" else np.inf for row, _ in joint_entries(self.joints)]
        return Chain(screw(z, near, pitches), self.fk(np.zeros(self.n)), points, self.name)

    def converted(self, convention: Convention) -> DHTable:
        """Convert the table to a convention, without loss: alpha and a move by one row, and the remainder to base or tool.

        Standard to modified: row i takes a and alpha of row i-1, and those of the last row go to the tool.
        Modified to standard: row i takes a and alpha of row i+1, and those of the first row go to the base.

        >>> table = DHTable([[0.4, 0.1, 0, 0], [0.3, 0, 0, 0]], convention="standard")
        >>> table.converted("modified").columns["a"]
        array([0. , 0.4])
        """
        if validate_convention(convention) == self.convention:
            return self
        rows, (step, left) = self.rows.copy(), ((1, -1) if convention == "modified" else (-1, 0))
        end = dh_transform(rows[left, 0], rows[left, 1], 0, 0, convention="standard")
        rows[:, :2] = np.roll(rows[:, :2], step, axis=0)
        rows[left + step, :2] = 0.0
        ends = {"tool": end @ self.tool} if convention == "modified" else {"base": self.base @ end}
        return self.changed(rows=rows, convention=convention, **ends)


def joint_axes(table: DHTable, rows: Array) -> tuple[Array, Array]:
    """Compute the joint axes in {s} at home: their directions (..., n, 3), and a point on each axis (..., n, 3).

    >>> table = DHTable([[1, 0, 2, 0]], convention="standard")
    >>> joint_axes(table, table.rows)[0]
    array([[0., 0., 1.]])
    """
    frames = table.frames(np.zeros(table.n), rows)
    moving = np.array([row for row, _ in joint_entries(table.joints)])
    # In the standard convention joint i moves about the z before its row, in the modified one about the z after it.
    at_joints = frames[..., moving + (table.convention == "modified"), :, :]
    return at_joints[..., :3, 2] * table.signs[moving, None], at_joints[..., :3, 3]


def table_frames(table: DHTable, q: Array) -> dict[str, Array]:
    """Compute the frames of a table in {s}, the last one on each link, by the number of the link; a fixed row moves with its link.

    >>> [*table_frames(DHTable([[1, 0, 0, 0]], convention="standard"), np.zeros(1))]
    ['0', '1']
    """
    links = accumulate((letter != "F" for letter in table.joints), initial=0)
    return {str(link): T for link, T in zip(links, table.frames(q), strict=True)}


def snapped(numbers: Array, unit: Array | float, tolerance: Array | float) -> Array:
    """Replace numbers by the multiples of a unit that they are near, to within a tolerance.

    >>> snapped(np.array([-1.0001, 0.4]), 1, 1e-3)
    array([-1. ,  0.4])
    """
    near = np.round(numbers / unit) * unit + 0.0
    return np.where(np.abs(numbers - near) <= tolerance, near, numbers)


def format_rows(
    table: DHTable,
    *,
    length: Callable[[float], str] = format_number,
    angle: Callable[[float], str] = format_degrees,
    variable: Callable[[int], str] = "q{}".format,
) -> list[list[str]]:
    r"""Write each row of a table as its four entries a, alpha, d, theta.

    length    writes a and d, given in metres
    angle     writes alpha and theta, given in radians
    variable  writes the variable of joint i, starting from 1

    >>> table = DHTable("a | alpha | d | theta\n 0.4 | pi/2 | 0 | 0.5*pi - q1\n 0 | 0 | q2 | 0", convention="standard")
    >>> format_rows(table)
    [['0.4', '90°', '0', '-q1 + 90°'], ['0', '0', 'q2', '0']]
    """
    rows = [[length(a), angle(alpha), length(d), angle(theta)] for a, alpha, d, theta in table.rows.tolist()]
    for joint, (row, column) in enumerate(joint_entries(table.joints), start=1):
        sign = "-" if table.signs[row] < 0 else ""
        rows[row][column] = add_variable(f"{sign}{variable(joint)}", rows[row][column])
    return rows


def add_variable(variable: str, constant: str) -> str:
    """Write the sum of a joint variable and a constant, which is left out if it is 0.

    >>> add_variable("q1", "-90°"), add_variable("-q2", "0")
    ('q1 - 90°', '-q2')
    """
    if constant in {"0", "0°"}:
        return variable
    return f"{variable} - {constant[1:]}" if constant.startswith("-") else f"{variable} + {constant}"


@cache
def headings(convention: str) -> tuple[str, ...]:
    """Return the headings of a table, which show its convention: row i of a modified table has a and alpha of the link before.

    The page of the 3-D viewer reads them from the same file. A table to be filled in has the names of `COLUMNS`.
    """
    import json  # for tables that are printed; `import kinlib` loads no more than NumPy

    by_convention = json.loads(Path(__file__).with_name("headings.json").read_text("utf-8"))
    return tuple(by_convention[convention])


def _read(given: Any, lengths: Mapping[str, float] | None, joints: str, convention: str) -> tuple[Array, str, Any, Any]:
    """Read rows in any form: the numbers, the letters, the signs, and base and tool if the text has them."""
    if not isinstance(lengths or {}, Mapping):
        raise ValueError(f"lengths must be a dictionary such as {{'l2': 0.5}}; got {validation.describe(lengths)}.")
    if isinstance(given, Sequence) and any(isinstance(row, Mapping) for row in given):
        cells = [[row.get(name) if isinstance(row, Mapping) else None for name in COLUMNS] for row in given]
        if missing := [k for k, row in enumerate(cells, start=1) if None in row]:
            raise ValueError(f"Each row must have all of {', '.join(COLUMNS)}, if only 0; row {missing[0]} does not.")
        given = "\n".join(" | ".join(map(str, row)) for row in [COLUMNS, *cells])
    if not isinstance(given, str):
        numbers = validation.vectors(cast("ArrayLike", given), "rows", 4)
        if numbers.ndim != 2 or not len(numbers):
            raise ValueError(f"rows must have shape (m, 4), with a, alpha, d, theta; got {numbers.shape}.")
        return numbers, joints or "R" * len(numbers), (), {}
    values = {name: float(validation.array(value, f"lengths[{name!r:.60}]")) for name, value in (lengths or {}).items()}
    read = read_rows(given, strict=True, lengths=values, joints=joints)
    if read.convention not in {None, convention}:
        raise ValueError(
            f"The text is that of a {read.convention} table, but convention is {convention!r}. These two are often confused: row i has a_i "
            f"and alpha_i in the standard convention, and a_{{i-1}} and alpha_{{i-1}} in the modified one (Craig). Write "
            f"convention={read.convention!r}, or, if the numbers are those of a {convention} table, write a and alpha without an index."
        )
    return read.numbers, read.joints, read.signs, read.ends


def _validate_rows(numbers: Array, joints: Any) -> None:
    if not isinstance(joints, str) or len(joints) != len(numbers) or set(joints) - set("RPF"):
        raise ValueError(f"joints must have a letter R, P or F for each of {len(numbers)} rows; got {joints!r:.60}.")
    if set(joints) <= {"F"}:
        raise ValueError("A table must have at least one joint, but every row is fixed. Is q1 missing from an entry?")
    for (row, column), value in np.ndenumerate(numbers):
        name = COLUMNS[column]
        if name in ANGLE_COLUMNS and not is_plausible_angle(value):
            raise ValueError(
                f"Row {row + 1}, {name}: an angle must be at most a full turn, 2 pi, or at most ten turns in whole degrees; got "
                f"{value:g} rad. If the number is in degrees, write {value:g}°; if not, subtract full turns."
            )
        if name not in ANGLE_COLUMNS and abs(value) > MAX_LENGTH_M:
            raise ValueError(f"Row {row + 1}: {name} must be at most {MAX_LENGTH_M:g} m; got {value:g} m.")


def _signs(given: ArrayLike, own: Sequence[float], count: int) -> Array:
    """The signs of the rows: those of the variables, the given ones, or 1."""
    if np.size(given) and len(own):
        raise ValueError("signs must be left out, because the variables in the rows have their own.")
    signs = validation.array(given, "signs") if np.size(given) else np.array(own) if len(own) else np.ones(count)
    if signs.shape != (count,) or (np.abs(signs) != 1).any():
        raise ValueError(f"signs must have 1 or -1 for each of the {count} rows; got {validation.describe(given)}.")
    return signs


def validate_convention(name: Any) -> Convention:
    """Return the name of a convention; ValueError for any other name.

    >>> validate_convention("standard")
    'standard'
    """
    if not isinstance(name, str) or name not in get_args(Convention):
        raise ValueError(
            f"convention must be 'standard' or 'modified'; got {name!r:.60}. Is z_i on the axis of joint i+1 (standard) or i (modified)?"
        )
    return cast("Convention", name)
