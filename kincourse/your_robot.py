"""Your robot: a URDF, a DH table that was pasted, or both; what the table says of the arm, and the table that is right.

The notebook and the page of that name show what `examine` returns. Everything that a person gave is escaped before it is shown.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from html import escape
from itertools import product
from typing import Any

import numpy as np

from kincourse.robot_sheets.robot_sheet import robot_sheet, with_plain_name
from kincourse.text.dh_tables import in_latex
from kinlib.arrays.formatting import format_degrees, format_matrix, format_number, html_table
from kinlib.arrays.tolerances import ROUNDING_ERROR, TYPED_PI_ERROR
from kinlib.chains.chain import Chain
from kinlib.chains.robots import youbot
from kinlib.dh.assignment import assign_frames
from kinlib.dh.diagnosis import Diagnosis, diagnose
from kinlib.dh.equivalence import describe_pose, equivalent, measured_difference
from kinlib.dh.explanation.rounding import with_right_angles
from kinlib.dh.explanation.search import TableExplanation, explain_by_choices
from kinlib.dh.parsing import Assumption
from kinlib.dh.read_table import read_table
from kinlib.dh.slips import CHOICES, OTHER_CONVENTION, WRONG_NUMBER, Fault
from kinlib.dh.table import PRINTED_DIGITS, Convention, DHTable, format_rows, headings, snapped, table_frames
from kinlib.rigid.lie import homogeneous, nearest_rotation
from kinlib.urdf.chains import load_urdf
from kinlib.urdf.robot_tree import Tree
from kinlib.view.viewer.viewer import Viewer, explore, opening
from misstep.sheet import OpenSheet

CORKE = "as in Corke's Robotics Toolbox"
JOINT_CHOICES = ("zeros", "signs")
MAX_EXPLANATIONS = 4
AGREES, ENDS = {"right", "rounded"}, {"wrong base", "wrong tool"}
CHOICE_WORDS = {"another zero": "joint zeros", "sign of a joint value": "joint signs",
                "wrong base": "base", "wrong tool": "tool"}  # fmt: skip
"""The faults that are choices of the arm, and how they are named."""


class KnownArms:
    """A list of the arms in KNOWN with their sources; the page fills its menu from it."""

    def _repr_html_(self) -> str:
        rows = [[name, str(table.n), source] for name, (table, source) in KNOWN.items()]
        return html_table("Known arms", ("arm", "joints", "source"), rows)

    def __repr__(self) -> str:
        return "\n".join(f"{name}: {source}" for name, (_, source) in KNOWN.items())


def _published(
    rows: Sequence[Sequence[float]], source: str, *, convention: Convention = "standard", joints: str = ""
) -> tuple[DHTable, str]:
    """Return a maker's table, a and d in metres, alpha and theta in degrees, and its source."""
    return DHTable(np.array(rows) * (1, np.pi / 180, 1, np.pi / 180), convention, joints=joints), source


