"""Your robot: a URDF, a DH table that was pasted, or both; what the table says of the arm, and the table that is right.

The notebook and the page of that name show what `examine` returns. Everything that a person gave is escaped before it is shown.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from html import escape
from typing import Any

import numpy as np

from kincourse.robot_sheets.robot_sheet import robot_sheet, with_plain_name
from kinlib.arrays.formatting import format_degrees, format_number, html_table
from kinlib.arrays.tolerances import ROUNDING_ERROR
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import youbot
from kinlib.dh.assignment import FrameAssignment, assign_frames
from kinlib.dh.diagnosis import Diagnosis, diagnose
from kinlib.dh.equivalence import CHOICES, equivalent, measured_difference
from kinlib.dh.explanation.search import explain_by_choices
from kinlib.dh.formatting import headings
from kinlib.dh.read_table import read_table
from kinlib.dh.table import Convention, DHTable, format_rows, table_frames
from kinlib.dh.table_text import Assumption
from kinlib.urdf.chains import load_urdf
from kinlib.urdf.robot_tree import Tree
from kinlib.view.viewer.viewer import Viewer, explore, opening
from misstep.sheet import OpenSheet

MAX_URDF_LENGTH = 20_000_000
"""The maximum number of characters of a URDF file; longer ones are refused before they are parsed."""

UR_SOURCE = 'Universal Robots, "DH parameters for calculations of kinematics and dynamics"'
CORKE = "as in Corke's Robotics Toolbox"

JOINT_CHOICES = ("zeros", "signs")

SLIP_WORDS = "If only the base and the tool may differ: "


class KnownArms:
    """A list of the arms in KNOWN with their sources; the page fills its menu from it."""

    def _repr_html_(self) -> str:
        rows = [[name, str(table.n), source] for name, (table, source) in KNOWN.items()]
        return html_table("Known arms", ("arm", "joints", "source"), rows)

    def __repr__(self) -> str:
        return "\n".join(f"{name}: {source}" for name, (_, source) in KNOWN.items())


def known_arms() -> KnownArms:
    """Return the list of known arms, to be shown in a notebook."""
    return KnownArms()


def _published(
    rows: Sequence[Sequence[float]], source: str, *, convention: Convention = "standard", joints: str = ""
) -> tuple[DHTable, str]:
    """Return a maker's table, a and d in metres, alpha and theta in degrees, and its source."""
    return DHTable(np.array(rows) * (1, np.pi / 180, 1, np.pi / 180), convention, joints=joints), source


def _universal(*lengths: float) -> tuple[DHTable, str]:
    d1, a2, a3, d4, d5, d6 = lengths
    rows = [(0, 90, d1, 0), (a2, 0, 0, 0), (a3, 0, 0, 0), (0, 90, d4, 0), (0, -90, d5, 0), (0, 0, d6, 0)]
    return _published(rows, UR_SOURCE)


