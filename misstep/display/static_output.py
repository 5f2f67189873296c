"""Whether notebooks are being executed for a static page, on which no Python runs afterwards.

kinlib/view/drawing/picture.py reads the same variable, because the two packages are installed independently of each other.
"""

import os

ENVIRONMENT_VARIABLE = "NOTEBOOK_STATIC_PAGE"
"""Set while notebooks are executed for a static page. Then questions include their explanations; otherwise Python shows them
after the answer, so that a student's saved notebook does not contain them."""


def is_page() -> bool:
    """Whether outputs are for a page, without a kernel or, where the variable is "live", with a Python of its own."""
    return bool(os.environ.get(ENVIRONMENT_VARIABLE))