def _universal(*lengths: float) -> tuple[DHTable, str]:
    d1, a2, a3, d4, d5, d6 = lengths
    rows = [(0, 90, d1, 0), (a2, 0, 0, 0), (a3, 0, 0, 0), (0, 90, d4, 0), (0, -90, d5, 0), (0, 0, d6, 0)]
    return _published(rows, 'Universal Robots, "DH parameters for calculations of kinematics and dynamics"')


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

    @cached_property
    def read(self) -> DHTable | None:
        """The given table with right angles where its digits mean them, such as 1.5708; the other numbers as they were given."""
        return with_right_angles(self.table) if self.table else None

    @property
    def sentence(self) -> str:
        """The answer in one sentence: how far the tools are apart for the same q, and why."""
        if self.unread:
            return self.unread
        if self.table is None or self.arm is None:
            one = self.arm or self.table
            return f"{one.name}: {one.n} joint{'s'[: one.n != 1]}." if one else "Give a URDF file, a table, or both."
        if self.strict is None:
            letters, count = self.table.joints.replace("F", ""), f"{self.table.n} joint{'s'[: self.table.n != 1]}"
            has = f"The table has {count} ({letters}), and the arm has {self.arm.n} ({self.arm.joint_types})"
            return f"{has}, so they cannot be compared. Choose another tip or base, or write flange before a row without a joint."
        if self.strict.verdict == "right":
            return "The table agrees with the arm: the same q gives the same pose."
        size = _difference(self.table, self.arm, 3)
        if self.strict.verdict == "rounded":
            return f"The table agrees with the arm to the digits that are printed: for the same q the tool differs by {size}."
        return f"For the same q the tool differs by up to {size}, at 1000 random configurations{self._meaning}."

    @property
    def _meaning(self) -> str:
        """What the difference means, as the end of the sentence that states it."""
        if not self.explanations:
            return "; no small change of the table explains this"
        first, cause, count = self.explanations[0], _cause(self.explanations[0]), len(self.explanations)
        itself = "the table itself" if {each.name for each in first.faults} <= ENDS else "apart from them the table"
        right = f": {itself} is right" * first.is_a_choice
        if count > 1:
            return f"; {count} explanations fit, and the first is {cause}{right}"
        return f", and only because of {cause}{right}" if first.is_a_choice else f"; this is explained by {cause}"

    @cached_property
    def explanations(self) -> list[TableExplanation]:
        """What explains the difference, that with the fewest changes first; each has all changes after which the poses agree."""
        free, strict = self.free, self.strict
        if free is None or strict is None or strict.verdict in AGREES:
            return []
        is_right = free.verdict in AGREES
        faults: list[tuple[Sequence[Fault], DHTable]] = [((), strict.table)] if is_right else []
        # Where only several zeros and signs are found, a mistake may explain the same if the base and the tool may differ.
        is_many = len(strict.faults) > 1 and strict.explanations[0].is_a_choice
        some = diagnose(strict.table, strict.arm, JOINT_CHOICES) if is_many else strict
        either = [*([] if is_right else free.explanations), *some.explanations]
        faults += [(each.faults, each.corrected) for each in either if not each.is_a_choice]
        found = [_explained(strict, *each) for each in faults]
        off = [max(measured_difference(each.corrected.to_chain(), strict.arm)) for each in found]
        several: list[TableExplanation] = []
        for each, error in zip(found, off, strict=True):
            if error <= min(3 * min(off) + 1e-6, 0.05) and not any(each.says_as_much(other) for other in several):
                several.append(each)
        # A mistake beside choices that are enough without it explains nothing.
        told = [{(fault.name, fault.row, fault.column) for fault in each.faults} for each in several]
        several = [each for each, own in zip(several, told, strict=True) if not any(other < own for other in told)]
        invented = [sum(fault.name == WRONG_NUMBER for fault in each.faults) for each in several]
        order = sorted(range(len(several)), key=lambda k: (several[k].edits, invented[k], several[k].is_a_choice))
        return [several[k] for k in order[:MAX_EXPLANATIONS]]

    @cached_property
    def corrected(self) -> DHTable | None:
        """The table with the poses of the arm for the same q, as near the given one as was found."""
        if not self.arm or (self.strict and self.strict.verdict in AGREES):
            return self.read
        if self.explanations:
            return self.explanations[0].corrected
        return assign_frames(
            self.arm, self.table.convention if self.table and self.strict else "standard", snap=True
        ).table

    @property
    def wrong_rows(self) -> list[int]:
        """The rows, from 0, in which the table differs from the corrected one."""
        right, table = self.corrected, self.read
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
        right = table_frames(self.corrected or self.table, q)
        frames |= {f"{name}'": T for name, T in right.items() if not np.allclose(T, frames[name], atol=1e-6)}
        shown = [f"frame {name}" for name in (row, row + 1, f"{row}'", f"{row + 1}'") if str(name) in frames]
        return explore(arm, show=("axes", *shown), start=q, frames=frames, visuals=self.visuals)

    def _repr_html_(self) -> str:
        return "".join(self._blocks())

    def _blocks(self) -> Iterator[str]:
        yield f'<p class="your-robot-answer{" your-robot-unread" * bool(self.unread)}"><strong>{escape(self.sentence)}</strong></p>'
        if self.unread:
            return
        if self.strict and self.strict.verdict not in AGREES:
            yield from self._told_explanations(self.strict)
        if self.table:
            yield self._side_by_side()
        if self.arm and not self.table:
            yield from _both_conventions(self.arm)
        for name, text in self.copies().items():
            is_open, head = " open" * (name == "text"), f"{self._whose} as {escape(name)}"
            yield f"<details{is_open}><summary>{head}</summary><pre>{escape(text)}</pre></details>"
        asked = [
            f"{each.text} If not, choose another {each.argument.replace('_', ' ')} ({', '.join(each.options)})."
            if each.options else each.text
            for each in self.assumed
        ]  # fmt: skip
        yield "<p>The arm:</p>" * bool(self.notes) + _listed(self.notes)
        yield "<p>What was assumed of the table:</p>" * bool(asked) + _listed(asked)

    @property
    def _whose(self) -> str:
        """Whose rows the texts to copy have."""
        if self.arm and (not self.table or self.strict is None):
            return "The table of the arm" + ", not yours," * bool(self.table)
        if self.wrong_rows or any(not each.is_a_choice for each in self.explanations):
            return "The corrected table"
        return "The table with the base and the tool of the arm" if self.explanations else "The table"

    def _told_explanations(self, strict: Diagnosis) -> Iterator[str]:
        """Write each explanation as a list of all its changes; the first is that of the corrected table."""
        found = self.explanations
        if strict.verdict == "undecided" and found and not found[0].is_a_choice:
            rounded = f"its numbers may only be rounded ({strict.rounding})"
            cause = rounded if strict.rounding else "axes are nearly parallel"
            yield f"<p>Whether the table has a mistake cannot be decided, because {escape(cause)}.</p>"
        yield f"<p>{escape(strict.note)}</p>" * bool(strict.note and found)
        if not found:
            yield f"<p>{escape(str(strict))} The corrected table is a new one: frames were assigned to the arm.</p>"
        for number, each in enumerate(found, start=1):
            several = f"Explanation {number}. " if len(found) > 1 else ""
            used = ", as in the corrected table below" * (number == 1 < len(found))
            these = "this change" if each.edits == 1 else "these changes"
            yield f"<p>{several}With {these} the table agrees with the arm{used}:</p>"
            yield _listed([fault.text for fault in each.faults])

    def _side_by_side(self) -> str:
        """The rows of the table, each with what is other in the corrected one, marked in a column and not by colour alone."""
        right, table = self.corrected, self.read
        if table is None or right is None or not self.arm or right.rows.shape != table.rows.shape:
            return _shown(table, "The table that was read") if table is not None else ""
        marks = {row: "✗ first wrong row" if k == 0 else "✗" for k, row in enumerate(self.wrong_rows)}
        rows = [
            [marks.get(i, "✓"), str(i + 1), *(a if a == b else f"{a} → {b}" for a, b in zip(one, other, strict=True))]
            for i, (one, other) in enumerate(zip(_entries(table), _entries(right), strict=True))
        ]
        return _shown(right, "The table, and → the numbers that give the arm's poses", rows, self.arm)


