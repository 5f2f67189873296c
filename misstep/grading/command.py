"""Grade a sheet: a folder or a download of submissions in, a folder of results out.

    misstep grade solutions/03_poe_space/03_poe_space.ipynb submissions/ --out results/

A run may be stopped at any moment, and goes on where it was when it is started again. Every submission gets a grade and a
reason. In the folder of results:

    grades.csv       a row for each student          report.html   how the class did, for the lecture
    matches.csv      answers right for others        feedback/     a page for each student
    canvas.csv, moodle.csv, gradescope.csv           for the platform that the roster came from
    feedback.zip     all pages, as Moodle and Canvas take them back
    results/         what the next run goes on from
"""

import argparse
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

from tqdm import tqdm

from misstep.grading.collect.gather import Handed, gather
from misstep.grading.collect.roster import read_roster
from misstep.grading.collect.submission import Master, master
from misstep.grading.judging.bounded_executor import as_done
from misstep.grading.judging.cluster import Unreachable, cluster, grade_here
from misstep.grading.judging.grader import Grader
from misstep.grading.judging.result import Result
from misstep.grading.publish.feedback_zip import give_back
from misstep.grading.publish.result_store import Book, Busy, opened
from misstep.grading.result_sink import Desk
from misstep.grading.sandbox.limits import UNSAFE, Limits, Missing
from misstep.grading.tasks import Task, tasks

AHEAD = 3
"""For each worker, so many submissions are on their way, so that none waits for a disk."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("sheet", type=Path, metavar="SHEET", help="the sheet that was handed out: solutions/X/X.ipynb")
    parser.add_argument("submissions", type=Path, metavar="SUBMISSIONS", help="a folder, or the zip of a platform")
    parser.add_argument(
        "--course", metavar="COURSE", help="the package or the folder of the course (default: the installed one)"
    )
    parser.add_argument("--out", type=Path, required=True, metavar="RESULTS", help="the folder for the results")
    parser.add_argument("--roster", type=Path, metavar="CSV", help="who is in the course, as the platform exports it")
    parser.add_argument("--id-column", metavar="NAME", help="the column of the roster with the ids that students type")
    parser.add_argument("--column", metavar="NAME", help="what the sheet is called on the platform (default: its name)")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="how many at a time (default: 2)")
    parser.add_argument("--regrade", action="store_true", help="grade everybody anew, whatever is there already")
    parser.add_argument(
        "--only", nargs="+", metavar="ID", help="grade these students, and leave the others as they are"
    )
    parser.add_argument(
        "--cluster", metavar="tcp://HOST:PORT", help="the scheduler of a Dask cluster that does the work"
    )
    parser.add_argument(
        "--gradebook", type=Path, metavar="COURSE", help="an nbgrader course, whose gradebook is filled too"
    )
    parser.add_argument(
        UNSAFE, action="store_true", dest="unsafe", help="run code with your own rights: only if you trust it"
    )


def run(options: argparse.Namespace) -> int:
    """Grade, and say what came of it: 0 done, 1 some could not be graded, 2 asked for what cannot be."""
    if options.jobs < 1:
        print(f"misstep grade: --jobs should be 1 or more; got {options.jobs}.", file=sys.stderr)
        return 2
    try:
        return _run(options)
    except (ValueError, OSError, ModuleNotFoundError, Missing, Busy, Unreachable) as fault:
        print(f"misstep grade: {fault}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("misstep grade: stopped. What was graded is kept; the same command goes on from there.", file=sys.stderr)
        return 130


def _run(options: argparse.Namespace) -> int:
    sheet = master(options.sheet, options.course)
    roster = read_roster(options.roster, options.id_column) if options.roster else None
    gathered = gather(options.submissions, sheet.name, roster)
    chosen = _chosen(gathered.handed, options.only)
    for remark in gathered.remarks:
        print(remark)
    with (
        opened(options.out, sheet.name) as book,
        Desk(options.out, sheet, options.gradebook, options.regrade) as desk,
    ):
        lost = _grade(options, sheet, chosen, book, desk)
        for handed in chosen:
            if handed.student not in desk.done and (result := book.kept(handed.student)):
                desk.take(handed, result)
        from misstep.grading.publish.publish import publish  # by now the desk has imported it

        said = publish(options.out, gathered.handed, book, roster, options.column, done=desk.done)
        said += desk.remarks()
        give_back(options.out, gathered, sheet.name)
    print("\n".join([*said, *([f"{UNSAFE}: the submissions ran with your rights."] if options.unsafe else [])]))
    for student, why in lost.items():
        print(f"Not graded: {student}: {why!r}. The same command tries again.", file=sys.stderr)
    return 1 if lost else 0


def _chosen(handed: Sequence[Handed], only: Sequence[str] | None) -> list[Handed]:
    if not only:
        return list(handed)
    wanted = {name.casefold() for name in only}
    chosen = [each for each in handed if each.student.casefold() in wanted]
    if unknown := wanted - {each.student.casefold() for each in chosen}:
        raise ValueError(
            f"There is no submission of {', '.join(sorted(unknown))}. Ids stand in grades.csv as --only wants them."
        )
    return chosen


def _grade(
    options: argparse.Namespace, sheet: Master, handed: Sequence[Handed], book: Book, desk: Desk
) -> dict[str, BaseException]:
    """Grade what has no result yet, and keep each result as it comes. Who could not be graded, and why."""
    is_done = (lambda *_: False) if options.regrade else (lambda student, mark: book.kept(student, mark) is not None)
    lost = {}
    with tqdm(total=len(handed), unit="sheet", desc=sheet.name, disable=None) as bar:

        def waiting() -> Iterator[Task]:
            for task in tasks(handed, sheet, not options.unsafe, is_done):
                if task is None:
                    bar.update()
                else:
                    yield task

        coming = waiting()
        if (first := next(coming, None)) is None:
            return {}  # and nothing was started for it
        with _workers(options, sheet) as (submit, jobs):
            for task, done in as_done(submit, _chained(first, coming), AHEAD * jobs):
                if isinstance(done, BaseException):
                    lost[task.handed.student] = done
                else:
                    result = task.signed(done)
                    book.keep(result, task.mark)
                    desk.take(task.handed, result)
                bar.update()
    return lost


def _chained(first: Task, rest: Iterator[Task]) -> Iterator[Task]:
    yield first
    yield from rest


@contextmanager
def _workers(options: argparse.Namespace, sheet: Master) -> Iterator[tuple[Callable[[Task], Future[Result]], int]]:
    """What takes a task to be graded, and how many at a time: threads over one grader, or a cluster."""
    limits, is_safe = Limits(), not options.unsafe
    if options.cluster:
        with cluster(options.cluster) as (executor, jobs):
            yield lambda task: executor.submit(grade_here, sheet, limits, is_safe, task.drawn_for, task.content), jobs
    else:
        with Grader(sheet, limits, is_safe) as grader, ThreadPoolExecutor(options.jobs) as pool:
            yield lambda task: pool.submit(grader.grade, task.drawn_for, task.content), options.jobs
