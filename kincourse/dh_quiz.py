"""A quiz on DH tables: a random arm at each click, and a table that is judged by equivalence of mechanisms.

Of several random arms, the next one is that which best tells the mistakes apart that still explain what the student did, as
a teacher would choose the next exercise.
"""

import secrets
from collections.abc import Collection, Iterator
from functools import partial

from kincourse.answers.dh_table import DHTableAnswer
from kincourse.mistakes.dh import z_on_the_wrong_joint
from kincourse.sampling.arms import ArmSampler
from kincourse.text.joint_table import joint_table
from kinlib.arrays.tolerances import EQUIVALENCE_TOL
from kinlib.dh.assignment import assign_frames
from kinlib.dh.diagnosis import diagnose
from kinlib.dh.slips import tables_with_a_slip
from kinlib.dh.table import Convention, DHTable, validate_convention
from kinlib.view import draw_joints
from misstep.display.card import TITLES, Card
from misstep.judge import Judgement, judge
from misstep.mistakes import mistake
from misstep.problem import Problem

JOINT_TYPES = ("RR", "RRR", "RPR", "RRP", "PRR", "RPRR", "RRPR", "RRRR")
"""The types of the joints of the arms, from base to tool."""

CANDIDATES = 8
"""How many arms are drawn to choose one from."""

MISTAKES = (
    *("sign of a", "sign of alpha", "sign of d", "a and d swapped", "theta and alpha swapped", "column shifted"),
    *("variable in the wrong column", "other convention"),
)
"""The mistakes that may be suspected, by the names of `kl.diagnose`."""

CLEAR = 0.6
"""How well an arm must tell each suspected mistake from the others, so that no other arm is drawn."""

FREE = (
    "Only the mechanism is compared. You choose frame 0, the last frame, where each joint has its zero, and in which direction it "
    "is positive; a sheet gives these, and there a table that differs in them is wrong."
)
"""What the quiz leaves free, so that nobody takes a table that is right here for one that is right in a sheet."""

EMPTY_TABLE = "a | alpha | d | theta\n"
"""What the text box holds before anything is typed."""


def draw_problem(seed: str, convention: Convention) -> Problem:
    """Draw an arm whose DH table is asked for, the same one for the same seed.

    Raises ValueError if the convention is neither "standard" nor "modified".

    >>> draw_problem("one", "standard").answer.value.convention
    'standard'
    """
    sampler = ArmSampler(seed, "quiz")
    arm = sampler.arm(sampler.choice(JOINT_TYPES))
    table = assign_frames(arm, convention=validate_convention(convention)).table
    other: Convention = "modified" if convention == "standard" else "standard"
    misread = assign_frames(arm, convention=other).table.changed(convention=convention)
    return Problem(
        statement=f"Give a DH table of this arm in the {convention} convention. {FREE}\n\n{joint_table(arm)}",
        figure=partial(draw_joints, arm),
        answer=DHTableAnswer(table),
        mistakes=[
            mistake(
                "other convention",
                misread,
                "This is a table of the arm, in the other convention. Where does a row begin: with the joint, or with the link?",
            )
        ],
    )


def separation(problem: Problem, names: Collection[str]) -> dict[str, float]:
    """Return for each mistake how well this arm tells it from the others and from a right table, from 0 to 1.

    A table with the mistake, made once, counts 1/k if k of the mistakes lead to tables of the same arm, and 0 if it is right.
    The result is the mean.

    >>> separation(draw_problem("one", "standard"), ["other convention", "sign of a"])  # this arm has no a
    {'other convention': 1.0, 'sign of a': 0.0}
    """
    agrees, right = problem.answer.agrees, problem.answer.value
    kinds = [right]  # one table of each arm, the right one first
    found: dict[str, list[int]] = {name: [] for name in names}
    for name, table in wrong_tables(right):
        if name in found:
            kind = next((k for k, other in enumerate(kinds) if all(agrees(table, other))), len(kinds))
            kinds += [table] * (kind == len(kinds))
            found[name].append(kind)
    count = [sum(kind in reached for reached in found.values()) for kind in range(len(kinds))]
    return {
        name: sum(1 / count[kind] for kind in reached if kind) / max(len(reached), 1) for name, reached in found.items()
    }


def wrong_tables(table: DHTable) -> Iterator[tuple[str, DHTable]]:
    """Yield the names of mistakes, and the tables to which each of them leads from a right one where it is made once.

    >>> tables = wrong_tables(DHTable([[1, 0, 2, 0]], convention="standard"))
    >>> next(table.columns["a"] for name, table in tables if name == "a and d swapped")
    array([2.])
    """
    yield "other convention", z_on_the_wrong_joint(table)
    for row, letter in enumerate(table.joints):
        other = "P" if letter == "R" else "R"
        yield "variable in the wrong column", table.changed(joints=table.joints[:row] + other + table.joints[row + 1 :])
    yield from ((name, wrong) for name, wrong in tables_with_a_slip(table) if name in MISTAKES)