def _shown(table: DHTable, caption: str, rows: Sequence[Sequence[str]] = (), arm: Chain | None = None) -> str:
    """Write a table with its convention, below it the base and the tool with all their digits, and how far it is from an arm."""
    heads = [*["agrees"] * bool(rows), *headings(table.convention)]
    rows = rows or [[str(i), *row] for i, row in enumerate(_entries(table), start=1)]
    caption = f"{caption} ({table.convention} convention, lengths in m)"
    ends = [f"{name} = {format_matrix(T, PRINTED_DIGITS)}: {describe_pose(T)}" for name, T in _ends(table).items()]
    if arm:
        off = _difference(table, arm)
        differ = "are the arm's" if off == "0 m and 0°" else f"differ from the arm's by at most {off}"
        ends.append(f"With these numbers, the poses for the same q {differ}.")
    return html_table(caption, heads, rows) + "".join(f"<p>{escape(end)}</p>" for end in ends)


def _explained(strict: Diagnosis, mistakes: Sequence[Fault], table: DHTable) -> TableExplanation:
    """Add to mistakes the choices of the arm that are still missing: as few of base, tool, zeros and signs as are enough."""
    mistakes = [fault for fault in mistakes if fault.name not in ENDS]
    plain = with_right_angles(table)
    start = plain.changed(base=strict.table.base, tool=strict.table.tool)
    for tolerance, fixed in product((1e-6, 1e-4, 1e-2), (CHOICES, JOINT_CHOICES, ())):
        found = equivalent(start, strict.arm, fixed=fixed, tolerance=tolerance)
        if found.verdict == "same":
            choices = explain_by_choices(start, found)
            faults = [*mistakes, *choices.faults]
            return TableExplanation(faults, _without_noise(choices.corrected), len(faults))
    return TableExplanation(mistakes, start, len(mistakes))


