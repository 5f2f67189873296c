"""What the bug hunt of lecture 08 finds. It is here because its captions tell the answer."""

from collections.abc import Callable
from typing import Any

import numpy as np

from kincourse.lecture_08_closed_chains.drawings import slide_linkage
from kinlib.arrays.validation import Array
from kinlib.mechanisms.mechanism import Mechanism


def slide_solution(residual: Callable[[Array], Array], linkage: Mechanism, after: Any) -> Any:
    """Solve an equation of a four-bar by Newton's method, and show whether the loop is closed where the equation is solved.

    residual  of the equation, at the values of A, B, D and C; A is held
    """
    q = np.array([1.0, 0.0, 1.5, 0.0])
    steps = [q]
    for _ in range(8):
        J = np.stack([(residual(q + h) - residual(q - h)) / 2e-6 for h in 1e-6 * np.eye(4)[1:]], axis=1)
        q = q + np.append(0, np.linalg.lstsq(J, -residual(q))[0])
        steps.append(q)
    captions = [
        f"the function gives {np.linalg.norm(residual(q)):.2g}; the linkage's own residual is {np.linalg.norm(linkage.residual(q)):.2f}"
        for q in steps
    ]
    return slide_linkage(linkage, np.array(steps), "steps", range(len(steps)), captions=captions, after=after)
