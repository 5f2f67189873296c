"""What the tests of courses share: the wheel of the engine."""

import subprocess
import sys

import pytest
import submissions


@pytest.fixture(scope="session")
def wheel(tmp_path_factory):
    """The wheel of misstep, built from its own pyproject.toml without a network."""
    out = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-P", "-m", "hatchling", "build", "-t", "wheel", "-d", str(out)]
    subprocess.run(command, cwd=submissions.ROOT / "misstep", check=True, capture_output=True)
    return next(out.glob("*.whl"))