def _listed(items: Sequence[str], kind: str = "ul") -> str:
    return f"<{kind}>{''.join(f'<li>{escape(item)}</li>' for item in items)}</{kind}>" * bool(items)


def _difference(table: DHTable, arm: Chain, digits: int = 2) -> str:
    """How far the poses of a table and an arm differ for the same q, in words."""
    metres, radians = measured_difference(table.to_chain(), arm)
    return (
        f"{format_number(metres, digits)} m and {format_number(math.degrees(radians), digits, zero=min(1e-6, metres))}°"
    )


def _cause(explanation: TableExplanation) -> str:
    """Say where the changes of an explanation are."""
    names = {fault.name for fault in explanation.faults}
    choices = " and ".join(words for name, words in CHOICE_WORDS.items() if name in names)
    mistakes = [fault for fault in explanation.faults if fault.name not in CHOICE_WORDS]
    rows = sorted({str(fault.row) for fault in mistakes if fault.row})
    count = "a mistake" if len(mistakes) == 1 else f"{len(mistakes)} mistakes"
    place = f"row{'s'[: len(rows) != 1]} {', '.join(rows)}" if rows else "the whole table"
    return f"{count} in {place}" + f", with the {choices} of the arm" * bool(choices) if mistakes else choices


def _without_noise(table: DHTable) -> DHTable:
    """Return a table whose base and tool have 0 and 1 where they are off by the digits of a typed pi / 2."""
    ends = np.array([table.base, table.tool])
    R = nearest_rotation(snapped(ends[:, :3, :3], 1, TYPED_PI_ERROR))
    base, tool = homogeneous(R, snapped(ends[:, :3, 3], 1e-6, 1e-8))
    return table.changed(base=base, tool=tool)


def _both_conventions(arm: Chain) -> Iterator[str]:
    """The DH tables of an arm, the reason for each frame, and its screw axes."""
    for convention in OTHER_CONVENTION:
        exact, clean = (assign_frames(arm, convention=convention, snap=snap) for snap in (False, True))
        yield _shown(clean.table, arm.name, arm=arm)
        if np.abs(exact.table.rows - clean.table.rows).max() > 1e-12:
            yield f"<details><summary>All digits</summary>{_shown(exact.table, f'{arm.name}, exact')}</details>"
        steps = _listed([str(step) for step in clean.steps], "ol")
        yield f"<details><summary>The reason for each frame</summary>{steps}</details>"
    shown = clean.table.to_chain() if clean.accuracy < 1e-7 else arm
    yield f"<details><summary>Screw axes and M</summary><pre>{escape(str(shown))}</pre></details>"


def _entries(table: DHTable, variable: str = "q{}") -> list[list[str]]:
    length, angle = (partial(write, digits=PRINTED_DIGITS) for write in (format_number, format_degrees))
    return format_rows(table, length=length, angle=angle, variable=variable.format)


def _ends(table: DHTable) -> dict[str, Any]:
    """Base and tool, those that are not the identity."""
    ends = {"base": table.base, "tool": table.tool}
    return {name: T for name, T in ends.items() if np.abs(T - np.eye(4)).max() > ROUNDING_ERROR}


