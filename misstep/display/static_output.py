"""Whether notebooks are being executed for a static page, on which no Python runs afterwards.

kinlib/view/drawing/static_export.py is the same, because the two packages are installed independently of each other.
"""

import os

ENVIRONMENT_VARIABLE = "NOTEBOOK_STATIC_PAGE"
"""Set while notebooks are executed for a static page. Then questions include their explanations; otherwise Python shows them
after the answer, so that a student's saved notebook does not contain them."""


def is_static_export() -> bool:
    """Whether outputs must work without a kernel."""
    return bool(os.environ.get(ENVIRONMENT_VARIABLE))
