"""The tables of lectures in README.md and on the site's home page, and the sentences that say how large the course is.

A lecture is found by its folder. Its title and its question are in the `__init__.py` of this folder.
"""

import re
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from kincourse.catalog import COURSE

NUMBER_WORDS = (
    *("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"),
    *("thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"),
)

README_ROWS = re.compile(r"^(?:\| \[\d\d[a-z]? .*\n)+", re.MULTILINE)
"""The rows of the table of lectures, which begin with the number of a lecture."""

FILES_WITH_LISTS = ("README.md", "paper/paper.md")
"""The files that say how large the course is. The home page of the site is filled in when the site is built."""


@dataclass(frozen=True)
class Lecture:
    """A lecture as the lists show it.

    name      the name of its notebook and of its sheet, such as 03_poe_space
    problems  the number of problems on its sheet; 0 if it has no sheet
    """

    name: str
    title: str
    question: str
    problems: int

    @property
    def number(self) -> str:
        """Its number, two digits and perhaps a letter: 04b continues 04."""
        return self.name.partition("_")[0]


def lectures() -> list[Lecture]:
    """Return the lectures of the course, in order.

    >>> lectures()[0]
    Lecture(name='00_start_here', title='Start here', question='How does this course work?', problems=0)
    """
    found = []
    for name in COURSE.lectures:
        folder = import_module(f"{COURSE.package}.lecture_{name}")
        problems = len(COURSE.find_sheet(name).problems) if name in COURSE.sheets() else 0
        found.append(Lecture(name, folder.TITLE, folder.QUESTION, problems))
    return found


def sheet_of(lecture: str) -> str:
    """Return the name of a lecture's sheet: its own, or that of the lecture that it continues; "" if there is none.

    lecture  the name of its notebook

    >>> sheet_of("04b_velocity"), sheet_of("00_start_here")
    ('04_poe_body', '')
    """
    sheets = COURSE.sheets()
    return lecture if lecture in sheets else next((sheet for sheet in sheets if sheet[:2] == lecture[:2]), "")


def table_rows(notebooks: str, sheet: str) -> str:
    """Write the rows of a Markdown table of the lectures.

    notebooks  the folder of the notebooks
    sheet      the cell of the sheet, with {name}, {number} and {problems} in braces

    >>> table_rows("notebooks", "[{problems}](exercises/{name}/{name}.ipynb)").splitlines()[0]
    '| [00 Start here](notebooks/00_start_here.ipynb) | How does this course work? | |'
    """
    rows = []
    for lecture in lectures():
        problems = f"{lecture.problems} problem{'s' * (lecture.problems > 1)}"
        cell = sheet.format(name=lecture.name, number=lecture.number, problems=problems) if lecture.problems else ""
        if not cell and (shared := sheet_of(lecture.name)):
            cell = f"with {shared[:2]}"
        link = f"[{lecture.number} {lecture.title}]({notebooks}/{lecture.name}.ipynb)"
        rows.append(f"| {link} | {lecture.question} | {f'{cell} ' * bool(cell)}|\n")
    return "".join(rows)


def fill_home_page(text: str) -> str:
    """Fill in the table of lectures, the navigation and the numbers of lectures and sheets in site/pages/index.md."""
    found = lectures()
    filled = {
        "{table of lectures}\n": table_rows("lectures", "[sheet {number}](sheets/{name}.ipynb)"),
        "{lectures}\n": "".join(f"{one.number} {one.title} <lectures/{one.name}>\n" for one in found),
        "{number of lectures}": in_words(len(found)),
        "{number of sheets}": in_words(sum(one.problems > 0 for one in found)),
    }
    for placeholder, value in filled.items():
        text = text.replace(placeholder, value)
    return text


def with_lists(text: str) -> str:
    """Replace the rows of a table of lectures as in README.md, and the numbers of lectures, sheets and problems.

    >>> text = "It has two lectures, made from two lectures."
    >>> with_lists(text) == f"It has {in_words(len(lectures()))} lectures, made from two lectures."
    True
    """
    found = lectures()
    rows = table_rows("notebooks", "[{problems}](exercises/{name}/{name}.ipynb)")
    text = README_ROWS.sub(lambda _: rows, text)
    number = rf"\b(?:{'|'.join(NUMBER_WORDS)}|\d+)"
    sheets = in_words(sum(one.problems > 0 for one in found))
    text = re.sub(rf"(?<=It has ){number}(?= lecture)", in_words(len(found)), text)
    text = re.sub(rf"{number}(?= (?:exercise )?sheets with )", sheets, text)
    return re.sub(r"(?<=sheets with )\d+(?=\sproblems)", str(sum(one.problems for one in found)), text)


def write_lists(root: Path) -> list[Path]:
    """Write the table and the numbers into the files of a repository that have them, and return those that changed."""
    changed = []
    for file in (root / name for name in FILES_WITH_LISTS):
        before = file.read_text("utf-8")
        if (after := with_lists(before)) != before:
            file.write_text(after, "utf-8", newline="\n")
            changed.append(file)
    return changed


def in_words(number: int) -> str:
    """Write a number as a word, up to twenty.

    >>> in_words(11), in_words(21)
    ('eleven', '21')
    """
    return NUMBER_WORDS[number] if number < len(NUMBER_WORDS) else str(number)