def formats(table: DHTable) -> dict[str, str]:
    """Write a table as text, CSV, LaTeX, Python, and for the Robotics Toolbox, each with convention, units, base and tool.

    >>> print(formats(DHTable([[0.4, 0, 0.1, 0]], convention="standard"))["CSV"])
    # standard convention, lengths in m, angles in degrees
    i,a_i [m],alpha_i [deg],d_i [m],theta_i [deg]
    1,0.4,0,0.1,q1
    """
    says = f"{table.convention} convention, lengths in m, angles in"
    poses = {name: format_matrix(T, PRINTED_DIGITS) for name, T in _ends(table).items()}
    ends = [f"{name} = {text}" for name, text in poses.items()]
    heads = list(zip(headings(table.convention), ["", " [m]", " [deg]", " [m]", " [deg]"], strict=True))
    csv = [",".join(name + unit for name, unit in heads)]
    csv += [f"{i},{','.join(row)}".replace(" ", "").replace("°", "") for i, row in enumerate(_entries(table), 1)]
    latex = [" & ".join(in_latex(name).join("$$") + unit for name, unit in heads) + r" \\ \hline"]
    for i, row in enumerate(_entries(table, "q_{{{}}}"), 1):
        latex.append(" & ".join([str(i), *(cell.replace("°", r"^\circ").join("$$") for cell in row)]) + r" \\")
    head, tail = r"\begin{tabular}{ccccc}", r"\end{tabular}"
    extra = f", joints={table.joints!r}" if set(table.joints) != {"R"} else ""
    extra += f", signs={table.signs.astype(int).tolist()}" if (table.signs != 1).any() else ""
    extra += "".join(f",\n    {name}={text}" for name, text in poses.items())
    body = [f"    {[float(format_number(x, PRINTED_DIGITS)) for x in row]}," for row in table.rows.tolist()]
    rows = ["# lengths in m, angles in radians", "table = kl.DHTable([", *body]
    return {
        "text": f"# {says} degrees\n{table}",
        "CSV": "\n".join([f"# {says} degrees", *csv, *ends]),
        "LaTeX": "\n".join([f"% {says} degrees", *(f"% {end}" for end in ends), head, *latex, tail]),
        "Python": "\n".join(["import kinlib as kl", *rows, f"], convention={table.convention!r}{extra})"]),
        "Robotics Toolbox": _in_the_toolbox(table, f"# {says} radians"),
    }


def _in_the_toolbox(table: DHTable, says: str) -> str:
    """Write a table for the Robotics Toolbox; as that has no fixed rows, frames are assigned to an arm with such rows."""
    if "F" in table.joints:
        table = assign_frames(table.to_chain(), table.convention).table
        says += "; new frames, because no row can be fixed"
    end = {"standard": "DH", "modified": "MDH"}[table.convention]
    kinds = [{"P": "Prismatic", "R": "Revolute"}[letter] + end for letter in table.joints]
    links = []
    for kind, sign, row in zip(kinds, table.signs, table.rows.tolist(), strict=True):
        a, alpha, d, theta = (format_number(x, PRINTED_DIGITS) for x in row)
        values = f"theta={theta}, offset={d}" if kind[0] == "P" else f"d={d}, offset={theta}"
        links.append(f"    {kind}(a={a}, alpha={alpha}, {values}{', flip=True' * bool(sign < 0)}),")
    ends = [f",\n    {name}=SE3({format_matrix(T, PRINTED_DIGITS)}, check=False)" for name, T in _ends(table).items()]
    names = ", ".join(["DHRobot", *sorted({*kinds})])
    imports = f"from roboticstoolbox import {names}\nfrom spatialmath import SE3"
    return "\n".join([imports, says, "robot = DHRobot([", *links, f"]{''.join(ends)})"])


