"""Make the archives of Python in the browser small and fast: compiled modules, and nothing that no cell can use.

precompile.mjs runs this file in the Pyodide of the site, because only the same Python reads the modules that it has compiled.
The archives are written by the Python that builds the site, which compresses much faster.
"""

import marshal
import re
import sys
from importlib.util import MAGIC_NUMBER, cache_from_source, source_hash
from pathlib import Path
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


def loaded_paths() -> set[str]:
    """List the modules that this Python has loaded, by their paths in their archives."""
    files = [getattr(module, "__file__", None) for module in sys.modules.values()]
    return {re.sub(r".*/(?:site-packages|python\d+\.zip)/", "", file) for file in files if isinstance(file, str)}


def compile_loaded(source: str, target: str, with_sources: bool, loaded: set[str] | None = None) -> None:
    """Write the modules of an archive that are loaded into another archive, compiled, at their places beside the sources."""
    loaded = loaded_paths() if loaded is None else loaded
    with ZipFile(source) as old, ZipFile(target, "w") as new:
        for path in (name for name in old.namelist() if name in loaded and name.endswith(".py")):
            text = old.read(path)
            code = marshal.dumps(compile(text, path, "exec", dont_inherit=True))
            unchecked = (1).to_bytes(4, "little")  # the flag of a module that is not compared with its source
            place = cache_from_source(path) if with_sources else f"{path}c"
            new.writestr(place, MAGIC_NUMBER + unchecked + source_hash(text) + code)


def rewrite(source: Path, modules: Path, target: Path) -> None:
    """Write an archive again with compiled modules, in the place of their sources or beside them.

    The others stay as they are, because a compiled module is larger. The same files always give the same bytes.
    """
    with ZipFile(source) as old, ZipFile(modules) as compiled_ones, ZipFile(target, "w") as new:
        files = dict.fromkeys(old.namelist(), old) | dict.fromkeys(compiled_ones.namelist(), compiled_ones)
        for path in sorted(name for name in files if f"{name}c" not in files):
            if not path.endswith("/") and not UNUSED.search(path):
                new.writestr(ZipInfo(path), files[path].read(path), ZIP_DEFLATED, 9)
