"""The address of a section of a lecture: of its notebook on a server of notebooks, or of its page on the site of the course.

Whether a page is made is read from the variable that kinlib/view/drawing/picture.py reads, too.
"""

import os
import re

ENVIRONMENT_VARIABLE = "NOTEBOOK_STATIC_PAGE"
"""Set while notebooks are executed for a page. Then questions include their explanations; otherwise Python shows them after the
answer, so that a student's saved notebook does not contain them."""


def is_page() -> bool:
    """Whether outputs are for a page, without a kernel or, where the variable is "live", with a Python of its own."""
    return bool(os.environ.get(ENVIRONMENT_VARIABLE))


def lecture_address(lecture: str, site: str = "") -> str:
    """Return the address of a section of a lecture, relative to the open notebook, or of its page if no notebook is found.

    Where a page of the site runs the code there are no notebooks, and the page makes links to notebooks lead to pages.

    lecture  notebook and heading, "01_ohm#Parallel circuits"
    site     the address of the site of the course, "" if it has none
    """
    name, _, heading = lecture.partition("#")
    # A sheet is in exercises/01_frames, and a blank step in the folder of the notebooks itself.
    paths = [f"{'../' * level}notebooks/{name}.ipynb" for level in range(3)]
    found = filter(os.path.isfile, paths)  # Path.is_file raises an error for a folder that cannot be read
    path = next(found, paths[1] if is_page() else "")
    # A heading has this id in JupyterLab.
    return f"{path}#{heading.replace(' ', '-')}" if path else page_address(lecture, site)


def page_address(lecture: str, site: str) -> str:
    """Return the address of a section of a lecture on the site of the course; "" if it has none."""
    name, _, heading = lecture.partition("#")
    section = re.sub(r"[^a-z0-9]+", "-", heading.lower()).lstrip("-0123456789").rstrip("-")  # as docutils does
    return f"{site.rstrip('/')}/lectures/{name}.html#{section}" if site else ""
