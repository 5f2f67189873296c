"""Options and rules for every pytest run: --quick, the oracle check, the order of tests, and no silent skips in CI."""

import os
import sys
from collections import defaultdict

import pytest

# Workers, kernels, graders and builds of the site import the same packages: without stored bytecode, each of them would compile
# all of Jupyter, Matplotlib and SymPy again. Images of containers often switch it off.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

# The template of a new course, and its examples, can be imported only after they were copied; test_new_course.py does so.
collect_ignore = ["misstep/new_course/template", "misstep/new_course/examples"]
# Grading needs Linux or macOS; on Windows not even its modules can be imported.
if sys.platform == "win32":
    collect_ignore += ["misstep/grading"]


def pytest_addoption(parser):
    """Add --quick, --nightly, and --oracles, which takes twice as long as the tests that it checks."""
    parser.addoption("--oracles", action="store_true", help="check that every comparison with an oracle can fail")
    parser.addoption("--nightly", action="store_true", help="also run tests marked nightly, which take minutes each")
    parser.addoption("--quick", action="store_true", help="leave out what is slow; three minutes on two cores")


def pytest_configure(config):
    """Load the oracle check if --oracles is given."""
    if config.getoption("--oracles"):
        config.pluginmanager.import_plugin("check_oracles")


# --- how long it takes, and what --quick leaves out ---

PROCESSOR_MINUTES = {False: 18, True: 3}
"""Minutes of one core that the whole suite and --quick keep busy, with their browsers and servers: on two cores, half of that."""

SLOW = (
    *("tests/site", "tests/browser", "tests/fuzz", "tests/misstep/grading", "exercises", "solutions", "notebooks"),
    *("tests/misstep/courses", "tests/misstep/test_release.py"),
    *("tests/repository/test_ci.py", "tests/repository/test_javascript.py"),
    *("tests/repository/test_packages.py", "tests/kinlib/test_types.py"),
)
"""What --quick leaves out: all that needs the site, a browser, the sandbox, npm or a pytest of its own; and notebooks but three."""

QUICK_NOTEBOOKS = (
    "notebooks/03_poe_space.ipynb",
    "exercises/03_poe_space/03_poe_space.ipynb",
    "solutions/03_poe_space/03_poe_space.ipynb",
)

QUICK_CASES = 3
"""How many cases of each parametrized test --quick keeps."""


def pytest_report_header(config):
    """Say how long the tests take if all of them run."""
    if config.args_source is not pytest.Config.ArgsSource.TESTPATHS or config.option.collectonly:
        return None
    cores = min(os.cpu_count() or 1, 4)  # more of them do not help: the site is built by one
    minutes = PROCESSOR_MINUTES[config.option.quick]
    hint = "" if config.option.quick else "; --quick leaves out the site, browser, sandbox and most notebooks"
    return f"these tests take about {minutes / cores:.0f} min on {cores} idle cores{hint}"


def pytest_ignore_collect(collection_path, config):
    """With --quick, do not even import slow tests."""
    if not config.option.quick:
        return None
    is_slow = any(collection_path.is_relative_to(config.rootpath / path) for path in SLOW)
    is_kept = any((config.rootpath / kept).is_relative_to(collection_path) for kept in QUICK_NOTEBOOKS)
    return True if is_slow and not is_kept else None  # None leaves it to other plug-ins


def thinned(items):
    """Keep some cases of each parametrized test, from all over its list.

    >>> from types import SimpleNamespace
    >>> tests = [SimpleNamespace(nodeid=f"test_fk[{k}]") for k in range(7)] + [SimpleNamespace(nodeid="test_other")]
    >>> [test.nodeid for test in thinned(tests)]
    ['test_fk[0]', 'test_fk[3]', 'test_fk[6]', 'test_other']
    """
    cases = defaultdict(list)
    for item in items:
        cases[item.nodeid.partition("[")[0]].append(item)
    return [item for alike in cases.values() for item in alike[:: -(-len(alike) // QUICK_CASES)]]


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


# --- the order of tests, and which tests run on one worker ---

LONGEST_FIRST = (
    "notebooks/",
    "exercises/",
    "tests/site/test_site.py",
    "solutions/",
    "tests/kincourse/sheets/test_sheets.py",
)
"""What starts first, so that all workers end at about the same time. The site and the tests of notebooks use the outputs of these."""


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(config, items):
    """Start with what failed in the last run, then with what takes longest."""
    kept = [item for item in items if config.option.nightly or not item.get_closest_marker("nightly")]
    kept = set(thinned(kept) if config.option.quick else kept)
    config.hook.pytest_deselected(items=[item for item in items if item not in kept])
    items[:] = [item for item in items if item in kept]
    failed = config.cache.get("cache/lastfailed", {}) if hasattr(config, "cache") else {}
    failed_groups = {group(nodeid) for nodeid in failed}

    def place(item):
        is_long = [item.nodeid.startswith(start) for start in LONGEST_FIRST]
        return group(item.nodeid) not in failed_groups, [not one for one in is_long]

    items.sort(key=place)
    return (yield)


def group(nodeid):
    """Which tests a worker takes together: those of a file, or of one notebook, or of one problem of a sheet.

    >>> group("tests/kinlib/test_chain.py::test_fk[rpr]")
    'tests/kinlib/test_chain.py'
    >>> group("notebooks/01_frames.ipynb::Cell 3")
    'notebooks/01_frames.ipynb'
    >>> group("tests/kincourse/sheets/test_sheets.py::test_a_blank_stub_earns_a_friendly_zero[None-07.4]")
    'tests/kincourse/sheets/test_sheets.py 07.4'
    """
    file, _, test = nodeid.partition("::")
    parameters = test.partition("[")[2].removesuffix("]")
    if file.endswith("/test_sheets.py"):
        return f"{file} {parameters.rpartition('-')[2]}".strip()
    return file


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Distribute tests by `group`, with --dist=loadscope.

    Not by the mark xdist_group: with pytest 9.2, pytest-xdist 3.8 ignores it (https://github.com/pytest-dev/pytest-xdist/issues/1386).
    """
    if config.getvalue("dist") != "loadscope":
        return None
    from xdist.scheduler import LoadScopeScheduling

    class GroupScheduling(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            return group(nodeid)

    return GroupScheduling(config, log)
