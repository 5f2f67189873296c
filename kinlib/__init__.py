"""kinlib: robot forward kinematics, small enough to read and strict enough to trust.

Twelve jobs, with kinlib imported as kl and numpy as np:

>>> import tempfile, numpy as np, kinlib as kl
>>> arm = kl.load_urdf(kl.to_urdf(kl.robots.puma560()))                # 1, 2  load a URDF file or its text; export an arm
>>> own = kl.Chain(kl.screw(axis=[[0, 0, 1], [0, 1, 0]], point=[[0, 0, 0], [1, 0, 0]]), np.eye(4))        # 3  write an arm
>>> q = arm.random_configurations(1000)                                # or {"joint_1": 0.5, ...}, a value for each name
>>> arm.fk(q).shape, arm.link_poses(q).shape                           # 4  of the tool; how far each link has moved
((1000, 4, 4), (1000, 6, 4, 4))
>>> arm.jacobian(q).shape, arm.body_jacobian(q).shape                  # 5  Jacobians in {s} and in {b}
((1000, 6, 6), (1000, 6, 6))
>>> bool(arm.within_limits(q).all())                                   # 6  limits
True
>>> table = kl.assign_frames(arm, convention="standard").table         # 7  the DH table of an arm
>>> bool(np.allclose(table.to_chain().fk(q), arm.fk(q)))               # 8  the arm of a DH table
True
>>> print(kl.diagnose(table.changed(convention="modified"), arm))      # 9  what is wrong with a DH table
The table is in the standard convention, but was read as modified.
>>> linkage = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
>>> linkage.assembly_modes(hold={"A": 1.0}).shape                      # 10  close a chain: all ways of assembling it
(2, 4)
>>> kl.symbolic.shorthand(kl.symbolic.fk(own))[:3, 3].T                # 11  closed forms, in SymPy
Matrix([[c_1*(1 - c_2), s_1*(1 - c_2), s_2]])
>>> kl.show(own, path=tempfile.mkdtemp() + "/arm.png")                # 12  a picture; kl.show(own) has sliders

Rigid motions
    exp(x)               rotation vectors (..., 3) -> rotations (..., 3, 3); twists (..., 6) -> poses (..., 4, 4)
    log(X)               the inverse of exp
    inverse(X)           T_ab -> T_ba
    adjoint(X)           poses (..., 4, 4) -> (..., 6, 6), which takes twists in {b} to twists in {a}
    hat(x), vee(X)       vector or twist -> its matrix, and back
    screw(axis, point, pitch), line(S)           a line -> its screw axis (..., 6), and back as a Line
    nearest_rotation(X)  repair a rounded rotation or pose
Open chains
    Chain(screws, home)  n screw axes (n, 6) and M (4, 4): fk, link_poses, jacobian, limits; print(arm) lists its axes
    robots               the arms of the course, and robots.arm and robots.pose to write your own
    load_urdf(file), to_urdf(arm), Tree          URDF; Tree.from_urdf(file) has all branches, and poses(q) of all links
Denavit-Hartenberg
    DHTable(rows, convention), dh_transform(a, alpha, d, theta, convention)
    read_table(text)                             a table as it was pasted, with what was assumed for it
    assign_frames(arm, convention)               a FrameAssignment, with its table and .steps, the reason for each frame
    equivalent(one, other), diagnose(table, arm), check_frames(arm, frames, convention)
                         compare: an Equivalence, a Diagnosis, a list of Breach
Closed chains
    Mechanism(joints), Joint, linkages           a Mechanism, also of linkages: assemble, trace, mobility
Also
    symbolic             the same formulas in SymPy
    show(robot)          an arm, a table, a tree or a closed chain in pictures and three dimensions; more in kinlib.view

A twist and a screw axis are (omega, v), as in Modern Robotics. {s} is the frame of the base, {b} that of the end-effector, and T_ab
takes coordinates in {b} to coordinates in {a}; radians and metres. An array of shape (..., n) holds any number of configurations.
`to_dict` and `from_dict` write an arm or a table as JSON data and read it. `help(kl.Chain.fk)`, for example, says shapes, units,
frames and errors.
"""

from typing import TYPE_CHECKING, Any

from kinlib.chains import robots
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment, assign_frames
from kinlib.dh.diagnosis import Diagnosis, diagnose
from kinlib.dh.equivalence import Equivalence, equivalent
from kinlib.dh.read_table import read_table
from kinlib.dh.rules import Breach, check_frames
from kinlib.dh.table import Convention, DHTable, dh_transform
from kinlib.mechanisms import linkages
from kinlib.mechanisms.joints import Joint
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import adjoint, exp, hat, inverse, log, nearest_rotation, vee
from kinlib.rigid.screw import Line, line, screw
from kinlib.urdf.chains import load_urdf, to_urdf
from kinlib.urdf.robot_tree import Tree

if TYPE_CHECKING:
    from kinlib import symbolic, view
    from kinlib.view import show

    # For type checkers only: `help` would print every class and function named here, 1,700 lines.
    __all__ = [
        "Breach", "Chain", "Convention", "DHTable", "Diagnosis", "Equivalence", "FrameAssignment", "Joint", "Line",
        "Mechanism", "Tree", "adjoint", "assign_frames", "check_frames", "dh_transform", "diagnose", "equivalent",
        "exp", "hat", "inverse", "line", "linkages", "load_urdf", "log", "nearest_rotation", "read_table", "robots",
        "screw", "show", "symbolic", "to_urdf", "vee", "view",
    ]  # fmt: skip
else:

    def __getattr__(name: str) -> Any:
        """Import kl.symbolic, kl.view and kl.show when they are first used, because SymPy and widgets take long to import."""
        if name not in {"show", "symbolic", "view"}:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib import import_module

        return import_module("kinlib.view").show if name == "show" else import_module(f"kinlib.{name}")

    def __dir__() -> list[str]:
        return sorted({*globals(), "show", "symbolic", "view"} - {"Any", "TYPE_CHECKING"})


__version__ = "0.1.0"
