"""The decorator for problems of this course: their sampler also draws points, frames and arms."""

from functools import partial

from kincourse.sampling.arms import ArmSampler
from misstep.problem import problem as any_problem

problem = partial(any_problem, sampler=ArmSampler)
"""`misstep.problem.problem` with an ArmSampler."""
