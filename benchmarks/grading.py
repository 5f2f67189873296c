"""How fast a class is graded: the same 100 submissions of sheet 03, by kinlib and by nbgrader, in one run.

    python -m benchmarks.grading
    python -m benchmarks.grading 20 200        by both, and then by kinlib alone

kinlib grades two at a time; nbgrader has no way to. Both are timed from start to end, imports included, kinlib with its pages
of feedback and its report. Memory is what the grading process and all that it started take together, each shared page
counted once (PSS), at its highest; growth is how far the last third of the long run lies above the second, in the median.
"""

import csv
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += [str(Path(__file__).parent), str(Path(__file__).parents[1] / "tests")]
from stock import ROOT, Course
from submissions import as_bytes, handed_in, mistaken, released, right

JOBS = 2


def main(count=100, many=1000):
    """Print seconds, submissions a minute and memory of both, over the same submissions."""
    with tempfile.TemporaryDirectory() as top:
        theirs, handed, more = Course(Path(top, "theirs")), Path(top, "handed"), Path(top, "more")
        for number in range(count):
            student, notebook = generated(number)
            theirs.hand_in(student, notebook)
            save(handed, student, notebook)
        for number in range(many):
            save(more, *generated(number))
        books = [str(Course(Path(top, name), is_asserting=False).folder) for name in ("book", "long book")]
        print(f"{count} submissions of sheet 03            seconds    a minute    ms each    memory")
        plain = told("kinlib grade", count, *ours(handed, Path(top, "plain")))
        booked = told("with nbgrader's gradebook", count, *ours(handed, Path(top, "booked"), "--gradebook", books[0]))
        stock = told("nbgrader autograde", count, theirs.autograde())
        print(f"kinlib is {stock / plain:.0f} times as fast")
        scores = theirs.scores()
        differ = [whole - scores.get(student, 0) for student, whole in points(Path(top, "plain")).items()]
        more_points, fewer = sum(one > 0 for one in differ), sum(one < 0 for one in differ)
        print(
            f"points: {differ.count(0)} the same, {more_points} more from kinlib, for parts of answers, {fewer} fewer\n"
        )
        seconds, memory = ours(more, Path(top, "long"), "--gradebook", books[1])
        told(f"{many}, with the gradebook", many, seconds, memory)
        print(
            f"each further submission takes {1e3 * (seconds - booked) / (many - count):.0f} ms, pages and gradebook included"
        )
        third = len(memory) // 3
        growth = statistics.median(memory[2 * third :]) - statistics.median(memory[third : 2 * third])
        print(f"growth from the second third to the last: {growth:+.0f} MB")


def told(what, count, seconds, memory=()):
    """Print a line of the table, and give the seconds back."""
    most = f"{max(memory):7.0f} MB" if memory else ""
    print(f"{what:36} {seconds:9.1f} {60 * count / seconds:11.0f} {1e3 * seconds / count:10.1f} {most}", flush=True)
    return seconds


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
    """Grade a folder as an instructor does: the seconds, and the memory every half second in MB."""
    start = time.perf_counter()
    command = [sys.executable, "-m", "kinlib", "grade", released(), handed, "--out", out, "--jobs", str(JOBS), *options]
    memory = []
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, env=os.environ | {"PYTHONPATH": str(ROOT)}) as process:
        while process.poll() is None:
            memory.append(sum(map(own_share, family(process.pid))))
            time.sleep(0.5)
    if process.returncode:
        raise SystemExit(f"kinlib grade ended with {process.returncode}")
    return time.perf_counter() - start, memory


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
