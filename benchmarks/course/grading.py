"""Speed of grading a class: 10 submissions of sheet 03 by misstep and by nbgrader, then 300 and 600 by misstep.

    python -m benchmarks.course.grading
    python -m benchmarks.course.grading 60 120        60 instead of 300, and 120 instead of 600

The 10 are graded by both in turn, three times, because in a small class the start counts. misstep grades the 300 three times
too, in turn with nbgrader, and the median counts. nbgrader would need a quarter of an hour for 300, so it grades 10, 20 and 60,
and its time for 300 is reckoned: its start, and the same time for each submission, fitted by least squares to these runs. How
far the runs are from this line is printed. Processor time is that of all processes that a run starts.

Each is timed from start to end as an instructor runs it, imports included. misstep grades two submissions at a time, which
nbgrader cannot, and fills nbgrader's gradebook, as `nbgrader autograde` does. It also writes a feedback page for each student
and a report, which autograde does not; misstep's time includes them, and the time of the pages alone is printed below.

Memory is the highest total of the grading process and all processes that it started, where each shared page counts once
(PSS); growth is the difference between the medians of the last third and of the second third of the long run.
"""

import csv
import ctypes
import os
import random
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import redirect_stdout, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from submissions import as_bytes, handed_in, mistaken, released, right

from benchmarks.course.nbgrader_baseline import ROOT, Course
from benchmarks.measure import Curve, MissingRequirementError, Row, timed_row

JOBS = 2

PR_SET_CHILD_SUBREAPER = 36

SMALL, SMALL_ROUNDS, MIN_SMALL_SPEEDUP = 10, 3, 10.0
"""A small class: its size, how often it is graded, and the target for its speed compared with nbgrader."""

NBGRADER_SIZES = 20, 60
"""Larger classes that nbgrader grades, from which its time for a still larger one is reckoned."""

MIN_SPEEDUP, MAX_MS_EACH, MAX_MEMORY_MB, MAX_GROWTH_MB = 25.0, 50.0, 250.0, 5.0
"""Targets: speed compared with nbgrader, time for each further submission, memory, growth of memory."""

CLASS_SIZES = (25, 50, 100, 200)
"""Numbers of submissions for which the growth of the time is measured."""


@dataclass(frozen=True)
class GradingRun:
    """The number of graded submissions, wall and processor time in seconds, and the memory every second, in MB."""

    count: int
    seconds: float
    processor_seconds: float = 0.0
    memory: Sequence[float] = ()

    def print_line(self, name: str) -> None:
        """Print a line of the table."""
        each, memory = self.seconds / self.count, f"{max(self.memory):7.0f} MB" if self.memory else ""
        numbers = f"{self.seconds:9.1f} {self.processor_seconds:9.1f} {60 / each:11.0f} {1e3 * each:10.1f}"
        print(f"{name:36} {numbers} {memory}", flush=True)

    @property
    def growth(self) -> float:
        """The growth of memory from the second third to the last, in MB."""
        third = len(self.memory) // 3
        return statistics.median(self.memory[2 * third :]) - statistics.median(self.memory[third : 2 * third])


@dataclass(frozen=True)
class Comparison:
    """A small class graded by both in turn, larger ones by nbgrader and by misstep, and many submissions by misstep.

    small              by misstep without a gradebook, and by nbgrader, in each round
    with_gradebook     by misstep, which also fills nbgrader's gradebook, in each round
    pages              the feedback pages alone
    nbgrader           smaller classes by nbgrader, in turn with these
    many               by misstep with a gradebook, many more submissions
    point_differences  how many points misstep gives more than nbgrader, for each submission that both have graded
    """

    small: Sequence[tuple[GradingRun, GradingRun]]
    with_gradebook: Sequence[GradingRun]
    pages: GradingRun
    nbgrader: Sequence[GradingRun]
    many: GradingRun
    point_differences: Sequence[float]

    @property
    def nbgrader_line(self) -> np.poly1d:
        """The seconds of nbgrader, reckoned for any number of submissions."""
        sizes, seconds = zip(*((run.count, run.seconds) for run in self.nbgrader_runs), strict=True)
        return np.poly1d(np.polyfit(sizes, seconds, 1))

    @property
    def nbgrader_runs(self) -> list[GradingRun]:
        """All runs of nbgrader."""
        return [*(theirs for _, theirs in self.small), *self.nbgrader]

    @property
    def farthest_from_line(self) -> float:
        """The largest distance of a run of nbgrader from its line, relative to its time."""
        return max(abs(self.nbgrader_line(run.count) / run.seconds - 1) for run in self.nbgrader_runs)

    @property
    def count(self) -> int:
        """The size of the larger class."""
        return self.with_gradebook[0].count

    @property
    def seconds(self) -> float:
        """The seconds of misstep for the larger class, gradebook and pages included."""
        return statistics.median(run.seconds for run in self.with_gradebook)

    @property
    def speedup(self) -> float:
        """How many times as fast as nbgrader misstep is, gradebook and pages included."""
        return float(self.nbgrader_line(self.count)) / self.seconds

    @property
    def ms_each(self) -> float:
        """The time for each further submission, gradebook included and its page excluded, in ms."""
        further = (self.many.seconds - self.seconds) / (self.many.count - self.count)
        return 1e3 * (further - self.pages.seconds / self.pages.count)

    @property
    def max_memory(self) -> float:
        """The highest memory of misstep, in MB."""
        return max(max(run.memory) for run in (*self.with_gradebook, self.many))


