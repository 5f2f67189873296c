"""The problems of sheet 01: matrices, and sets of eigenvalues."""

import numpy as np

from misstep import Problem, Sampler, Sheet, mistake, problem
from misstep.answers.groups.members import Members
from misstep.answers.number import Numbers
from misstep.mutants.expression import given
from misstep.mutants.operations import MATRIX, VECTOR, inverse


def matrix(sampler: Sampler) -> np.ndarray:
    """Draw a matrix of whole numbers, none of which is 0."""
    return np.array([[sampler.choice([-3, -2, -1, 1, 2, 3]) for _ in range(2)] for _ in range(2)])


@problem("01.1", "A product", points=2, lecture="01_eigenvalues#Products")
def product(sampler: Sampler) -> Problem:
    """Without an expression: the author lists the mistakes. Whole numbers are exact."""
    A, B = matrix(sampler), matrix(sampler)
    return Problem(
        statement=f"Give the product $AB$ of A = {A.tolist()} and B = {B.tolist()}.",
        given={"A": A, "B": B},
        answer=Numbers(A @ B),
        mistakes=[
            mistake("order", B @ A, "This is $BA$. A product of matrices depends on the order."),
            mistake("entry by entry", A * B, "You multiplied entry by entry. Use `@`."),
        ],
    )


@problem("01.2", "A system of equations", points=3, lecture="01_eigenvalues#Inverses")
def system(sampler: Sampler) -> Problem:
    """With an expression: the engine changes it in the ways in which people go wrong, and names the change."""
    a, c = float(sampler.integer(3, 5)), float(sampler.integer(3, 5))
    A = np.array([[a, 1.0], [float(sampler.choice([-2, 2])), c]])
    b = np.array([float(sampler.integer(1, 4)), float(sampler.integer(5, 9))])
    x = inverse(given("A", A, MATRIX)) @ given("b", b, VECTOR)
    return Problem(
        statement=f"Solve $Ax = b$ for A = {A.tolist()} and b = {b.tolist()}.",
        given={"A": A, "b": b},
        answer=Numbers(x.value),
        solution=x,
    )


@problem("01.3", "Eigenvalues", points=2, lecture="01_eigenvalues#Eigenvalues")
def eigenvalues(sampler: Sampler) -> Problem:
    """A set: the order does not matter."""
    a, b = sampler.integer(3, 9), sampler.integer(1, 2)
    A = np.array([[a, b], [b, a]])
    return Problem(
        statement=f"Give the eigenvalues of A = {A.tolist()}, in any order.",
        given={"A": A},
        answer=Members([a + b, a - b], repeated=True),
        mistakes=[
            mistake("diagonal", [a, a], "These are the entries on the diagonal. A has others beside it."),
            mistake("determinant and trace", [a * a - b * b, 2 * a], "These are the determinant and the trace."),
        ],
    )


SHEET = Sheet("01_eigenvalues", "Eigenvalues", [product, system, eigenvalues])