KNOWN: Mapping[str, tuple[DHTable, str]] = {
    "youBot": (assign_frames(youbot(), convention="standard").table, youbot().source),
    "UR3e": _universal(0.15185, -0.24355, -0.2132, 0.13105, 0.08535, 0.0921),
    "UR5": _universal(0.089159, -0.425, -0.39225, 0.10915, 0.09465, 0.0823),
    "UR5e": _universal(0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996),
    "UR10e": _universal(0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655),
    "UR16e": _universal(0.1807, -0.4784, -0.36, 0.17415, 0.11985, 0.11655),
    "Panda": _published(
        [(0, 0, 0.333, 0), (0, -90, 0, 0), (0, 90, 0.316, 0), (0.0825, 90, 0, 0), (-0.0825, -90, 0.384, 0), (0, 90, 0, 0),
         (0.088, 90, 0, 0), (0, 0, 0.107, 0)], 'Franka Emika, "Robot and interface specifications"', convention="modified",
        joints="RRRRRRRF"),
    "iiwa 14": _published(
        [(0, -90, 0.36, 0), (0, 90, 0, 0), (0, 90, 0.42, 0), (0, -90, 0, 0), (0, -90, 0.4, 0), (0, 90, 0, 0), (0, 0, 0.126, 0)],
        'KUKA, "LBR iiwa 14 R820, Specification" (dimensions)'),
    "KR 16": _published(
        [(0.26, 90, 0.675, 0), (0.68, 0, 0, 90), (-0.035, 90, 0, 0), (0, -90, 0.67, 0), (0, 90, 0, 0), (0, 0, 0.158, 180)],
        'KUKA, "KR 6-2, KR 16-2, Specification" (dimensions)'),
    "IRB 140": _published(
        [(0.07, -90, 0.352, 0), (0.36, 0, 0, -90), (0, -90, 0, 0), (0, 90, 0.38, 0), (0, -90, 0, 0), (0, 0, 0.065, 180)],
        f"ABB, IRB 140 data sheet, {CORKE}"),
    "PUMA 560": _published(
        [(0, 90, 0.6718, 0), (0.4318, 0, 0, 0), (0.0203, -90, 0.15005, 0), (0, 90, 0.4318, 0), (0, -90, 0, 0), (0, 0, 0, 0)],
        f"Unimation, PUMA 560, {CORKE}"),
    "Stanford arm": _published(
        [(0, -90, 0.412, 0), (0, 90, 0.154, 0), (0, 0, 0, -90), (0, -90, 0, 0), (0, 90, 0, 0), (0, 0, 0.263, 0)],
        "Paul, Stanford AIM-177, figure 2.3", joints="RRPRRR"),
    "Cobra 600 (SCARA)": _published(
        [(0.325, 0, 0.387, 0), (0.275, 180, 0, 0), (0, 0, 0, 0), (0, 0, 0, 0)], f"Adept, Cobra 600, {CORKE}", joints="RRPR"),
}  # fmt: skip
"""Arms by the numbers of their makers, each with its source."""