def draw_next(seed: str, convention: Convention, suspects: Collection[str]) -> Problem:
    """Draw arms until one tells the suspected mistakes apart; of CANDIDATES that do not, return the one that does it best."""
    drawn = []
    for k in range(CANDIDATES):
        problem = draw_problem(f"{seed}/{k}", convention)
        told = separation(problem, suspects).values()
        if all(value >= CLEAR for value in told):
            return problem
        drawn.append((sum(told), problem))
    return max(drawn, key=lambda pair: pair[0])[1]


def suspects_after(suspects: Collection[str], problem: Problem, table: DHTable) -> set[str]:
    """Return the mistakes that still explain what a student did, after the first table of an arm; none if any may.

    A right table excludes the mistakes that would have made it wrong. A wrong one leaves those that explain it.
    """
    if all(problem.answer.agrees(table, problem.answer.value)):
        return {name for name in suspects or MISTAKES if not separation(problem, [name])[name]}
    found = diagnose(table, problem.answer.value, tolerance=EQUIVALENCE_TOL, in_pairs=False)
    explaining = {fault.name for explanation in found.explanations for fault in explanation.faults} & {*MISTAKES}
    return explaining & set(suspects) or explaining or set(suspects)


class Quiz:
    """One arm after the other, with a text box for its table. Jupyter displays it as a widget.

    right, asked   the number of arms with a right table, and the number of arms drawn so far
    suspects       the mistakes that still explain what the student did; none if any may
    """

    def __init__(self, convention: Convention, seed: str | None = None) -> None:
        import ipywidgets as widgets  # not installed where sheets are graded

        self.convention = validate_convention(convention)
        self.seed = seed if seed is not None else secrets.token_hex(8)
        self.asked = 0
        self.right = 0
        self.suspects: set[str] = set()
        self._solved = self._read = False
        self._statement_box = widgets.HTML()
        self._table_box = widgets.Textarea(
            value=EMPTY_TABLE, description="Your table", layout=widgets.Layout(width="95%", height="9em")
        )
        self._feedback_box = widgets.HTMLMath()
        check = widgets.Button(description="Check", tooltip="Check the table that you have typed")
        another = widgets.Button(description="Another arm", tooltip="Draw another arm")
        check.on_click(lambda _: self.check(self._table_box.value))
        another.on_click(lambda _: self.another())
        self._layout = widgets.VBox(
            [self._statement_box, self._table_box, widgets.HBox([check, another]), self._feedback_box]
        )
        self.another()

    def another(self) -> None:
        """Draw the next arm."""
        self.asked += 1
        self._solved = self._read = False
        self.problem = draw_next(f"{self.seed}/{self.asked}", self.convention, self.suspects)
        figure = self.problem.figure() if self.problem.figure else None
        heading = Card("note", f"Arm {self.asked}", [f"Give a DH table in the {self.convention} convention. {FREE}"])
        self._statement_box.value = heading.html() + (figure.html() if figure else "")
        self._table_box.value = EMPTY_TABLE
        self._feedback_box.value = ""

    def check(self, typed: object) -> Judgement:
        """Judge a table and display the feedback. The same arm stays until `another` draws the next one."""
        judgement = judge(self.problem, ... if typed == EMPTY_TABLE else typed)
        if judgement.state == "right" and not self._solved:
            self._solved = True
            self.right += 1
        if judgement.state in {"right", "partly", "wrong"} and not self._read:
            self._read = True  # only the first table of an arm: feedback has explained the mistakes of the others
            self.suspects = suspects_after(self.suspects, self.problem, self.problem.answer.read(typed))
        lines = [finding.text for finding in judgement.findings]
        self._feedback_box.value = Card(
            judgement.state, TITLES[judgement.state], [*lines, f"{self.right} right of {self.asked}."]
        ).html()
        return judgement

    def _repr_mimebundle_(self, **options: object) -> dict[str, object]:
        text = f"A quiz on DH tables in the {self.convention} convention.\n{self.problem.statement}"
        bundle: dict[str, object] = {**self._layout._repr_mimebundle_(**options), "text/plain": text}
        return bundle


def quiz(convention: Convention, seed: str | None = None) -> Quiz:
    """Start a quiz on DH tables: a random arm at each click, and a table to type, judged by equivalence of mechanisms.

    seed  the same seed draws the same arms; by default each quiz draws different ones

    Raises ValueError if the convention is neither "standard" nor "modified".

    >>> quiz("modified", seed="class of 2026").check("a | alpha | d | theta").state
    'unreadable'
    """
    return Quiz(convention, seed)
