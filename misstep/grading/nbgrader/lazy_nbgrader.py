"""Import nbgrader's gradebook without its web server, and nbformat without the grammars of web addresses.

`import nbgrader` imports what its Jupyter extensions need, and `import jsonschema` compiles forty grammars if the package
rfc3987_syntax is installed. Together this takes two seconds and 35 MB, and a gradebook needs none of it.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec, module_from_spec

PACKAGE = "nbgrader"
GRAMMARS_PACKAGE = "rfc3987_syntax"


@contextmanager
def lazy_nbgrader() -> Iterator[None]:
    """Inside, modules of nbgrader are imported without its `__init__`, and jsonschema without its grammars.

    A package that was imported before stays as it is. Afterwards, both can be imported completely.
    """
    spec, added = find_spec(PACKAGE), set[str]()
    if spec and PACKAGE not in sys.modules:
        sys.modules[PACKAGE] = module_from_spec(spec)
        added.add(PACKAGE)
    if GRAMMARS_PACKAGE not in sys.modules:
        sys.modules[GRAMMARS_PACKAGE] = None  # type: ignore[assignment]  # None makes the import fail
        added.add(GRAMMARS_PACKAGE)
    try:
        yield
    finally:
        for name in added:
            del sys.modules[name]