@dataclass(frozen=True, eq=False)
class Examination:
    """What is known of a robot: the arm, the table that was read, what was assumed for it, and the comparison of the two.

    free, strict   the diagnosis with all choices free, and with all fixed: the second is right only if the same q gives the same pose
    unread         why a table or a file could not be read; then the rest is what could
    notes          what else was decided, for example which joints are left at 0
    visuals        the file of the arm, and its base link, for `explore`
    """

    arm: Chain | None = None
    table: DHTable | None = None
    assumed: Sequence[Assumption] = ()
    free: Diagnosis | None = None
    strict: Diagnosis | None = None
    unread: str = ""
    notes: Sequence[str] = ()
    visuals: tuple[Tree, str] | None = None

    @property
    def sentence(self) -> str:
        """The answer in one sentence."""
        if self.unread:
            return self.unread
        if self.table is None or self.arm is None:
            given = self.arm or self.table
            return f"{given.name}: {given.n} joints." if given else "Give a URDF file, a table, or both."
        if self.strict is None:
            letters, count = self.table.joints.replace("F", ""), f"{self.table.n} joint{'s'[: self.table.n != 1]}"
            return (
                f"The table has {count} ({letters}), and the arm has {self.arm.n} ({self.arm.joint_types}), so they cannot be "
                "compared. Choose another tip or base, or look for a missing row."
            )
        metres, radians = measured_difference(self.table.to_chain(), self.arm)
        size = f"{format_number(metres, 3)} m and {format_number(math.degrees(radians), 3, zero=1e-6)}°"
        if self.strict.verdict == "right":
            return "The table agrees with the arm: the same q gives the same pose."
        if self.strict.verdict == "rounded":
            return f"The table agrees with the arm to the digits that are printed: for the same q the tool differs by {size}."
        return f"For the same q the tool differs by up to {size}, at 1000 random configurations."

    @property
    def readings(self) -> list[str]:
        """Each reading that explains the difference, that with the fewest changes first."""
        if not self.free or not self.strict or self.strict.verdict in {"right", "rounded"}:
            return []
        texts = []
        is_right = self.free.verdict in {"right", "rounded"}
        if is_right:
            lines = [line for line in str(self.free).splitlines()[2:] if not line.startswith(("To count", "If q is"))]
            texts.append("\n".join(["The table describes the same arm with other choices:", *lines]))
        elif self.free.explanations:
            texts.append(str(self.free))
        strict = str(self.strict)
        is_choice = bool(self.strict.explanations) and self.strict.explanations[0].is_a_choice
        if self.slip:
            texts.append(f"{SLIP_WORDS}{self.slip}")
        elif strict not in texts and not (is_right and (is_choice or self._is_told_by_choices)):
            same = "If q, base and tool are meant to be the same: " if texts else ""
            texts.append(same + strict)
        return sorted(texts, key=lambda text: (text.count("\n"), len(text)))

    @property
    def _is_told_by_choices(self) -> bool:
        """Whether the choices up to which the table is right change the same numbers as the only mistake that was found."""
        if self.table is None or self.free is None or self.strict is None or len(self.strict.explanations) != 1:
            return False
        choices = explain_by_choices(self.table, self.free.comparison)
        return choices is not None and self.strict.explanations[0].says_as_much(choices)

    @cached_property
    def slip(self) -> Diagnosis | None:
        """What is wrong if the base and the tool may differ, where otherwise only choices of several zeros and signs are found."""
        if not self.strict or len(self.strict.faults) < 2 or not self.strict.explanations[0].is_a_choice:
            return None
        slip = diagnose(self.strict.table, self.strict.arm, JOINT_CHOICES)
        return slip if slip.explanations and not slip.explanations[0].is_a_choice else None

    @property
    def corrected(self) -> DHTable | None:
        """The table with the poses of the arm for the same q, as near the given one as was found."""
        if not self.arm:
            return self.table
        convention = self.table.convention if self.table and self.strict else "standard"
        return self._changed or assign_frames(self.arm, convention=convention, snap=True).table

    @property
    def _changed(self) -> DHTable | None:
        """The given table with few other numbers that has the poses of the arm; None if none was found."""
        return self._followed[0] if self._followed else None

    @cached_property
    def _followed(self) -> tuple[DHTable, str, bool] | None:
        """That table, the reading that it follows, and whether choices of the arm were added: the first of those nearest to the arm."""
        if self.strict is None or self.free is None:
            return None
        if self.slip and self.slip.corrected:
            return _with_choices(self.slip.corrected, self.slip.arm, JOINT_CHOICES), SLIP_WORDS, False
        arm, told = self.strict.arm, str(self.strict)
        found = [(near, told, False) for near in (self.strict.corrected, self.strict.nearest) if near is not None]
        if self.strict.nearest is not None and self.strict.up_to:
            found = [(_with_choices(self.strict.nearest, arm), told, True)]
        if self.free.explanations:
            found.append((_with_choices(self.free.explanations[0].corrected, arm), str(self.free), True))
        return min(found, key=lambda each: round(max(measured_difference(each[0].to_chain(), arm)), 4), default=None)

    @property
    def wrong_rows(self) -> list[int]:
        """The rows, from 0, in which the table differs from the corrected one."""
        right, table = self.corrected, self.table
        if right is None or table is None or right.rows.shape != table.rows.shape:
            return []
        one, other = (np.column_stack([each.rows, each.signs]) for each in (table, right))
        return [int(row) for row in np.flatnonzero(np.abs(one - other).max(axis=1) > 1e-9)]

    def copies(self) -> dict[str, str]:
        """The corrected table as text to copy: as text, CSV, LaTeX, Python, and for the Robotics Toolbox."""
        return formats(self.corrected) if self.corrected else {}

    def picture(self) -> Viewer | None:
        """The arm with sliders, and on it the frames of the table and, in grey and with a prime, those of the arm.

        They can be switched on one by one. Those of the first wrong row are on: that of the row, and the one before it.
        """
        arm = self.arm or (self.table.to_chain() if self.table else None)
        if arm is None:
            return None
        if not self.table or self.table.n != arm.n:
            return explore(arm, show=("axes", "base", "tool"), visuals=self.visuals)
        row, q = self.wrong_rows[0] if self.wrong_rows else 0, opening(arm)
        frames = table_frames(self.table, q)
        if self.corrected and self.wrong_rows:
            right = table_frames(self.corrected, q)
            frames |= {f"{name}'": T for name, T in right.items() if not np.allclose(T, frames[name], atol=1e-6)}
        shown = [f"frame {name}" for name in (row, row + 1, f"{row}'", f"{row + 1}'") if str(name) in frames]
        return explore(arm, show=("axes", *shown), start=q, frames=frames, visuals=self.visuals)

    def _repr_html_(self) -> str:
        return "".join(self._blocks())

    def _blocks(self) -> Iterator[str]:
        readings = self.readings
        yield f'<p class="your-robot-answer{" your-robot-unread" * bool(self.unread)}"><strong>{escape(self.sentence)}</strong></p>'
        if self.unread:
            return
        for number, text in enumerate(readings):
            head, *changes = map(escape, text.splitlines())
            lead = ("Either: ", "Or: ")[number] if len(readings) > 1 else ""
            listed = "".join(f"<li>{change}</li>" for change in changes)
            yield f"<p><strong>{lead}</strong>{head}</p>" + f"<ul>{listed}</ul>" * bool(changes)
        if self.assumed or self.notes:
            asked = [each for each in self.assumed if each.options]
            items = [f"{note}" for note in self.notes] + [each.text for each in self.assumed if not each.options]
            items += [
                f"{each.text} If not, choose another {each.argument.replace('_', ' ')} ({', '.join(each.options)})."
                for each in asked
            ]
            yield f"<p>What was assumed:</p><ul>{''.join(f'<li>{escape(item)}</li>' for item in items)}</ul>"
        if self.table:
            yield self._side_by_side()
        if self.arm and not self.table:
            for convention in ("standard", "modified"):
                yield from _assigned(assign_frames(self.arm, convention=convention), self.arm)
            yield f"<details><summary>Screw axes and M</summary><pre>{escape(str(self.arm))}</pre></details>"
        if self.strict and self.corrected and self.wrong_rows:
            yield f"<p>{escape(self._about_the_corrected(readings))}</p>"
        for name, text in self.copies().items():
            label = "The corrected table" if self.wrong_rows else "The table"
            is_open = " open" * (name == "text")
            yield f"<details{is_open}><summary>{label} as {escape(name)}</summary><pre>{escape(text)}</pre></details>"

    def _about_the_corrected(self, readings: Sequence[str]) -> str:
        """Say which reading the corrected table follows, and how far its poses are off."""
        if self.arm is None or self.corrected is None:
            return ""
        metres, radians = measured_difference(self.corrected.to_chain(), self.arm)
        off = f"{format_number(metres, 2, zero=1e-9)} m and {format_number(math.degrees(radians), 2, zero=1e-7)}°"
        follows = "The corrected table is a new one, with frames assigned to the arm, because no small change was found"
        if self._followed:
            number = next((k for k, text in enumerate(readings) if self._followed[1] in text), 0)
            which = ("the first reading", "the second reading")[number] if len(readings) > 1 else "these changes"
            first = ", and of these its first line" * any("\nor: " in text for text in readings[number : number + 1])
            choices = ", with the base, the tool, the zeros and the signs of the arm" * self._followed[2]
            follows = f"The corrected table has {which}{first}{choices}"
        return f"{follows}; for the same q its poses differ from the arm's by at most {off}."

    def _side_by_side(self) -> str:
        """The rows of the table, each with what is other in the corrected one, marked in a column and not by colour alone."""
        right, table = self.corrected, self.table
        if table is None or right is None or not self.arm or right.rows.shape != table.rows.shape:
            return table._repr_html_() if table is not None else ""
        wrong = self.wrong_rows
        marks = {row: "✗ first wrong row" if row == wrong[0] else "✗" for row in wrong}
        rows = [
            [marks.get(i, "✓"), str(i + 1), *(a if a == b else f"{a} → {b}" for a, b in zip(one, other, strict=True))]
            for i, (one, other) in enumerate(zip(_entries(table), _entries(right), strict=True))
        ]
        return html_table(
            "The table, and → the numbers that give the arm's poses", ["", *headings(table.convention)], rows
        )


