"""Rules for every pytest run: which tests start first, and no silent skips in CI."""

import os
import sys

import pytest

# Workers, kernels and builds of the site import the same packages: without stored bytecode, each of them would compile all of
# Jupyter, Matplotlib and SymPy again. Images of containers often switch it off.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

BROWSER = ("tests/browser/", "tests/site/")
"""The folders whose tests use a browser."""

FIRST = (
    "notebooks/",
    "exercises/",
    "tests/browser/test_viewers.py",
    "tests/browser/test_browser_lab.py",
    "tests/browser/test_jupyterlab.py",
    "tests/browser/test_planar_arm.py",
    "tests/kincourse/sheets/",
    *BROWSER,
)
"""What starts first, so that workers seldom wait for each other: the notebooks, whose outputs the site takes; one file while
another worker runs the last of them; the file that builds the site; what needs no site, meanwhile; and then what needs it."""


@pytest.fixture(autouse=True, scope="session")
def import_kinlib(doctest_namespace):
    """Give the examples in docstrings kl, as the lectures import it."""
    import kinlib

    doctest_namespace["kl"] = kinlib


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(items):
    """Start with the tests in FIRST, in this order."""
    items.sort(key=lambda item: [not item.nodeid.startswith(start) for start in FIRST])
    return (yield)


def pytest_runtest_setup(item):
    """Close the browsers before another test, which may call asyncio.run."""
    if "browser" in sys.modules and not item.nodeid.startswith(BROWSER):
        sys.modules["browser"].close_browsers()


def fail_if_skipped(report):
    """Turn the report of a skipped test or module into a failure, in CI on Linux. Expected failures (xfail) stay.

    .ci/run and GitHub's Linux runners have a browser, Node with npm and every oracle: a skip there means that part of the
    course is not tested. Elsewhere it is legitimate: for example, Pinocchio has no wheel for Windows.
    """
    if "CI" in os.environ and sys.platform == "linux" and report.skipped and not hasattr(report, "wasxfail"):
        reason = report.longrepr[-1] if isinstance(report.longrepr, tuple) else report.longrepr
        report.outcome = "failed"
        report.longrepr = f"{report.nodeid} must not be skipped in CI. {reason}"
    return report


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_makereport():
    """Fail a test that is skipped in CI."""
    return fail_if_skipped((yield))


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_make_collect_report():
    """Fail a module that is skipped in CI."""
    return fail_if_skipped((yield))
