"""The same chain in the hands of others: Pinocchio's model of it, built joint by joint from nothing but the screws."""

import numpy as np


def pinocchio_model(chain):
    """A pinocchio model with one joint a screw and a last frame, "tool", at the chain's home pose."""
    import pinocchio as pin

    model = pin.Model()
    parent, at = 0, np.zeros(3)
    for i, S in enumerate(chain.screws):
        omega, v = S[:3], S[3:]
        point = np.cross(omega, v)  # on the axis, nearest the origin; zero for a slide
        if not omega.any():
            joint = pin.JointModelPrismaticUnaligned(v)
        elif abs(omega @ v) > 1e-15:
            joint = pin.JointModelHelicalUnaligned(omega, omega @ v)
        else:
            joint = pin.JointModelRevoluteUnaligned(omega)
        parent = model.addJoint(parent, joint, pin.SE3(np.eye(3), point - at), f"joint {i + 1}")
        at = point
    tool = pin.SE3(chain.home[:3, :3], chain.home[:3, 3] - at)
    model.addFrame(pin.Frame("tool", parent, tool, pin.FrameType.OP_FRAME))
    return model
