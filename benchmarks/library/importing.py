"""Time of `import kinlib` in a new interpreter, compared with `import numpy` alone, which kinlib needs.

    python -m benchmarks importing

Each round starts Python twice, once for each import. Bytecode is cached in a separate folder, as it is where packages are
installed; the round that fills the cache is dropped. Both times include the start of Python, which nobody can avoid.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from benchmarks.measure import Row, Workload, compare

ROOT = Path(__file__).parents[2]


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the row of the table."""
    with tempfile.TemporaryDirectory() as folder:
        variables = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        environment = {**variables, "PYTHONPYCACHEPREFIX": folder, "PYTHONPATH": str(ROOT)}

        def importing(name: str) -> Workload:
            command = [sys.executable, "-c", f"import {name}"]
            return Workload(partial(subprocess.run, command, env=environment, check=True))

        peers = {"import numpy": (partial(importing, "numpy"), 1.3)}
        yield from compare("import kinlib", importing("kinlib"), peers, rounds=1 if quick else 31, at_most=True)
