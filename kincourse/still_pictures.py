"""The picture below the title of each lecture, which a notebook shows before any cell is run: `kincourse pictures`.

It is the last key frame of the lecture's film, or the still form of the arm that the reader moves. On the site the film is there at
once, so the pages leave the picture out (site/kinsite/sphinx_source.py).
"""

import importlib
import json
import re
from argparse import ArgumentParser, Namespace
from pathlib import Path

from kincourse.catalog import COURSE
from kinlib.view.drawing.picture import Picture

HANDS_ON = {"00_start_here": "drag", "03_poe_space": "space"}
"""Lectures that begin with an arm instead of a film, each with the scene of this arm."""
IMAGE = re.compile(r"!\[[^\n]*\]\(pictures/\w+\.svg\)\n\n")


def add_arguments(_: ArgumentParser) -> None:
    """Add the arguments of the command, which has none."""


def run(_: Namespace) -> int:
    """Write the picture of each lecture, and its name and text alternative into the first cell. Returns the exit code."""
    for lecture in COURSE.lectures:
        picture = first_picture(lecture)
        drawing = Path("notebooks", "pictures", f"{lecture}.svg")
        drawing.parent.mkdir(exist_ok=True)
        drawing.write_text(on_paper(picture), "utf-8")
        path = Path("notebooks", f"{lecture}.ipynb")
        notebook = json.loads(path.read_text("utf-8"))
        first = notebook["cells"][0]
        shown = picture.alt.removeprefix(f"{picture.caption} ")  # a caption asks the question of the film
        first["source"] = with_image("".join(first["source"]), lecture, shown).splitlines(keepends=True)
        path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", "utf-8")
    return 0


def first_picture(lecture: str) -> Picture:
    """Draw the still form of what a lecture begins with."""
    if lecture in HANDS_ON:
        arm = importlib.import_module("kincourse.lecture_00_start_here.planar_arm")
        picture: Picture = arm.PlanarArm(HANDS_ON[lecture]).picture()
    else:
        picture = importlib.import_module(f"kincourse.lecture_{lecture}.opening").opening().still[-1]
    return picture


def on_paper(picture: Picture) -> str:
    """Return a drawing on white paper, because an image in a notebook does not know the theme of JupyterLab."""
    return picture.labelled_svg().replace("<svg", '<svg style="background:white"', 1)


def with_image(text: str, lecture: str, alt: str) -> str:
    """Put the image of a lecture below its first paragraph, in place of an older one."""
    title, first, *rest = IMAGE.sub("", text).split("\n\n")
    return "\n\n".join([title, first, f"![{alt}](pictures/{lecture}.svg)", *rest])
