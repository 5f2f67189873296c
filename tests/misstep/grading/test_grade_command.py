"""`misstep grade`: from a folder to results, stopped at any moment and gone on with, each submission graded once."""

import csv
import errno
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import ClassVar

import pytest
import submissions
from submissions import SHEET, as_bytes, handed_in, mistaken, right

if sys.platform != "linux":
    pytest.skip("the sandbox is made of Linux", allow_module_level=True)

from misstep.__main__ import main
from misstep.grading import command
from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.publish.result_store import ResultStore, open_results
from misstep.grading.sandbox.limits import SandboxUnavailable

SOLUTION = str(submissions.ROOT / "solutions" / SHEET / f"{SHEET}.ipynb")

SLOW = "import time\ntime.sleep(0.4)"

PARTS = {k: line for k, line in right("carol").items() if k <= 4}

CLASS = {
    "alice": (as_bytes(handed_in("alice", right("alice"))), 28, ""),
    "boris": (as_bytes(handed_in("boris", mistaken("boris"), first=SLOW)), None, ""),
    "carol": (as_bytes(handed_in("carol", PARTS)), 12, ""),
    "david": (as_bytes(handed_in("david", right("alice"), first=SLOW)), None, ""),
    "erika": (as_bytes(handed_in("alice", right("alice"))), None, "graded with the numbers of 'erika'"),
    "frank": (b"%PDF-1.7", 0, "a PDF"),
    "grace": (None, 0, "Nothing was handed in"),
    "heidi": (as_bytes(handed_in("heidi", right("heidi"), first=SLOW)), 28, ""),
}
"""By student, what was handed in, the points that it deserves (or None, where some are lucky), and the reason told."""


@pytest.fixture(scope="module")
def handed(tmp_path_factory):
    root = tmp_path_factory.mktemp("submissions")
    for student, (content, _, _) in CLASS.items():
        (root / student).mkdir()
        if content is not None:
            (root / student / f"{SHEET}.ipynb").write_bytes(content)
    return root


def grade(source, out, *options):
    return main(["grade", SOLUTION, str(source), "--out", str(out), *map(str, options)])


def rows(path):
    with path.open(newline="") as stream:
        return list(csv.DictReader(stream))


def snapshot(folder):
    """Every file with its bytes and the time of its last change."""
    return {p.relative_to(folder): (p.read_bytes(), p.stat().st_mtime_ns) for p in folder.rglob("*") if p.is_file()}


def contents(folder, pattern):
    return {path.name: path.read_bytes() for path in folder.glob(pattern)}


@pytest.fixture(scope="module")
def out(handed, tmp_path_factory):
    """The results of a whole run."""
    folder = tmp_path_factory.mktemp("results")
    if grade(handed, folder) != 0:
        try:
            command.Grader(command.read_released_sheet(Path(SOLUTION))).close()
        except SandboxUnavailable as missing:
            pytest.skip(f"NO GRADING IS TESTED: {missing}")
    return folder


def test_everybody_gets_the_points_and_the_reason_they_deserve(out):
    told = {row["student"]: row for row in rows(out / "grades.csv")}
    assert list(told) == list(CLASS)
    for student, (_, points, reason) in CLASS.items():
        assert points is None or float(told[student]["points"]) == points, student
        assert reason in told[student]["reason"]
    assert float(told["boris"]["points"]) < 20
    assert told["boris"]["mistakes"].count(";") >= 5
    pages = {student: (out / "feedback" / f"{student}.html").read_text("utf-8") for student in ("alice", "boris")}
    assert "Returning mistake: “omega x p” explains answers in 5 of the 5" in pages["boris"]
    assert "Returning mistake: " not in pages["alice"]
    assert "The id 'alice' is in 2 sheets." in told["erika"]["reason"]
    assert not (out / "feedback.zip").exists()