def main(count: int = 300, many: int = 600) -> Comparison:
    """Grade with both, and print the results with their targets."""
    print(f"{'submissions of sheet 03':36}   seconds processor    a minute    ms each    memory")
    comparison = compare_with_nbgrader(count, many)
    line, off = comparison.nbgrader_line, comparison.farthest_from_line
    differences = comparison.point_differences
    more, fewer = sum(points > 0 for points in differences), sum(points < 0 for points in differences)
    small = statistics.median(theirs.seconds / ours.seconds for ours, theirs in comparison.small)
    print(f"""
of {comparison.small[0][0].count} submissions, misstep is {small:.1f} times as fast as nbgrader (target: {MIN_SMALL_SPEEDUP:.0f})
misstep, gradebook and pages included, is {comparison.speedup:.1f} times as fast as nbgrader (target: {MIN_SPEEDUP:.0f})
    for which nbgrader is reckoned to take {line(0):.1f} s and {line[1]:.2f} s for each; its runs are at most {off:.0%} from this
each further submission, without its page, takes {comparison.ms_each:.0f} ms (target: at most {MAX_MS_EACH:.0f})
memory: {comparison.max_memory:.0f} MB (target: at most {MAX_MEMORY_MB:.0f}), {comparison.many.growth:+.0f} MB during {many} submissions
points: {differences.count(0)} equal, {more} higher from misstep, for partly right answers, {fewer} lower""")
    return comparison


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the rows of the table of all benchmarks.

    Raises MissingRequirementError if there is no sandbox.
    """
    if sys.platform != "linux":
        raise MissingRequirementError("the sandbox needs Linux")
    with redirect_stdout(sys.stderr):
        comparison = main(3, 9) if quick else main()
    count, many = comparison.count, comparison.many.count
    each, peer = comparison.seconds / count, float(comparison.nbgrader_line(count)) / count
    small = [[run.seconds / run.count for run in runs] for runs in zip(*comparison.small, strict=True)]
    name = f"grading {comparison.small[0][0].count} submissions, each"
    yield timed_row(name, small[0], "nbgrader autograde", small[1], target=MIN_SMALL_SPEEDUP)
    *sizes, last = sorted({run.count for run in comparison.nbgrader_runs})
    reckoned = f"nbgrader autograde, reckoned from {', '.join(map(str, sizes))} and {last}"
    yield Row(f"grading {count} submissions, each, gradebook filled", "s", each, MIN_SPEEDUP, reckoned, peer)
    yield Row(
        "each further submission, gradebook filled", "s", comparison.ms_each / 1e3, MAX_MS_EACH / 1e3, at_most=True
    )
    yield Row(f"memory of grading, {JOBS} at a time", "MB", comparison.max_memory, MAX_MEMORY_MB, at_most=True)
    yield Row(f"growth of memory during {many} submissions", "MB", comparison.many.growth, MAX_GROWTH_MB, at_most=True)


def curves(quick: bool = False) -> Iterator[Curve]:
    """Measure how the time grows with the class, without a gradebook. Each class is graded once, as the time hardly varies."""
    counts = (1, 2, 4) if quick else CLASS_SIZES
    with tempfile.TemporaryDirectory() as top:
        runs = []
        for count in counts:
            handed = Path(top, f"{count} handed in")
            for number in range(count):
                save(handed, *generated(number))
            runs.append(grade_with_misstep(handed, Path(top, f"{count} graded")))
    yield Curve("grading a class", "submissions", counts, tuple(run.seconds for run in runs))


def compare_with_nbgrader(count: int, many: int) -> Comparison:
    """Grade the same submissions with both, then many more with misstep, and print a line after each run."""
    with tempfile.TemporaryDirectory() as top:
        handed, more = Path(top, "handed"), Path(top, "more")
        sizes = (SMALL, *NBGRADER_SIZES) if count > SMALL else (1, 2, 3)
        small = compare_in_turn(Path(top, "small"), sizes[0], SMALL_ROUNDS if count > SMALL else 1)
        for folder, size in ((handed, count), (more, many)):
            for number in range(size):
                save(folder, *generated(number))
        with_gradebook, by_nbgrader = [], []
        for size in sizes:
            nbgrader, book, out = (
                Course(Path(top, f"nbgrader {size}")),
                Path(top, f"book {size}"),
                Path(top, f"out {size}"),
            )
            for number in range(size):
                nbgrader.hand_in(*generated(number))
            options = ("--gradebook", Course(book, is_asserting=False).folder)
            with_gradebook.append(grade_with_misstep(handed, out, *options))
            with_gradebook[-1].print_line(f"{count}, with nbgrader's gradebook")
            by_nbgrader.append(grade_with_nbgrader(nbgrader, size))
            by_nbgrader[-1].print_line(f"{size}, nbgrader autograde")
        pages = GradingRun(count, seconds_of_pages(out, Path(top, "pages")))
        pages.print_line(f"of {count}, pages of feedback")
        own = points(out)
        differences = [own[student] - score for student, score in nbgrader.scores().items() if student in own]
        options = ("--gradebook", Course(Path(top, "long book"), is_asserting=False).folder)
        long = grade_with_misstep(more, Path(top, "long"), *options)
        long.print_line(f"{many}, with nbgrader's gradebook")
    return Comparison(small, with_gradebook, pages, by_nbgrader, long, differences)


def compare_in_turn(top: Path, count: int, rounds: int) -> list[tuple[GradingRun, GradingRun]]:
    """Grade a small class with misstep and with nbgrader in each round, and print a line after each run."""
    runs = []
    for number in range(rounds):
        folder = top / str(number)
        folder.mkdir(parents=True)
        nbgrader = Course(folder / "nbgrader")
        for k in range(count):
            student, notebook = generated(k)
            nbgrader.hand_in(student, notebook)
            save(folder / "handed", student, notebook)
        runs.append((grade_with_misstep(folder / "handed", folder / "out"), grade_with_nbgrader(nbgrader, count)))
        for run, name in zip(runs[-1], ("misstep grade", "nbgrader autograde"), strict=True):
            run.print_line(f"{count}, {name}")
    return runs


def grade_with_nbgrader(course: Course, count: int) -> GradingRun:
    """Grade what a course has collected with nbgrader."""
    before = processor_seconds()
    seconds = course.autograde()
    return GradingRun(count, seconds, processor_seconds() - before)


def processor_seconds() -> float:
    """The processor time of all processes that this one has started, and of those that these have left behind."""
    ctypes.CDLL(None).prctl(
        PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0
    )  # from now on, the kernel gives us what others leave behind
    with suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


@cache
def generated(number):
    """Return a student and a submission: most answers right, some with a known mistake, some missing."""
    chance, student = random.Random(number), f"student{number:04}"
    good, bad = right(student), mistaken(student, number)
    lines = {k: chance.choices([good[k], bad[k], "pass"], [6, 3, 1])[0] for k in good}
    return student, handed_in(student, lines)


def save(folder, student, notebook):
    """Write a submission into a folder of submissions."""
    path = folder / student / released().name
    path.parent.mkdir(parents=True)
    path.write_bytes(as_bytes(notebook))


def grade_with_misstep(handed, out, *options):
    """Grade a folder with misstep, as an instructor does, and record time and memory."""
    before, start = processor_seconds(), time.perf_counter()
    command = [
        sys.executable,
        "-m",
        "misstep",
        "grade",
        released(),
        handed,
        "--out",
        out,
        "--jobs",
        str(JOBS),
        *options,
    ]
    memory = []
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, env=os.environ | {"PYTHONPATH": str(ROOT)}) as process:
        while process.poll() is None:
            memory.append(sum(map(proportional_memory, process_tree(process.pid))))
            with suppress(subprocess.TimeoutExpired):
                process.wait(1.0)
    if process.returncode:
        raise MissingRequirementError(
            f"misstep grade ended with {process.returncode}. Run it by itself to see its error message."
        )
    seconds = time.perf_counter() - start
    return GradingRun(len(list(handed.iterdir())), seconds, processor_seconds() - before, memory)


def seconds_of_pages(out, where):
    """Write the pages of all results again, and return the seconds."""
    from misstep.grading.publish.publish import publish_feedback
    from misstep.grading.publish.result_store import ResultStore

    results = [ResultStore(out).load(path.stem) for path in (out / "results").glob("*.json")]
    start = time.perf_counter()
    for result in results:
        publish_feedback(where, result)
    return time.perf_counter() - start


def points(out):
    """Read the points of each student from grades.csv."""
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        return {row["student"]: float(row["points"]) for row in csv.DictReader(file)}


def process_tree(process):
    """Return the ids of a process and of all processes that it started."""
    try:
        children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        return [process]
    return [process, *(each for child in children for each in process_tree(int(child)))]


def proportional_memory(process):
    """Return the proportional set size of a process in MB; 0 if it has ended."""
    try:
        lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
    except OSError:
        return 0.0
    return next((int(line.split()[1]) / 1024 for line in lines if line.startswith("Pss:")), 0.0)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
