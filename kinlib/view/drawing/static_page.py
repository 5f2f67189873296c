"""Whether notebooks are being executed for a static page, on which no Python runs afterwards.

misstep/display/static_output.py reads the same variable, because the two packages are installed independently of each other.
"""

import os

ENVIRONMENT_VARIABLE = "NOTEBOOK_STATIC_PAGE"
"""Set while notebooks are executed for a static page. Then sliders include a picture for each of their values; otherwise
Python draws them when the slider moves."""


def is_without_kernel() -> bool:
    """Whether outputs must work without a kernel."""
    return os.environ.get(ENVIRONMENT_VARIABLE, "") not in ("", "live")
