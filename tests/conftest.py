"""What every test run shares: how Hypothesis draws, one thread a worker, and the seconds that each notebook took."""

import os

if "PYTEST_XDIST_WORKER" in os.environ:
    # Workers already share the cores; BLAS reads this once, when NumPy loads, and kernels that we start inherit it
    os.environ.update(dict.fromkeys(("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"))

import hypothesis
import matplotlib as mpl

# Not by the variable MPLBACKEND: kernels would inherit it, and draw otherwise than they do for a student
mpl.use("agg")

# Deadlines measure the machine, not the code. In CI the same commit draws the same examples; at home each run draws new.
hypothesis.settings.register_profile("kinlib", deadline=None, derandomize="CI" in os.environ, print_blob=True)
# tests/mutation.py runs a module's tests once for each fault: a few examples, the same ones, and no search for the smallest
hypothesis.settings.register_profile(
    "mutation",
    deadline=None,
    derandomize=True,
    database=None,
    max_examples=25,
    phases=[hypothesis.Phase.explicit, hypothesis.Phase.generate],
)
hypothesis.settings.load_profile("kinlib")


def pytest_terminal_summary(terminalreporter):
    passed = terminalreporter.getreports("passed")
    seconds = {name: value for report in passed for name, value in report.user_properties if name.endswith(".ipynb")}
    if seconds:
        terminalreporter.section("seconds per notebook, from a cold kernel")
    for name, value in sorted(seconds.items()):
        terminalreporter.write_line(f"{value:5.1f}  {name}")
