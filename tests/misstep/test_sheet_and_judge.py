"""The engine of the sheets: drawing variants, reading and judging answers, on small problems."""

from dataclasses import dataclass

import numpy as np
import pytest

from misstep.answers.base import Unreadable
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.order import Ordering
from misstep.judge import Finding, Judgement, judge
from misstep.mistakes import mistake
from misstep.problem import Problem, problem
from misstep.sampling import Sampler
from misstep.sheet import OpenSheet, Sheet
from misstep.verdict import Verdict, _finding_text


@dataclass(frozen=True, eq=False)
class Rows(Numbers):
    """Rows of numbers; each row is a part. They have no slips, so that the mistakes of a problem are the only ones."""

    @property
    def parts(self):
        return [f"row {i + 1}" for i in range(len(self.value))]

    def slips(self):
        return ()

    def hint(self, given, part):
        first, second = np.isclose(given[part], self.value[part]).reshape(2, 3).all(axis=1)
        return "Its first half is right." if first else "Its second half is right." if second else ""

    def part_indices(self):
        return list(range(len(self.value)))


def two_rows(mistakes):
    return Problem("Give both.", Rows(np.array([[0, 0, 1, 0, -2, 0], [0, 1, 0, 3, 0, 0.0]])), mistakes)


NEGATED = mistake(
    "negated",
    np.array([[0, 0, -1, 0, 2, 0], [0, -1, 0, -3, 0, 0.0]]),
    "You reversed the axes.",
    part="This row has the opposite sign.",
)
SHIFTED = mistake(
    "shifted",
    np.array([[0, 0, 1, 0, -1, 0], [0, 1, 0, 4, 0, 0.0]]),
    "You moved the points.",
    part="This point is moved.",
)


def test_the_numbers_of_a_student_never_change():
    """If these numbers change, every student who is working on a sheet gets other problems."""
    draw = Sampler("ada", "03.1")
    assert [draw.integer(1, 100) for _ in range(6)] == [96, 41, 10, 90, 95, 7]


def test_right_blank_and_unreadable_answers_are_judged_in_all_parts():
    p = two_rows([NEGATED])
    parts = ["row 1", "row 2"]
    expected = "Expected an array of shape (2, 6)"
    assert judge(p, p.answer.value) == Judgement("right", 1.0, parts, [])
    blank = Finding(parts, f"{expected.replace('ted', 'ted:', 1)}.")
    assert judge(p, ...) == judge(p, None) == Judgement("blank", 0.0, (), [blank])
    unreadable = Finding(parts, f"{expected}; got a list of shape (2,).")
    assert judge(p, [1, 2]) == Judgement("unreadable", 0.0, (), [unreadable])


def test_a_mistake_in_all_parts_is_one_finding_and_each_unexplained_part_is_one():
    p = two_rows([SHIFTED, NEGATED])
    whole = Finding(["row 1", "row 2"], "You reversed the axes.", "negated", (("negated",),))
    assert judge(p, NEGATED.value) == Judgement("wrong", 0.0, [], [whole])
    unforeseen = judge(p, [[0, 1, 0, 0, -2, 0], [1, 0, 0, 3, 0, 0]])
    hint = "Its second half is right."
    assert unforeseen == Judgement("wrong", 0.0, [], [Finding(["row 1"], hint), Finding(["row 2"], hint)])
    nowhere = judge(p, np.full((2, 6), 9.0)).findings[0].message
    assert nowhere.startswith("None of the mistakes that we know gives this.")


def test_a_mistake_in_one_part_is_named_for_that_part():
    p = two_rows([NEGATED, SHIFTED])
    judgement = judge(p, [p.answer.value[0], NEGATED.value[1]])
    assert (judgement.state, judgement.fraction) == ("partly", 0.5)
    assert judgement.right_parts == ["row 1"]
    [finding] = judgement.findings
    assert (finding.parts, finding.mistake, finding.message) == (
        ["row 2"],
        "negated",
        "This row has the opposite sign.",
    )


