"""A user's script passes `mypy --strict`, and mypy knows the type of every result."""

from textwrap import dedent

from mypy import api

SCRIPT = """
    import numpy as np

    import kinlib as kl

    arm = kl.Chain(screws=[[0, 0, 1, 0, 0, 0]], home=np.eye(4), limits=[[-1, 1]])
    convention: kl.Convention = "modified" if arm.n > 2 else "standard"
    table = kl.DHTable("a | alpha | d | theta \\n 0.4 | 0 | 0 | q1", convention=convention, base=np.eye(4).tolist())
    numbers = kl.DHTable([[0.4, 0, 0, 0]], convention="modified", signs=[-1])
    joint = kl.Joint("A", ("ground", "crank"), [0, 0, 1, 0, 0, 0])
    reveal_type(table.rows)
    reveal_type(arm.screws)
    reveal_type(arm.fk([0.3]))
    reveal_type(table.jacobian([0.3]))
    reveal_type(arm.within_limits([0.3]))
    reveal_type(kl.assign_frames(arm, convention=convention).frames)
    reveal_type(kl.nearest_rotation(np.eye(3)))
    reveal_type(joint.screws)
    tree = kl.Tree.from_urdf(kl.to_urdf(arm))
    reveal_type(tree.coupling)
    reveal_type(tree.poses([0.3], base=np.eye(4)))
    reveal_type(tree.chain("base_link", "tool").fk([0.3]))
"""


def test_a_users_script_passes_mypy_strict(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(dedent(SCRIPT).replace("\\\\n", "\\n"), "utf-8")
    report, errors, _ = api.run(["--strict", str(script)])
    assert not errors
    revealed = [line.partition('type is "')[2] for line in report.splitlines() if "Revealed" in line]
    assert [line for line in report.splitlines() if ": error:" in line] == []
    assert len(revealed) == SCRIPT.count("reveal_type")
    assert not [kind for kind in revealed if kind.startswith("Any") or "ndarray" not in kind]
