"""Kinds of answers that belong to kinematics: screws, poses, DH rows and tables, frames."""
