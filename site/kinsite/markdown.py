"""Write Markdown: docstrings as prose, and text with its special characters escaped.

Docstrings are plain text with aligned lists, to be read in the source. No standard docstring parser understands these lists.
"""

import inspect
import re

SPECIAL = re.compile(r"([\\`*_{}\[\]<>$|~^#])")
DEFINITION = re.compile(r"^(\S.{,40}?)(?:  +|(?<=\)) +(?=->))(\S.*)$")
"""A line in two columns, or a line such as "(..., 3) -> (..., 3, 3)"."""


def prose(text: str, doctest: bool = False) -> str:
    """Write a docstring as Markdown: paragraphs, aligned lists as definitions, examples as code.

    doctest  whether to include the examples
    """
    parts = []
    for block in re.split(r"\n\s*\n", text.strip()):
        if block.startswith(">>>"):
            parts += [f"```pycon\n{block}\n```"] if doctest else []
        elif block.startswith("    "):
            parts.append(f"```text\n{inspect.cleandoc(block)}\n```")
        else:
            parts.append(paragraph(block))
    return "\n\n".join(parts)


def paragraph(block: str) -> str:
    r"""Write one paragraph as Markdown, in which lines in two columns become definitions.

    >>> print(paragraph("(..., 3) -> (..., 3, 3), the matrix.\nIt is skew."))
    `(..., 3)`
    : -\> (..., 3, 3), the matrix.
    <BLANKLINE>
    It is skew.
    """
    lines: list[str] = []
    in_list = False
    for line in block.split("\n"):
        word, _, rest = line.partition(" ")
        if in_list and line.startswith("  "):
            lines.append(f"  {escape(line.strip())}")
        elif found := DEFINITION.match(line):
            lines.append(f"\n`{found[1].strip()}`\n: {escape(found[2])}")
            in_list = True
        else:
            blank_line = "\n" if in_list or word in ("Raises", "Source:") else ""
            lines.append(blank_line + (f"**{word}** {escape(rest)}" if word in ("Raises", "Source:") else escape(line)))
            in_list = False
    return "\n".join(lines).strip("\n")


def escape(text: str) -> str:
    r"""Escape the special characters of Markdown in a text, except in `code` and around *one emphasised word*.

    >>> escape("the *fixed* axes of `a_1`, **options")
    'the *fixed* axes of `a_1`, \\*\\*options'
    """
    parts = re.split(r"(`[^`]+`|(?<![\w*])\*[a-z]+\*(?![\w*]))", text)
    return "".join(part if index % 2 else SPECIAL.sub(r"\\\1", part) for index, part in enumerate(parts))
