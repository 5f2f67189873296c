"""What pytest leaves alone, and what it is asked beside its own: grading is made of Linux, oracles are asked for."""

import sys
from pathlib import Path

# On Windows not even its modules load.
collect_ignore = (
    ["kinlib/grading", "tests/fuzz_answers.py", "tests/fuzz_notebooks.py"] if sys.platform == "win32" else []
)


def pytest_addoption(parser):
    """Let tests be doubted, which takes twice as long as running them."""
    parser.addoption("--oracles", action="store_true", help="doubt every test that names an oracle, and print them all")


def pytest_configure(config):
    """Doubt them, if that is asked for."""
    if config.getoption("--oracles"):
        sys.path.insert(0, str(Path(__file__).parent / "tests"))
        config.pluginmanager.import_plugin("doubts")
