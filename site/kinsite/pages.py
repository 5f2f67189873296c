"""What stands around the text of each page: the bar above a lecture or a sheet, the script and style that it needs."""

import shutil
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from kinlib import robots
from kinlib.view import explore
from kinlib.view.viewer import STATIC
from kinsite.fonts import FONTS


def setup(app: Sphinx) -> dict[str, Any]:
    """Tell Sphinx what to call, and when."""
    app.add_directive("kinlib-arm", ArmDirective)
    app.connect("builder-inited", bring_files)
    app.connect("html-page-context", around, priority=800)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


class ArmDirective(SphinxDirective):
    """An arm of kl.robots, to turn."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Show it."""
        made = getattr(robots, self.arguments[0])()
        return [nodes.raw("", explore(made).html(), format="html")]


def bring_files(app: Sphinx) -> None:
    """Bring the viewer and KaTeX's style and fonts; every browser that we serve reads woff2."""
    target = Path(app.outdir) / "_static"
    (target / "katex" / "fonts").mkdir(parents=True, exist_ok=True)
    shutil.copy(FONTS / "katex.min.css", target / "katex")
    for font in (FONTS / "fonts").glob("*.woff2"):
        shutil.copy(font, target / "katex" / "fonts")
    for script in STATIC.glob("*.js"):
        shutil.copy(script, target)
    files = Path(app.srcdir) / "files"
    if files.exists():
        shutil.copytree(files, Path(app.outdir) / "files", dirs_exist_ok=True)


def around(app: Sphinx, page: str, _: str, context: dict[str, Any], doctree: Any) -> None:
    """Say what the templates need to know of a page."""
    folder, _, name = page.partition("/")
    is_notebook = folder in ("lectures", "sheets") and name != "index" and doctree is not None
    context["kinlib_notebook"] = f"files/{page}.ipynb" if is_notebook else ""
    context["kinlib_kind"] = folder.rstrip("s") if is_notebook else ""
    context["kinlib_sheet"] = name if folder == "lectures" and f"sheets/{name}" in app.env.found_docs else ""
    context["kinlib_lecture"] = name if folder == "sheets" and f"lectures/{name}" in app.env.found_docs else ""
