"""Habits of students in Jupyter, planted in honest submissions: the official solutions, as the student "your id" hands them in."""

import json
import os
import re
import tempfile
from collections.abc import Callable, Mapping
from copy import deepcopy
from functools import cache
from pathlib import Path

from submissions import ROOT, as_bytes, code, names, problem_of, released

from kincourse import sheets
from misstep.grading.collect.gather import gather
from misstep.grading.jobs import grade_best, make_jobs
from misstep.sheet import SAMPLE_ID

SHEETS = [name for name in sheets() if (ROOT / "solutions" / name).is_dir()]


@cache
def _solved(name):
    return json.loads(solution(name).read_text("utf-8"))


def solution(name):
    """The path of the notebook with the solution."""
    return ROOT / "solutions" / name / f"{name}.ipynb"


def solved(name):
    """The notebook with the solution, as a student hands it in."""
    return deepcopy(_solved(name))


# --- ways to change a notebook ---


def cells_of(notebook, kind):
    """The cells `answer-1`, `answer-2`, ... or `check-1`, ..., by problem."""
    return {k: cell for cell in notebook["cells"] if (k := problem_of(cell, kind))}


def opening(notebook):
    return next(cell for cell in notebook["cells"] if cell["id"] == "open")


def text(cell):
    return "".join(cell["source"])


def first(lines):
    """These lines at the top of the opening cell."""

    def plant(notebook, name):
        opening(notebook)["source"] = f"{lines}\n{text(opening(notebook))}"

    return plant


def in_answers(lines):
    """These lines at the top of each answer cell; {k} and {answer} are the problem and its variable."""

    def plant(notebook, name):
        for k, cell in cells_of(notebook, "answer").items():
            cell["source"] = f"{lines.format(k=k, answer=names(name)[k])}\n{text(cell)}"

    return plant


def after_answers(lines):
    """These lines at the end of each answer cell."""

    def plant(notebook, name):
        for k, cell in cells_of(notebook, "answer").items():
            cell["source"] = f"{text(cell)}\n{lines.format(k=k, answer=names(name)[k])}"

    return plant


def own_cell(source, at=0):
    """A code cell of the student's own."""

    def plant(notebook, name):
        notebook["cells"].insert(at if at >= 0 else len(notebook["cells"]), code(source))

    return plant


def in_line(old, new):
    """One line of the opening cell replaced."""

    def plant(notebook, name):
        cell = opening(notebook)
        assert old in text(cell)
        cell["source"] = text(cell).replace(old, new)

    return plant


def rearranged(order):
    """The cells in another order, or only some of them; `order` gets the cells and returns those that stay."""

    def plant(notebook, name):
        notebook["cells"] = order(notebook["cells"])

    return plant


def is_check(cell):
    return bool(problem_of(cell, "check"))


def checks_first(cells):
    """Each check cell directly above the answer cell of its problem."""
    checks = {problem_of(cell, "check"): cell for cell in cells if is_check(cell)}
    moved = []
    for cell in cells:
        if not is_check(cell):
            k = problem_of(cell, "answer")
            moved += [checks[k], cell] if k else [cell]
    return moved


def renamed(notebook, name):
    """Another variable for each answer, in the answer cells and in the check cells."""
    for variable in names(name).values():
        for cell in notebook["cells"]:
            if cell["cell_type"] == "code":
                cell["source"] = re.sub(rf"\b{variable}\b", f"my_{variable}", text(cell))


def set_below(notebook, name):
    """A wrong value first. The right one is in a cell below the check, which the student then ran again."""
    checks = cells_of(notebook, "check")
    answers = cells_of(notebook, "answer")
    for k, variable in names(name).items():
        place = notebook["cells"].index(checks[k]) + 1
        notebook["cells"].insert(place, code(text(answers[k])))
        answers[k]["source"] = f"{variable} = 0"
    count = 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            count += 2
            cell["execution_count"] = count
    for check in checks.values():
        check["execution_count"] += 3  # after the cell below it


def cleared(notebook, name):
    """The answers cleared at the end, and all check cells a second time below that."""
    clear = "\n".join(f"{variable} = ..." for variable in names(name).values())
    checks = [deepcopy(cell) for cell in cells_of(notebook, "check").values()]
    notebook["cells"] += [code(clear), *checks]


def helper_at_the_end(notebook, name):
    """A function at the end of the notebook, which the student ran first."""
    after_answers("{answer} = unchanged({answer})")(notebook, name)
    notebook["cells"].append(code("def unchanged(value):\n    return value"))


def opening_at_the_end(notebook, name):
    cell = opening(notebook)
    notebook["cells"].remove(cell)
    notebook["cells"].append(cell)


def other_sheet_too(notebook, name):
    other = next(sheet for sheet in SHEETS if sheet != name)
    in_line("sheet = open_sheet", f'last_week = open_sheet("{other}", student)\nsheet = open_sheet')(notebook, name)


