"""The index of the search: an entry for each section, term of the glossary and function, with its own address.

A word in German or of another book is found because pages/glossary.md has it. MiniSearch, which the page of the search loads
(static/search.js), ranks the entries by the kinds of `KINDS`; other words for a query are its `SYNONYMS`.
"""

import json
import re
import shutil
from collections.abc import Iterator
from html import unescape
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

from kinsite.npm_packages import MODULES

UNLISTED = {"404", "search", "index"}
SKIPPED = (nodes.literal_block, nodes.comment, addnodes.toctree, addnodes.index)
"""Parts of a section that are not searched: code, and what is only for the build. Of outputs, only questions are."""
SEPARATE = (nodes.section, nodes.title, nodes.definition_list, addnodes.glossary, addnodes.desc)
"""Parts of a section that are entries of their own, or its title."""

KINDS = {
    "lectures": "lecture",
    "sheets": "sheet",
    "mistakes": "mistakes",
    "robots": "robot",
    "reference": "reference",
    "guides": "contributing",
}
"""The kinds of pages, by their folder. A page in no folder is a kind of its own."""
DEFINED = {"glossary": "term"}
"""The kinds of definitions that are entries of their own, by their page."""

TAG = re.compile(r"<(script|style|svg|math)\b.*?</\1>|<[^>]+>", re.DOTALL)
LATEX = re.compile(r"\\(?:mathrm|mathcal|text|begin|end|frac|tag)\b|[\\{}$^&]|\$")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the functions of this module with Sphinx."""
    app.connect("build-finished", write_index)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def write_index(app: Sphinx, failed: Exception | None) -> None:
    """Write the entries as a script, which a page can also load from a folder, and MiniSearch."""
    if failed or app.builder.name != "html":
        return
    static = Path(app.outdir) / "_static"
    data = json.dumps(list(entries(app.env)), ensure_ascii=False, separators=(",", ":"))
    (static / "search-data.js").write_text(f"var kinlibSearchData = {data};\n", "utf-8")
    shutil.copy(MODULES / "minisearch" / "dist" / "umd" / "index.js", static / "minisearch.js")


def entries(env: BuildEnvironment) -> Iterator[dict[str, str]]:
    """Yield the entries of all pages: address, title, title of the page, kind and text."""
    for page in sorted(env.found_docs - UNLISTED):
        heading = clean(env.titles[page], own=True)
        for title, anchor, kind, text in page_entries(page, env.get_doctree(page)):
            yield {"url": f"{page}.html{anchor}", "title": title, "page": heading, "kind": kind, "text": text}


def page_entries(page: str, tree: nodes.document) -> Iterator[tuple[str, str, str, str]]:
    """Yield the entries of one page: title, anchor, kind and text."""
    folder, _, name = page.partition("/")
    kind = KINDS.get(folder, folder) if name[:1].isdigit() or folder not in ("lectures", "sheets") else name
    for section in tree.findall(nodes.section):
        is_page = section.parent is tree
        text = " ".join(filter(None, map(clean, section.children)))
        own_kind = "table" if kind == "robot" and not is_page else kind  # each robot has the same tables
        yield clean(section[0], own=True), "" if is_page else f"#{section['ids'][0]}", own_kind, text
    for item in tree.findall(nodes.definition_list_item):
        if folder in DEFINED and (ids := anchors(item)):
            term, *definition = item.children
            text = " ".join(clean(part, own=True) for part in definition)
            yield clean(term).strip(), f"#{ids[0]}", DEFINED[folder], text
    for described in tree.findall(addnodes.desc):
        signature = next(iter(described.findall(addnodes.desc_signature)))
        if signature["ids"]:
            name, text = signature["ids"][0], " ".join(map(clean, described.children[1].children))
            yield name.rpartition(".")[2], f"#{name}", "function", text


def anchors(item: nodes.Element) -> list[str]:
    """The ids of a definition's term, or of what is in it."""
    return [
        name for part in item.findall(nodes.Element) if not isinstance(part, nodes.definition) for name in part["ids"]
    ]


def clean(node: nodes.Node, own: bool = False) -> str:
    """The words of a part of a page, without code, markup and what is an entry of its own.

    own  whether the node itself is an entry of its own
    """
    if isinstance(node, SKIPPED) or (isinstance(node, SEPARATE) and not own):
        return ""
    if isinstance(node, nodes.raw):
        return words(unescape(TAG.sub(" ", node.astext()))) if "misstep-question" in node.astext() else ""
    if isinstance(node, nodes.math | nodes.math_block):
        return words(node.astext())
    if isinstance(node, nodes.Text):
        return str(node)
    inline = isinstance(node, nodes.TextElement)
    return ("" if inline else " ").join(filter(None, (clean(child) for child in node.children)))


def words(text: str) -> str:
    r"""Remove the commands of LaTeX.

    >>> words("the axis $\\omega$")
    'the axis omega'
    """
    return re.sub(r"\s+", " ", LATEX.sub("", text)).strip()
