"""What all tests share: the profiles of Hypothesis, one BLAS thread per worker, the browser, the site."""

import os
import subprocess
from pathlib import Path

if "PYTEST_XDIST_WORKER" in os.environ:
    # Workers already share the cores. BLAS reads this once, when NumPy is imported; kernels that tests start inherit it.
    os.environ.update(dict.fromkeys(("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"))

import hypothesis
import matplotlib as mpl
import pytest
from browser import close_browsers, running_browser
from notebook_runs import Recorder

# Not by the variable MPLBACKEND, because kernels would inherit it and draw differently than they do for a student.
mpl.use("agg")

# Deadlines measure the machine, not the code. In CI, the same commit draws the same examples; elsewhere each run draws new ones.
hypothesis.settings.register_profile(
    "kinlib", deadline=None, derandomize="CI" in os.environ, print_blob=True, max_examples=12
)
hypothesis.settings.load_profile("kinlib")


def pytest_configure(config):
    """Record what nbval executes."""
    config.pluginmanager.register(Recorder())


@pytest.fixture
def committed(tmp_path):
    """The files as git stores them, so that the tests also pass if you have worked in a notebook and saved it."""
    root = Path(__file__).parents[1]
    command = ["git", "checkout-index", "--all", f"--prefix={tmp_path.as_posix()}/"]
    return root if subprocess.run(command, cwd=root, capture_output=True, check=False).returncode else tmp_path


# --- the browser and the site ---
# conftest.py of the repository puts these tests one after the other, so that a browser starts once in each worker.


def pytest_sessionfinish():
    close_browsers()


@pytest.fixture(scope="module")
def chromium():
    return running_browser(webgl=True)


@pytest.fixture(scope="module")
def chromium_without_webgl():
    """A browser without WebGL, because drawing many arms without a graphics card takes minutes."""
    return running_browser(webgl=False)


@pytest.fixture(scope="module")
def site_folder():
    """The folder of the built site."""
    from built_site import build_site

    return build_site()


@pytest.fixture(scope="module")
def site_address(site_folder):
    """The address at which the built site is served."""
    from built_site import served

    with served(site_folder) as address:
        yield address


@pytest.fixture(scope="module")
def lab_address(site_folder, site_address):
    """The address of the built site, which must contain the lab."""
    if not (site_folder / "lab").exists():
        pytest.skip("NO LAB WAS BUILT: its files could not be downloaded.")
    return site_address
