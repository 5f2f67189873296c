"""What stands around the text of each page: the bar above a lecture or a sheet, the script and style that it needs."""

import hashlib
import shutil
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from kinlib import robots
from kinlib.view import explore
from kinlib.view.viewer.viewer import STATIC
from kinsite.execute import library
from kinsite.fonts import FONTS


def setup(app: Sphinx) -> dict[str, Any]:
    """Tell Sphinx what to call, and when."""
    # whatever of ours changes, pages are read anew: what they show is made by it
    app.add_config_value("kinlib_made_by", made_by(), "env")
    app.add_config_value("kinlib_lab", "", "html")  # the folder of the lab, where there is one
    app.add_directive("kinlib-arm", ArmDirective)
    app.connect("builder-inited", bring_files)
    app.connect("html-page-context", around, priority=800)
    app.connect("build-finished", clear)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def made_by() -> str:
    """What kinlib and the site's own modules are now, as one name."""
    own = sorted(Path(__file__).parent.glob("*.py"))
    return hashlib.sha256(b"".join([library().encode(), *(path.read_bytes() for path in own)])).hexdigest()


class ArmDirective(SphinxDirective):
    """An arm of kl.robots, to turn; `at` says the joint values to begin with."""

    required_arguments = 1
    option_spec: ClassVar = {"at": lambda text: [float(value) for value in text.split()]}

    def run(self) -> list[nodes.Node]:
        """Show it."""
        made = getattr(robots, self.arguments[0])()
        return [nodes.raw("", explore(made, start=self.options.get("at")).html(), format="html")]


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


def clear(app: Sphinx, failed: Exception | None) -> None:
    """Remove pages whose source is gone: Sphinx leaves them, and search engines find them."""
    known = {*app.env.found_docs, "search"}
    for path in [] if failed else Path(app.outdir).rglob("*.html"):
        name = path.relative_to(app.outdir).with_suffix("").as_posix()
        if name not in known and not name.startswith(("_static/", "lab/")):
            path.unlink()


def around(app: Sphinx, page: str, _: str, context: dict[str, Any], doctree: Any) -> None:
    """Say what the templates need to know of a page."""
    # furo calls its captions headings and leaves out of which level; captions they are
    context["furo_navigation_tree"] = context["furo_navigation_tree"].replace(' role="heading"', "")
    folder, _, name = page.partition("/")
    is_notebook = folder in ("lectures", "sheets") and name != "index" and doctree is not None
    context["kinlib_notebook"] = f"files/{page}.ipynb" if is_notebook else ""
    inside = f"notebooks/{name}.ipynb" if folder == "lectures" else f"exercises/{name}/{name}.ipynb"
    where = app.config.kinlib_lab
    context["kinlib_run"] = f"{where}/notebooks/index.html?path={inside}" if where and is_notebook else ""
    context["kinlib_kind"] = folder.rstrip("s") if is_notebook else ""
    context["kinlib_sheet"] = name if folder == "lectures" and f"sheets/{name}" in app.env.found_docs else ""
    context["kinlib_lecture"] = name if folder == "sheets" and f"lectures/{name}" in app.env.found_docs else ""
