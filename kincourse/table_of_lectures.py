"""The tables of lectures in README.md and on the site's home page.

A lecture is found by its folder. Its title and its question are in the `__init__.py` of this folder.
"""

from importlib import import_module
from typing import NamedTuple

from kincourse.catalog import COURSE


class Lecture(NamedTuple):
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
    """Return the lectures of the course, in order."""
    folders = {name: import_module(f"{COURSE.package}.lecture_{name}") for name in COURSE.lectures}
    counts = {name: len(COURSE.find_sheet(name).problems) for name in COURSE.sheets()}
    return [Lecture(name, one.TITLE, one.QUESTION, counts.get(name, 0)) for name, one in folders.items()]


def sheet_of(lecture: str) -> str:
    """Return the name of a lecture's sheet: its own, or that of the lecture that it continues; "" if there is none.

    lecture  the name of its notebook
    """
    sheets = COURSE.sheets()
    return lecture if lecture in sheets else next((sheet for sheet in sheets if sheet[:2] == lecture[:2]), "")


def table_rows(notebooks: str, sheet: str) -> str:
    """Write the rows of a Markdown table of the lectures.

    notebooks  the folder of the notebooks
    sheet      the cell of the sheet, with {name}, {number} and {problems} in braces
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
        "{number of lectures}": str(len(found)),
        "{number of sheets}": str(sum(one.problems > 0 for one in found)),
    }
    for placeholder, value in filled.items():
        text = text.replace(placeholder, value)
    return text
