"""A quiz on DH tables: a random arm at each click, and a table that is judged by equivalence of mechanisms."""

import secrets
from functools import partial

from kincourse.answers.dh_table import DHTableAnswer
from kincourse.sampling.arms import ArmSampler
from kincourse.text.joint_table import joint_table
from kinlib.dh.assignment import assign_frames
from kinlib.dh.slips import OTHER_CONVENTION
from kinlib.dh.table import Convention, validate_convention
from kinlib.view import draw_joints
from misstep.display.card import TONES, Card
from misstep.judge import Judgement, judge
from misstep.mistakes import Mistake
from misstep.problem import Problem

JOINT_TYPES = ("RR", "RRR", "RPR", "RRP", "PRR", "RPRR", "RRPR", "RRRR")
"""The types of the joints of the arms, from base to tool."""

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
    misread = assign_frames(arm, convention=OTHER_CONVENTION[convention]).table.changed(convention=convention)
    return Problem(
        statement=f"Give a DH table of this arm in the {convention} convention. {FREE}\n\n{joint_table(arm)}",
        figure=partial(draw_joints, arm),
        answer=DHTableAnswer(table),
        mistakes=[
            Mistake(
                "the other convention",
                misread,
                "This is a table of the arm, in the other convention. Where does a row begin: with the joint, or with the link?",
            )
        ],
    )


class Quiz:
    """One arm after the other, with a text box for its table. Jupyter displays it as a widget.

    right, asked   the number of arms with a right table, and the number of arms drawn so far
    """

    def __init__(self, convention: Convention, seed: str | None = None) -> None:
        import ipywidgets as widgets  # not installed where sheets are graded

        self.convention = validate_convention(convention)
        self.seed = seed if seed is not None else secrets.token_hex(8)
        self.asked = 0
        self.right = 0
        self._solved = False
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
        self._solved = False
        self.problem = draw_problem(f"{self.seed}/{self.asked}", self.convention)
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
        lines = [finding.text for finding in judgement.findings]
        self._feedback_box.value = Card(
            judgement.state, TONES[judgement.state][2], [*lines, f"{self.right} right of {self.asked}."]
        ).html()
        return judgement

    def _repr_mimebundle_(self, **options: object) -> dict[str, object]:
        seen = {"text/plain": self.problem.statement, "text/html": self._statement_box.value}  # without widgets
        bundle: dict[str, object] = {**self._layout._repr_mimebundle_(**options), **seen}
        return bundle


def quiz(convention: Convention, seed: str | None = None) -> Quiz:
    """Start a quiz on DH tables: a random arm at each click, and a table to type, judged by equivalence of mechanisms.

    seed  the same seed draws the same arms; by default each quiz draws different ones

    Raises ValueError if the convention is neither "standard" nor "modified".

    >>> quiz("modified", seed="class of 2026").check("a | alpha | d | theta").state
    'unreadable'
    """
    return Quiz(convention, seed)
