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


def pinocchio_loop(model, q):
    """Poses (N, 4, 4) of the tool for configurations (N, n), one after the other, in the fastest way that we know."""
    import pinocchio as pin

    data, tool = model.createData(), model.getFrameId("tool")
    T = np.empty((len(q), 4, 4))
    for i, row in enumerate(q):
        pin.forwardKinematics(model, data, row)
        T[i] = pin.updateFramePlacement(model, data, tool).homogeneous
    return T


def pinocchio_loop_by_joint(model, q):
    """The same as its examples write it, by the pose of the last joint, `data.oMi[n]`; the tool's offset once, at the end."""
    import pinocchio as pin

    data, tool = model.createData(), model.frames[model.getFrameId("tool")]
    T = np.empty((len(q), 4, 4))
    for i, row in enumerate(q):
        pin.forwardKinematics(model, data, row)
        T[i] = data.oMi[tool.parentJoint].homogeneous
    return T @ tool.placement.homogeneous
