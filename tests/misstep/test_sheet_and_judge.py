"""The engine of the sheets: drawing, reading, judging, on problems small enough to see through."""

from array import array

import numpy as np
import pytest

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.robots import youbot
from misstep.answers.base import Unreadable
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.order import Ordering
from misstep.judge import Finding, Judgement, judge
from misstep.mistakes import mistake
from misstep.problem import Problem
from misstep.verdict import Verdict


def two_screws(mistakes):
    return Problem("Give both.", ScrewsAnswer(np.array([[0, 0, 1, 0, -2, 0], [0, 1, 0, 3, 0, 0.0]])), mistakes)


NEGATED = mistake("negated", np.array([[0, 0, -1, 0, 2, 0], [0, -1, 0, -3, 0, 0.0]]), "You turned the axes round.")
SHIFTED = mistake("shifted", np.array([[0, 0, 1, 0, -1, 0], [0, 1, 0, 4, 0, 0.0]]), "You moved the points.")


def test_draws_are_the_same_for_ever():
    """These numbers were written down once. If they change, every student in the middle of a sheet gets another one."""
    draw = ArmSampler("ada", "03.1")
    assert [draw.integer(1, 100) for _ in range(6)] == [96, 41, 10, 90, 95, 7]


def test_right_blank_and_unreadable_are_told_for_every_part():
    p = two_screws([NEGATED])
    parts = ["screw 1", "screw 2"]
    expected = "Expected screw axes (omega, v), an array of shape (2, 6)"
    assert judge(p, p.answer.value) == Judgement("right", 1.0, parts, ())
    blank = Finding(parts, f"{expected.replace('ted', 'ted:', 1)}.")
    assert judge(p, ...) == judge(p, None) == Judgement("blank", 0.0, (), [blank])
    unreadable = Finding(parts, f"{expected}; got a list of shape (2,).")
    assert judge(p, [1, 2]) == Judgement("unreadable", 0.0, (), [unreadable])


def test_a_mistake_in_the_whole_is_one_finding_and_what_nobody_foresaw_is_one_a_part():
    p = two_screws([SHIFTED, NEGATED])
    whole = Finding(["screw 1", "screw 2"], "You turned the axes round.", "negated")
    assert judge(p, NEGATED.value) == Judgement("wrong", 0.0, [], [whole])
    unforeseen = judge(p, [[0, 1, 0, 0, -2, 0], [1, 0, 0, 3, 0, 0]])
    hint = "Its v is right, its omega is not."
    assert unforeseen == Judgement("wrong", 0.0, [], [Finding(["screw 1"], hint), Finding(["screw 2"], hint)])
    nowhere = judge(p, np.full((2, 6), 9.0)).findings[0].message
    assert nowhere.startswith("None of the mistakes that we know gives this.")


def test_a_mistake_in_one_part_is_named_for_that_part():
    p = two_screws([NEGATED, SHIFTED])
    judgement = judge(p, [p.answer.value[0], NEGATED.value[1]])
    assert (judgement.state, judgement.fraction) == ("partly", 0.5)
    assert judgement.right_parts == ["screw 1"]
    assert [(list(f.parts), f.mistake) for f in judgement.findings] == [(["screw 2"], "negated")]


def test_two_mistakes_in_two_parts_are_both_named():
    p = two_screws([NEGATED, SHIFTED])
    assert judge(p, [SHIFTED.value[0], NEGATED.value[1]]).mistakes == ["shifted", "negated"]
    half = judge(p, [SHIFTED.value[0], [0, 1, 0, 9, 9, 9]])
    assert [finding.mistake for finding in half.findings] == ["shifted", None]


def test_an_unforeseen_answer_still_gets_a_foothold():
    p = two_screws([NEGATED])
    judgement = judge(p, [p.answer.value[0], [0, 1, 0, 9, 9, 9]])
    assert judgement.mistakes == []
    assert judgement.findings[0].message == "Its omega is right, its v is not."


def test_an_answer_rounded_on_the_way_is_told_so():
    p = Problem("How far?", Numbers(np.array(0.7071), "m"), [mistake("sign", np.array(-0.7071), "Wrong way.")])
    assert "looks rounded" in judge(p, 0.7).findings[0].message
    assert judge(p, 0.707).state == "right"


def test_a_pose_that_is_no_pose_is_told_so():
    p = Problem("Where?", PoseAnswer(youbot().home), [])
    judgement = judge(p, 2 * youbot().home)
    assert "no rotation at all" in judgement.findings[0].message


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


def test_a_mistake_of_another_shape_is_refused_when_the_problem_is_written():
    with pytest.raises(ValueError, match=r"shape \(2, 6\).*shape \(6,\)"):
        two_screws([mistake("one row", np.zeros(6), "?")])