def test_a_student_with_the_answers_of_another_is_on_the_list(out):
    told = rows(out / "matches.csv")
    assert {row["student"] for row in told[:7]} <= {"david", "erika"}
    assert "alice" in told[0]["right for"]
    assert int(told[0]["answers right for one of them"]) >= 5
    assert "alice" not in {row["student"] for row in told}


def test_what_is_on_a_page_and_a_report_is_of_nobody_else(out):
    pages = {path.stem: path.read_text("utf-8") for path in (out / "feedback").iterdir()}
    assert set(pages) == set(CLASS)
    for student, page in pages.items():
        named = {name for name in CLASS if re.search(rf"\b{name}\b", page)}
        own = {student, "alice"} if student == "erika" else {student}  # erika's own sheet says alice
        assert named == own
    report = (out / "report.html").read_text("utf-8")
    assert not [name for name in CLASS if name in report]
    assert "omega x p" in report


def test_a_second_run_starts_nothing_and_touches_nothing(handed, out, monkeypatch):
    before = snapshot(out)
    monkeypatch.setattr(command, "Grader", None)
    assert grade(handed, out) == 0
    assert snapshot(out) == before


def test_killed_at_any_moment_it_goes_on_and_ends_as_if_nothing_had_been(handed, out, tmp_path):
    results = tmp_path / "out" / "results"
    options = ["grade", SOLUTION, str(handed), "--out", str(tmp_path / "out"), "--jobs", "1"]
    environment = {**os.environ, "PYTHONPATH": str(submissions.ROOT)}
    command = [sys.executable, "-m", "misstep", *options]
    with subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, start_new_session=True) as process:
        deadline = time.monotonic() + 120
        while len(list(results.glob("*.json"))) < 3 and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGKILL)
    done = snapshot(results)
    assert 3 <= len(done) < len(CLASS) + 1
    (results / ".partial.json.partial").write_text('{"version": 2, "fingerprint"')  # a write that was cut off
    assert grade(handed, tmp_path / "out") == 0
    after = snapshot(results)
    assert {path: after[path] for path in done} == done
    assert not list((tmp_path / "out").rglob("*.partial"))
    for pattern in ("*.csv", "feedback/*.html", "report.html"):
        assert contents(tmp_path / "out", pattern) == contents(out, pattern)


WORK = "import time\nstart = time.process_time()\nwhile time.process_time() - start < {}: pass"
"""Code that takes so many seconds of processor time."""


def test_the_number_of_jobs_and_the_load_change_no_byte_of_the_results(tmp_path):
    """Cells that compute for most of their time, one that takes too long, one that waits, and plots."""
    slow = {k: f"{WORK.format(0.6)}\n{line}" for k, line in right("slow").items() if k < 3}
    notebooks = {
        "slow": handed_in("slow", right("slow") | slow),
        "slower": handed_in("slower", right("slower") | {1: f"{right('slower')[1]}\n{WORK.format(60)}"}),
        "waiting": handed_in("waiting", right("waiting"), first="import time\ntime.sleep(2)"),
        "plots": handed_in("plots", right("plots"), last="for k in range(999): display('x' * 5000)"),
        "mistaken": handed_in("mistaken", mistaken("mistaken")),
    }
    for student, notebook in notebooks.items():
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / f"{SHEET}.ipynb").write_bytes(as_bytes(notebook))
    written = {}
    for jobs, load in ((1, 0), (12, 2)):
        others = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(load)]
        try:
            out = tmp_path / f"out{jobs}"
            assert grade(tmp_path / "in", out, "--jobs", jobs, "--limit", "cell_seconds=1") == 0
        finally:
            for process in others:
                process.kill()
                process.wait()
        files = [*out.glob("*.csv"), *out.glob("*.html"), *out.glob("feedback/*")]
        written[jobs] = {path.relative_to(out): path.read_bytes() for path in files}
    assert b"Traceback" not in written[1][Path("feedback/slower.html")]  # it would show where the cell was by chance
    assert written[1] == written[12]
    points = {row["student"]: row["points"] for row in rows(tmp_path / "out12" / "grades.csv")}
    assert points.pop("mistaken") != "28"
    assert {*points.values()} == {"28"}


