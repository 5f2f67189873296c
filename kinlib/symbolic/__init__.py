"""The formulas of the course in SymPy: kl.symbolic."""

from kinlib.symbolic.formulas import *  # noqa: F403 - formulas.__all__ lists the public names
from kinlib.symbolic.formulas import __all__ as __all__
