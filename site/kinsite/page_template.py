"""What surrounds the text of each page: the bar above a lecture or a sheet, the static files, the values of the templates."""

import hashlib
import shutil
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from kincourse.catalog import COURSE
from kincourse.lecture_00_start_here import planar_arm
from kincourse.table_of_lectures import sheet_of
from kinlib import robots
from kinlib.view import explore
from kinlib.view.viewer.widget import STATIC
from kinsite.demonstration import WrongAnswersDirective
from kinsite.execute import package_hash
from kinsite.html_tree import inner_html, read_html
from kinsite.npm_packages import FONTS, MODULES, TEXT_FONTS

PLANAR_ARM = [Path(planar_arm.__file__).with_suffix(suffix) for suffix in (".js", ".css")]
"""The arm of lecture 00, for the pages that have one."""
UNCOLOURED = {"n", "nn", "p", "pm", "w"}
"""Names, punctuation and spaces have the colour of all code in both themes: without elements of their own a page is lighter."""


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the functions of this module with Sphinx."""
    # Sphinx reads all pages again if this value changes, because the packages and these modules generate what they show
    own = b"".join(path.read_bytes() for path in sorted(Path(__file__).parent.rglob("*.py")))
    app.add_config_value("kinlib_generator_hash", package_hash() + hashlib.sha256(own).hexdigest(), "env")
    app.add_config_value("kinlib_lab", "", "html")  # the folder of the lab, or nothing if there is no lab
    app.add_directive("kinlib-arm", ArmDirective)
    app.add_directive("kinlib-wrong-answers", WrongAnswersDirective)
    app.connect("builder-inited", copy_files)
    app.connect("html-page-context", set_context, priority=800)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


class ArmDirective(SphinxDirective):
    """The interactive arm of the home page."""

    def run(self) -> list[nodes.Node]:
        """Insert the viewer of the arm."""
        return [nodes.raw("", explore(robots.youbot(), start=(0.5, 1.0, -1.3, -0.5, 0.4)).html(), format="html")]


def copy_files(app: Sphinx) -> None:
    """Copy the viewer, KaTeX's style and its fonts as woff2, which every supported browser reads, and the downloads."""
    target = Path(app.outdir) / "_static"
    # the scripts of KaTeX and marked are for outputs of cells that run on the page
    katex = [FONTS / name for name in ("katex.min.css", "katex.min.js", "contrib/auto-render.min.js")]
    copies = {
        target: [MODULES / "marked" / "lib" / "marked.umd.js", *STATIC.glob("*.js"), *PLANAR_ARM],
        target / "katex": katex,
        target / "katex" / "fonts": [*(FONTS / "fonts").glob("*.woff2")],
        Path(app.outdir): [Path(__file__).parents[1] / "service-worker.js"],  # it answers for its own folder only
    }
    for folder, sources in copies.items():
        folder.mkdir(parents=True, exist_ok=True)
        for source in sources:
            shutil.copy(source, folder)
    (target / "fonts").mkdir(exist_ok=True)
    for name, font in TEXT_FONTS.items():
        shutil.copy(font, target / "fonts" / name)
    sitemap = f"User-agent: *\nSitemap: {app.config.html_baseurl}sitemap.xml\n"
    (Path(app.outdir) / "robots.txt").write_text(sitemap, "utf-8")
    shutil.copytree(Path(app.srcdir) / "files", Path(app.outdir) / "files", dirs_exist_ok=True)


def set_context(app: Sphinx, page: str, _: str, context: dict[str, Any], doctree: Any) -> None:
    """Set the values that the templates need for a page."""
    context["body"] = adapt(context.get("body", ""), explains=not page.startswith(("reference/", "sheets/")))
    if "data-planar-arm" in context["body"]:
        app.add_js_file("planar_arm.js", defer="defer")
        app.add_css_file("planar_arm.css")
    # furo gives its captions the role of headings without a level, which is not valid; they are captions
    context["furo_navigation_tree"] = context["furo_navigation_tree"].replace(' role="heading"', "")
    folder, _, name = page.partition("/")
    is_notebook = folder in ("lectures", "sheets") and name != "index" and doctree is not None
    context["kinlib_notebook"] = f"files/{page}.ipynb" if is_notebook else ""
    path = f"notebooks/{name}.ipynb" if folder == "lectures" else f"exercises/{name}/{name}.ipynb"
    lab = app.config.kinlib_lab
    context["kinlib_run"] = f"{lab}/notebooks/index.html?path={path}" if lab and is_notebook else ""
    context["kinlib_lab_folder"] = f"{lab}/"
    context["kinlib_kind"] = folder.rstrip("s") if is_notebook else ""
    sheet = sheet_of(name) if folder == "lectures" else ""
    context["kinlib_sheet"] = sheet if f"sheets/{sheet}" in app.env.found_docs else ""
    lectures = [lecture for lecture in COURSE.lectures if f"lectures/{lecture}" in app.env.found_docs]
    context["kinlib_lectures"] = [one for one in lectures if folder == "sheets" and sheet_of(one) == name]


def adapt(body: str, explains: bool) -> str:
    """Make the text of a page lighter, and right for screen readers; headings of pages that explain count in the search."""
    page = read_html(body)
    for heading in page.xpath(".//th[@class='head'][not(normalize-space())][not(.//*[not(self::p)])]"):
        heading.clear(keep_tail=True)  # in a table without headings: a screen reader would say that it is one
        heading.tag = "td"
    for word in [span for span in page.iter("span") if span.get("class") in UNCOLOURED and not len(span)]:
        word.drop_tag()
    for fold in page.iter("summary"):
        fold.attrib.pop("aria-label", None)  # it is called what it shows
    for part in page.xpath(".//dl[contains(@class, 'glossary')] | .//dl[contains(@class, 'glossary')]/*"):
        part.tag = {"dt": "h2"}.get(part.tag, "div")  # a heading is a place that the search finds
    for heading in page.xpath(".//section/*[1][self::h2 or self::h3 or self::h4][not(@id)]"):
        heading.set("id", heading.getparent().attrib.pop("id"))  # likewise
    for heading in page.xpath(".//h1 | .//h2") if explains else ():
        heading.set("data-pagefind-weight", "10")  # the most that Pagefind knows
    for name in page.xpath(".//*[contains(@class, 'sig-name')]"):
        name.set("data-pagefind-weight", "5")
    return inner_html(page)
