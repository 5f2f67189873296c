"""A course on electric circuits, written into a folder: the engine must work for a subject that is not robotics."""

from pathlib import Path

FILES = {
    "__init__.py": '''
"""Electric circuits."""

from misstep import Course

COURSE = Course("circuits")
open_sheet, ask, attempt, explain = COURSE.open_sheet, COURSE.ask, COURSE.attempt, COURSE.explain
''',
    "lecture_01_ohm/__init__.py": "",
    "lecture_01_ohm/problems.py": """
import numpy as np

from misstep import Mistake, Problem, Sheet, mistake, problem
from misstep.answers.choice import Choice
from misstep.answers.function import Function, function_mistakes
from misstep.answers.number import Numbers


@problem("01.1", "Two resistors in parallel", points=2, lecture="01_ohm#Parallel circuits")
def parallel(sampler):
    first, second = sampler.choice([10, 20, 30]), sampler.choice([40, 50, 60])
    return Problem(
        statement=f"Resistors of {first} and {second} ohms are connected in parallel. What is their total resistance?",
        given={"first": first, "second": second},
        answer=Numbers(np.array(first * second / (first + second)), unit="ohm"),
        mistakes=[
            mistake("in series", first + second, "You added the resistances, as in a series circuit."),
            mistake("not inverted", 1 / first + 1 / second, "You gave the conductance: invert the sum."),
            mistake("mean", (first + second) / 2, "You gave the mean of the resistances."),
        ],
    )


@problem("01.2", "Which lamp is brighter?", points=1, lecture="01_ohm#Power")
def brighter(sampler):
    first, second = sampler.shuffled([60, 100, 150])[:2]
    options = {"a": "the first", "b": "the second", "c": "both are equally bright", "d": "neither shines"}
    right, wrong = ("a", "b") if first > second else ("b", "a")
    return Problem(
        statement=f"Lamps of {first} and {second} ohms are connected in series. Which one is brighter: {options}?",
        given={"first": first, "second": second},
        answer=Choice(right, options),
        mistakes=[
            mistake("as in parallel", wrong, "In series the current is the same, so P = R I^2."),
            mistake("same current, same power", "c", "The current is the same, but the power is R I^2."),
            mistake("current used up", "d", "A current is not used up."),
        ],
    )


@problem("01.3", "A capacitor discharges", points=3, lecture="01_ohm#Capacitors")
def discharge(sampler):
    voltage, time = sampler.integer(5, 12), sampler.choice([0.5, 1.0, 2.0])

    def mistakes(t):
        return [
            Mistake("charging", voltage * (1 - np.exp(-t / time)), "This is the voltage while it charges."),
            Mistake("sign", voltage * np.exp(t / time), "Your voltage grows: the exponent is negative."),
            Mistake("linear", voltage * (1 - t / time), "The voltage decays exponentially, not linearly."),
        ]

    return Problem(
        statement=f"A capacitor starts at {voltage} V; the time constant is {time} s. Write a function t -> voltage.",
        given={"voltage": voltage, "time": time},
        answer=Function(
            lambda t: voltage * np.exp(-t / time),
            Numbers(np.array(0.0), unit="V"),
            lambda chance: (chance.uniform(0.2, 0.4) * time,),
        ),
        mistakes=function_mistakes(mistakes, 0.3),
    )


SHEET = Sheet("01_ohm", "Ohm's law", [parallel, brighter, discharge])
""",
    "lecture_01_ohm/blanks.py": """
import numpy as np

from misstep import Problem, mistake, problem
from misstep.answers.number import Numbers


@problem("01.a", "Three resistors in series", points=1, lecture="01_ohm#Series circuits")
def series(sampler):
    return Problem(
        statement="What is the total resistance of 10, 20 and 30 ohms in series?",
        answer=Numbers(np.array(60.0), unit="ohm"),
        mistakes=[
            mistake("parallel", 60 / 11, "This is the resistance in parallel."),
            mistake("two only", 30, "You added the first two only."),
            mistake("mean", 20, "You gave the mean."),
        ],
    )


BLANKS = [series]
""",
    "lecture_01_ohm/questions.toml": """
[unit]
kind = 'recall'
text = 'What is the unit of resistance?'

[[unit.options]]
text = 'ohm'
right = true
why = 'One ohm is one volt per ampere.'

[[unit.options]]
text = 'ampere'
why = 'The ampere is the unit of current.'

[brightness]
kind = 'predict'
text = 'Two equal lamps are connected in series. How bright is each, compared with one lamp alone?'
explanation = 'The voltage is halved, *and* the current is halved.'

[[brightness.options]]
text = 'a quarter as bright'
right = true
why = 'Half the current gives a quarter of the power.'

[[brightness.options]]
text = 'half as bright'
why = 'The power grows with the square of the current.'
""",
    "lecture_02_dividers/__init__.py": "",
    "lecture_02_dividers/problems.py": """
import sympy as sp

from misstep import Problem, Sheet, mistake, problem
from misstep.answers.expression import ClosedForm

U, R_1, R_2 = sp.symbols("U R_1 R_2", positive=True)


@problem("02.1", "A voltage divider", points=2, lecture="02_dividers#The divider")
def divider(sampler):
    return Problem(
        statement="A voltage U lies across R_1 and R_2 in series. Give the voltage across R_2 as a formula.",
        answer=ClosedForm(U * R_2 / (R_1 + R_2)),
        mistakes=[
            mistake("other resistor", U * R_1 / (R_1 + R_2), "This is the voltage across R_1."),
            mistake("ratio", U * R_2 / R_1, "Divide by the total resistance, R_1 + R_2."),
            mistake("whole voltage", U, "This is the voltage across both."),
        ],
    )


SHEET = Sheet("02_dividers", "Voltage dividers", [divider])
""",
}


def write_course(folder: Path) -> Path:
    """Write the course into `folder / "circuits"` and return that path."""
    for name, text in FILES.items():
        file = folder / "circuits" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text.lstrip(), encoding="utf-8")
    return folder / "circuits"
