"""kinlib: robot forward kinematics, small enough to read and strict enough to trust.

Read the modules in the order of the lectures: lie, screw, chain, dh, frames. `NOTATION.md` says the conventions once.
"""

from kinlib import robots
from kinlib.chain import Chain
from kinlib.dh import DHTable, dh_transform
from kinlib.diagnosis import Diagnosis, diagnose
from kinlib.equivalence import Equivalence, equivalent
from kinlib.frame_check import Breach, check_frames
from kinlib.frames import FrameAssignment, assign_frames
from kinlib.lie import adjoint, exp, hat, inverse, log, vee
from kinlib.screw import Line, line, screw

__version__ = "0.1.0"

__all__ = [
    "Breach",
    "Chain",
    "DHTable",
    "Diagnosis",
    "Equivalence",
    "FrameAssignment",
    "Line",
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
    "log",
    "robots",
    "screw",
    "vee",
]