def _with_choices(table: DHTable, arm: Chain, fixed: Collection[str] = ()) -> DHTable:
    """Give a table that describes an arm up to choices the base, the tool, the zeros and the signs of the arm."""
    for tolerance in (1e-6, 1e-4, 1e-2):
        found = equivalent(table, arm, fixed=fixed, tolerance=tolerance)
        if choices := explain_by_choices(table, found):
            return choices.corrected
    return table


def _assigned(found: FrameAssignment, arm: Chain) -> Iterator[str]:
    clean = assign_frames(arm, convention=found.table.convention, snap=True)
    exact = replace(found.table, name=f"{arm.name}, exact")
    yield clean.table._repr_html_()
    by = f"differ from those of the arm by at most {clean.accuracy:.1e} (metres, and entries of R)"
    yield f"<p>The poses of this table {by if clean.accuracy > ROUNDING_ERROR else 'are those of the arm'}.</p>"
    if np.abs(exact.rows - clean.table.rows).max() > 1e-12:
        yield f"<details><summary>All digits</summary>{exact._repr_html_()}</details>"
    steps = "".join(f"<li>{escape(str(step))}</li>" for step in found.steps)
    yield f"<details><summary>The reason for each frame</summary><ol>{steps}</ol></details>"


def _entries(table: DHTable) -> list[list[str]]:
    return format_rows(table, length=lambda x: format_number(x, 6), angle=lambda x: format_degrees(x, 6))


