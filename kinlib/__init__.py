"""kinlib: robot forward kinematics, small enough to read and strict enough to trust.

The folders are in the order of the lectures: rigid, chains, dh, mechanisms, urdf; symbolic and view are used in all of them.
`NOTATION.md` lists the conventions.
"""

from typing import TYPE_CHECKING, Any

from kinlib.chains import robots
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment, assign_frames
from kinlib.dh.diagnosis import Diagnosis, diagnose
from kinlib.dh.equivalence import Equivalence, equivalent
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
    from kinlib import symbolic
    from kinlib.view.viewer.browser import show
else:

    def __getattr__(name: str) -> Any:
        """Import kl.symbolic and kl.show when they are first used, because SymPy and widgets take long to import."""
        if name not in {"show", "symbolic"}:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib import import_module

        return import_module("kinlib.symbolic") if name == "symbolic" else import_module("kinlib.view").show

    def __dir__() -> list[str]:
        return sorted({*globals(), *__all__})


__version__ = "0.1.0"

__all__ = [
    "Breach",
    "Chain",
    "Convention",
    "DHTable",
    "Diagnosis",
    "Equivalence",
    "FrameAssignment",
    "Joint",
    "Line",
    "Mechanism",
    "Tree",
    "adjoint",
    "assign_frames",
    "check_frames",
    "dh_transform",
    "diagnose",
    "equivalent",
    "exp",
    "hat",
    "inverse",
    "line",
    "linkages",
    "load_urdf",
    "log",
    "nearest_rotation",
    "robots",
    "screw",
    "show",
    "symbolic",
    "to_urdf",
    "vee",
]
