"""How soon: `import kinlib` in a fresh interpreter, beside `import numpy` alone, which it cannot do without.

    python -m benchmarks importing

Each round starts Python anew for both. Bytecode is kept as it is wherever packages are installed, in a folder of its own;
the round that fills it does not count. Starting Python is part of both times, for nobody can wait for less.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from benchmarks.measure import Row, Way, compared

ROOT = Path(__file__).parents[2]


def rows(quick: bool = False) -> Iterator[Row]:
    """The row of the table."""
    with tempfile.TemporaryDirectory() as folder:
        kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        environment = {**kept, "PYTHONPYCACHEPREFIX": folder, "PYTHONPATH": str(ROOT)}

        def importing(name: str) -> Way:
            command = [sys.executable, "-c", f"import {name}"]
            return Way(partial(subprocess.run, command, env=environment, check=True))

        peers = {"import numpy": (partial(importing, "numpy"), 1.3)}
        yield from compared("import kinlib", importing("kinlib"), peers, rounds=1 if quick else 31, at_most=True)
