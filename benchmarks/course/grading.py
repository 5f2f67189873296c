"""How fast a class is graded: the same 100 submissions of sheet 03, by kinlib and by nbgrader, in one run; then 1,000.

    python -m benchmarks.course.grading
    python -m benchmarks.course.grading 20 200        by both, and then by kinlib alone

Each is timed from start to end as an instructor runs it, imports included. misstep grades two at a time, which nbgrader has
no way to, and fills nbgrader's gradebook, as `nbgrader autograde` does. With it come a page of feedback for each student and
a report, which autograde does not make: they are in kinlib's seconds, and how long the pages take alone stands below them.

Memory is what the grading process and all that it started take together, each shared page counted once (PSS), at its
highest; growth is how far the last third of the long run lies above the second, in the median.
"""

import csv
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import redirect_stdout, suppress
from dataclasses import dataclass
from pathlib import Path

from submissions import as_bytes, handed_in, mistaken, released, right

from benchmarks.course.nbgrader_baseline import ROOT, Course
from benchmarks.measure import Curve, NotHere, Row

JOBS = 2

FASTER, EACH, MOST, GROWTH = 25.0, 50.0, 250.0, 5.0
"""Wanted: so many times as fast as nbgrader; at most so many ms for a submission, MB, and MB of growth."""

CLASSES = (25, 50, 100, 200, 400)
"""Submissions, to see how the time grows."""


@dataclass(frozen=True)
class Run:
    """So many submissions graded in so many seconds; the memory every half second, in MB."""

    count: int
    seconds: float
    memory: Sequence[float] = ()

    def told(self, what: str) -> None:
        """Print a line of the table."""
        each, most = self.seconds / self.count, f"{max(self.memory):7.0f} MB" if self.memory else ""
        print(f"{what:36} {self.seconds:9.1f} {60 / each:11.0f} {1e3 * each:10.1f} {most}", flush=True)

    @property
    def growth(self) -> float:
        """From the second third to the last, in MB."""
        third = len(self.memory) // 3
        return statistics.median(self.memory[2 * third :]) - statistics.median(self.memory[third : 2 * third])


@dataclass(frozen=True)
class Comparison:
    """The same submissions four times: without and with nbgrader's gradebook, pages alone, by nbgrader; then many more.

    differ  by how many points kinlib gives more than nbgrader, submission by submission
    """

    plain: Run
    booked: Run
    pages: Run
    stock: Run
    many: Run
    differ: Sequence[float]

    @property
    def faster(self) -> float:
        """How many times as fast kinlib is, gradebook and pages included."""
        return self.stock.seconds / self.booked.seconds

    @property
    def each(self) -> float:
        """What a submission takes beyond the start, gradebook included and its page left out, in ms."""
        further = (self.many.seconds - self.booked.seconds) / (self.many.count - self.booked.count)
        return 1e3 * (further - self.pages.seconds / self.pages.count)

    @property
    def most(self) -> float:
        """The most memory that kinlib took, in MB."""
        return max(*self.plain.memory, *self.booked.memory, *self.many.memory)


def main(count: int = 100, many: int = 1000) -> Comparison:
    """Grade, and print what came of it beside what was wanted."""
    print(f"{count} submissions of sheet 03            seconds    a minute    ms each    memory")
    made = compared(count, many)
    more, fewer = sum(points > 0 for points in made.differ), sum(points < 0 for points in made.differ)
    print(f"""
kinlib, gradebook and pages included, is {made.faster:.1f} times as fast as nbgrader (wanted: {FASTER:.0f})
beyond the start, a submission takes {made.each:.0f} ms, its page left out (wanted: at most {EACH:.0f})
of memory it takes {made.most:.0f} MB (wanted: at most {MOST:.0f}), and with {many} grows by {made.many.growth:+.0f} MB
points: {made.differ.count(0)} the same, {more} more from kinlib, for parts of answers, {fewer} fewer""")
    return made


