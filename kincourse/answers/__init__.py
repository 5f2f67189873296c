"""The kinds of answers that belong to kinematics: points, poses, screw axes, DH rows, DH tables and DH frames.

`misstep/answers/base.py` says what a kind of answer must define; kinds that fit any subject are in `misstep/answers`.
"""
