"""The address of a section of a lecture: of its notebook on a server of notebooks, or of its page on the site of the course."""

import os
import re

FOLDER = "notebooks"
"""The folder of the lectures' notebooks, beside the folder of a sheet or above it."""

MAX_LEVELS = 3
"""How many folders upwards it is searched: a sheet is in exercises/01_frames, a blank step in notebooks."""


def lecture_address(lecture: str, site: str = "") -> str:
    """Return the address of a section of a lecture, relative to the open notebook, or of its page if no notebook is found.

    lecture  notebook and heading, "01_ohm#Parallel circuits"
    site     the address of the site of the course, "" if it has none
    """
    name, _, heading = lecture.partition("#")
    for level in range(MAX_LEVELS):
        path = f"{'../' * level}{FOLDER}/{name}.ipynb"
        if os.path.isfile(path):  # noqa: PTH113 - Path.is_file raises an error for a folder that cannot be read
            return f"{path}#{heading.replace(' ', '-')}"  # the id that JupyterLab gives to a heading
    return page_address(lecture, site)


def page_address(lecture: str, site: str) -> str:
    """Return the address of a section of a lecture on the site of the course; "" if it has none.

    >>> page_address("01_ohm#Kirchhoff's laws, and Ohm's", "https://example.org/circuits/")
    'https://example.org/circuits/lectures/01_ohm.html#kirchhoff-s-laws-and-ohm-s'
    """
    name, _, heading = lecture.partition("#")
    section = re.sub(r"[^a-z0-9]+", "-", heading.lower()).lstrip("-0123456789").rstrip("-")  # as docutils does
    return f"{site.rstrip('/')}/lectures/{name}.html#{section}" if site else ""