def examine(
    arm: str | Chain | DHTable = "", table: str | DHTable = "", *, base: str = "", tip: str = "", **how: Any
) -> Examination:
    r"""Read an arm and a table, and compare them.

    arm    the path or the text of a URDF file, the name of an arm in KNOWN, a chain; or "" for none
    table  the text of a table as it was pasted; or "" for none
    base, tip  the links of the file between which the arm is; by default the root, and the end of the arm without a gripper
    how    what the text of the table does not say, as `read_table` takes it: convention, order, length_unit, angle_unit, joints

    >>> pasted = "a alpha d\n0 90 0.1625\n0.425 0 0\n-0.3922 0 0\n0 90 0.1333\n0 -90 0.0997\n0 0 0.0996"
    >>> print(examine("UR5e", pasted).explanations[0].faults[0].text)
    Row 2: a has the wrong sign.
    """
    found = Examination()
    try:
        if arm != "":
            chain, notes, visuals = _read_arm(arm, base, tip)
            found = replace(found, arm=chain, notes=notes, visuals=visuals)
        if table != "":
            said = {key: value for key, value in how.items() if value}
            read = (table, ()) if isinstance(table, DHTable) else read_table(table, **said)
            found = replace(found, table=read[0], assumed=read[1])
    except (ValueError, OSError) as error:
        return replace(found, unread=str(error))
    if found.arm is None or found.table is None or found.arm.n != found.table.n:
        return found
    return replace(found, free=diagnose(found.table, found.arm), strict=diagnose(found.table, found.arm, CHOICES))


def practise(arm: str | Chain | DHTable | Examination, student: str, *, base: str = "", tip: str = "") -> OpenSheet:
    """Make the exercise sheet of an arm, as `kincourse new-sheet` does, with the numbers of a student.

    arm, base, tip  as `examine` takes them, or what it returned

    Raises ValueError if there is no arm, or if it cannot be read.

    >>> list(practise("UR5e", "ada").problem(1).given)
    ['T_sr', 'T_rf', 'T_fb']
    """
    found = arm if isinstance(arm, Examination) else examine(arm, base=base, tip=tip)
    chain = found.arm or (found.table.to_chain() if found.table else None)
    if chain is None:
        raise ValueError(f"An exercise sheet needs a robot. {found.sentence}")
    return OpenSheet(robot_sheet("your_robot", with_plain_name(chain)), student)


def _read_arm(arm: str | Chain | DHTable, base: str, tip: str) -> tuple[Chain, list[str], tuple[Tree, str] | None]:
    if isinstance(arm, Chain):
        return arm, [], None
    if isinstance(arm, DHTable) or arm in KNOWN:
        table, source = (arm, "") if isinstance(arm, DHTable) else KNOWN[arm]
        chain = table.to_chain().changed(name="arm" if isinstance(arm, DHTable) else arm)
        return chain, [f"Source: {source}"] * bool(source), None
    if "<" not in arm and not arm.strip().endswith((".urdf", ".xml")):
        raise ValueError(f"{arm!r:.60} is neither a URDF file nor a known arm. Known are {', '.join(KNOWN)}.")
    chain, tree = load_urdf(arm, base or None, tip or None), Tree.from_urdf(arm)
    base, tip = base or tree.root, tip or tree.default_tip(base or None)
    counts = {end: sum(joint.moves for joint, _ in tree.path(base, end)) for end in tree.tips if end != tip}
    ends = [f"{end} ({count} joint{'s'[: count != 1]})" for end, count in counts.items()]
    notes = [f"The arm is from link {base} to link {tip}: {', '.join(chain.joint_names or ())}."]
    others = [name for name in tree.joint_names if name not in (chain.joint_names or ())]
    spans = np.zeros(chain.n) if chain.limits is None else np.ptp(chain.limits, axis=1)
    joints = zip(chain.joint_names, chain.joint_types, spans, strict=True)
    turns = [name for name, letter, span in joints if letter == "R" and 8 * np.pi < span < np.inf]
    lists = {
        "Other ends of the file, if yours is one of them": ends,
        "Joints that are not on the way are left at 0": others,
        "Joints whose limits are more than four turns apart, perhaps in degrees; a URDF has radians": turns,
    }
    for text, names in lists.items():
        notes += [f"{text}: {', '.join(names[:12])}{' and more' * (len(names) > 12)}."] * bool(names)
    return chain, notes, (tree, base)