def test_two_mistakes_in_two_parts_are_both_named():
    p = two_rows([NEGATED, SHIFTED])
    both = judge(p, [SHIFTED.value[0], NEGATED.value[1]])
    assert [(finding.parts, finding.mistake, finding.message) for finding in both.findings] == [
        (["row 1"], "shifted", "This point is moved."),
        (["row 2"], "negated", "This row has the opposite sign."),
    ]
    half = judge(p, [SHIFTED.value[0], [0, 1, 0, 9, 9, 9]])
    assert [finding.mistake for finding in half.findings] == ["shifted", None]


def test_an_unexplained_part_gets_a_hint():
    p = two_rows([NEGATED])
    judgement = judge(p, [p.answer.value[0], [0, 1, 0, 9, 9, 9]])
    assert judgement.mistakes == []
    assert judgement.findings[0].message == "Its first half is right."


def test_a_mistake_without_a_text_for_a_part_explains_only_whole_answers():
    p = two_rows([mistake("negated", NEGATED.value, "You reversed all axes.")])
    assert judge(p, NEGATED.value).mistakes == ["negated"]
    assert judge(p, [p.answer.value[0], NEGATED.value[1]]).mistakes == []


def test_a_variant_in_which_a_mistake_is_right_is_drawn_again():
    @problem("99.1", "A sign", points=1, lecture="none#none")
    def sign(draw):
        x = draw.integer(0, 1)
        return Problem(f"{x}", Numbers(np.array(float(x))), [mistake("sign", np.array(-float(x)), "Sign.")])

    assert {sign.variant(f"s{i}").statement for i in range(50)} == {"1"}


def test_a_problem_that_is_always_degenerate_is_refused():
    @problem("99.2", "Nothing to get wrong", points=1, lecture="none#none")
    def degenerate(draw):
        return Problem("", Numbers(np.array(0.0)), [mistake("sign", np.array(-0.0), "Sign.")])

    with pytest.raises(ValueError, match=r"Problem 99.2.*wider range"):
        degenerate.variant("ada")


def test_a_mistake_of_another_shape_is_refused_when_the_problem_is_made():
    with pytest.raises(ValueError, match=r"shape \(2, 6\).*shape \(6,\)"):
        two_rows([mistake("one row", np.zeros(6), "?")])


@pytest.mark.parametrize(
    ("answer", "given", "words"),
    [
        (Numbers(np.eye(3, 6)), np.eye(6, 3), "Rows and columns are swapped: try .T"),
        (Numbers(np.array(1.0), "m"), "1.0", "one number in m"),
        (Numbers(np.array(1.0), "m"), 1e308, r"got 1e\+308. Was there a division by almost zero"),
        (Numbers(np.eye(4)), np.eye(4) - 1e13, r"got 1e\+13. Was there"),
        (Ordering(["e_a", "M"]), ["e_a"], "M is missing"),
        (Ordering(["e_a", "M"]), ["e_a", "e_b"], "'e_b' is none of them"),
        (Ordering(["e_a", "M"]), "e_aM", "a list of the 2 names"),
        (Choice("a", {"a": "left", "b": "right"}), "c", "one of 'a', 'b'"),
    ],
)
def test_an_unreadable_value_is_refused_with_a_remedy(answer, given, words):
    with pytest.raises(Unreadable, match=words):
        answer.read(given)


class Rude:
    """An object that raises an error when it is converted to a number."""

    def __add__(self, other):
        raise RuntimeError("no")


PAIR = Numbers(np.zeros(2), "m")


@pytest.mark.parametrize(
    ("answer", "given", "message"),
    [
        (PAIR, [[1], [2, 3]], "Expected an array of shape (2,) in m; got a list whose rows differ in length."),
        (PAIR, 7, "Expected an array of shape (2,) in m; got int 7."),
        (PAIR, [Rude(), Rude()], "Expected an array of shape (2,) in m; got a list that does not turn into numbers."),
        (Numbers(np.array(0.0)), (), "Expected one number; got a tuple of shape (0,)."),
        (
            Numbers(np.zeros((4, 3, 2))),
            np.zeros((2, 3, 4)),
            "Expected an array of shape (4, 3, 2); got an ndarray of shape (2, 3, 4). The count of numbers is right",
        ),
        (
            PAIR,
            [np.nan, 0],
            "Expected an array of shape (2,) in m. Your answer contains NaN or infinity at index [0]. ",
        ),
        (
            Ordering(["e_a", "M"]),
            ["M", "e_a"] * 10,
            "Expected a list of the 2 names M, e_a, each once; e_a appears 10 times.",
        ),
        (Ordering(["e_a", "M"]), ["M"] * 21, "Expected a list of the 2 names M, e_a, each once; got list ['M', 'M', "),
        (Choice("a", {"a": "left", "b": "right"}), " " * 99 + "a", "Expected one of 'a', 'b'; got str '   "),
    ],
)
def test_the_message_for_an_unreadable_value_says_what_was_expected_and_given(answer, given, message):
    with pytest.raises(Unreadable) as refusal:
        answer.read(given)
    assert str(refusal.value).startswith(message)


