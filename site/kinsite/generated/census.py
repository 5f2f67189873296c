"""The page of the census: what feedback says to many wrong answers, as `misstep census --save` has counted it."""

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from kincourse import find_sheet, sheets
from kinsite.execute import ROOT
from kinsite.markdown import table
from misstep.census import COUNTS

RESULTS = ROOT / "site" / "census.json"
OUTSIDE = ("wrong", "full marks", "unnamed", "false", "undeserved", "unreadable", "refused")
"""What the page shows of the answers from outside, which evidence/checks/judge_outside.py has counted."""

HEAD = """\
# Census of the feedback

If an answer is wrong, the card names the mistake. This name is a claim about what a student did, so it can be wrong too. A
wrong name sends a student to the wrong section, and a wrong method that gets full marks is never corrected. The census counts
how often this happens.

For each problem, the numbers of {students} students are drawn. For each student, these answers are judged:

- every answer to which a change of the solution leads, by which people go wrong: a matrix instead of its inverse, two factors
  swapped, degrees instead of radians, a sign, ...;
- every mistake that the author of the problem has written down, and slips in a single entry.

And by itself:

- answers from outside, computed from the statement and the given values alone by code that imports neither the engine nor the
  problems. Only where the right answer stands in a drawing, or is one of many, does it start from ours. Each carries the sentence
  of what its maker did, and a claim is false if it says something else as a fact. Half of these kinds are counted by themselves
  too, in brackets; they were seen while the feedback was improved, so they are no blind test.

What is counted:

- **{full_marks}**: a wrong method is not noticed;
- **{misnamed}**: the card names another mistake than the one that was made;
- **{false}**: a sentence on the card is not true of the answer;
- **{unnamed}**: at least one wrong part of the answer is not explained by any mistake. The card then gives a hint only.

The first three should be 0. Of the answers from outside, those without any name are counted, and also right answers in another
form that were refused. You can repeat the census with two commands:

```text
misstep census --students {students} --save site/census.json
python evidence/checks/judge_outside.py --students 2 --save site/census.json
```
"""

TAIL = """\
## Mistakes that a sheet cannot tell apart

Two mistakes are told apart if they lead to different answers in at least one problem of the sheet. If a student makes one of
the mistakes below, the sheet cannot show which of the two it was.
"""


def pages() -> Iterator[tuple[str, str]]:
    """Yield the page: a table for each sheet, and the pairs of mistakes that no problem of a sheet tells apart."""
    yield "census.md", page(json.loads(RESULTS.read_text("utf-8")))


def page(census: Mapping[str, Any]) -> str:
    r"""Write the page. Fields of the census that are not known here are left out.

    >>> row = {"number": "01.1", "wrong": 8, "counts": {"unnamed": 2}, "new": 0}
    >>> text = page({"students": 3, "problems": [row], "inseparable": {"01_frames": [["a", "b"]]}, "new": 0})
    >>> print(*(line for line in text.splitlines() if line.startswith(("| 01.1", "| **", "- sheet"))), sep="\n")
    | **01** | 8 | 0 | 0 | 0 | 25 % |
    | **all** | 8 | 0 | 0 | 0 | 25 % |
    | 01.1 | 8 | 0 | 0 | 0 | 25 % |
    - sheet 01: `a` and `b`
    """
    rows = census["problems"]
    counted = {row["number"].partition(".")[0] for row in rows}
    missing = [number for name in sheets() if (number := name.partition("_")[0]) not in counted]
    parts = [HEAD.format(students=census["students"], **COUNTS), two_figures(census)]
    if outside := census.get("outside"):
        parts += ["## From outside", outside_table(outside)]
    parts += ["## All sheets", counts_table(rows_by_sheet(rows))]
    if missing:
        parts.append(f"Not counted in this census: sheet {', '.join(missing)}.")
    for name in sheets():
        number = name.partition("_")[0]
        if of_sheet := [row for row in rows if row["number"].startswith(f"{number}.")]:
            parts += [f"## Sheet {number}: {find_sheet(name).title}", counts_table(of_sheet)]
    pairs = [
        f"- sheet {name.partition('_')[0]}: " + "; ".join(f"`{one}` and `{other}`" for one, other in found)
        for name, found in census["inseparable"].items()
        if found
    ]
    return "\n\n".join([*parts, TAIL, "\n".join(pairs) or "There are none."]) + "\n"


