"""DH tables and their headings as Markdown and LaTeX."""

from collections.abc import Sequence

from kinlib.dh.parsing import COLUMNS


def in_latex(heading: str) -> str:
    r"""Write a heading in LaTeX."""
    return heading.replace("alpha", r"\alpha").replace("theta", r"\theta")


def markdown_table(rows: Sequence[Sequence[str]], heads: Sequence[str] = ("i", *COLUMNS)) -> str:
    """Write rows of entries as a table in Markdown, with the rows numbered from 1.

    heads  the headings of all columns, including the column of row numbers
    """
    lines = [" | ".join(cells) for cells in (heads, ["---"] * len(heads))]
    lines += [" | ".join([str(i), *row]) for i, row in enumerate(rows, start=1)]
    return "\n".join(f"| {line} |" for line in lines)
