"""Benchmarks of what the course is built on: grading, its sandbox, and the viewer in the browser."""

import sys
from pathlib import Path

# The benchmarks use the same submissions, attacks and browser as the tests.
SUPPORT = Path(__file__).parents[2] / "tests" / "support"
sys.path += [str(SUPPORT), str(SUPPORT / "pages")]