def two_figures(census: Mapping[str, Any]) -> str:
    """Write the share of wrong answers without a name twice: the engine's own, and from outside.

    >>> rows = [{"number": "01.1", "wrong": 8, "counts": {"unnamed": 1}}]
    >>> text = two_figures({"problems": rows, "outside": {"students": 1, "problems": {"01.1": {"wrong": 50, "unnamed": 2}}}})
    >>> print(text.partition("only tests ")[2])
    the engine. Of those from outside, 2 of 50 (4.0 %) have no name at all.
    """
    own = total("", census["problems"])
    text = (
        f"Of the wrong answers that the engine itself makes, {of(own['counts'].get('unnamed', 0), own['wrong'])} have a wrong part "
        "without a name, which only tests the engine."
    )
    if "outside" in census:
        counts: Counter[str] = sum(map(Counter, census["outside"]["problems"].values()), Counter())
        text += f" Of those from outside, {of(counts['unnamed'], counts['wrong'])} have no name at all."
    return text


def of(part: int, whole: int) -> str:
    """Write a share with its denominator.

    >>> of(1, 8)
    '1 of 8 (12.5 %)'
    """
    return f"{part:,} of {whole:,} ({part / whole:.1%})".replace("%", " %") if whole else f"{part} of 0"


def outside_table(outside: Mapping[str, Any]) -> str:
    """Write what was counted of the answers from outside, a row for each sheet, with the half that is counted by itself in brackets."""
    sheets_of: dict[str, Counter[str]] = {}
    for number, counts in outside["problems"].items():
        sheets_of.setdefault(number.partition(".")[0], Counter()).update(counts)
    sheets_of["**all**"] = sum(sheets_of.values(), Counter())
    rows = [
        [sheet, *(f"{counts[what]} ({counts[f'held out: {what}']})" for what in OUTSIDE)]
        for sheet, counts in sheets_of.items()
    ]
    return table(["sheet", *OUTSIDE], rows, rule="---:")


def rows_by_sheet(rows: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Add up the counts of the problems of each sheet, and of all of them."""
    numbers = dict.fromkeys(row["number"].partition(".")[0] for row in rows)
    return [
        *(total(f"**{sheet}**", [row for row in rows if row["number"].startswith(f"{sheet}.")]) for sheet in numbers),
        total("**all**", rows),
    ]


def total(number: str, rows: Sequence[Mapping[str, Any]]) -> Mapping[str, Any]:
    """Add up the counts of some problems."""
    counts: Counter[str] = sum((Counter(row["counts"]) for row in rows), Counter())
    return {"number": number, "counts": counts, "wrong": sum(row["wrong"] for row in rows)}


def counts_table(rows: Sequence[Mapping[str, Any]]) -> str:
    """Write the counts as a table, one row for each problem or sheet."""
    heads = ["problem" if "." in rows[0]["number"] else "sheet", "wrong answers", *COUNTS.values()]
    cells = []
    for row in rows:
        counts = [str(row["counts"].get(what, 0)) for what in COUNTS if what != "unnamed"]
        unnamed = share(row["counts"].get("unnamed", 0), row["wrong"])
        cells.append([row["number"], str(row["wrong"]), *counts, unnamed])
    return table(heads, cells, rule="---:")


def share(part: int, whole: int) -> str:
    """Write a share in percent.

    >>> share(1, 8), share(0, 0)
    ('12 %', '–')
    """
    return f"{part / whole:.0%}".replace("%", " %") if whole else "–"