# --- what a run does, with a grader that is none ---


class Told:
    """Stands in for the grader: everybody has 2 points of 3, and it remembers whom it was asked about."""

    asked: ClassVar = []
    broken: ClassVar = set()

    def __init__(self, sheet, limits, is_safe, judge):
        self.is_safe = is_safe

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def grade(self, student, content, seed_id):
        self.asked.append(student)
        if student in self.broken:
            raise RuntimeError("the machine gave up")
        one = ProblemResult("03.1", "Screw axes", 2.0, 3.0, "partly", "x\n  2 of 3 points.", "<p>2</p>")
        return Result(student, SHEET, 2.0, 3.0, "graded", "", [one], is_safe=self.is_safe)


@pytest.fixture(scope="module")
def judge():
    """The processes that write pages, for all runs with the grader that is none."""
    with command.start_judge(command.read_released_sheet(Path(SOLUTION))) as started:
        yield started


@pytest.fixture
def asked(judge, monkeypatch):
    """Whom the grader was asked about since the last look."""
    monkeypatch.setattr(command, "Grader", Told)
    monkeypatch.setattr(command, "start_judge", lambda *_, **__: nullcontext(judge))
    monkeypatch.setattr(Told, "broken", set())

    def look():
        students = sorted(Told.asked)
        Told.asked.clear()
        return students

    look()
    return look


@pytest.fixture
def folder(tmp_path):
    for student in ("ada", "bob", "cyn"):
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / f"{SHEET}.ipynb").write_bytes(as_bytes(handed_in(student)))
    return tmp_path / "in"


def test_what_changed_or_cannot_be_read_is_graded_again_and_nothing_else(folder, tmp_path, asked, monkeypatch):
    out = tmp_path / "out"
    assert grade(folder, out) == 0
    assert asked() == ["ada", "bob", "cyn"]
    (folder / "bob" / f"{SHEET}.ipynb").write_bytes(as_bytes(handed_in("bob", first="1")))
    assert grade(folder, out) == 0
    assert asked() == ["bob"]
    (out / "results" / "ada.json").write_text('{"version": 0}')
    (out / "results" / "bob.json").write_bytes(b"\xff")
    incomplete = json.loads((out / "results" / "cyn.json").read_text())
    del incomplete["result"]["problems"][0]["number"]
    (out / "results" / "cyn.json").write_text(json.dumps(incomplete))
    assert grade(folder, out) == 0
    assert asked() == ["ada", "bob", "cyn"]  # what cannot be read is made anew
    assert grade(folder, out, "--unsafe-no-sandbox") == 0  # another way to run is another result
    assert asked() == ["ada", "bob", "cyn"]
    monkeypatch.setattr("misstep.grading.fingerprint.code_digest", lambda *_: "a problem was changed")
    assert grade(folder, out, "--unsafe-no-sandbox") == 0
    assert asked() == ["ada", "bob", "cyn"]


def test_only_and_regrade(folder, tmp_path, asked, capsys):
    out = tmp_path / "out"
    assert grade(folder, out, "--only", "ADA") == 0
    assert asked() == ["ada"]
    assert [row["student"] for row in rows(out / "grades.csv")] == ["ada"]
    assert grade(folder, out) == 0
    assert asked() == ["bob", "cyn"]
    assert grade(folder, out, "--regrade", "--only", "bob", "cyn") == 0
    assert asked() == ["bob", "cyn"]
    assert len(rows(out / "grades.csv")) == 3
    assert grade(folder, out, "--only", "zoe") == 2
    assert "There is no submission of zoe" in capsys.readouterr().err


def test_a_submission_on_which_the_machine_gives_up_is_said_and_tried_again(folder, tmp_path, asked, capsys):
    Told.broken.add("bob")
    assert grade(folder, tmp_path / "out") == 1
    said = capsys.readouterr()
    assert "Not graded: bob: RuntimeError('the machine gave up')" in said.err
    assert "2 of 3 submissions" in said.out
    Told.broken.clear()
    asked()
    assert grade(folder, tmp_path / "out") == 0
    assert asked() == ["bob"]