def test_numbers_are_read_up_to_the_largest_one():
    assert PAIR.read([1e12, -1e12]).tolist() == [1e12, -1e12]
    assert Numbers(np.zeros((0, 6))).read(np.zeros((0, 6))).shape == (0, 6)


def test_orders_and_choices_are_judged():
    order = Ordering(["e_a", "M"])
    assert [judge(Problem("", order, []), given).state for given in (["e_a", "M"], ("e_a", "M"), ["M", "e_a"])] == [
        *("right", "right", "wrong")
    ]
    assert judge(Problem("", order, []), ["M", "e_a"]).findings[0].message == "Your order is the right one, reversed."
    choice = Choice("b", {"a": "left", "b": "right"})
    assert [judge(Problem("", choice, []), given).state for given in ("b", " B\n", " " * 98 + "b", "a")] == [
        *("right", "right", "right", "wrong")
    ]


def test_a_card_names_score_mistake_and_section():
    @problem("99.3", "Two rows", points=4, lecture="01_ohm#Currents")
    def template(draw):
        return two_rows([NEGATED])

    p = template.variant("ada")
    text = Verdict(template, judge(p, [p.answer.value[0], NEGATED.value[1]]))._repr_mimebundle_()["text/plain"]
    assert "Partly right" in text
    assert "2 of 4 points" in text
    assert "Row 2: This row has the opposite sign." in text
    assert "lecture 01_ohm, section “Currents”" in text


def test_findings_of_a_card_are_in_the_order_of_the_parts():
    @problem("99.3", "Two rows", points=1, lecture="01_ohm#Currents")
    def template(draw):
        swapped = mistake("swapped", NEGATED.value[::-1], "A whole.", "This row is swapped.")
        return two_rows([NEGATED, swapped])

    p = template.variant("ada")
    for row_1, row_2 in [(p.mistakes[1], p.mistakes[0]), (p.mistakes[0], p.mistakes[1])]:
        verdict = Verdict(template, judge(p, [row_1.value[0], row_2.value[1]]))
        assert [line.partition(":")[0] for line in verdict.card.text().splitlines()[2:]] == [
            "  Row 1",
            "  Row 2",
            "  Re-read",
        ]
        assert verdict.judgement.mistakes == [row_1.name, row_2.name]


@pytest.mark.parametrize(
    ("parts", "begins"),
    [(["row 2"], "Row 2: "), (["q_2", "the rate"], "q_2 and the rate: "), (["$L$"], "$L$: ")],
)
def test_a_symbol_keeps_its_letter_where_a_part_begins_a_sentence(parts, begins):
    assert _finding_text(Finding(parts, "It is wrong."), is_on_whole=False) == f"{begins}It is wrong."


class Remarked(Numbers):
    """Numbers with a remark on every right answer."""

    def remark(self, given):
        return "You wrote it in another form."


def test_a_remark_on_a_right_answer_is_no_mistake_and_nothing_to_reread():
    @problem("99.4", "A number", points=2, lecture="01_ohm#Currents")
    def template(draw):
        return Problem("", Remarked(np.array(2.0)))

    sheet = OpenSheet(Sheet("01_ohm", "Ohm", [template]), "ada")
    verdict = sheet.check(1, 2)
    assert verdict.card.text() == "✓ Problem 99.4: Right\n  2 of 2 points.\n  You wrote it in another form."
    assert verdict.judgement.mistakes == []
    assert sheet.tally().recurrences == []
    assert "2 of 2 | right" in repr(sheet.tally()) == sheet.tally()._repr_markdown_()
