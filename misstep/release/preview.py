"""`misstep preview 01.2`: a problem as a student sees it, and each mistake with the card that it gets."""

from argparse import ArgumentParser, Namespace

from misstep.catalog import find_course
from misstep.judge import judge
from misstep.verdict import Verdict


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep preview`."""
    parser.add_argument("number", help="the number of the problem, such as 01.2")
    parser.add_argument("--student", default="another student", help="whose numbers to take")


def run(options: Namespace) -> int:
    """Print the problem, and return 0. Raises ValueError for an unknown number; the message lists those that exist."""
    course = find_course()
    templates = {one.number: one for sheet in course.sheets() for one in course.find_sheet(sheet).problems}
    if options.number not in templates:
        raise ValueError(f"There is no problem {options.number!r}. The problems are: {', '.join(templates)}.")
    template = templates[options.number]
    problem = template.variant(options.student)
    print(template.number, template.title, problem.statement, sep="\n\n")
    print(f"Given: {problem.given}\nExpected: {problem.answer.expected}\nRight: {problem.answer.value}")
    for mistake in [*problem.known_mistakes, *problem.slips]:
        print(
            f"\nMistake: {mistake.name}, {mistake.value}\n{Verdict(template, judge(problem, mistake.value)).card.text()}"
        )
    return 0
