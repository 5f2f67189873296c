"""The engine of the sheets: drawing variants, reading and judging answers, on small problems."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from misstep.answers.number import Numbers
from misstep.diagnosis.explanation import Finding
from misstep.judge import STEP_BY_STEP, UNKNOWN, Judgement, judge
from misstep.mistakes import Mistake
from misstep.mutants.expression import given as of_solution
from misstep.problem import Problem, problem, templates_in
from misstep.sampling import Sampler
from misstep.sheet import OpenSheet, Sheet
from misstep.worked_solution import worked_solution


@dataclass(frozen=True, eq=False)
class Rows(Numbers):
    """Rows of numbers; each row is a part."""

    @property
    def parts(self):
        return [f"row {i + 1}" for i in range(len(self.value))]

    def order(self, given):
        return None

    def resemblance(self, given, part):
        first, second = np.isclose(given[part], self.value[part]).reshape(2, 3).all(axis=1)
        return ("", "Its first half is right.") if first else ("", "Its second half is right.") if second else None

    def part_indices(self):
        return list(range(len(self.value)))


def two_rows(mistakes):
    return Problem("Give both.", Rows(np.array([[0, 0, 1, 0, -2, 0], [0, 1, 0, 3, 0, 0.0]])), mistakes)


def template(make, number="01.1", points=1, **options):
    return problem(number, "A title", points=points, lecture="01_ohm#Currents", **options)(make)


def opened(drawn, **options):
    """A sheet with this one problem."""
    return OpenSheet(Sheet("01_ohm", "Ohm's law", [template(lambda _: drawn, **options)]), "ada")


NEGATED = Mistake(
    "negated",
    np.array([[0, 0, -1, 0, 2, 0], [0, -1, 0, -3, 0, 0.0]]),
    "This row has the opposite sign.",
    in_parts=True,
)
SHIFTED = Mistake(
    "shifted",
    np.array([[0, 0, 1, 0, -1, 0], [0, 1, 0, 4, 0, 0.0]]),
    "This point is moved.",
    in_parts=True,
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
    whole = Finding(["row 1", "row 2"], "This row has the opposite sign.", [p.mistakes[1]], is_method=True)
    assert judge(p, NEGATED.value) == Judgement("wrong", 0.0, [], [whole])
    assert whole.mistake == "negated"
    unforeseen = judge(p, [[0, 1, 0, 0, -2, 0], [1, 0, 0, 3, 0, 0]])
    assert unforeseen.findings[0].message == "Its second half is right."
    nowhere = [Finding([f"row {k}"], UNKNOWN, check=STEP_BY_STEP) for k in (1, 2)]
    assert judge(p, 9.0 + np.arange(12).reshape(2, 6) ** 2).findings == nowhere


def test_a_mistake_in_one_part_is_named_for_that_part():
    p = two_rows([NEGATED, SHIFTED])
    negated = (["row 2"], "negated", "This row has the opposite sign.")
    cases = [
        ([p.answer.value[0], NEGATED.value[1]], [negated]),
        ([SHIFTED.value[0], NEGATED.value[1]], [(["row 1"], "shifted", "This point is moved."), negated]),
        ([p.answer.value[0], [0, 1, 0, 9, 9, 9]], [(["row 2"], None, "Its first half is right.")]),
    ]
    for given, told in cases:
        judgement = judge(p, given)
        assert [(one.parts, one.mistake, one.message) for one in judgement.findings] == told
        assert (judgement.state, judgement.fraction) == (("partly", 0.5) if len(told) == 1 else ("wrong", 0.0))
        assert list(judgement.right_parts) == ["row 1"] * (len(told) == 1)
    half = judge(p, [SHIFTED.value[0], [0, 1, 0, 9, 9, 9]])
    assert [finding.mistake for finding in half.findings] == ["shifted", None]


def test_a_mistake_that_looks_like_the_right_answer_in_another_unit_is_left_out():
    """A card names the unit before any mistake, so that the mistake would have a message that no student reads."""
    values = {"in metres": 0.27102, "in centimetres": 27.1, "nothing": 0.0, "another distance": 280.0}
    ways = [Mistake(name, np.array(value), "A sentence.") for name, value in values.items()]
    drawn = Problem("How far?", Numbers(np.array(271.0), unit="mm"), ways).without_duplicates()
    assert [one.name for one in drawn.mistakes] == ["another distance"]
    assert judge(drawn, 280.0).mistakes == ["another distance"]


def test_a_problem_is_refused_for_an_answer_of_no_kind_a_mistake_of_another_shape_or_the_number_of_another():
    with pytest.raises(ValueError, match=r"shape \(2, 6\).*shape \(6,\)"):
        two_rows([Mistake("one row", np.zeros(6), "?")])
    with pytest.raises(ValueError, match=r"answer must be an Answer, such as Numbers\(\.\.\.\); got Expression"):
        Problem("How far?", of_solution("x", 1.0))
    with pytest.raises(ValueError, match=r"its own number; 01.1 is there twice"):
        templates_in(SimpleNamespace(one=template(two_rows), other=template(two_rows)))


def test_a_card_names_score_mistake_and_section_and_its_findings_are_in_the_order_of_the_parts():
    p = two_rows([NEGATED, Mistake("swapped", NEGATED.value[::-1], "This row is swapped.", in_parts=True)])
    sheet = opened(p, points=4)
    text = sheet.check(1, [p.answer.value[0], NEGATED.value[1]])._repr_mimebundle_()["text/plain"]
    said = (
        "Partly right",
        "2 of 4 points",
        "Row 2: This row has the opposite sign.",
        "section “Currents” of lecture 01",
    )
    assert all(words in text for words in said)
    for row_1, row_2 in [(p.mistakes[1], p.mistakes[0]), (p.mistakes[0], p.mistakes[1])]:
        verdict = sheet.check(1, [row_1.value[0], row_2.value[1]])
        begins = [line.partition(":")[0].strip() for line in verdict.card.text().splitlines()[2:]]
        assert begins == ["Row 1", "Row 2", "Re-read"]
        assert verdict.judgement.mistakes == [row_1.name, row_2.name]


class Remarked(Numbers):
    """Numbers with a remark on every right answer."""

    def remark(self, given):
        return "You wrote it in another form."


def test_a_remark_on_a_right_answer_is_no_mistake_and_nothing_to_reread():
    sheet = opened(Problem("", Remarked(np.array(2.0))), points=2)
    verdict = sheet.check(1, 2)
    assert verdict.card.text() == "✓ Problem 01.1: Right\n  2 of 2 points.\n  You wrote it in another form."
    assert (verdict.judgement.mistakes, sheet.tally().returning) == ([], [])
    assert "2 of 2 | right" in repr(sheet.tally()) == sheet.tally()._repr_markdown_()


def test_a_check_after_an_answer_cell_that_failed_judges_no_older_answer():
    """In IPython, as in JupyterLab: the variable still has the value of the run before."""
    from IPython.core.interactiveshell import InteractiveShell

    shell = InteractiveShell.instance()
    try:
        cells = ("from kincourse import open_sheet", "sheet = open_sheet('03_poe_space', 'ada')")
        for cell in (*cells, "screws_1 = sheet.problem(1).answer.value", "verdict = sheet.check(1, screws_1)"):
            assert shell.run_cell(cell).success
        assert shell.user_ns["verdict"].score == 2
        for broken, name in (("screws_1 = [1 / 0]", "ZeroDivisionError"), ("screws_1 = [1", "SyntaxError")):
            shell.run_cell(broken)
            assert shell.run_cell("verdict = sheet.check(1, screws_1)").success
            text = shell.user_ns["verdict"].card.text()
            assert "ended with an error" in text
            assert name in text
        shell.run_cell("screws_1 = 3", cell_id="answer-1")
        shell.run_cell("screw_1 = 4", cell_id="answer-1")  # misspelled
        shell.run_cell("verdict = sheet.check(1, screws_1)")
        assert "Your lines do not set `screws_1` any more." in shell.user_ns["verdict"].card.text()
    finally:
        InteractiveShell.clear_instance()


@pytest.mark.parametrize(("level", "place"), [("Usual", " Look at the sign of entry 3."), ("Hard", "")])
def test_the_first_card_tells_the_idea_and_the_second_one_the_place_unless_the_problem_is_hard(level, place):
    sheet = opened(Problem("Give all.", Numbers(np.array([1.0, -2.0, 4.0]))), level=level)
    sheet.check(1, None)
    first, second = (" ".join(map(str, sheet.check(1, [1, -2, -4]).card.body)) for _ in range(2))
    idea = "Apart from the signs, this is right."
    assert idea in first
    assert "entry" not in first
    assert second == first.replace(idea, idea + place)


def test_a_right_answer_is_followed_by_a_worked_solution_and_a_further_question():
    solution = of_solution("x", 6.0) / 2
    sheet = opened(Problem("Halve 6.", Numbers(np.array(3.0)), further="And a third?", solution=solution))
    assert sheet.check(1, 12).worked == ()
    further = "A further question: And a third?"
    assert sheet.check(1, 3).card.body[1:] == ["One way to it:", "$x = 6$", "$x / 2 = 3$", further]


def test_a_worked_solution_says_where_it_leaves_given_values_out():
    values = [of_solution(f"x_{{{k}}}", float(k)) for k in range(20)]
    first, *_ = worked_solution(Problem("", Numbers(np.array(190.0)), solution=sum(values[1:], values[0])))
    assert first.endswith(", and others")


def test_the_tally_names_a_mistake_that_returns_also_if_it_was_corrected():
    def half(sampler):
        x = sampler.integer(3, 9)
        wrong = [Mistake("sign", np.array(-x / 2), "A sentence.")]
        return Problem("Halve it.", Numbers(x / 2), wrong, given={"x": x}, solution=of_solution("x", float(x)) / 2)

    sheet = OpenSheet(Sheet("01_ohm", "Ohm's law", [template(half, f"01.{k}") for k in range(1, 5)]), "ada")
    x = {k: sheet.given(k).x for k in range(1, 5)}
    for k, answer in ((1, 2 * x[1]), (1, x[1] / 2), (2, 2 * x[2]), (3, -x[3] / 2), (4, ...)):
        sheet.check(k, answer)
    assert sheet.tally().score == 1
    *_, total, empty, line = sheet.tally()._repr_markdown_().splitlines()
    assert (total.startswith("| **together**"), empty) == (True, "")
    assert line == "- Returning mistake: “product for division” explains answers in 2 problems (01.1, 01.2)."
