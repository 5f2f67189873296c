"""Mistakes across problems: bugs that return, and slips."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from misstep.answers.number import Numbers
from misstep.diagnosis.bugs import Observation, Recurrence, recurrences
from misstep.mistakes import mistake
from misstep.mutants import expression
from misstep.problem import Problem, problem
from misstep.sheet import OpenSheet, Sheet

NAMES = "abcde"


@st.composite
def sheets(draw):
    """For each problem the possible mistakes, in groups that lead to the same wrong answer."""
    problems = []
    for _ in range(draw(st.integers(1, 6))):
        places = draw(st.fixed_dictionaries({}, optional={name: st.integers(0, 2) for name in NAMES}))
        groups = [[name for name in sorted(places) if places[name] == place] for place in range(3)]
        problems.append([group for group in groups if group])
    return problems


def as_alternatives(group):
    return [[name] for name in group]


def work(sheet, bugs):
    """What a student with these bugs hands in, where each bug shows in a part of its own."""
    return [
        Observation(
            f"01.{k}",
            {name for group in groups for name in group},
            [as_alternatives(group) for group in groups for name in group if name in bugs],
        )
        for k, groups in enumerate(sheet, start=1)
    ]


@given(sheets(), st.sampled_from(NAMES))
def test_a_single_bug_is_named_with_those_alone_that_no_problem_tells_apart_from_it(sheet, bug):
    where = [f"01.{k}" for k, groups in enumerate(sheet, start=1) if any(bug in group for group in groups)]
    together = [next((set(group) for group in groups if bug in group), set()) for groups in sheet]
    with_it = [{name for group in groups for name in group} for groups in sheet]
    alike = {
        n
        for n in NAMES
        if all(
            (n in names) == (bug in names) and (n in group) == (bug in group)
            for names, group in zip(with_it, together, strict=True)
        )
    } | {bug}
    expected = [Recurrence(" or ".join(sorted(alike)), where, len(where))] if where else []
    assert recurrences(work(sheet, {bug})) == expected


def test_of_mistakes_made_together_each_is_counted_that_is_certain():
    for alternatives, names in [
        ([["a", "b"]], ["a", "b"]),
        ([["a", "b"], ["a", "c"]], ["a", "b or c"]),
        ([["a", "b"], ["c", "d"]], ["a and b or c and d"]),
        ([["a"], ["a", "b"]], ["a"]),
    ]:
        found = recurrences([Observation("01.1", set(NAMES), [alternatives])])
        assert [one.name for one in found] == names
    seen = [Observation("01.1", {"a", "b"}, [[["a"], ["b"]]]), Observation("01.2", {"a", "b"}, [[["b"]]])]
    assert recurrences(seen) == [Recurrence("b", ["01.1", "01.2"], 2)], "it explains another answer, too"


def test_once_is_a_slip_only_where_it_could_have_been_several_times():
    seen = [Observation("01.1", {"a", "b"}, [[["a"]]]), *(Observation(f"01.{k}", {"a"}) for k in (2, 3))]
    assert recurrences(seen)[0].is_slip
    assert not recurrences(seen[:2])[0].is_slip
    unlisted = [Observation(f"01.{k}", {"a"}, [[["rounded"]]] if k < 3 else []) for k in (1, 2, 3)]
    assert str(recurrences(unlisted)[0]) == "Returning mistake: “rounded” explains answers in 2 problems (01.1, 01.2)."


# --- in a sheet ---


def half(k):
    @problem(f"01.{k}", "A half", points=1, lecture="01_fractions#Halves")
    def drawn(sampler):
        x = sampler.integer(3, 9)
        wrong = [mistake("sign", np.array(-x / 2), "A sentence.")]
        solution = expression.given("x", float(x)) / 2
        return Problem("Halve it.", Numbers(np.array(x / 2)), wrong, given={"x": x}, solution=solution)

    return drawn


@pytest.fixture
def sheet():
    return OpenSheet(Sheet("01_fractions", "Fractions", [half(k) for k in range(1, 6)]), "ada")


def test_the_tally_names_a_mistake_that_returns_and_a_slip(sheet):
    """Also a mistake that was corrected afterwards, as in problem 1; mutants and mistakes of the author alike."""
    sheet.check(1, 2 * sheet.given(1).x)
    assert sheet.tally()._repr_markdown_().splitlines()[-1].startswith("| **together**")
    x = {k: sheet.given(k).x for k in range(1, 6)}
    for k, answer in {1: x[1] / 2, 2: 2 * x[2], 3: -x[3] / 2, 4: x[4] / 2, 5: ...}.items():
        sheet.check(k, answer)
    assert sheet.tally().score == 2
    possible = "of the 4 answered problems in which it can be made"
    assert sheet.tally()._repr_markdown_().splitlines()[-2:] == [
        f"- Returning mistake: “product for division” explains answers in 2 {possible} (01.1, 01.2).",
        f"- Probably a slip: “sign” explains answers in 1 {possible} (01.3).",
    ]
