"""The problems of sheet 01.

Each function draws the numbers of one student and returns the problem with its solution.
"""

import numpy as np

from misstep import Problem, Sampler, Sheet, mistake, problem
from misstep.answers.number import Numbers
from misstep.answers.quantity import Quantity
from misstep.answers.text import Prose
from misstep.mutants.expression import given
from misstep.mutants.operations import ANGLE, radians, sin


@problem("01.1", "Two resistors in parallel", points=2, lecture="01_ohm#Parallel circuits")
def parallel(sampler: Sampler) -> Problem:
    """Without an expression: the author lists the mistakes."""
    first, second = sampler.choice([10, 20, 30]), sampler.choice([40, 50, 60])
    return Problem(
        statement=f"Resistors of {first} and {second} ohms are connected in parallel. Give their total resistance, in ohms.",
        given={"first": first, "second": second},
        answer=Numbers(np.array(first * second / (first + second))),
        mistakes=[
            mistake("in series", first + second, "You added the resistances, as in a series circuit."),
            mistake("not inverted", 1 / first + 1 / second, "You gave the conductance. Take its inverse."),
            mistake("mean", (first + second) / 2, "You gave the mean of the resistances."),
        ],
    )


@problem("01.2", "The voltage at one moment", points=2, lecture="01_ohm#Alternating current")
def alternating(sampler: Sampler) -> Problem:
    """With an expression: the engine changes it in the ways in which people go wrong, and names the change."""
    peak, degrees = float(sampler.integer(5, 20)), float(sampler.integer(20, 70))
    u = given(r"\hat u", peak) * sin(radians(given(r"\varphi", degrees, ANGLE)))
    return Problem(
        statement=f"An alternating voltage has the peak value {peak:g} V. Give its value at a phase of {degrees:g} degrees, in volts.",
        given={"peak": peak, "degrees": degrees},
        answer=Numbers(np.array(u.value)),
        solution=u,
    )


@problem("01.3", "An impedance", points=3, lecture="01_ohm#Alternating current")
def impedance(sampler: Sampler) -> Problem:
    """A complex number with a unit, which students give as text."""
    ohms, reactance = sampler.choice([30.0, 50.0, 80.0]), sampler.choice([20.0, 40.0, 70.0])
    z = given("R", ohms) + given(r"\mathrm{j}", 1j) * given("X", reactance)
    return Problem(
        statement=f"A coil has the resistance {ohms:g} Ω and the reactance {reactance:g} Ω. Give its impedance with its unit.",
        given={"resistance": ohms, "reactance": reactance},
        answer=Quantity(z.value, "ohm"),
        solution=z,
    )


@problem("01.4", "Why does it lag?", points=3, lecture="01_ohm#Alternating current")
def lag(sampler: Sampler) -> Problem:
    """A text, which a person marks by these criteria."""
    device = sampler.choice(["a coil", "a motor", "a transformer"])
    return Problem(
        statement=f"In two or three sentences: why does the current in {device} lag behind the voltage?",
        answer=Prose({"names the induced voltage": 2, "says what it opposes": 1}),
    )


SHEET = Sheet("01_ohm", "Ohm's law", [parallel, alternating, impedance, lag])
