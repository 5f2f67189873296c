"""The formulas of the course in SymPy: kl.symbolic."""

from kinlib.symbolic.formulas import *  # noqa: F403 - the formulas say themselves which names are public
from kinlib.symbolic.formulas import __all__ as __all__