def _numbers(values: Array) -> list[list[float]]:
    """Return numbers with twelve digits, without rounding errors."""
    return [[float(format_number(x, 12, zero=1e-9)) for x in row] for row in values.tolist()]


def formats(table: DHTable) -> dict[str, str]:
    """Write a table as text, CSV, LaTeX, Python, and for the Robotics Toolbox.

    >>> print(formats(DHTable([[0.4, 0, 0.1, 0]], convention="standard"))["Robotics Toolbox"])
    DHRobot([
        RevoluteDH(a=0.4, alpha=0, d=0.1, offset=0),
    ])
    """
    rows, names = _entries(table), headings(table.convention)[1:]
    greek = [name.replace("alpha", "\\alpha").replace("theta", "\\theta") for name in names]
    latex = [" & ".join(["$i$", *(f"${name}$" for name in greek)]) + r" \\ \hline"]
    latex += [
        " & ".join([str(i), *(cell.replace("°", r"^\circ").join("$$") for cell in row)]) + r" \\"
        for i, row in enumerate(rows, 1)
    ]
    numbers = _numbers(table.rows)
    extra = f", joints={table.joints!r}" if set(table.joints) != {"R"} else ""
    extra += f", signs={table.signs.astype(int).tolist()}" if (table.signs != 1).any() else ""
    ends = {"base": table.base, "tool": table.tool}
    extra += "".join(f",\n    {name}={_numbers(T)}" for name, T in ends.items() if np.abs(T - np.eye(4)).max() > 1e-9)
    body = "\n".join(f"    {row}," for row in numbers)
    kind = {"standard": "DH", "modified": "MDH"}[table.convention]
    links = []
    for letter, sign, (a, alpha, d, theta) in zip(table.joints, table.signs, numbers, strict=True):
        flip = ", flip=True" if sign < 0 else ""
        lead = f"a={a:g}, alpha={alpha:.12g}" if alpha else f"a={a:g}, alpha=0"
        if letter == "P":
            links.append(f"    Prismatic{kind}({lead}, theta={theta:.12g}, offset={d:g}{flip}),")
        elif letter == "R":
            links.append(f"    Revolute{kind}({lead}, d={d:g}, offset={theta:.12g}{flip}),")
    fixed = "# a fixed row belongs to the tool\n" if "F" in table.joints else ""
    return {
        "text": str(table),
        "CSV": "\n".join(",".join(row) for row in [["a", "alpha", "d", "theta"], *rows]),
        "LaTeX": "\\begin{tabular}{ccccc}\n" + "\n".join(latex) + "\n\\end{tabular}",
        "Python": f"kl.DHTable([\n{body}\n], convention={table.convention!r}{extra})",
        "Robotics Toolbox": f"{fixed}DHRobot([\n" + "\n".join(links) + "\n])",
    }


