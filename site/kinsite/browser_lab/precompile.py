"""Make the archives of Python in the browser small and fast: compiled modules, and nothing that no cell can use.

precompile.mjs runs this file in the Pyodide of the site, because only the same Python reads the modules that it has compiled.
"""

import marshal
import re
import sys
from importlib.util import MAGIC_NUMBER, cache_from_source, source_hash
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

UNUSED = re.compile(
    r"""
    \.(?:pyi|pxd|[ach])$ | /include/ | numpy/f2py/      # for compilers and type checkers
    | \.data/ | /(?:lab|nb)extension/ | kinlib/view/js/ # scripts that are in the lab and on the pages already
    | /tests?/ | /RECORD$ | misstep/grading/
    | pygments/(?:lexers|styles)/(?!_|python|default)   # for other languages than Python
    """,
    re.VERBOSE,
)
"""Files that no cell can use."""

UNCHECKED = (1).to_bytes(4, "little")
"""The flag of a compiled module that is not compared with its source."""


def loaded_paths() -> set[str]:
    """List the modules that this Python has loaded, by their paths in their archives."""
    files = [getattr(module, "__file__", None) for module in sys.modules.values()]
    return {re.sub(r".*/(?:site-packages|python\d+\.zip)/", "", file) for file in files if isinstance(file, str)}


def compiled(source: bytes, path: str) -> bytes:
    """Compile a module to the bytes of a .pyc file.

    >>> compiled(b"x = 1", "m.py")[:4] == MAGIC_NUMBER
    True
    """
    code = compile(source, path, "exec", dont_inherit=True)
    return MAGIC_NUMBER + UNCHECKED + source_hash(source) + marshal.dumps(code)


def precompile(source: str, target: str, with_sources: bool, loaded: set[str] | None = None) -> None:
    """Write an archive again, with the modules that are loaded compiled, in the place of their sources or beside them.

    The others stay as they are, because a compiled module is larger. The same files always give the same bytes.
    """
    loaded = loaded_paths() if loaded is None else loaded
    with ZipFile(source) as old, ZipFile(target, "w") as new:
        for path in sorted(name for name in old.namelist() if not name.endswith("/") and not UNUSED.search(name)):
            data = old.read(path)
            is_compiled = path in loaded and path.endswith(".py")
            if is_compiled:
                place = cache_from_source(path) if with_sources else f"{path}c"
                new.writestr(ZipInfo(place), compiled(data, path), ZIP_DEFLATED, 9)
            if with_sources or not is_compiled:
                new.writestr(ZipInfo(path), data, ZIP_DEFLATED, 9)
