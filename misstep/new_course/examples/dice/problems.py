"""The problems of sheet 01: exact fractions, and intervals."""

from fractions import Fraction

from misstep import Problem, Sampler, Sheet, mistake, problem
from misstep.answers.groups.interval import Interval
from misstep.answers.number import Numbers
from misstep.mutants.expression import given


@problem("01.1", "At least one six", points=2, lecture="01_dice#Independent events")
def at_least_one(sampler: Sampler) -> Problem:
    """Without an expression: the author lists the mistakes."""
    rolls = sampler.integer(2, 4)
    return Problem(
        statement=f"A die is rolled {rolls} times. How probable is at least one six? Give a fraction.",
        given={"rolls": rolls},
        answer=Numbers(1 - Fraction(5, 6) ** rolls),
        mistakes=[
            mistake("none", Fraction(5, 6) ** rolls, "This is how probable no six is. Take the complement."),
            mistake("all", Fraction(1, 6) ** rolls, "This is how probable it is that every roll is a six."),
            mistake("added", Fraction(rolls, 6), "You added the probabilities, but two sixes may come together."),
        ],
    )


@problem("01.2", "A positive test", points=3, lecture="01_dice#Conditional probability")
def positive_test(sampler: Sampler) -> Problem:
    """With an expression: the engine changes it in the ways in which people go wrong, and names the change."""
    ill, found = Fraction(1, sampler.choice([20, 50, 100])), Fraction(sampler.choice([90, 95]), 100)
    alarm = Fraction(sampler.choice([4, 8]), 100)
    p, s, f = given("p", ill), given("s", found), given("f", alarm)
    return Problem(
        statement=f"Of all people, the share {ill} is ill. A test finds {found} of the ill, and {alarm} of the others by mistake. "
        "How probable is it that a person with a positive test is ill? Give a fraction.",
        given={"ill": ill, "found": found, "alarm": alarm},
        answer=Numbers((p * s / (p * s + (1 - p) * f)).value),
        solution=p * s / (p * s + (1 - p) * f),
    )


@problem("01.3", "Where it is constant", points=2, lecture="01_dice#Distribution functions")
def step(sampler: Sampler) -> Problem:
    """An interval, whose ends matter."""
    faces = sampler.choice([6, 8, 12])
    face = sampler.integer(2, faces - 2)
    return Problem(
        statement=f"X is the number that a fair die with {faces} faces shows, and F(x) = P(X ≤ x). For which x is F(x) = {face}/{faces}? "
        "Give an interval as text.",
        given={"faces": faces, "face": face},
        answer=Interval(f"[{face}, {face + 1})"),
        mistakes=[mistake("one too low", f"[{face - 1}, {face})", "There, the face itself is not counted yet.")],
    )


SHEET = Sheet("01_dice", "Dice", [at_least_one, positive_test, step])