def test_a_submission_that_reached_a_limit_is_graded_again_alone_before_it_is_stored(
    folder, tmp_path, asked, monkeypatch, capsys
):
    stored = []
    graded = Told.grade

    def grade_limited(self, student, content, seed_id):
        first = student not in self.asked
        limits = ["a limit"] if first or student == "cyn" else []
        return replace(graded(self, student, content, seed_id), limits=limits)

    def save(self, result, fingerprint):
        stored.append((result.student, result.limits))
        keep(self, result, fingerprint)

    keep = ResultStore.save
    monkeypatch.setattr(Told, "grade", grade_limited)
    monkeypatch.setattr(ResultStore, "save", save)
    assert grade(folder, tmp_path / "out", "--jobs", 3) == 0
    assert sorted(asked()) == ["ada", "ada", "bob", "bob", "cyn", "cyn"]
    assert sorted(stored) == [("ada", []), ("bob", []), ("cyn", ["a limit"])]
    told = capsys.readouterr().out
    assert "cyn reached a limit, also when graded alone: a limit." in told
    assert "Limits: cell_seconds 10, " in told


def test_two_runs_do_not_write_into_one_folder_and_two_sheets_neither(folder, tmp_path, asked, capsys):
    out = tmp_path / "out"
    with open_results(out, SHEET):
        assert grade(folder, out) == 2
    assert "Another run writes" in capsys.readouterr().err
    other = str(submissions.released("05_dh_standard"))
    assert main(["grade", other, str(folder), "--out", str(out)]) == 2
    assert f"has the results of sheet {SHEET}" in capsys.readouterr().err


@pytest.mark.usefixtures("asked")
def test_what_cannot_be_is_told_in_a_sentence(folder, tmp_path, capsys):
    lecture = str(submissions.ROOT / "notebooks" / "03_poe_space.ipynb")
    for sheet, options, message in [
        (SOLUTION, ["--jobs", "0"], "--jobs must be at least 1"),
        (SOLUTION, ["--roster", "nowhere.csv"], "nowhere.csv cannot be read"),
        (lecture, [], "is it the notebook of a sheet"),
        ("nowhere.ipynb", [], "SHEET must be the notebook of a sheet; nowhere.ipynb cannot be read: No such file"),
        (SOLUTION, ["--limit", "cell=3"], "--limit takes NAME=NUMBER, with one of the names cell_seconds,"),
        (SOLUTION, ["--limit", "threads=0"], "The limit threads must be a positive number; got 0"),
    ]:
        assert main(["grade", sheet, str(folder), "--out", str(tmp_path / "out"), *options]) == 2
        assert message in capsys.readouterr().err
    (tmp_path / "out").mkdir(exist_ok=True)
    head, late = "student,problem,points,comment\n", "student,problem,points,comment,days late\n"
    for text, message in [
        ("student,problem,points\n", "must have the columns student, problem, points, comment; comment is missing"),
        (f"{head}ada,03.1,two,\n", "points must be a number, 0 or more; got 'two' for ada 03.1"),
        (f"{head}ada,03.1,-1,\n", "got '-1' for ada 03.1"),
        (f"{head}ada,03.7,1,\n", "sheet 03_poe_space has no problem '03.7'; it has 03.1"),
        (f"{head}ada,03.1,9,\n", "ada 03.1 can have at most 3 points; got 9"),
        (f"{late}ada,,,,2\n", "ada has days late, and there is no rule for them"),
        (f"{late}ada,,,,x\n", "days late must be a number, 0 or more; got 'x'"),
        (f"{late}ada,03.1,,,1\n", "leave the problem 03.1 empty for ada"),
    ]:
        (tmp_path / "out" / "overrides.csv").write_text(text)
        assert grade(folder, tmp_path / "out") == 2
        assert message in capsys.readouterr().err


