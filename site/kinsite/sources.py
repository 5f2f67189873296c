"""What Sphinx reads: the pages of site/pages, the executed notebooks, and the pages that are made from kinlib.

A file is only touched when it changes, so that Sphinx reads only what has changed.
"""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from kinsite import gallery, mistakes, performance, progress, reference, witnesses
from kinsite.execute import ROOT, execute_all, made

SITE = ROOT / "site"
LECTURES = sorted((ROOT / "notebooks").glob("*.ipynb"))
SHEETS = sorted(path for path in (ROOT / "exercises").glob("*/*.ipynb"))

MOVED = {
    r"\.\./exercises/(\w+)/\1\.ipynb": r"../sheets/\1.ipynb",
    r"\.\./NOTATION\.md": "../notation.md",
    r"\.\./CONTRIBUTING\.md": "../contributing.md",
}
"""Where a link of a notebook leads on the site."""

CHECKED = "# NBVAL_CHECK_OUTPUT"
"""Tells the tests to compare what a cell shows; it tells a reader nothing."""

SAMPLE = """\
:::{{note}}
The numbers below are those of the id "your id". Yours come from your own id, and so nobody can copy them:
run this sheet in the browser, or {{download}}`download it </{path}>` and open it in Jupyter, and write your id in its first cell.
:::
"""


def prepare(source: Path) -> None:
    """Write everything that Sphinx reads into a folder, and remove what is no longer there.

    Raises NotebookRaised for a notebook that does not run, ValueError for a robot without a source.
    """
    written = {source / name for name, text in pages() if write(source / name, text)}
    for old in source.rglob("*"):
        if old.is_file() and old not in written:
            old.unlink()


def pages() -> Iterator[tuple[str, str]]:
    """Every page of the site: its path and its text."""
    executed = execute_all([*reversed(LECTURES), *SHEETS])
    yield from written_pages()
    yield from performance.pages()
    yield from notebooks(executed)
    yield from witnesses.pages()
    yield from progress.pages(*({path: executed[path] for path in paths} for paths in (LECTURES, SHEETS)))
    for module in (gallery, mistakes, reference):
        source = Path(module.__file__ or "").read_text("utf-8")
        yield from made(module.__name__.rpartition(".")[2], module.pages, source).items()


def written_pages() -> Iterator[tuple[str, str]]:
    """The pages that people have written, in site/pages and at the top of the repository."""
    for path in sorted((SITE / "pages").rglob("*.md")):
        text = path.read_text("utf-8")
        yield path.relative_to(SITE / "pages").as_posix(), linked(text) if path.stem == "glossary" else text
    yield "notation.md", (ROOT / "NOTATION.md").read_text("utf-8")
    yield "contributing.md", (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    if (SITE / "instructors.md").exists():
        yield "instructors.md", (SITE / "instructors.md").read_text("utf-8")


def linked(text: str) -> str:
    r"""Text whose lectures can be followed: "Lecture 04" becomes a link to it.

    >>> linked("Lecture 00.")
    '[Lecture\xa000](lectures/00_start_here.ipynb).'
    """
    names = {path.stem[:2]: path.name for path in LECTURES}
    return re.sub(
        r"([Ll]ecture)\s(\d\d)\b",
        lambda found: f"[{found[1]}\N{NO-BREAK SPACE}{found[2]}](lectures/{names[found[2]]})",
        text,
    )


def notebooks(executed: Mapping[Path, NotebookNode]) -> Iterator[tuple[str, str]]:
    """The lectures as they run, the sheets as they look before anybody has answered, and both as files to take away."""
    for path in LECTURES:
        yield f"lectures/{path.name}", nbformat.writes(moved(executed[path]))
        yield f"files/lectures/{path.name}", path.read_text("utf-8")
    for path in SHEETS:
        yield f"sheets/{path.name}", nbformat.writes(unanswered(moved(executed[path]), path))
        yield f"files/sheets/{path.name}", path.read_text("utf-8")


def moved(notebook: NotebookNode) -> NotebookNode:
    """A notebook whose links lead to where things are on the site, without the marks that are for tests."""
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            for old, new in MOVED.items():
                cell.source = re.sub(rf"\]\({old}", f"]({new}", cell.source)
        else:
            cell.source = cell.source.removeprefix(f"{CHECKED}\n")
    notebook.metadata.pop("widgets", None)
    return notebook


def unanswered(notebook: NotebookNode, path: Path) -> NotebookNode:
    """A sheet without the cards that say, below each problem, that nothing has been answered yet."""
    for cell in notebook.cells:
        if cell.get("id", "").startswith(("check-", "tally", "open")):
            cell.outputs = []
    notebook.cells.insert(
        1, nbformat.v4.new_markdown_cell(SAMPLE.format(path=f"files/sheets/{path.name}"), id="sample")
    )
    return notebook


def write(path: Path, text: str) -> bool:
    """Write a file unless it says so already."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text("utf-8") != text:
        path.write_text(text, "utf-8")
    return True
