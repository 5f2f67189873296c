"""Read a DH table that was pasted, from a data sheet, a web page, a spreadsheet, a paper, or code, and say what was assumed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from kinlib.arrays.validation import describe
from kinlib.dh.parsing import Assumption
from kinlib.dh.table import Convention, DHTable, validate_convention
from kinlib.dh.table_text import read_rows


class Reading(NamedTuple):
    """A table that was read, and what was assumed for it."""

    table: DHTable
    assumed: Sequence[Assumption]


def read_table(
    text: str,
    *,
    convention: Convention | None = None,
    order: str = "",
    length_unit: str = "",
    angle_unit: str = "",
    joints: str = "",
) -> Reading:
    r"""Read a table that was pasted, and list what was assumed.

    convention   "standard" or "modified"; by default as the text says, and otherwise asked
    order        the columns of a text without a heading, for example "theta d a alpha"
    length_unit  "m", "cm" or "mm"; angle_unit  "rad" or "deg"; by default as the text says, or as the numbers suggest
    joints       a letter for each row, R, P or F; by default those that have a variable, or all rows

    An assumption that the numbers alone suggest lists the options, so that a person can be asked.

    Raises ValueError for a text without a table, with the line that cannot be read and what to try.

    >>> table, assumed = read_table("theta(deg); d(mm); a(mm); alpha(deg)\n0; 89,2; 0; 90\n0; 0; -425; 0", convention="standard")
    >>> table.rows.round(4)[:, :3]
    array([[ 0.    ,  1.5708,  0.0892],
           [-0.425 ,  0.    ,  0.    ]])
    >>> [each.text for each in assumed if "theta" in each.text]
    ['theta has no variable: each row is a revolute joint, with the number as its offset.']
    """
    if not isinstance(text, str):
        raise ValueError(f"text must be the text of a table; got {describe(text)}. Pass rows of numbers to DHTable.")
    said = {"order": order, "length_unit": length_unit, "angle_unit": angle_unit, "convention": convention}
    read = read_rows(text, strict=False, lengths={}, joints=joints, **said)
    if not read.numbers[:, :3].any():
        raise ValueError("No row has a length or a twist: every a, alpha and d is 0. Name the columns in a heading.")
    used = validate_convention(convention or read.convention or "standard")
    return Reading(DHTable(read.numbers, used, joints=read.joints, signs=read.signs, **read.ends), read.assumed)