def test_from_a_download_of_canvas_to_the_files_that_canvas_takes(tmp_path, asked, capsys):
    with zipfile.ZipFile(tmp_path / "submissions.zip", "w") as archive:
        for number, student in ((1, "ada"), (2, "bob")):
            archive.writestr(f"x{student}_{number}_9{number}_{SHEET}.ipynb", as_bytes(handed_in(student)))
    roster = "Student,ID,SIS User ID,SIS Login ID,Section\nA,1,,ada,S\nB,2,,bob,S\nC,3,,cyn,S\n"
    (tmp_path / "roster.csv").write_text(roster)
    zipped, out = tmp_path / "submissions.zip", tmp_path / "out"
    assert grade(zipped, out, "--roster", tmp_path / "roster.csv", "--column", "Sheet 3 (7)") == 0
    assert asked() == ["ada", "bob", "cyn"]
    assert (out / "canvas.csv").read_text().splitlines()[2:] == ["A,1,,ada,S,2", "B,2,,bob,S,2", "C,3,,cyn,S,"]
    with zipfile.ZipFile(out / "feedback.zip") as archive:  # without a page of cyn
        pages = {name: archive.read(name) for name in archive.namelist()}
    assert pages == {
        f"x{name}_{number}_9{number}_feedback.html": (out / "feedback" / f"{name}.html").read_bytes()
        for number, name in ((1, "ada"), (2, "bob"))
    }
    assert capsys.readouterr().out.startswith("3 of 3 submissions: 1 absent, 2 graded. ")
    assert grade(zipped, tmp_path / "other") == 0
    assert asked() == ["xada_1", "xbob_2"]
    assert "no --roster" in capsys.readouterr().out
    assert [row["student"] for row in rows(tmp_path / "other" / "grades.csv")] == ["xada_1", "xbob_2"]


def test_what_is_decided_by_hand_reaches_tables_pages_and_platforms_and_stays(folder, tmp_path, asked, capsys):
    out = tmp_path / "out"
    shutil.rmtree(folder / "cyn")
    (tmp_path / "roster.csv").write_text("Student,ID,SIS User ID,SIS Login ID,Section\nA,1,,ada,S\nB,2,,bob,S\n")
    roster = ("--roster", tmp_path / "roster.csv")
    assert grade(folder, out, *roster) == 0
    assert (out / "overrides.csv").read_text() == "student,problem,points,comment,days late\n"
    (out / "formgrader.csv").write_text(
        "student,problem,points,comment\nada,03.1,1,Seen in formgrader.\nbob,03.1,1.5,So.\n"
    )
    (out / "overrides.csv").write_text(
        "student;problem;points;comment\nada;03.1;2,5;The <sketch> is right.\nbob;;0;Two days late.\n"
    )
    assert grade(folder, out, *roster) == 0
    assert asked() == ["ada", "bob"]  # the first time
    for options in ((), ("--regrade",)):
        assert grade(folder, out, *roster, *options) == 0
        assert {row["student"]: (row["points"], row["03.1"]) for row in rows(out / "grades.csv")} == {
            "ada": ("2.5", "2.5"),
            "bob": ("0", "1.5"),
        }
        assert [line[-3:] for line in (out / "canvas.csv").read_text().splitlines()[2:]] == ["2.5", "S,0"]
        pages = {name: (out / "feedback" / f"{name}.html").read_text() for name in ("ada", "bob")}
        assert "from 2 to 2 1/2 points. The &lt;sketch&gt; is right." in pages["ada"]
        assert "formgrader" not in pages["ada"]
        assert "Changed by your instructor from 1 1/2 to 0 points. Two days late." in pages["bob"]
        assert "By hand (overrides.csv, formgrader): ada, bob." in capsys.readouterr().out
    assert "2 with points or comments by hand" in (out / "report.html").read_text()


