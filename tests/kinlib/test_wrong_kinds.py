"""Objects of another kind than a function takes are refused with what must hold, what was given and what to try."""

import numpy as np
import pytest

import kinlib as kl

ARM = kl.robots.rpr()
TABLE = kl.DHTable([[0.4, 0, 0, 0]], convention="standard")
LINKAGE = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: ARM.random_configurations(2.5), "count must be .*got float 2.5. Try int"),
        (lambda: kl.equivalent("abc", ARM), r"a must be a Chain .*got str 'abc'.*load_urdf"),
        (lambda: kl.equivalent(ARM, ARM, fixed="tool"), r"fixed must be .*got 'tool'. Try fixed=\["),
        (lambda: kl.assign_frames(kl.robots.rpr, "standard"), r"chain must be a Chain; got function.*call it, rpr\(\)"),
        (lambda: kl.DHTable("a|alpha|d|theta\n0.4|0|0|t2", "standard"), "got 't2'. .*write q2"),
        (
            lambda: kl.DHTable(f"{TABLE}\ntool = [[1]", "standard"),
            r"tool must be a rotation .* or a pose .*; got shape",
        ),
        (lambda: kl.to_urdf(TABLE), r"chain must be a Chain; got DHTable.*table\.to_chain"),
        (lambda: LINKAGE.assemble([0, 0.5, 1, 0.5], hold="A"), "hold must be a Mapping; got str 'A'. Try {'A': 1.0}"),
        (lambda: LINKAGE.trace(np.zeros((2, 4))), r"start must have shape \(4,\); got \(2, 4\).*start\[0\]"),
        (lambda: kl.symbolic.fk(TABLE), r"arm must be a Chain; got DHTable.*table\.to_chain"),
        (lambda: kl.robots.pose(np.eye(3) * 2, [0, 0, 0]), "axes is not rigid"),
    ],
)
def test_a_wrong_kind_is_refused(call, said):
    with pytest.raises(ValueError, match=said):
        call()


def test_an_arm_is_written_without_a_name_and_named_afterwards():
    arm = kl.robots.arm([([0, 0, 1], [0, 0, 0])], np.eye(4)).changed(joint_names=["turn"], name="mast")
    assert arm.fk({"turn": np.pi})[0, 0] == pytest.approx(-1)
    assert (arm.name, arm.source, arm.joint_names) == ("mast", "", ("turn",))
