"""The opening film: one bolt, seen from a camera and from the base of a robot, with the numbers of each."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp, homogeneous
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.viewer.pictures import Pictures, film, share

CAMERA = homogeneous(exp([0, 0, np.pi]) @ exp([2.4, 0, 0]), (0.9, 0.5, 1.0))
BESIDE = {"camera": [(150, 0)], "base": [(140, -30)]}
"""Where the numbers are written, in pixels to the right of the middle of their arrow and above it: off both arrows in each picture."""

START, END = np.array([0.9, 0.0, 0.2]), np.array([0.3, 0.7, 0.2])
BOLT_FOR_CAMERA = CAMERA[:3, :3].T @ (START - CAMERA[:3, 3])
"""The coordinates (3,) of the bolt in the frame of the camera, at the start."""

AROUND = np.array([(-0.2, -0.3, 0), (1.3, 1.0, 1.2)])


def draw_bolt(bolt: Array, *, base: bool = True, gripper: Array | None = None) -> Picture:
    """Draw a bolt at a point (3,) of the base frame, seen from a camera and, if `base`, from the base of a robot.

    gripper  a pose (4, 4) in the base frame, drawn as a frame {g}
    """
    seen = CAMERA[:3, :3].T @ (bolt - CAMERA[:3, 3])
    texts = [(CAMERA, "camera", seen, GREY)] + ([(np.eye(4), "base", bolt, ORANGE)] if base else [])
    canvas = Canvas(AROUND)
    canvas.floor(AROUND)
    for T, name, numbers, colour in texts:
        canvas.triad(T, name, 0.25)
        canvas.arrow(T[:3, 3], bolt, colour, 1.6, style="--")
        text = f"from the {name}: {vector_text(numbers.round(2))}"
        canvas.label((T[:3, 3] + bolt) / 2, text, colour, BESIDE[name], size=11)
    canvas.dot(bolt, INK, 10)
    canvas.label(bolt, "bolt", INK)
    said = " ".join(f"From the {name} the bolt is at {vector_text(numbers.round(2))}." for _, name, numbers, _ in texts)
    if gripper is not None:
        canvas.triad(gripper, "g", 0.25)
        said += f" The frame of the gripper is at {vector_text(gripper[:3, 3].round(2))}."
    return canvas.picture(said)


def opening() -> Pictures:
    """Play a bolt that moves on a table, with its coordinates in the frame of a camera and in that of a base."""

    def draw(t: float) -> Picture:
        return draw_bolt(START + share(t, 4, 7) * (END - START), base=t >= 2)

    return film(
        draw,
        [
            (1.9, "A camera measures where a bolt is."),
            (2.1, "Seen from the base of the robot, the same bolt has other coordinates."),
            (
                4.0,
                "The bolt moves, and its coordinates change in both frames. Which matrix takes those of the camera to those of the base?",
            ),
        ],
    )
