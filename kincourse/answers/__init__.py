"""The kinds of answers that belong to kinematics: points, poses, screw axes, DH rows, DH tables and DH frames."""
