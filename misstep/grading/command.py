"""Grade a sheet: a folder or a download of submissions in, a folder of results out.

    misstep grade solutions/03_poe_space/03_poe_space.ipynb submissions/ --out results/

Grading may be stopped at any moment, and continues where it was when it is started again. Every submission gets a grade and
a reason. The folder of results has:

    grades.csv       a row for each student           report.html   how the class did, for the lecture
    matches.csv      answers right for other students  feedback/     a page for each student
    canvas.csv, moodle.csv, gradescope.csv            points for the platform that exported the roster
    feedback.zip     all pages, as Moodle and Canvas import them
    overrides.csv    points, comments and late days by hand, for you to fill in (--late says what a day costs)
    changes.csv      points that a later run changed, with the reason
    results/         the stored results, from which the next run continues
"""

import argparse
import errno
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import dataclass, fields
from functools import partial
from importlib.util import find_spec
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from misstep.grading.collect.gather import Submission, WrongRoster, gather
from misstep.grading.collect.roster import read_roster
from misstep.grading.collect.run_plan import ReleasedSheet, read_released_sheet
from misstep.grading.fork_server import ProcessEnded
from misstep.grading.jobs import GradingJob, grade_best, make_jobs, run_bounded
from misstep.grading.judging.cluster import ClusterUnreachable, connect, grade_on_worker
from misstep.grading.judging.grader import Grader, start_judge
from misstep.grading.judging.result import Result
from misstep.grading.publish.feedback_zip import write_feedback_zip
from misstep.grading.publish.overrides import LateRule, check_overrides, write_template
from misstep.grading.publish.result_store import FolderInUse, ResultStore, open_results
from misstep.grading.sandbox.limits import UNSAFE_OPTION, Limits, SandboxUnavailable
from misstep.grading.steps import StepFailed, StepProcesses
from misstep.grading.write_results import ResultWriter

if TYPE_CHECKING:
    from misstep.grading.nbgrader.gradebook import GradebookWriter

REQUIRED = ("IPython", "jinja2", "latex2mathml", "mistune", "tqdm", "yaml")
"""The packages of the extra. They are imported where they are used, because that takes long."""

EXPLAINED_ERRORS = (ModuleNotFoundError, SandboxUnavailable, FolderInUse, ProcessEnded, StepFailed, ClusterUnreachable)
"""The errors whose message is a sentence for the instructor."""

PROGRESS = "{desc}: {n_fmt} of {total_fmt} |{bar:30}| about {remaining} left"
"""How a terminal shows the progress: the estimate is minutes and seconds, from the time that the last ones took."""

MIN_KEY_LENGTH = 8

TABLES_SECONDS, TABLES_SECONDS_PER_STUDENT = 30.0, 0.5
"""Processor time for comparing and writing the tables of a class."""

