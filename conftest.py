"""Options and rules for every pytest run: the oracle check, what Windows leaves out, and no silent skips in CI."""

import os
import sys

import pytest

# Grading needs Linux or macOS; on Windows not even its modules can be imported.
collect_ignore = (
    ["misstep/grading", "tests/fuzz/test_fuzz_answers.py", "tests/fuzz/test_fuzz_notebooks.py"]
    if sys.platform == "win32"
    else []
)


def pytest_addoption(parser):
    """Add --oracles, which takes twice as long as the tests that it checks."""
    parser.addoption("--oracles", action="store_true", help="check that every comparison with an oracle can fail")


def pytest_configure(config):
    """Load the oracle check if --oracles is given."""
    if config.getoption("--oracles"):
        config.pluginmanager.import_plugin("check_oracles")


# --- skipped tests fail in CI ---
# .ci/run and GitHub's Linux runners have everything that the tests need: a browser, Node with npm, the sandbox, every oracle.
# A skip there means that part of the course is not tested. On other systems, a skip is legitimate where the system lacks
# something for good: forks, the sandbox and a wheel of Pinocchio on Windows, and the sandbox on macOS.


def fail_if_skipped(report):
    """Turn the report of a skipped test or module into a failure, in CI on Linux. Expected failures (xfail) stay."""
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
