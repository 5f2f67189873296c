"""Import nbgrader's gradebook without its web server, and nbformat without the formats of web addresses, times and colours.

`import nbgrader` imports what its Jupyter extensions need, and `import jsonschema` the packages that check formats, if they are
installed; rfc3987_syntax compiles forty grammars. Together this takes two seconds and 37 MB, and a gradebook needs none of it.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec, module_from_spec

PACKAGE = "nbgrader"
FORMAT_PACKAGES = "rfc3987_syntax", "isoduration", "webcolors", "uri_template", "fqdn"


@contextmanager
def lazy_nbgrader() -> Iterator[None]:
    """Inside, modules of nbgrader are imported without its `__init__`, and jsonschema without its formats.

    A package that was imported before stays as it is. Afterwards, both can be imported completely.
    """
    spec, added = find_spec(PACKAGE), set[str]()
    if spec and PACKAGE not in sys.modules:
        sys.modules[PACKAGE] = module_from_spec(spec)
        added.add(PACKAGE)
    for name in {*FORMAT_PACKAGES} - {*sys.modules}:
        sys.modules[name] = None  # type: ignore[assignment]  # None makes the import fail
        added.add(name)
    try:
        yield
    finally:
        for name in added:
            del sys.modules[name]
