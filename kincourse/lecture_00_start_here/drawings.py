"""The parts of an arm, each with its name: base, joints, links and end-effector."""

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np

from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, LINK_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import JOINT_KINDS, draw_arm
from kinlib.view.figures.joint_bodies import draw_joint_bodies, stations

SHORTEST_LABELLED_SHARE = 0.08
"""A link that is shorter, as a share of the size of the arm, is not labelled: the label would cover its joints."""

LABELS_ABOVE = [(0, 20), (0, -20), (34, 14), (-34, 14), (34, -14), (-34, -14), (48, 0), (-48, 0), (0, 36), (0, -36)]


def draw_parts(chain: Chain) -> Picture:
    """Draw an arm at home with the names of its parts: base, joints with their numbers, links and end-effector.

    >>> draw_parts(kl.robots.rpr()).alt[:98]
    'RPR: from the base through joint 1 (revolute), link 1, joint 2 (prismatic), link 2, joint 3 (revol'
    """
    path = stations(chain)
    canvas = Canvas(path)
    canvas.floor(path)
    canvas.line(path, LINK_GREY, 6.0)
    draw_joint_bodies(canvas, chain, chain.link_poses(np.zeros(chain.n)))
    canvas.triad(np.eye(4), "s", 0.2 * canvas.size)
    canvas.triad(chain.home, "b", 0.2 * canvas.size)
    canvas.label(path[0], "base", INK, [(-40, 4), (40, -22), (-40, -22), (44, 4)], 12)
    canvas.label(path[-1], "end-effector", INK, [(0, -24), (52, 20), (52, -20), (0, -40), (60, 0)], 12)
    for i, (start, end) in enumerate(pairwise(path[1:]), start=1):
        if i < chain.n and np.linalg.norm(end - start) > SHORTEST_LABELLED_SHARE * canvas.size:
            canvas.label((start + end) / 2, f"link {i}", VIOLET, LABELS_ABOVE, 12)
    kinds = [f"joint {i} ({JOINT_KINDS[letter]})" for i, letter in enumerate(chain.joint_types, start=1)]
    parts = [text for i, kind in enumerate(kinds, start=1) for text in (kind, f"link {i}")]
    at = "; ".join(f"{i} at {vector_text(p)}" for i, p in enumerate(path[1:-1], start=1))
    alt = f"{chain.name}: from the base through {', '.join(parts[:-1])} to the end-effector. Joints, in metres: {at}."
    return canvas.picture(alt, cropped=True)


def draw_home(chain: Chain) -> Picture:
    """Draw an arm at home with its axes. The text does not say where the end-effector is, because a blank step asks for it.

    >>> "end-effector" in draw_home(kl.robots.rpr()).alt
    False
    """
    picture = draw_arm(chain, caption="The arm at home, with the axes of its joints.")
    return replace(picture, alt=re.sub(r" The end-effector is at [^;]*? m\.", "", picture.alt))
