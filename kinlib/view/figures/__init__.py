"""Figures of robots as SVG, each with a text alternative; the function that makes it is called describe_... or _describe.

arm.py                 arms, and arms at home whose screw axes can be read off
frames.py              frames
lettered_chain.py      an open chain at home with a letter for each of its lengths
joint_bodies.py        the cylinders, boxes and threads of joints
point_velocity.py      the velocity of a point of a rotating body
axis_relations.py      how two joint axes can be related, and their common normals
dh_table.py            a DH table, and what the four numbers of a row measure
frame_assignment.py    the steps of a frame assignment (assignment_steps.py: what each step shows)
linkage.py             linkages
"""
