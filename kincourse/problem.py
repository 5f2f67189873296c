"""What every problem of this course is written with: the decorator, its sampler, and what the function returns."""

from functools import partial

from kincourse.sampling.arms import ArmSampler
from misstep.problem import Problem
from misstep.problem import problem as any_problem

__all__ = ["ArmSampler", "Problem", "problem"]

problem = partial(any_problem, sampler=ArmSampler)
"""`misstep.problem.problem` with an ArmSampler, which also draws points, frames and arms."""