PLANTS = {
    # lines of the opening cell that cannot work while a sheet is graded
    "!pip install": first("!pip install kinlib"),
    "files = !ls": first("files = !ls\nprint(len(files))"),
    "%pip install": first("%pip install pandas"),
    "%matplotlib widget": first("%matplotlib widget"),
    "%matplotlib qt": first("%matplotlib qt"),
    "matplotlib.use": first("import matplotlib\nmatplotlib.use('TkAgg')"),
    "%autoreload": first("%load_ext autoreload\n%autoreload 2"),
    "an unknown magic": first("%load_ext nb_black\n%nbdev_export"),
    "import pandas": first("import pandas as pd\npd.set_option('display.precision', 3)"),
    "import pandas, numpy": first("import pandas as pd, numpy as np"),
    "google.colab": first(
        "from google.colab import drive\ndrive.mount('/content/drive')\nhome = drive.path + '/x'\nprint(home)"
    ),
    "os.chdir": first("import os\nos.chdir('/content/drive/robotics')"),
    "open('notes.txt')": first("notes = open('notes.txt').read()\nprint(notes[:10])"),
    "os.system, subprocess": first("import os, subprocess\nos.system('ls')\nsubprocess.run(['ls'])"),
    "input()": in_line(f'student = "{SAMPLE_ID}"', "student = input('Your id: ')"),
    "open_sheet(input())": in_line(", student)", ", input('Your id: '))"),
    "another sheet opened": other_sheet_too,
    "%%bash": own_cell("%%bash\npip install kinlib\nls"),
    "a half-typed cell": own_cell("for k in range(3", 1),
    # output, which costs nothing
    "plots at 150 dpi": own_cell(
        "import matplotlib.pyplot as plt\nimport numpy as np\nplt.rcParams['figure.dpi'] = 150\n"
        "for k in range(6):\n    plt.figure(figsize=(8, 7))\n    plt.imshow(np.random.rand(900, 900))\n    plt.show()",
        -1,
    ),
    "large tables": own_cell(
        "from IPython.display import HTML\nfor k in range(3):\n    display(HTML('<table>' + '<tr><td>0.123456</td></tr>' * 90_000))",
        -1,
    ),
    "2,000 displays": own_cell("for k in range(2000):\n    display('x' * 5000)", -1),
    "long prints in many cells": in_answers("for _ in range(100): print('x' * 50_000)"),
    # lines in answer cells
    "import in answers": in_answers("import seaborn as sns\nsns.set_theme()"),
    "%%time": in_answers("%%time"),
    "print the right answer": in_answers("print(sheet.problem({k}).answer.value)"),
    # the opening cell, the sheet, and the order of cells
    "opening cell deleted": rearranged(lambda cells: [cell for cell in cells if cell["id"] != "open"]),
    "opening cell at the end": opening_at_the_end,
    "sheet overwritten": after_answers("sheet = 'sheet {k}'"),
    "checks above answers": rearranged(checks_first),
    "all checks deleted": rearranged(lambda cells: [cell for cell in cells if not is_check(cell)]),
    "helper at the end": helper_at_the_end,
    "answer set again below": set_below,
    "answers cleared at the end": cleared,
    "answers renamed": renamed,
}
"""By habit, a function that plants it in a notebook."""


def beside(name, *, blank, own):
    """The blank sheet and the student's own file under these names, the blank one modified last."""
    return {own: as_bytes(solved(name)), blank: released(name).read_bytes()}


FILES: Mapping[str, Callable[[str], Mapping[str, bytes]]] = {
    "X (1).ipynb beside blank X.ipynb": lambda name: beside(name, blank=f"{name}.ipynb", own=f"{name} (1).ipynb"),
    "X.ipynb beside blank X (1).ipynb": lambda name: beside(name, blank=f"{name} (1).ipynb", own=f"{name}.ipynb"),
    "mine.ipynb beside blank X.ipynb": lambda name: beside(name, blank=f"{name}.ipynb", own="mine.ipynb"),
}
"""By habit, the files that are handed in, by name, the oldest first."""

HABITS = [*PLANTS, *FILES]


def handed_in_files(habit, name):
    """What a student with this habit hands in: the bytes of files by name, the oldest first."""
    if habit in FILES:
        return FILES[habit](name)
    notebook = solved(name)
    if habit:
        PLANTS[habit](notebook, name)
    return {f"{name}.ipynb": as_bytes(notebook)}


def grade_habit(grader, habit):
    """The result of a habit on the sheet of a grader, from files on the disk."""
    with tempfile.TemporaryDirectory() as folder:
        (own := Path(folder, SAMPLE_ID)).mkdir()
        for number, (file, content) in enumerate(handed_in_files(habit, grader.sheet.name).items()):
            (own / file).write_bytes(content)
            os.utime(own / file, (1e9 + number, 1e9 + number))
        (job,) = make_jobs(gather(Path(folder), grader.sheet.name).submissions, grader.sheet, "")
        return job.complete(grade_best(grader.grade, *job.request))
