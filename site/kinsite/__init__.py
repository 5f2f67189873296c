"""The course site: executes the notebooks, generates the pages about the packages, and shows outputs without a kernel."""

import sys

# nbformat imports jsonschema, which would compile 38 grammars to recognise IRIs, for a second of every build. Notebooks
# contain no IRIs. None makes Python treat the module as missing, and then jsonschema leaves this check out.
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
