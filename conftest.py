"""Rules for every pytest run: which tests one worker takes together, in which order, and no silent skips in CI."""

import os
import sys

import pytest
from xdist.scheduler import LoadScopeScheduling

# Workers, kernels and builds of the site import the same packages: without stored bytecode, each of them would compile all of
# Jupyter, Matplotlib and SymPy again. Images of containers often switch it off.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

BROWSER = ("tests/browser/", "tests/site/")
"""The folders whose tests use a browser."""

WITHOUT_SITE = [f"tests/browser/test_{name}.py" for name in ("viewers", "jupyterlab", "planar_arm")]
FIRST = ("notebooks/", "exercises/", WITHOUT_SITE[0], "tests/browser/test_browser_lab.py", *WITHOUT_SITE[1:], *BROWSER)
"""What starts first, so that workers seldom wait for each other: the notebooks, whose outputs the site takes; one file while
another worker runs the last of them; a file that builds the site; what needs no site, meanwhile; and then what needs it."""


def group(nodeid):
    """Which tests a worker takes together: those of a file, of one notebook, or of one problem of a sheet.

    >>> group("tests/kinlib/test_chain.py::test_fk[rpr]")
    'tests/kinlib/test_chain.py'
    >>> group("tests/kincourse/sheets/test_sheets.py::test_a_blank_stub_earns_a_friendly_zero[None-07.4]")
    'tests/kincourse/sheets/test_sheets.py 07.4'
    """
    file, _, test = nodeid.partition("::")
    if file.endswith("/test_sheets.py"):
        return f"{file} {test.partition('[')[2].removesuffix(']').rpartition('-')[2]}".strip()
    return file


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(items):
    """Start with the tests in FIRST, in this order."""
    items.sort(key=lambda item: [not item.nodeid.startswith(start) for start in FIRST])
    return (yield)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Distribute tests by `group`, with --dist=loadscope."""

    class GroupScheduling(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            return group(nodeid)

    return GroupScheduling(config, log) if config.getvalue("dist") == "loadscope" else None


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