def rows(quick: bool = False) -> Iterator[Row]:
    """The rows of the table of all benchmarks.

    Raises NotHere where there is no sandbox.
    """
    if sys.platform != "linux":
        raise NotHere("the sandbox is made of what only Linux has")
    with redirect_stdout(sys.stderr):
        made = main(3, 9) if quick else main()
    count, many, peer = made.booked.count, made.many.count, "nbgrader autograde"
    each, stock = (run.seconds / run.count for run in (made.booked, made.stock))
    yield Row(f"grade {count} submissions, each, gradebook filled", "s", each, FASTER, peer, stock)
    yield Row("each further submission, gradebook filled", "s", made.each / 1e3, EACH / 1e3, at_most=True)
    yield Row(f"memory of grading, {JOBS} at a time", "MB", made.most, MOST, at_most=True)
    yield Row(f"growth of memory in {many} submissions", "MB", made.many.growth, GROWTH, at_most=True)


def curves(quick: bool = False) -> Iterator[Curve]:
    """How the time grows with the class, without a gradebook. Each class is graded once: what it takes is no matter of luck."""
    counts = (1, 2, 4) if quick else CLASSES
    with tempfile.TemporaryDirectory() as top:
        runs = []
        for count in counts:
            handed = Path(top, f"{count} handed in")
            for number in range(count):
                save(handed, *generated(number))
            runs.append(ours(handed, Path(top, f"{count} graded")))
    yield Curve("grading a class", "submissions", counts, tuple(run.seconds for run in runs))


def compared(count: int, many: int) -> Comparison:
    """Grade the same submissions by both, and then many more by kinlib alone, telling each as it is done."""
    with tempfile.TemporaryDirectory() as top:
        theirs, handed, more = Course(Path(top, "theirs")), Path(top, "handed"), Path(top, "more")
        for number in range(count):
            student, notebook = generated(number)
            theirs.hand_in(student, notebook)
            save(handed, student, notebook)
        for number in range(many):
            save(more, *generated(number))
        books = [str(Course(Path(top, name), is_asserting=False).folder) for name in ("book", "long book")]
        plain = ours(handed, Path(top, "plain"))
        plain.told("misstep grade")
        booked = ours(handed, Path(top, "booked"), "--gradebook", books[0])
        booked.told("with nbgrader's gradebook")
        pages = Run(count, seconds_of_pages(Path(top, "booked"), Path(top, "pages")))
        pages.told("    of this, pages of feedback")
        stock = Run(count, theirs.autograde())
        stock.told("nbgrader autograde")
        scores = theirs.scores()
        differ = [whole - scores.get(student, 0) for student, whole in points(Path(top, "plain")).items()]
        long = ours(more, Path(top, "long"), "--gradebook", books[1])
        long.told(f"{many}, with nbgrader's gradebook")
    return Comparison(plain, booked, pages, stock, long, differ)


def generated(number):
    """A student and what they hand in: most answers right, some mistaken, some missing."""
    chance, student = random.Random(number), f"student{number:04}"
    good, bad = right(student), mistaken(student, number)
    lines = {k: chance.choices([good[k], bad[k], "pass"], [6, 3, 1])[0] for k in good}
    return student, handed_in(student, lines)


def save(folder, student, notebook):
    """Lay a submission where a folder of submissions has it."""
    path = folder / student / released().name
    path.parent.mkdir(parents=True)
    path.write_bytes(as_bytes(notebook))


def ours(handed, out, *options):
    """Grade a folder as an instructor does."""
    start = time.perf_counter()
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
            memory.append(sum(map(own_share, family(process.pid))))
            with suppress(subprocess.TimeoutExpired):
                process.wait(0.5)
    if process.returncode:
        raise NotHere(f"misstep grade ended with {process.returncode}. It says why when it is run by itself.")
    return Run(len(list(handed.iterdir())), time.perf_counter() - start, memory)


def seconds_of_pages(out, where):
    """Write the pages of results once more, and nothing else: the seconds."""
    from misstep.grading.publish.publish import publish_feedback
    from misstep.grading.publish.result_store import ResultStore

    results = [ResultStore(out).load(path.stem) for path in (out / "results").glob("*.json")]
    start = time.perf_counter()
    for result in results:
        publish_feedback(where, result)
    return time.perf_counter() - start


def points(out):
    """What grades.csv says, by student."""
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        return {row["student"]: float(row["points"]) for row in csv.DictReader(file)}


def family(process):
    """The ids of a process and of all that it started."""
    try:
        children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        return [process]
    return [process, *(one for child in children for one in family(int(child)))]


def own_share(process):
    """The proportional set size of a process in MB; 0 once it is gone."""
    try:
        lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
    except OSError:
        return 0.0
    return next((int(line.split()[1]) / 1024 for line in lines if line.startswith("Pss:")), 0.0)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
