"""How fast a class is graded: the same 100 submissions of sheet 03, by kinlib and by nbgrader, in one run.

    python -m benchmarks.grading
    python -m benchmarks.grading 20 200        by both, and then by kinlib alone

kinlib grades two at a time; nbgrader has no way to. Both are timed from start to end, imports included. Memory is what the
grading process and all that it started take together, each shared page counted once (PSS), at its highest; growth is how
far the second half of the long run lies above the first, in the median.
"""

import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path += [str(Path(__file__).parent), str(Path(__file__).parents[1] / "tests")]
from stock import ROOT, Course
from submissions import as_bytes, handed_in, mistaken, released, right

JOBS = 2


def main(count=100, many=1000):
    """Print seconds, submissions a minute and memory of both, over the same submissions."""
    with tempfile.TemporaryDirectory() as folder:
        course = Course(Path(folder))
        handed, more = Path(folder, "handed"), Path(folder, "more")
        for number in range(count):
            student, notebook = generated(number)
            course.hand_in(student, notebook)
            save(handed, student, notebook)
        for number in range(many):
            save(more, *generated(number))
        seconds, memory, points = ours(handed)
        print(f"{count} submissions of sheet 03           seconds    a minute    ms each    memory")
        print(f"kinlib, {JOBS} at a time                  {row(count, seconds)}    {max(memory):4.0f} MB")
        theirs = course.autograde()
        print(f"nbgrader autograde                   {row(count, theirs)}")
        scores = course.scores()
        agreed = sum(scores.get(student) == whole for student, whole in points.items())
        print(
            f"kinlib is {theirs / seconds:.0f} times as fast; {agreed} of {count} get the same from both, the others parts of points"
        )
    seconds, memory, _ = ours(more)
    half = len(memory) // 2
    growth = statistics.median(memory[half:]) - statistics.median(memory[:half])
    print(
        f"kinlib, {many} submissions            {row(many, seconds)}    {max(memory):4.0f} MB, growth {growth:+.0f} MB"
    )


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


def row(count, seconds):
    """Seconds, submissions a minute, milliseconds each."""
    return f"{seconds:7.1f}    {60 * count / seconds:8.0f}    {1e3 * seconds / count:7.1f}"


def ours(folder):
    """Grade a folder in a process of its own: the seconds, the memory every half second in MB, the points."""
    start = time.perf_counter()
    command = [sys.executable, __file__, "--grade", str(folder)]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, text=True, env=os.environ | {"PYTHONPATH": str(ROOT)}
    ) as process:
        memory = []
        while process.poll() is None:
            memory.append(sum(map(own_share, family(process.pid))))
            time.sleep(0.5)
        told = process.stdout.read()
    seconds = time.perf_counter() - start
    return seconds, memory, {student: float(points) for student, points in map(str.split, told.splitlines())}


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


def grade(folder):
    """What the other process does: grade every submission of a folder, and print the points."""
    from kinlib.grading.grade import Grader
    from kinlib.grading.submission import master
    from kinlib.grading.work import as_done

    def graded(path):
        return grader.grade(path.parent.name, path.read_bytes()).points

    with Grader(master(released())) as grader, ThreadPoolExecutor(JOBS) as pool:
        for path, points in as_done(pool, graded, sorted(Path(folder).glob("*/*.ipynb")), 2 * JOBS):
            print(path.parent.name, points)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--grade"]:
        grade(sys.argv[2])
    else:
        main(*map(int, sys.argv[1:]))