def test_late_days_cost_what_the_rule_says_and_each_change_is_recorded(folder, tmp_path, asked, monkeypatch, capsys):
    out = tmp_path / "out"
    assert grade(folder, out) == 0
    (out / "overrides.csv").write_text(
        "student,problem,points,comment,days late\nada,,,,2.5\nbob,,,A doctor's note.,1\ncyn,,0.5,,9\n"
    )
    rule = ("--late", "percent=20,free=1,lowest=10")
    assert grade(folder, out, *rule) == 0
    points = {row["student"]: float(row["points"]) for row in rows(out / "grades.csv")}
    assert points == {"ada": pytest.approx(2 - 0.2 * 2 * 3), "bob": 2, "cyn": 0.5}
    assert "2.5 days late, 1 of them free: 1.2 of 2 points are taken" in (out / "feedback" / "ada.html").read_text()
    assert [row["student"] for row in rows(out / "changes.csv")] == ["ada", "cyn"]
    assert asked() == ["ada", "bob", "cyn"]  # and nobody a second time
    graded = Told.grade
    monkeypatch.setattr(Told, "grade", lambda *arguments: with_points(graded(*arguments), 3.0))
    assert grade(folder, out, *rule, "--regrade", "03.9") == 2  # there is no such problem, and nothing is stored
    assert "Sheet 03_poe_space has the problems 03.1; got 03.9" in capsys.readouterr().err
    assert grade(folder, out, *rule, "--regrade", "03.1", "--only", "bob") == 0
    assert [(row["student"], row["problem"], row["before"], row["after"]) for row in rows(out / "changes.csv")][
        -2:
    ] == [
        ("bob", "", "2", "3"),
        ("bob", "03.1", "2", "3"),
    ]
    for wrong in ("10", "percent=x", "percent=10,days=2", "percent=-1", "free=2"):
        assert grade(folder, out, "--late", wrong) == 2


def with_points(result, points):
    return replace(result, points=points, problems=[replace(one, points=points) for one in result.problems])


def test_only_a_change_in_what_a_sheet_imports_grades_again(tmp_path, monkeypatch):
    from misstep.catalog import Course
    from misstep.grading import code_digest

    course = tmp_path / "circuits"
    text = {
        "__init__": "",
        "laws": "",
        "imported_by_none": "",
        "lecture_01_ohm": "",
        "lecture_02_loops": "from circuits import laws\n",
        "lecture_03_power": "from circuits.lecture_01_ohm import problems\n",
    }

    def digests():
        for name, source in text.items():
            path = course / name / "problems.py" if name.startswith("lecture") else course / f"{name}.py"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(source)
        code_digest.code_digest.cache_clear()
        return [code_digest.code_digest("circuits", sheet) for sheet in ("01_ohm", "02_loops", "03_power")]

    monkeypatch.setattr(Course, "folder", course)
    monkeypatch.setattr(code_digest, "find_course", lambda _: Course("circuits"))
    before = digests()
    for changed, again in {
        "lecture_01_ohm": [True, False, True],
        "lecture_02_loops": [False, True, False],
        "laws": [False, True, False],
        "imported_by_none": [False, False, False],
    }.items():
        text[changed] += "# mended\n"
        after = digests()
        assert [a != b for a, b in zip(before, after, strict=True)] == again
        before = after
    code_digest.code_digest.cache_clear()


@pytest.mark.usefixtures("asked")
def test_a_disk_that_takes_no_more_is_told_in_a_sentence(folder, tmp_path, monkeypatch, capsys):
    full = r"the disk is full at /out/x\. All results so far are stored\. Free some space; the same command"
    for number, message in {
        errno.ENOSPC: full,
        errno.EROFS: r"/out/x cannot be written, because its disk is read-only\. Choose another folder with --out\.",
        errno.EACCES: r"/out/x: Permission denied\.",
    }.items():

        def refuse(*_, number=number):
            raise OSError(number, os.strerror(number), "/out/x")

        monkeypatch.setattr(ResultStore, "save", refuse)
        assert grade(folder, tmp_path / "out") == 2
        assert re.search(message, capsys.readouterr().err)
