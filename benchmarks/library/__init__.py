"""Benchmarks of kinlib: each module compares one part of the library with other packages."""

import sys
from pathlib import Path

# The benchmarks use the same oracles and example arms as the tests.
sys.path.append(str(Path(__file__).parents[2] / "tests" / "support"))
