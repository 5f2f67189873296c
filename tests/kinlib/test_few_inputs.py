"""One input, or a few, cost no more than a teaching library takes for one, and no more than a loop over single calls.

Processor time, because other programs run meanwhile; the smallest of several rounds; and with room, because even that varies.
"""

import time

import modern_robotics as mr
import numpy as np
import pytest

import kinlib as kl

ROOM = 1.25
PUMA = kl.robots.puma560()
LONG = kl.Chain(kl.screw(np.eye(3)[[2, 0, 1, 2, 1, 0]] @ kl.exp([0.3, 0.5, 0.7]), np.eye(6)[:, :3] + 0.1), np.eye(4))
RNG = np.random.default_rng(0)
TWISTS, Q = RNG.uniform(-1.5, 1.5, (16, 6)), RNG.uniform(-2, 2, (16, 6))
POSES = kl.exp(TWISTS)


def shortest(*functions, rounds=15, repetitions=20):
    """Return the processor seconds of each function, measured alternately: the shortest round."""
    seconds = [[] for _ in functions]
    for _ in range(rounds):
        for function, measured in zip(functions, seconds, strict=True):
            start = time.process_time()
            for _ in range(repetitions):
                function()
            measured.append(time.process_time() - start)
    return [min(measured) for measured in seconds]


@pytest.mark.parametrize(
    ("ours", "theirs", "argument", "its_argument"),
    [
        (kl.exp, mr.MatrixExp6, TWISTS[0], mr.VecTose3(TWISTS[0])),
        (kl.log, mr.MatrixLog6, POSES[0], POSES[0]),
        (kl.log, mr.MatrixLog6, kl.exp([0, 3, 0, 1, 2, 3]), kl.exp([0, 3, 0, 1, 2, 3])),
        (kl.adjoint, mr.Adjoint, POSES[0], POSES[0]),
        (kl.inverse, mr.TransInv, POSES[0], POSES[0]),
    ],
    ids=["exp", "log", "log near pi", "adjoint", "inverse"],
)
def test_one_motion_is_as_fast_as_modern_robotics(ours, theirs, argument, its_argument):
    own, other = shortest(lambda: ours(argument), lambda: theirs(its_argument))
    assert own <= other


@pytest.mark.parametrize("count", [2, 3, 5, 8, 12, 16])
@pytest.mark.parametrize(
    ("function", "arguments"),
    [
        *((method, Q) for method in (PUMA.fk, PUMA.jacobian, LONG.fk, LONG.jacobian, LONG.link_poses)),
        *((function, POSES) for function in (kl.log, kl.adjoint, kl.inverse)),
        (kl.exp, TWISTS),
    ],
    ids=["fk", "jacobian", "long fk", "long jacobian", "long link_poses", "log", "adjoint", "inverse", "exp"],
)
def test_a_small_batch_is_no_slower_than_a_loop_of_single_calls(function, arguments, count):
    batch = arguments[:count]
    for given in (batch, batch.tolist()):
        at_once, one_by_one = shortest(lambda: function(given), lambda: [function(one) for one in given], rounds=7)  # noqa: B023
        assert at_once <= ROOM * one_by_one


@pytest.mark.parametrize("method", ["link_poses", "fk_body", "body_jacobian"])
def test_other_methods_of_one_configuration_take_at_most_three_times_as_long_as_fk(method):
    for q in (Q[0], Q[0].tolist()):
        fk, other = shortest(lambda: PUMA.fk(q), lambda: getattr(PUMA, method)(q))  # noqa: B023
        assert other <= 3 * fk
