"""Write what Sphinx reads: the pages of site/pages, the executed notebooks, and the pages generated from the packages.

A file is written only if its text changes, so that Sphinx reads only what has changed.
"""

import re
from collections.abc import Iterator, Mapping
from html import unescape
from pathlib import Path

import nbformat
from docutils.nodes import make_id
from nbformat import NotebookNode

from kincourse.still_pictures import IMAGE
from kincourse.table_of_lectures import fill_home_page
from kinsite.execute import ROOT, execute_all
from kinsite.generated import gallery, mistakes, progress, reference

SITE = ROOT / "site"
LECTURES = sorted((ROOT / "notebooks").glob("*.ipynb"))
SHEETS = sorted((ROOT / "exercises").glob("*/*.ipynb"))

LINK_TARGETS = {
    r"(?:\.\./)+notebooks/(\w+)\.ipynb": r"../lectures/\1.ipynb",
    r"\.\./exercises/(\w+)/\1\.ipynb": r"../sheets/\1.ipynb",
    r"\.\./NOTATION\.md": "../notation.md",
    r"\.\./site/pages/glossary\.md": "../glossary.md",
}
"""Where the links of a notebook lead on the site."""

OUTPUT_LINK = re.compile(r'href="([\w./]+)\.(?:ipynb|md)(?:#([^"]*))?"')
"""A link in the output of a cell: to a section to re-read, or in an explanation. Sphinx does not resolve links in HTML."""

TO_RUN = re.compile(r"Replace the `\.\.\.` in each answer cell, run the cell, and then run the check below it\.\s+")
"""What a sheet says to do in Jupyter; its page says at the top what to do there."""

SAMPLE_NOTE = """\
:::{{note}}
:class: kinlib-sample
The numbers below are those of the id "your id". Your own numbers are different, because they are computed from your id:
work on this page in a browser that runs scripts, or
{{download}}`download it </{path}>` and open it in Jupyter, and write your id in its first cell.
:::
"""


def write_source(folder: Path) -> None:
    """Write everything that Sphinx reads into a folder, and delete the files of earlier builds that are not needed any more."""
    pages = {folder / name: text for name, text in all_pages()}
    for path, text in pages.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
    for old in folder.rglob("*"):
        if old.is_file() and old not in pages:
            old.unlink()


def all_pages() -> Iterator[tuple[str, str]]:
    """Yield the path and the text of every page of the site."""
    executed = execute_all([*reversed(LECTURES), *SHEETS])
    yield from handwritten_pages()
    yield from notebook_pages(executed)
    yield from progress.pages(*({path: executed[path] for path in paths} for paths in (LECTURES, SHEETS)))
    for generated in (gallery, reference, mistakes):
        yield from generated.pages()


def handwritten_pages() -> Iterator[tuple[str, str]]:
    """Yield the pages that are written by hand, in site/pages and at the top of the repository."""
    for path in sorted((SITE / "pages").rglob("*.md")):
        name, text = path.relative_to(SITE / "pages").as_posix(), path.read_text("utf-8")
        text = text.replace("(../instructors.md", "(instructors.md")  # on the site, all of them are in one folder
        complete = {"glossary.md": link_lectures, "index.md": fill_home_page}.get(name, str)
        yield name, complete(text)
    yield "notation.md", (ROOT / "NOTATION.md").read_text("utf-8")
    yield "instructors.md", (SITE / "instructors.md").read_text("utf-8").replace("](pages/", "](")


def link_lectures(text: str) -> str:
    r"""Turn each mention of a lecture, such as "Lecture 04", into a link to it.

    >>> link_lectures("Lecture 00.")
    '[Lecture\xa000](lectures/00_start_here.ipynb).'
    """
    names = {path.stem.partition("_")[0]: path.name for path in LECTURES}
    return re.sub(
        r"([Ll]ecture)\s(\d\d[a-z]?)\b",
        lambda found: f"[{found[1]}\N{NO-BREAK SPACE}{found[2]}](lectures/{names[found[2]]})",
        text,
    )


def notebook_pages(executed: Mapping[Path, NotebookNode]) -> Iterator[tuple[str, str]]:
    """Yield the executed lectures, the sheets without answers, and the file of each notebook for download."""
    for path in LECTURES:
        yield f"lectures/{path.name}", nbformat.writes(picture_first(adapt(executed[path])))
        download = nbformat.read(path, as_version=4)
        download.cells[0].source = IMAGE.sub("", download.cells[0].source)  # its file is not downloaded
        yield f"files/lectures/{path.name}", nbformat.writes(download)
    for path in SHEETS:
        yield f"sheets/{path.name}", nbformat.writes(without_cards(adapt(executed[path]), path))
        yield f"files/sheets/{path.name}", path.read_text("utf-8")


def adapt(notebook: NotebookNode) -> NotebookNode:
    """Make the links of a notebook lead to the pages of the site, and name its cells."""

    def linked(text: str, start: str) -> str:
        for old, new in LINK_TARGETS.items():
            text = re.sub(re.escape(start) + old, start + new, text)
        return text

    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = linked(cell.source, "](")
            continue
        cell.metadata["kinlib-cell"] = cell.get("id", "")  # names the addresses of its figures
        for data in (output["data"] for output in cell.outputs if "text/html" in output.get("data", {})):
            data["text/html"] = OUTPUT_LINK.sub(link_to_page, linked(data["text/html"], 'href="'))
    return notebook


def picture_first(notebook: NotebookNode) -> NotebookNode:
    """Show the film of a lecture directly below its title, where a notebook that has not run has a still picture."""
    first = notebook.cells[0]
    if IMAGE.search(first.source):
        title, _, text = IMAGE.sub("", first.source).partition("\n\n")
        first.source = title
        notebook.cells.insert(2, nbformat.v4.new_markdown_cell(text, id=f"{first.id}-text"))
    return notebook


def link_to_page(found: re.Match[str]) -> str:
    """Make a link to a notebook, or to a section in it, lead to the page.

    >>> OUTPUT_LINK.sub(link_to_page, 'href="../lectures/06_dh_modified.ipynb#The-n-=-5-arm"')
    'href="../lectures/06_dh_modified.html#the-n-5-arm"'
    """
    section = f"#{make_id(unescape(found[2]))}" if found[2] else ""
    return f'href="{found[1]}.html{section}"'


def without_cards(notebook: NotebookNode, path: Path) -> NotebookNode:
    """Remove from a sheet the cards, which only say that nothing is answered yet, and how a notebook is answered; add a note."""
    for cell in notebook.cells:
        if cell.get("id", "").startswith(("check-", "tally", "open")):
            cell.outputs = []
    notebook.cells[0].source = TO_RUN.sub("", notebook.cells[0].source)
    note = SAMPLE_NOTE.format(path=f"files/sheets/{path.name}")
    notebook.cells.insert(1, nbformat.v4.new_markdown_cell(note, id="sample"))
    return notebook
