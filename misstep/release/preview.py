"""`misstep preview 01.2`: a problem as a student sees it, and the cards of the right answer and of each mistake."""

from argparse import ArgumentParser, Namespace

from misstep.catalog import find_course
from misstep.judge import judge
from misstep.verdict import Verdict
from misstep.worked_solution import worked_solution


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep preview`."""
    parser.add_argument("number", help="the number of the problem, such as 01.2, or of a blank step, such as 01.a")
    parser.add_argument("--student", default="another student", help="whose numbers to take")


def run(options: Namespace) -> int:
    """Print the problem, and return 0. Raises ValueError for an unknown number; the message lists those that exist."""
    course = find_course()
    known = {one.number: one for name in course.sheets() for one in course.find_sheet(name).problems} | course.blanks()
    if options.number not in known:
        raise ValueError(f"There is no problem {options.number!r}. The problems are: {', '.join(known)}.")
    template = known[options.number]
    problem = template.variant(options.student)
    print(template.number, template.title, problem.statement, sep="\n\n")
    if problem.figure:
        print(f"\nThe drawing: {problem.figure().alt}")
    print(f"\nGiven: {problem.given}\nExpected: {problem.answer.expected}")
    judgement, worked = judge(problem, problem.answer.value), worked_solution(problem)
    right = Verdict(template, judgement, worked=worked, further=problem.further)
    print(f"\nThe right answer, {problem.answer.value}\n{right.card.text()}")
    for mistake in [*problem.known_mistakes, *problem.slips]:
        judgement = judge(problem, mistake.value)
        if judgement.state != "right":  # what is declared as invisible
            print(f"\nMistake: {mistake.name}, {mistake.value}\n{Verdict(template, judgement).card.text()}")
    return 0
