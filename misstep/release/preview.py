"""`misstep preview 01.2`: a problem as a student sees it, and each mistake with the card that it gets."""

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator

from misstep.catalog import find_course
from misstep.judge import judge
from misstep.problem import Template
from misstep.verdict import Verdict


def preview(template: Template, student: str) -> Iterator[str]:
    """Yield a problem with the numbers of a student: statement, given values, answer, and each mistake with its card."""
    problem = template.variant(student)
    yield f"{template.number} {template.title}, with the numbers of {student!r}\n\n{problem.statement}"
    yield "Given: " + (", ".join(f"{name} = {value}" for name, value in problem.given.items()) or "nothing")
    yield f"Expected: {problem.answer.expected}\nRight: {problem.answer.value}"
    for k, mistake in enumerate([*problem.known_mistakes, *problem.slips], start=1):
        card = Verdict(template, judge(problem, mistake.value)).card
        lines = [paragraph for paragraph in card.body if isinstance(paragraph, str)]
        yield "\n    ".join([f"Mistake {k}: {mistake.name}, {mistake.value}", card.title, *lines])


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
    print(*preview(templates[options.number], options.student), sep="\n\n")
    return 0
