"""Prepare notebooks for a page: typeset formulas in outputs, write images to files, fold side tracks.

In JupyterLab, formulas in HTML are typeset by JupyterLab. Here they are typeset during the build, as in the text.
"""

import base64
import hashlib
import json
import re
import socket
import subprocess
import time
from html import escape, unescape
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.nodes import make_id
from lxml import etree
from lxml.html import HtmlElement
from sphinx.application import Sphinx
from sphinxcontrib import katex

from kinsite.html_tree import inner_html, read_html

katex.KATEX_DEFAULT_OPTIONS.update(throwOnError=True, strict="error")  # a formula with an error fails the build
katex.STARTUP_TIMEOUT = 60.0  # a busy machine needs more than the 5 s of the extension

NOT_TEXT = ("script", "style", "pre", "code", "textarea", "svg")
PUNCTUATION = re.compile(r"[.,;:?!)\]’”]+")
MAX_UNBROKEN_LENGTH = 24  # characters of LaTeX that fit on one line of any phone; a longer formula may be broken
TAG = re.compile(r"\\tag\{([^}]+)\}")  # the number of a formula
SIDE_TRACK = "Side track:"
"""The beginning of the heading of a section that may be skipped. JupyterLab folds it by the metadata of its cell."""
LENGTH = re.compile(r"([\d.]+)(?:pt|px)?")
FORMULA = re.compile(r"\$\$(.+?)\$\$|(?<!\\)\$([^$\n]+?)\$")


def start_katex(folder: Path, timeout: float) -> tuple[subprocess.Popen[bytes], socket.socket]:
    """Start the server that typesets formulas, and connect to it as soon as it listens.

    The extension's own function connects as soon as the socket's file exists, and gives up when the connection is
    refused. But on a busy machine, the server listens only a moment later.
    """
    address = str(folder / "katex.sock")
    command = katex.KaTeXServer.build_command(socket=address)
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=folder)
    connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    deadline = time.monotonic() + timeout
    while connection.connect_ex(address) != 0:
        if time.monotonic() > deadline:
            connection.close()
            process.kill()
            process.wait()
            raise katex.KaTeXServer.timeout_error(timeout)
        time.sleep(0.01)
    return process, connection


katex.KaTeXServer.start_server_process = staticmethod(start_katex)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the functions of this module with Sphinx."""
    app.connect("doctree-resolved", prepare_page)
    app.connect("doctree-resolved", fold_side_tracks)
    return {"parallel_read_safe": True, "parallel_write_safe": False}


def prepare_page(app: Sphinx, doctree: nodes.document, page: str) -> None:
    """Typeset the formulas in the HTML of a page, write its images to files, and keep punctuation with its formula."""
    for image in doctree.findall(nodes.image):
        image["loading"] = "lazy"  # the gallery alone has more than twenty
    for formula in list(doctree.findall(nodes.math)):
        keep_punctuation(formula)
    for block in list(doctree.findall(nodes.math_block)):
        if found := TAG.search(block.astext()):  # the anchor of a numbered formula comes before it
            anchor = f'<span class="kinlib-anchor" id="{make_id(f"formula {found[1]}")}"></span>'
            block.parent.insert(block.parent.index(block), nodes.raw("", anchor, format="html"))
    up, folder = "../" * page.count("/"), Path(app.outdir) / "_images"
    for cell in doctree.findall(nodes.container):
        if name := cell.get("cell_metadata", {}).get("kinlib-cell"):
            cell["classes"].append(f"kinlib-cell-{name}")  # for live.js, which hands in the cells of a sheet
    for node in list(doctree.findall(nodes.raw)):
        if node.get("format") != "html" or isinstance(node.parent, nodes.TextElement):
            continue  # within a line, a raw node is a single tag
        output = read_html(node.astext())
        typeset_formulas(output)
        extract_images(output, folder, f"{up}_images")
        for viewer in output.xpath(".//div[@data-kinlib-viewer][script]"):
            # the style sheet keeps the height free that a viewer will need; one without sliders has other controls
            sliders = len(json.loads(viewer.find("script").text)["scene"].get("sliders", [])) or 7
            viewer.set("style", f"--sliders:{sliders}")
        node.rawsource = inner_html(output)
        node.children = [nodes.Text(node.rawsource)]


def fold_side_tracks(_: Sphinx, doctree: nodes.document, page: str) -> None:
    """Fold the sections whose heading begins with "Side track:"; the heading opens its section."""
    for section in doctree.findall(nodes.section):
        title = section[0]
        if page.startswith("lectures/") and title.astext().startswith(SIDE_TRACK):
            section.insert(0, nodes.raw("", '<details class="kinlib-side"><summary>', format="html"))
            section.insert(2, nodes.raw("", "</summary>", format="html"))
            section.append(nodes.raw("", "</details>", format="html"))


def keep_punctuation(formula: nodes.math) -> None:
    """Keep a short formula and the punctuation after it on one line: a browser may break a line after any formula."""
    following = formula.next_node(descend=False, siblings=True)
    mark = PUNCTUATION.match(following.astext()) if isinstance(following, nodes.Text) else None
    if mark is None or len(formula.astext()) > MAX_UNBROKEN_LENGTH:
        return
    rest = nodes.Text(following.astext()[mark.end() :])
    following.parent.replace(following, rest)
    formula.parent.replace(formula, together := nodes.inline(classes=["together"]))
    together += [formula, nodes.Text(mark[0])]


def typeset_formulas(html: HtmlElement) -> None:
    """Typeset the formulas in HTML: $...$ within the line, $$...$$ on a line of their own; none in code."""
    outside = " and ".join(f"not(ancestor::{name})" for name in NOT_TEXT)
    for text in html.xpath(f".//text()[contains(., '$')][{outside}]"):
        element, new = text.getparent(), read_html(FORMULA.sub(typeset, escape(text, quote=False)))
        if text.is_text:
            element.text = None
            element.insert(0, new)
        else:
            element.tail = None
            element.addnext(new)
        new.drop_tag()


def typeset(found: re.Match[str]) -> str:
    """Typeset one formula with KaTeX."""
    options = {"displayMode": True} if found[1] else None
    return f'<span class="math">{katex.render_latex(unescape(found[1] or found[2]), options)}</span>'


def extract_images(html: HtmlElement, folder: Path, address: str) -> None:
    """Write the images of HTML to files, which a browser fetches only when they are scrolled into view, or printed (course.js)."""
    for image in html.xpath(".//img[starts-with(@src, 'data:image/')]"):
        kind, _, encoded = image.get("src").partition(";base64,")
        data, ending = base64.b64decode(encoded), "png" if kind.endswith("png") else "svg"
        name = f"{hashlib.sha256(data).hexdigest()[:20]}.{ending}"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
        image.set("loading", "lazy")
        image.set("src", f"{address}/{name}")
        if ending == "svg":  # so that the page does not jump when it is loaded
            for side, size in etree.fromstring(data).attrib.items():
                if side in ("width", "height") and (length := LENGTH.fullmatch(size)):
                    image.set(side, str(round(float(length[1]))))