@pytest.mark.parametrize(
    ("answer", "given", "words"),
    [
        (ScrewsAnswer(np.eye(3, 6)), np.eye(6, 3), "Rows and columns are swapped: try .T"),
        (ScrewsAnswer(np.eye(1, 6)[0]), [0, 0, 1], "is the other half missing"),
        (ScrewsAnswer(np.eye(3, 6)), np.zeros(18), "arrangement is not"),
        (Numbers(np.array(1.0), "m"), "1.0", "one number in m"),
        (Numbers(np.array(1.0), "m"), 1e308, r"got 1e\+308. Was there a division by almost zero"),
        (PoseAnswer(np.eye(4)), np.eye(4) - 1e13, r"got 1e\+13. Was there"),
        (Ordering(["e_a", "M"]), ["e_a"], "M appears 0 times"),
        (Ordering(["e_a", "M"]), ["e_a", "e_b"], "'e_b' is none of them"),
        (Ordering(["e_a", "M"]), "e_aM", "a list of the 2 names"),
        (Choice("a", {"a": "left", "b": "right"}), "c", "one of 'a', 'b'"),
    ],
)
def test_what_cannot_be_read_is_refused_with_the_remedy(answer, given, words):
    with pytest.raises(Unreadable, match=words):
        answer.read(given)


class Rude:
    """What raises when it is asked for a number."""

    def __add__(self, other):
        raise RuntimeError("no")


PAIR = Numbers(np.zeros(2), "m")


@pytest.mark.parametrize(
    ("answer", "given", "said"),
    [
        (PAIR, [[1], [2, 3]], "Expected an array of shape (2,) in m; got a list whose rows differ in length."),
        (PAIR, np.zeros(3), "Expected an array of shape (2,) in m; got an ndarray of shape (3,)."),
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
            "Expected an array of shape (2,) in m. Your answer holds NaN or infinity at index [0]. ",
        ),
        (ScrewsAnswer(np.eye(1, 6)[0]), 0, "Expected a screw axis (omega, v), an array of shape (6,); got int 0."),
        (
            Ordering(["e_a", "M"]),
            ["M", "e_a"] * 10,
            "Expected a list of the 2 names M, e_a, each once; e_a appears 10 times.",
        ),
        (Ordering(["e_a", "M"]), [7], "Expected a list of the 2 names M, e_a, each once; int 7 is none of them. "),
        (Ordering(["e_a", "M"]), ["M"] * 21, "Expected a list of the 2 names M, e_a, each once; got list ['M', 'M', "),
        (Choice("a", {"a": "left", "b": "right"}), 7, "Expected one of 'a', 'b'; got int 7."),
        (Choice("a", {"a": "left", "b": "right"}), " " * 99 + "a", "Expected one of 'a', 'b'; got str '   "),
    ],
)
def test_what_cannot_be_read_is_told_word_for_word_what_was_expected_and_what_came(answer, given, said):
    with pytest.raises(Unreadable) as refusal:
        answer.read(given)
    assert str(refusal.value).startswith(said)


@pytest.mark.parametrize(
    ("answer", "given", "came"),
    [
        (ScrewsAnswer(np.eye(3, 6)), np.zeros((2, 6)), "an ndarray of shape (2, 6)"),
        (ScrewsAnswer(np.eye(1, 6)[0]), 0, "int 0"),
        (ScrewsAnswer(np.eye(1, 6)[0]), np.zeros(5), "an ndarray of shape (5,)"),
        (PAIR, (1, 2, 3), "a tuple of shape (3,)"),
        *(
            (PAIR, type(name, (list,), {})([1]), f"{a} {name} of shape (1,)")
            for a, name in [("an", "Odd"), ("a", "Xs")]
        ),
        (PAIR, array("d", [1]), "an array of shape (1,)"),
    ],
)
def test_a_remedy_is_told_where_there_is_one_and_nowhere_else(answer, given, came):
    with pytest.raises(Unreadable) as refusal:
        answer.read(given)
    assert str(refusal.value) == f"Expected {answer.expected}; got {came}."


def test_what_is_read_may_be_as_large_as_any_and_empty():
    assert PAIR.read([1e12, -1e12]).tolist() == [1e12, -1e12]
    assert ScrewsAnswer(np.zeros((0, 6))).read(np.zeros((0, 6))).shape == (0, 6)


