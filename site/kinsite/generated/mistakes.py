"""The index of mistakes: the mistakes that each sheet recognises, and the message for each.

A message may contain numbers of the student who reads it. So each problem is drawn for several students, and what differs
between their messages is left out. Therefore the pages contain no student's numbers, and no right answer.
"""

import re
from collections.abc import Iterator, Sequence
from html import escape

from docutils.nodes import make_id
from myst_parser.slugs import github_slugify

from kincourse import find_sheet, sheets
from misstep.problem import Template
from misstep.sheet import Sheet

STUDENTS = tuple(f"a reader of the site, {letter}" for letter in "abcdefgh")
"""Ids for which the problems are drawn: enough of them that every number that can differ does differ."""

GAP = "…"
TOKEN = re.compile(r"\$[^$]*\$|`[^`]*`|[^\s$`]+|\s+")
SENTENCE_END = re.compile(r"(?<=[.?!])\s+(?=[A-Z$`])")
GAPS = re.compile(rf"{GAP}([\s,]+{GAP})+")
DECIMAL = re.compile(r"(?<![\w.^_{])-?\d+\.\d+")
"""Decimal numbers. If few students have the same message, these are computed from a student's numbers."""


def pages() -> Iterator[tuple[str, str]]:
    """Yield one page for each sheet, and an overview."""
    named_sheets = [(name, find_sheet(name)) for name in sheets()]
    for name, sheet in named_sheets:
        yield f"mistakes/{name}.md", page(name, sheet)
    yield "mistakes/index.md", overview(named_sheets)


def overview(named_sheets: Sequence[tuple[str, Sheet]]) -> str:
    """Write the page that lists the pages of the sheets, and all mistakes by their names."""
    names = "\n".join(name for name, _ in named_sheets)
    places: dict[str, list[str]] = {}
    for name, sheet in named_sheets:
        for template in sheet.problems:
            for mistake in messages(template):
                link = f'<a href="{name}.html#{anchor(template.number, mistake)}">{template.number}</a>'
                places.setdefault(mistake, []).append(link)
    listed = "\n".join(f"<li>{escape(mistake)}: {', '.join(places[mistake])}</li>" for mistake in sorted(places))
    count = sum(map(len, places.values()))
    return f"""\
# Index of mistakes

The sheets recognise {count} mistakes by name. If your wrong answer is one of them, the card says which step went wrong,
in the words of these pages.

Read them before you hand in. If you recognise your own mistake, you are in good company: each of them has been made
before, in a lecture hall, in a book or in a widely used library.

Where a message contains your own numbers, these pages show {GAP} instead.

```{{toctree}}
:maxdepth: 1

{names}
```

## All mistakes by name

The numbers are those of the problems. Each mistake has an address, which you can link to.

```{{raw}} html
<ul class="kinlib-names">
{listed}
</ul>
```
"""


def anchor(problem: str, mistake: str) -> str:
    """Name the id of a mistake on the page of its sheet.

    >>> anchor("05.3", "sign of alpha")
    'mistake-05-3-sign-of-alpha'
    """
    return str(make_id(f"mistake-{problem}-{mistake}"))


def page(name: str, sheet: Sheet) -> str:
    """Write the page with the mistakes of one sheet, problem by problem."""
    number = name.partition("_")[0]
    parts = [
        f"# Mistakes of sheet {number}: {sheet.title}",
        f"The mistakes that [sheet {number}](../sheets/{name}.ipynb) recognises, and the message for each.",
    ]
    for template in sheet.problems:
        lecture, _, heading = template.lecture.partition("#")
        parts += [
            f"## {template.number} {template.title}",
            f"Re-read: [{heading or 'the lecture'}](../lectures/{lecture}.ipynb{'#' + github_slugify(heading) if heading else ''}).",
            *(
                f"[`{mistake}`]{{#{anchor(template.number, mistake)}}}\n: {message}"
                for mistake, message in messages(template).items()
            ),
        ]
    return "\n\n".join(parts) + "\n"


def messages(template: Template) -> dict[str, str]:
    """Collect the message of each mistake of a problem, by name, without what belongs to one student only."""
    variants: dict[str, list[str]] = {}
    for student in STUDENTS:
        for mistake in template.variant(student).known_mistakes:
            variants.setdefault(mistake.name, []).append(mistake.message)
    return {name: common_text(messages) for name, messages in variants.items()}


def common_text(messages: Sequence[str]) -> str:
    """Keep what the messages of a mistake have in common, with a gap where they differ.

    Messages with other words are other sentences; those that the most students get are kept. A sentence after the first one is
    left out if it has a gap.

    >>> common_text(["You turned 7 times as far.", "You turned 9 times as far. It was 2."])
    'You turned … times as far.'
    >>> common_text(["You swapped $a$ and $b$. See 1.", "You swapped $b$ and $c$. See 2.", "You left out $p$."])
    'You swapped … and ….'
    >>> common_text(["Always 0.5."] * 3)
    'Always 0.5.'
    """
    groups: list[tuple[list[list[str]], list[str]]] = []
    for message in messages:
        sentences = [TOKEN.findall(sentence) for sentence in SENTENCE_END.split(message)]
        for common, members in groups:
            if is_similar(common[0], sentences[0]):
                common[:] = [
                    [one if one == other else GAP for one, other in zip(*pair, strict=True)]
                    for pair in zip(common, sentences, strict=False)
                    if is_similar(*pair)
                ]
                members.append(message)
                break
        else:
            groups.append((sentences, [message]))
    common, members = max(groups, key=lambda group: len(group[1]))
    first, *others = (
        "".join(tokens) if len(set(messages)) == 1 else DECIMAL.sub(GAP, "".join(tokens)) for tokens in common
    )
    return " ".join([GAPS.sub(GAP, first), *(sentence for sentence in others if GAP not in sentence)])


def is_similar(one: Sequence[str], other: Sequence[str]) -> bool:
    """Whether two sentences, as tokens, have the same length and share at least half of their words."""
    words = [pair for pair in zip(one, other, strict=False) if pair[0].strip()]
    return len(one) == len(other) and 2 * sum(first == second for first, second in words) >= len(words)
