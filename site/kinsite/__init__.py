"""The course site: executes the notebooks, writes the pages that are made from kinlib, and shows outputs without a kernel."""

import sys

# jsonschema, which nbformat imports, would build 38 grammars to tell whether an IRI is one. No notebook holds any, and
# every build, also of nothing, would wait a second for them. None says that there is no such module.
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]

STRICT = ("-n", "-W", "--keep-going")
"""How Sphinx is called: whatever it warns of fails the build, and all of it is told before."""