PENDING_PER_WORKER = 3
"""How many submissions are read ahead for each worker, so that no worker waits for the disk."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("sheet", type=Path, metavar="SHEET", help="the notebook of the sheet: solutions/X/X.ipynb")
    parser.add_argument("submissions", type=Path, metavar="SUBMISSIONS", help="a folder, or the zip file of a platform")
    parser.add_argument(
        "--course",
        metavar="COURSE",
        help="the package or the folder of the course (default: the installed one that has the sheet, or else the one beside solutions/)",
    )
    parser.add_argument("--out", type=Path, required=True, metavar="RESULTS", help="the folder for the results")
    parser.add_argument("--roster", type=Path, metavar="CSV", help="the list of students, as the platform exports it")
    parser.add_argument("--id-column", metavar="NAME", help="the column of the roster with the ids that students type")
    parser.add_argument(
        "--column", metavar="NAME", help="the column of the sheet on the platform (default: the sheet's name)"
    )
    parser.add_argument(
        "--site",
        metavar="URL",
        help="the address of the course's site, to whose lectures feedback links (default: the one that the course names)",
    )
    parser.add_argument(
        "--key", metavar="KEY", help="a secret: then only answers count that are right for other numbers too"
    )
    parser.add_argument("--key-file", type=Path, metavar="FILE", help="the file with the key, instead of --key")
    parser.add_argument(
        "--limit",
        action="append",
        default=[],
        metavar="NAME=NUMBER",
        help=f"change a limit of what one submission may use, as often as you like; the limits are: {Limits()}",
    )
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="how many at a time (default: 2)")
    parser.add_argument(
        "--regrade",
        nargs="*",
        metavar="PROBLEM",
        help="grade every submission again, even if it has a result; with numbers such as 03.2, only these problems",
    )
    parser.add_argument(
        "--late",
        default="",
        metavar="percent=NUMBER,...",
        help="what the days late of overrides.csv cost: percent of the maximum for each day, and if you like free=DAYS and lowest=PERCENT",
    )
    parser.add_argument(
        "--only", nargs="+", metavar="ID", help="grade only these students, and leave the other results as they are"
    )
    parser.add_argument(
        "--cluster", metavar="tcp://HOST:PORT", help="the scheduler of a Dask cluster that runs the submissions"
    )
    parser.add_argument(
        "--gradebook", type=Path, metavar="FOLDER", help="the folder of an nbgrader course, to fill its gradebook too"
    )
    parser.add_argument(
        UNSAFE_OPTION,
        action="store_true",
        dest="unsafe",
        help="run submissions with your own rights; use it only for code that you trust",
    )


def run(options: argparse.Namespace) -> int:
    """Grade, and return the exit code: 0 done, 1 some or all submissions could not be graded, 2 impossible request."""
    if options.jobs < 1:
        raise ValueError(f"--jobs must be at least 1; got {options.jobs}.")
    if missing := next((package for package in REQUIRED if find_spec(package) is None), None):
        raise ModuleNotFoundError(f"No module named {missing!r}")
    try:
        return _run(options)
    except OSError as error:
        raise ValueError(_explain(error)) from error
    except EXPLAINED_ERRORS as error:
        raise ValueError(str(error)) from error
    except WrongRoster as error:
        print(f"misstep grade: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(
            "misstep grade: stopped. All results so far are stored; the same command continues from there.",
            file=sys.stderr,
        )
        return 130


def _explain(error: OSError) -> str:
    """What an error of the system means for the results, and what to do."""
    if error.errno in {errno.ENOSPC, errno.EDQUOT}:
        where = f" at {error.filename}" if error.filename else ""
        return f"the disk is full{where}. All results so far are stored. Free some space; the same command continues from there."
    if error.errno == errno.EROFS:
        return f"{error.filename} cannot be written, because its disk is read-only. Choose another folder with --out."
    return f"{error.filename}: {error.strerror}." if error.filename and error.strerror else str(error)


def _run(options: argparse.Namespace) -> int:
    limits = _read_limits(options.limit)
    late = LateRule.parse(options.late) if options.late else None
    sheet = read_released_sheet(options.sheet, options.course, options.site, _read_key(options.key, options.key_file))
    roster = read_roster(options.roster, options.id_column) if options.roster else None
    gathered = gather(options.submissions, sheet.name, roster)
    selected = _select(gathered.submissions, options.only)
    for remark in gathered.remarks:
        print(remark)
    with (
        open_results(options.out, sheet.name) as store,
        _open_gradebook(options, sheet) as gradebook,
        ThreadPoolExecutor(options.jobs) as pool,
        start_judge(sheet, has_gradebook=gradebook is not None) as judge,
    ):
        write_template(options.out)
        check_overrides(options.out, has_late_rule=late is not None)
        failures, limited = Run(options, sheet, limits, judge, store, pool).grade(selected)
        students = [submission.student for submission in gathered.submissions]
        writer = ResultWriter(options.out, judge, pool, late)
        if gradebook:
            writer.fill_gradebook(gradebook, selected)
        writer.write_pages(students)
        summary = judge.do(
            "tables",
            seconds=TABLES_SECONDS + TABLES_SECONDS_PER_STUDENT * len(students),
            out=options.out,
            students=students,
            roster=roster,
            column=options.column,
            limits=str(limits),
            late=late,
        )
        write_feedback_zip(options.out, gathered, sheet.name)
    summary += [f"Limits: {limits}.", *sorted(writer.remarks)]
    summary += [
        f"{student} reached a limit, also when graded alone: {'; '.join(why)}." for student, why in limited.items()
    ]
    if options.unsafe:
        summary.append(f"{UNSAFE_OPTION}: the submissions ran with your rights.")
    print("\n".join(summary))
    for student, error in failures.items():
        print(f"Not graded: {student}: {error!r}. The same command tries again.", file=sys.stderr)
    return 1 if failures else 0


def _open_gradebook(
    options: argparse.Namespace, sheet: ReleasedSheet
) -> "AbstractContextManager[GradebookWriter | None]":
    """The gradebook of the nbgrader course, if there is one."""
    if options.gradebook is None:
        return nullcontext()
    from misstep.grading.nbgrader.gradebook import open_gradebook  # here, because it takes a second to import

    return open_gradebook(options.gradebook, sheet, overwrite=options.regrade is not None)


def _read_limits(settings: Sequence[str]) -> Limits:
    """The limits, changed by settings such as "cell_seconds=20".

    Raises ValueError for a setting of another form.
    """
    values: dict[str, float] = {}
    known = {field.name: field.type for field in fields(Limits)}
    for setting in settings:
        name, _, text = setting.partition("=")
        try:
            values[name] = (int if known[name] in {int, "int"} else float)(text)
        except (KeyError, ValueError) as error:
            raise ValueError(
                f"--limit takes NAME=NUMBER, with one of the names {', '.join(known)}; got {setting!r}."
            ) from error
    return Limits(**values)  # type: ignore[arg-type]


def _read_key(key: str | None, file: Path | None) -> str:
    """The key, or that in a file; "" if there is none.

    Raises ValueError for a key of less than 8 characters, which can be guessed, and for the name of a file as the key.
    """
    if key is None and file is None:
        return ""
    if key is not None and file is not None:
        raise ValueError("Give the key with --key or with --key-file, not with both.")
    is_file = False
    with suppress(OSError):  # a key may be what cannot be the name of a file
        is_file = key is not None and Path(key).is_file()
    if is_file:
        raise ValueError(f"--key takes the key itself; {key} is a file. Pass it with --key-file {key}.")
    try:
        text = file.read_text("utf-8").strip() if file else str(key)
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"The key cannot be read from {file}: {getattr(error, 'strerror', None) or error}.") from error
    if len(text) < MIN_KEY_LENGTH:
        raise ValueError(
            f"The key must have at least {MIN_KEY_LENGTH} characters; it has {len(text)}. Students must not guess it."
        )
    return text


def _select(submissions: Sequence[Submission], only: Sequence[str] | None) -> list[Submission]:
    if not only:
        return list(submissions)
    ids = {student.casefold() for student in only}
    selected = [submission for submission in submissions if submission.student.casefold() in ids]
    if unknown := ids - {submission.student.casefold() for submission in selected}:
        raise ValueError(
            f"There is no submission of {', '.join(sorted(unknown))}. --only takes ids as in the column student of grades.csv."
        )
    return selected


@dataclass(frozen=True)
class Run:
    """One run of the command: what it was asked for, and where its results go."""

    options: argparse.Namespace
    sheet: ReleasedSheet
    limits: Limits
    judge: StepProcesses
    store: ResultStore
    pool: Executor

    def grade(self, submissions: Sequence[Submission]) -> tuple[dict[str, BaseException], dict[str, Sequence[str]]]:
        """Grade what has no result yet, and store each result at once.

        A submission that reaches a limit is graded again at the end, alone: neither the load of the machine nor the number of
        jobs may cost a point.

        Returns the errors of those that could not be graded, and the limits of those that reached one alone.
        """
        from tqdm import tqdm  # here, because it is slow to import, and the other processes start meanwhile

        failures, limited, again = dict[str, BaseException](), dict[str, Sequence[str]](), list[Submission]()
        with tqdm(total=len(submissions), desc=self.sheet.name, bar_format=PROGRESS, disable=None) as bar:
            jobs = self._jobs(submissions, bar.update)
            if (first := next(jobs, None)) is None:
                return {}, {}  # without starting a sandbox
            with self._start_workers() as (submit, worker_count):

                def outcomes() -> Iterator[tuple[GradingJob, Result | BaseException]]:
                    for job, outcome in run_bounded(submit, chain([first], jobs), PENDING_PER_WORKER * worker_count):
                        if isinstance(outcome, Result) and outcome.limits:
                            again.append(job.submission)  # without its bytes, of which many might not fit into memory
                        else:
                            yield job, outcome
                    yield from run_bounded(submit, self._jobs(again, bar.update), 1)

                for job, outcome in outcomes():
                    bar.update()
                    if isinstance(outcome, BaseException):
                        failures[job.submission.student] = outcome
                        continue
                    result = self._store(job, outcome)
                    if result.limits:
                        limited[result.student] = result.limits
        return failures, limited

    def _store(self, job: GradingJob, outcome: Result) -> Result:
        result = job.complete(outcome)
        if self.options.regrade and (old := self.store.load(result.student)):
            result = result.keeping(old, self.options.regrade)
        self.store.save(result, job.fingerprint)
        return result

    def _jobs(self, submissions: Sequence[Submission], skip: Callable[[], object]) -> Iterator[GradingJob]:
        """The jobs of the submissions that have no result yet."""
        for job in make_jobs(submissions, self.sheet, f"{self.limits}, {not self.options.unsafe}"):
            if self.options.regrade is None and self.store.load(job.submission.student, job.fingerprint):
                skip()
            else:
                yield job

    @contextmanager
    def _start_workers(self) -> Iterator[tuple[Callable[[GradingJob], Future[Result]], int]]:
        """A function that submits a job, and how many jobs run at a time: in threads with one grader, or on a cluster."""
        is_safe = not self.options.unsafe
        if self.options.cluster:
            with connect(self.options.cluster) as (executor, worker_count):
                grade = partial(grade_on_worker, (self.sheet, self.limits, is_safe))
                yield lambda job: executor.submit(grade_best, grade, *job.request), worker_count
            return
        with Grader(self.sheet, self.limits, is_safe, self.judge) as grader:
            yield lambda job: self.pool.submit(grade_best, grader.grade, *job.request), self.options.jobs
