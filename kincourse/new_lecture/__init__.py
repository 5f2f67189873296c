"""`kincourse new-lecture 11_dynamics "Dynamics" "Which torques move an arm?"`: a small lecture that passes all tests.

It writes one folder of kincourse, one notebook and one solution, from which the students' sheet is released. The site, the tests
and the engine find the lecture by its folder; README.md, the paper and lecture 00, which list the lectures, are brought up to date.
"""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

from kincourse.catalog import COURSE
from misstep.answers.number import Numbers
from misstep.problem import Problem, Template
from misstep.release.instructor_notebook import Entry, notebook, notebook_of
from misstep.sheet import Sheet

TEMPLATE = Path(__file__).parent / "template"

SHEET_INTRO = """\
One problem, three points. The numbers are your own, because they come from your id. Replace the `...` in the answer cell, run \
the cell, and then run the check below it. You may check as often as you like; the last answer counts."""

SOLUTION = """\
theta = np.radians(given.degrees)
position_1 = np.array([given.upper_arm + given.forearm * np.cos(theta), given.forearm * np.sin(theta)])"""

TABLE_OF_TIMES = "notebooks/00_start_here.ipynb"
MINUTES = 10
"""The lecture that lists how long each takes, and how long the small one takes."""

UPDATE_LISTS = "from pathlib import Path; from kincourse.table_of_lectures import write_lists; write_lists(Path())"


def new_lecture(name: str, title: str, question: str, root: Path) -> list[Path]:
    """Write a small lecture into a copy of the repository, and return its files.

    name      the number and the short name, such as 11_dynamics
    title     its title in the lists of lectures
    question  what it answers, in one sentence

    Raises ValueError if the name is not of this form, its number is taken, or root is not a copy of the repository.

    >>> from tempfile import mkdtemp
    >>> new_lecture("11_dynamics", "Dynamics", "Which torques move an arm?", Path(mkdtemp()))
    Traceback (most recent call last):
    ValueError: the folder must be a copy of the repository, with kincourse/ and notebooks/; got ...
    """
    if not re.fullmatch(r"\d\d[a-z]?_[a-z][a-z0-9_]*", name):
        raise ValueError(
            "the name must be two digits, a letter if the lecture continues another one, and words in small letters, such as "
            f"11_dynamics or 11b_dynamics; got {name!r}."
        )
    for what, text in (("title", title), ("question", question)):
        if not text.strip() or set(text) & set('"\\\n'):
            raise ValueError(f"the {what} must be one line of text without quotes and backslashes; got {text!r}.")
    if not (root / "kincourse").is_dir() or not (root / "notebooks").is_dir():
        raise ValueError(f"the folder must be a copy of the repository, with kincourse/ and notebooks/; got {root}.")
    number = name.partition("_")[0]
    if taken := [*(root / "kincourse").glob(f"lecture_{number}_*"), *(root / "notebooks").glob(f"{number}_*")]:
        raise ValueError(
            f"the number of a new lecture must be free; {number} is that of {taken[0].name}. Take another."
        )

    def filled(template: str) -> str:
        text = (TEMPLATE / f"{template}.txt").read_text("utf-8")
        for key, value in (("number", number), ("name", name), ("title", title), ("question", question)):
            text = text.replace(f"@{key}@", value)
        return text

    folder = f"kincourse/lecture_{name}"
    files = {f"{folder}/{part}.py": filled(part) for part in ("problems", "blanks", "drawings", "opening")}
    files[f"{folder}/__init__.py"] = filled("init")
    files[f"{folder}/questions.toml"] = filled("questions")
    files[f"notebooks/{name}.ipynb"] = notebook_of(filled("lecture"))
    files[f"solutions/{name}/{name}.ipynb"] = solution_of(name, title)
    files[TABLE_OF_TIMES] = with_row(
        (root / TABLE_OF_TIMES).read_text("utf-8"), f"| [{number} {title}]({name}.ipynb) | {question} | {MINUTES} |"
    )
    for place, text in files.items():
        (root / place).parent.mkdir(parents=True, exist_ok=True)
        (root / place).write_text(text, "utf-8", newline="\n")
    return [root / place for place in files]


def with_row(notebook: str, row: str) -> str:
    r"""Put the row of a lecture into the table of lecture 00, in the order of the numbers.

    >>> table = json.dumps({"source": ["| [01 Frames](01_frames.ipynb) | Where? | 85 |\n", "the end"]}, indent=1)
    >>> json.loads(with_row(table, "| [02 More](02_more.ipynb) | Why? | 10 |"))["source"][1]
    '| [02 More](02_more.ipynb) | Why? | 10 |\n'
    """
    rows = re.findall(r'^ *"\| \[\d\d.*\n', notebook, re.MULTILINE)
    number = row.partition("[")[2]
    before = max(
        (other for other in rows if other.partition("[")[2] < number), key=lambda other: other.partition("[")[2]
    )
    indent = before[: before.index('"')]
    return notebook.replace(before, f"{before}{indent}{json.dumps(row + chr(10), ensure_ascii=False)},\n")


def solution_of(name: str, title: str) -> str:
    """Write the instructor's notebook of the sheet, with the solution of its one problem."""
    template = Template(
        f"{name.partition('_')[0]}.1",
        "The end of a bent arm",
        3,
        f"{name}#An example",
        lambda _: Problem("", Numbers(np.zeros(1))),
    )
    imports = "import numpy as np\n\nfrom kincourse import open_sheet"
    return notebook(
        Sheet(name, title, [template]), [Entry("position", "Answer with two numbers.", SOLUTION)], SHEET_INTRO, imports
    )


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument("name", help="the number and the short name: 11_dynamics")
    parser.add_argument("title", help='its title in the lists of lectures: "Dynamics"')
    parser.add_argument("question", help='what it answers: "Which torques move an arm?"')


def run(options: argparse.Namespace) -> int:
    """Write the lecture into this copy of the repository, and return the exit code: 0 done, 2 if it cannot be written."""
    root = COURSE.folder.parent
    try:
        written = new_lecture(options.name, options.title, options.question, root)
    except (ValueError, OSError) as fault:
        print(f"kincourse new-lecture: {fault}", file=sys.stderr)
        return 2
    for arguments in (["-m", "misstep", "release"], ["-c", UPDATE_LISTS]):  # a new process finds the new lecture
        subprocess.run([sys.executable, *arguments], cwd=root, check=True)
    print("\n".join(f"written: {path.relative_to(root).as_posix()}" for path in written))
    print(
        f"Change them into your lecture, and run: python course.py test tests/kincourse -k {options.name.partition('_')[0]}"
    )
    return 0
