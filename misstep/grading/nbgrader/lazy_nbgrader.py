"""Importing nbgrader's gradebook without its web server, and notebooks without a grammar of web addresses.

`import nbgrader` brings up what its extensions of Jupyter need, and `import jsonschema` compiles forty grammars if the package
rfc3987_syntax is there: together two seconds and 35 MB, for what no gradebook asks.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec, module_from_spec

PACKAGE = "nbgrader"
GRAMMARS = "rfc3987_syntax"


@contextmanager
def lean() -> Iterator[None]:
    """Inside, modules of nbgrader can be imported without its `__init__`, and jsonschema does without its grammars.

    Where one of them was imported before, it stays as it is. Afterwards both can be imported whole.
    """
    spec, added = find_spec(PACKAGE), set[str]()
    if spec and PACKAGE not in sys.modules:
        sys.modules[PACKAGE] = module_from_spec(spec)
        added.add(PACKAGE)
    if GRAMMARS not in sys.modules:
        sys.modules[GRAMMARS] = None  # type: ignore[assignment]  # so Python writes down that there is none
        added.add(GRAMMARS)
    try:
        yield
    finally:
        for name in added:
            del sys.modules[name]
