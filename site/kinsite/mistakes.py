"""The index of mistakes: what each sheet recognises, and what it says then.

A message may hold numbers of the student whom it is for. Several students' problems are drawn, and what differs between
them is left out: so nobody's numbers stand on a page for all, and no right answer ever does.
"""

import re
from collections.abc import Iterator, Sequence

from myst_parser.slugs import github_slugify

from kincourse import find_sheet, sheets
from misstep.problem import Template
from misstep.sheet import Sheet

READERS = tuple(f"a reader of the site, {letter}" for letter in "abcdefgh")
"""Ids for whom the problems are drawn: enough of them that what can differ does."""

GAP = "…"
TOKEN = re.compile(r"\$[^$]*\$|`[^`]*`|[^\s$`]+|\s+")
MEASURED = re.compile(r"(?<![\w.^_{])-?\d+\.\d+")
"""Decimal numbers: measured on one student's robot, if a message holds any that few students share."""


def pages() -> Iterator[tuple[str, str]]:
    """One page a sheet, and one that leads to them."""
    found = [(name, find_sheet(name)) for name in sheets()]
    for name, sheet in found:
        yield f"mistakes/{name}.md", page(name, sheet)
    count = sum(len(messages(template)) for _, sheet in found for template in sheet.problems)
    yield "mistakes/index.md", overview(found, count)


def overview(found: Sequence[tuple[str, Sheet]], count: int) -> str:
    """The page that leads to the pages of the sheets."""
    listed = "\n".join(name for name, _ in found)
    return f"""\
# Index of mistakes

The sheets know {count} mistakes by name. A wrong answer that is one of them is not called wrong: the card says which
step went astray, in the words that stand on these pages.

Read them before you hand in. If you recognise yourself, you are in good company: every one of them was made by somebody,
in a lecture hall, in a book or in a library that people rely on.

Where a message speaks of your own numbers, these pages show {GAP} instead.

```{{toctree}}
:maxdepth: 1

{listed}
```
"""


def page(name: str, sheet: Sheet) -> str:
    """The mistakes of one sheet, problem by problem."""
    number = name[:2]
    parts = [
        f"# Mistakes of sheet {number}: {sheet.title[0].lower()}{sheet.title[1:]}",
        f"What [sheet {number}](../sheets/{name}.ipynb) recognises, and what it says then.",
    ]
    for template in sheet.problems:
        lecture, _, heading = template.lecture.partition("#")
        parts += [
            f"## {template.number} {template.title}",
            f"Read again: [{heading or 'the lecture'}](../lectures/{lecture}.ipynb{'#' + github_slugify(heading) if heading else ''}).",
            *(f"`{wrong}`\n: {said}" for wrong, said in messages(template).items()),
        ]
    return "\n\n".join(parts) + "\n"


def messages(template: Template) -> dict[str, str]:
    """What a problem says of each of its mistakes, by name; what is only one student's is left out."""
    said: dict[str, list[str]] = {}
    for reader in READERS:
        for wrong in template.variant(reader).mistakes:
            said.setdefault(wrong.name, []).append(wrong.message)
    return {name: common(heard) for name, heard in said.items()}


def common(heard: Sequence[str]) -> str:
    """What several messages share: the words where they agree, a gap where they do not.

    >>> common(["You turned 7 times as far.", "You turned 9 times as far."])
    'You turned … times as far.'
    >>> common(["Longer by 2.509 m.", "It is even."])
    'Longer by … m. Or: It is even.'
    """
    variants: dict[int, list[str]] = {}
    for message in dict.fromkeys(heard):
        tokens = TOKEN.findall(message)
        alike = variants.setdefault(len(tokens), tokens)
        variants[len(tokens)] = [one if one == other else GAP for one, other in zip(alike, tokens, strict=True)]
    single = len(set(heard)) == 1
    texts = ["".join(tokens) for tokens in variants.values()]
    return " Or: ".join(text if single else MEASURED.sub(GAP, text) for text in texts)
