"""What is of another kind than a function takes is refused with what must hold, what was given and what to try."""

import numpy as np
import pytest

import kinlib as kl

Z = (0, 0, 1)
ARM = kl.robots.rpr()
TABLE = kl.DHTable([[0.4, 0, 0, 0]], convention="standard")
LINKAGE = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: kl.equivalent("abc", ARM), r"a must be a Chain .*got str 'abc'.*load_urdf"),
        (lambda: kl.equivalent(ARM, ARM, fixed="tool"), r"fixed must be .*got 'tool'. Try fixed=\["),
        (lambda: kl.equivalent(ARM, ARM, tolerance=0), "tolerance must be a positive number"),
        (lambda: kl.diagnose(TABLE.rows, ARM), r"table must be a DHTable; got ndarray .*Try DHTable\(..., convention="),
        (lambda: kl.assign_frames(kl.robots.rpr, "standard"), r"chain must be a Chain; got function.*call it, rpr\(\)"),
        (lambda: kl.DHTable("a|alpha|d|theta\n0.4|0|0|t2", "standard"), "got 't2'. .*write q2"),
        (lambda: kl.DHTable("a|alpha|d|theta\n0|0|0|-q1", "standard", signs=[1]), "signs must be left out"),
        (lambda: kl.check_frames(ARM, [np.eye(4)] * 3, "standard"), r"\(4, 4, 4\).*got \(3, 4, 4\).*missing"),
        (
            lambda: kl.assign_frames(kl.robots.hrr(), "standard"),
            "joint 1 of HRR arm is helical",
        ),
        (lambda: kl.to_urdf(kl.robots.hrr()), "URDF has no helical joint; joint 1 of HRR arm"),
        (lambda: kl.to_urdf(TABLE), r"chain must be a Chain; got DHTable.*table\.to_chain"),
        (lambda: LINKAGE.assemble([0, 0.5, 1, 0.5], hold="A"), "hold must be a Mapping; got str 'A'. Try {'A': 1.0}"),
        (lambda: LINKAGE.trace(np.zeros((2, 4))), r"start must have shape \(4,\); got \(2, 4\).*start\[0\]"),
        (lambda: kl.symbolic.screw((1, 1, 0)), r"axis must be a unit vector; its length is sqrt\(2\)"),
        (
            lambda: kl.screw(Z, pitch=[0.0, np.nan]),
            r"pitch must be finite, or inf .*; got nan\. .*negate the axis",
        ),
        (
            lambda: kl.line([[*Z, 0, 0, 0], [0, 0, 0, 0, 3, 4]]),
            r"In S\[1\] the length of v \(omega is zero.*\) is 5\. ",
        ),
    ],
)
def test_a_wrong_kind_is_refused(call, said):
    with pytest.raises(ValueError, match=said):
        call()