def examine(
    arm: str | Chain | DHTable = "",
    table: str | DHTable = "",
    *,
    base: str = "",
    tip: str = "",
    **how: Any,
) -> Examination:
    r"""Read an arm and a table, and compare them.

    arm    the path or the text of a URDF file, the name of an arm in KNOWN, a chain; or "" for none
    table  the text of a table as it was pasted; or "" for none
    base, tip  the links of the file between which the arm is; by default the root, and the end of the arm without a gripper
    how    what the text of the table does not say, as `read_table` takes it: convention, order, length_unit, angle_unit, joints

    >>> print(examine("UR5e", "a alpha d\n0 90 0.1625\n0.425 0 0\n-0.3922 0 0\n0 90 0.1333\n0 -90 0.0997\n0 0 0.0996").sentence)
    For the same q the tool differs by up to 0.85 m and 0°, at 1000 random configurations.
    """
    found = Examination()
    try:
        if arm != "":
            chain, notes, visuals = _read_arm(arm, base, tip)
            found = replace(found, arm=chain, notes=notes, visuals=visuals)
        if table != "":
            reading = (
                (table, ()) if isinstance(table, DHTable) else read_table(table, **{k: v for k, v in how.items() if v})
            )
            found = replace(found, table=reading[0], assumed=reading[1])
    except (ValueError, OSError) as error:
        return replace(found, unread=str(error))
    if found.arm is None or found.table is None or found.arm.n != found.table.n:
        return found
    free, strict = (diagnose(found.table, found.arm, fixed) for fixed in ((), CHOICES))
    return replace(found, free=free, strict=strict)


def practise(arm: str | Chain | DHTable | Examination, student: str, *, base: str = "", tip: str = "") -> OpenSheet:
    """Make the exercise sheet of an arm, as `kincourse new-sheet` does, with the numbers of a student.

    arm        as `examine` takes it, or what it returned
    base, tip  as `examine` takes them

    Raises ValueError if there is no arm, or if it cannot be read.

    >>> list(practise("UR5e", "ada").problem(1).given)
    ['T_sr', 'T_rf', 'T_fb']
    """
    if isinstance(arm, Examination):
        chain = arm.arm or (arm.table.to_chain() if arm.table else None)
        if chain is None:
            raise ValueError(f"An exercise sheet needs a robot. {arm.sentence}")
    else:
        chain, *_ = _read_arm(arm, base, tip)
    return OpenSheet(robot_sheet("your_robot", with_plain_name(chain)), student)


def _read_arm(arm: str | Chain | DHTable, base: str, tip: str) -> tuple[Chain, list[str], tuple[Tree, str] | None]:
    if isinstance(arm, Chain):
        return arm, [], None
    if isinstance(arm, DHTable) or arm in KNOWN:
        table, source = (arm, "") if isinstance(arm, DHTable) else KNOWN[arm]
        chain = table.to_chain().changed(name="arm" if isinstance(arm, DHTable) else arm)
        return chain, [f"Source: {source}"] * bool(source), None
    if len(arm) > MAX_URDF_LENGTH:
        raise ValueError(
            f"A URDF file must have at most {MAX_URDF_LENGTH // 10**6} million characters; got {len(arm)}."
        )
    if "<" not in arm and not arm.strip().endswith((".urdf", ".xml")):
        raise ValueError(f"{arm!r:.60} is neither a URDF file nor a known arm. Known are {', '.join(KNOWN)}.")
    chain, tree = load_urdf(arm, base or None, tip or None), Tree.from_urdf(arm)
    base, tip = base or tree.root, tip or tree.default_tip(base or None)
    counts = {end: sum(step.joint.moves for step in tree.path(base, end)) for end in tree.tips if end != tip}
    ends = [f"{end} ({count} joint{'s'[: count != 1]})" for end, count in counts.items()]
    notes = [f"The arm is from link {base} to link {tip}: {', '.join(chain.joint_names or ())}."]
    others = [name for name in tree.joint_names if name not in (chain.joint_names or ())]
    for text, names in (
        ("Other ends of the file, if yours is one of them:", ends),
        ("Joints that are not on the way are left at 0:", others),
    ):
        notes += [f"{text} {', '.join(names[:12])}{' and more' * (len(names) > 12)}."] * bool(names)
    return chain, notes, (tree, base)