@pytest.mark.parametrize(
    ("right", "near", "far"),
    [(0, 9e-4, 1.1e-3), (0.5, 0.5009, 0.5011), (1, 1.0009, 1.0015), (-1000, -1000.9, -1001.1)],
)
def test_a_number_may_be_off_by_a_thousandth_of_itself_or_of_1(right, near, far):
    answer = Numbers(np.array(float(right)))
    assert answer.agrees(np.array(float(near)), answer.value) == answer.agrees(answer.value, np.array(near)) == [True]
    assert answer.agrees(np.array(float(far)), answer.value) == answer.agrees(answer.value, np.array(far)) == [False]


def test_names_are_put_in_order_and_options_are_chosen():
    order = Ordering(["e_a", "M"])
    assert [judge(Problem("", order, []), given).state for given in (["e_a", "M"], ("e_a", "M"), ["M", "e_a"])] == [
        *("right", "right", "wrong")
    ]
    assert judge(Problem("", order, []), ["M", "e_a"]).findings[0].message.startswith("None of the mistakes")
    choice = Choice("b", {"a": "left", "b": "right"})
    assert [judge(Problem("", choice, []), given).state for given in ("b", " B\n", " " * 98 + "b", "a")] == [
        *("right", "right", "right", "wrong")
    ]


TURN = np.array([[0.0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])


def turned(R, p=(1, 2, 3)):
    T = TURN.copy()
    T[:3, :3], T[:3, 3] = R, p
    return T


@pytest.mark.parametrize(
    ("given", "right_parts", "hints"),
    [
        (TURN, ["rotation", "position"], []),
        (turned(TURN[:3, :3], (9, 9, 9)), ["rotation"], [False]),
        (turned(np.eye(3)), ["position"], [False]),
        (turned(2 * np.eye(3)), ["position"], [True]),
        (turned([[0.87, -0.5, 0], [0.5, 0.87, 0], [0, 0, 1]]), ["position"], [False]),
        (turned(np.diag([1, 1, -1])), ["position"], [True]),
        (turned(2 * np.eye(3), (9, 9, 9)), [], [True, False]),
    ],
)
def test_a_pose_is_judged_by_rotation_and_position_and_what_is_no_rotation_is_told_so(given, right_parts, hints):
    judgement = judge(Problem("", PoseAnswer(TURN), []), given)
    assert list(judgement.right_parts) == right_parts
    assert ["no rotation at all" in finding.message for finding in judgement.findings] == hints


@pytest.mark.parametrize(
    ("row", "right_parts"),
    [
        ((0, 0, 0, 0), ["rotation"]),
        ((0, 0.5, 0, 1), ["position"]),
        ((1, 2, 3, 4), []),
        ((0, 0, 0, 1.0005), ["rotation", "position"]),
    ],
)
def test_a_pose_ends_in_a_row_of_its_own(row, right_parts):
    judgement = judge(Problem("", PoseAnswer(TURN), []), [*TURN[:3].tolist(), row])
    assert list(judgement.right_parts) == right_parts
    assert all(finding.message.startswith("The last row of a pose is 0 0 0 1") for finding in judgement.findings)


def test_a_pose_that_is_wrong_and_no_more_is_told_nothing_of_its_form():
    given = turned(np.eye(3), (9, 9, 9))
    given[3, 3] = 1.0005
    for finding in judge(Problem("", PoseAnswer(TURN), []), given).findings:
        assert finding.message.startswith("None of the mistakes")


def test_a_screw_is_told_which_half_is_right_if_one_is():
    right = np.array([0, 0, 1, 0, -2, 0.5])
    problem = Problem("", ScrewsAnswer(right), [])
    assert problem.answer.parts == ["screw 1"]
    told = {
        (0, 0, 1, 9, -2, 0.5): "Its omega is right, its v is not.",
        (0, 0.0005, 1, 9, -2, 0.5): "Its omega is right, its v is not.",
        (0, 1, 0, 0, -2, 0.5): "Its v is right, its omega is not.",
        (0, 1, 0, 9, -2, 0.5): "None of the mistakes",
    }
    for given, words in told.items():
        assert judge(problem, given).findings[0].message.startswith(words)


def test_a_list_of_lists_of_the_right_shape_is_as_good_as_an_array():
    assert judge(two_screws([]), [[0, 0, 1, 0, -2, 0], [0, 1, 0, 3, 0, 0]]).state == "right"


def test_a_card_names_score_mistake_and_section():
    @problem("99.3", "Two screws", points=4, lecture="03_poe_space#Revolute joints")
    def template(draw):
        return two_screws([NEGATED])

    p = template.variant("ada")
    text = Verdict(template, judge(p, [p.answer.value[0], NEGATED.value[1]]))._repr_mimebundle_()["text/plain"]
    assert "Partly right" in text
    assert "2 of 4 points" in text
    assert "Screw 2: You turned the axes round." in text
    assert "lecture 03_poe_space, section “Revolute joints”" in text
