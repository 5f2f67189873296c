"""The page that shows a reader's progress. The record is stored in the reader's browser only."""

import re
from collections.abc import Iterator, Mapping
from html import escape
from pathlib import Path

from nbformat import NotebookNode

from kincourse.table_of_lectures import sheet_of

QUESTION = re.compile(r'data-misstep-question="([^"]+)"[^>]*data-right="(\d)"')
"""The name of a question, and the index of its right option."""

HEAD = """\
# Your progress

What you have read, answered and solved is stored in this browser only, and is never sent anywhere. If you clear the
browser's data, the record is lost, so save a copy if it matters to you. A problem counts as solved once you have run its
sheet in the browser and the check gave full marks. This page has no influence on your grade. *Delete everything* also deletes
what you have typed on the pages, but not what you have typed in JupyterLab.
"""


def pages(lectures: Mapping[Path, NotebookNode], sheets: Mapping[Path, NotebookNode]) -> Iterator[tuple[str, str]]:
    """Yield the page: a table that a script fills in, and that can be read without the script.

    lectures, sheets  the executed notebooks by their paths; a sheet has the same file name as its lecture
    """
    rows = []
    problems = {path.stem: sum(cell.id.startswith("check-") for cell in sheet.cells) for path, sheet in sheets.items()}
    for path, notebook in sorted(lectures.items()):
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        html = ("".join(output.get("data", {}).get("text/html", "")) for output in outputs)
        if not (found := [pair for text in html for pair in QUESTION.findall(text)]):
            continue
        names, right = zip(*found, strict=True)
        number, problem_count = path.stem.partition("_")[0], problems.get(path.stem, 0)
        shared = "" if problem_count else sheet_of(path.stem)[:2]
        solved = f"0 of {problem_count}" if problem_count else f"with {shared}" * bool(shared)
        title = notebook.cells[0].source.split("\n", 1)[0].removeprefix("# ")
        rows.append(
            f'<tr data-lecture="lectures/{path.stem}" data-questions="{escape(" ".join(names))}" '
            f'data-keys="{" ".join(right)}" data-problems="{problem_count}">'
            f'<th scope="row"><a href="lectures/{path.stem}.html">{number} {escape(title)}</a></th>'
            f"<td data-read>not yet</td><td data-answered>0 of {len(names)}</td><td data-right>0</td>"
            f"<td data-solved>{solved}</td></tr>"
        )
    table = (
        '<div class="kinlib-progress" data-kinlib-progress><table><caption class="visually-hidden">Lectures read, questions '
        'answered and problems solved</caption><thead><tr><th scope="col">lecture</th><th scope="col">read</th>'
        '<th scope="col">questions answered</th><th scope="col">right at once</th><th scope="col">problems solved</th></tr></thead>'
        f"<tbody>{''.join(rows)}</tbody></table></div>"
    )
    yield "progress.md", f"{HEAD}\n````{{raw}} html\n{table}\n````\n"
