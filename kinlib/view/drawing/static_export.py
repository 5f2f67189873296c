"""Whether what is shown goes to a page without a kernel, where nothing can be asked of Python afterwards."""

import os

ENVIRONMENT_VARIABLE = "NOTEBOOK_STATIC_PAGE"
"""Set where notebooks are executed for a page. Then questions carry their explanations with them and sliders their
pictures; in a lab they do not, for there Python answers, and a saved notebook shall not tell."""


def is_static_export() -> bool:
    """Whether outputs should stand for themselves."""
    return bool(os.environ.get(ENVIRONMENT_VARIABLE))
