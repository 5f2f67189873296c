"""`misstep grade`: points are those of the stored answers, what needs eyes is named, and no file decides about another one."""

import csv
import json
import multiprocessing
import os
import subprocess
import sys
import time
from unittest.mock import Mock

import pytest
from submissions import NAME, SHEET, answered, as_bytes, emissions, released, write, zipped

from kincourse import COURSE
from misstep.cli import main
from misstep.grading import workers
from misstep.grading.collect.submissions import gather
from misstep.grading.command import sheet_name
from misstep.grading.judging import Request
from misstep.grading.workers import grade_within, open_executor

workers.CONTEXT.set_forkserver_preload(["kincourse.lecture_01_frames.problems", "misstep.grading.judging"])
FULL, TOTAL = 22, 25
"""The points that a check gives, and those with the text that an instructor marks."""
ESCAPE = "\x1b[5m\u202e=<script>"


def grade(folder, capsys, *options):
    """The exit code, what was printed, and the rows of grades.csv by student."""
    out = folder.parent / "out"
    code = main(["grade", str(folder), "--sheet", "01", "--out", str(out), *options])
    printed = capsys.readouterr()
    path = out / "grades.csv"
    rows = list(csv.DictReader(path.read_text("utf-8").splitlines())) if path.exists() else []
    return code, printed.out + printed.err, {row["student"]: row for row in rows}


def changed(student, change, **how):
    """A sheet whose stored answers are changed one by one."""
    notebook = answered(student, **how)
    for emission in emissions(notebook):
        change(emission)
    return notebook


def points(rows):
    return {student: float(row["points"]) for student, row in rows.items()}


def test_a_class_where_all_is_well(tmp_path, capsys):
    people = {f"s{k}": answered(f"s{k}", wrong=[k] if k else []) for k in (0, 1, 9)}
    code, printed, rows = grade(write(tmp_path / "in", **{f"{s}/{NAME}": one for s, one in people.items()}), capsys)
    assert (code, rows["s0"]["reason"]) == (0, "")
    assert points(rows) == {"s0": FULL, "s1": pytest.approx(FULL - 2, abs=2), "s9": FULL - 3}
    assert "3 students: 3 graded." in printed
    assert rows["s9"]["mistakes"].startswith("01.9 ")
    page = (tmp_path / "out" / "feedback" / "s9.html").read_text("utf-8")
    assert "not yet right" in page
    assert "<script" not in page
    report = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert rows["s9"]["mistakes"].removeprefix("01.9 ") in report
    assert "Needs your eyes" not in report


def test_what_an_instructor_must_know_is_said_with_names(tmp_path, capsys):
    late = answered("late")
    next(cell for cell in late["cells"] if cell["id"] == "answer-3")["execution_count"] = 99
    copied = changed("ada", lambda one: one.update(student="eve"))
    people = {
        **{name: answered(name) for name in ("ada", "bob")},
        "some": answered("some", skip=[4, 7]),
        "none": released(),
        "late": late,
        "eve": copied,
        "other": answered("bob"),
        "sample": answered("your id"),
        "pdf": b"%PDF-1.4",
        "away": answered("away"),
    }
    folder = write(tmp_path / "in", **{f"{s}/{NAME}": one for s, one in people.items()})
    for k in range(3):
        write(folder, **{f"group/{k}.ipynb": answered(("ada", "bob", "some")[k])})
    (folder / "away" / NAME).unlink()
    (tmp_path / "roster.csv").write_text("\n".join(["id", *people, "group", "gone"]), "utf-8")
    code, printed, rows = grade(folder, capsys, "--roster", str(tmp_path / "roster.csv"))
    said = {line.partition(":")[0]: line.partition(":")[2] for line in printed.splitlines()}
    named = {
        "No answer is stored. The student must open the notebook, run all cells, save, and hand it in again": "none",
        "Some check cells were not run or ended with an error, so these problems have no stored answer": "some (01.4, 01.7)",
        "An answer cell was run after its check, so another answer may be stored than the one in the cell": "late (01.3)",
        "Could not be read": "pdf (The file is a PDF",
        "The id that was typed is not the student's (--roster gives them, --typed-ids takes those that were typed)": "other (typed 'bob'",
        "One id was typed in the notebooks of several students": "bob (also other)",
        "Several answers are the same as those of another student, although their numbers differ": "ada (eve",
        "The notebooks under this name are of several ids, and one counts. Grade a section, or a class in a zip file, by itself": "group",
        "Nothing was handed in": "gone",
    }
    assert code == 1
    for text, name in named.items():
        assert name in said[text], text
    report = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert all(text.replace("'", "&#39;") in report for text in [*named, "3 of them with 0 points"])
    assert points(rows)["late"] == points(rows)["ada"] == FULL
    assert points(rows)["eve"] < FULL / 2
    assert rows["gone"]["status"] == "absent"


def test_without_a_roster_the_ids_in_the_sheets_may_count(tmp_path, capsys):
    folder = write(tmp_path / "in", **{f"Lovelace/{NAME}": answered("ada"), f"Boole/{NAME}": answered("bob")})
    _, _, rows = grade(folder, capsys, "--typed-ids")
    assert points(rows) == {"Boole": FULL, "Lovelace": FULL}


def test_an_answer_that_was_checked_for_another_id_is_explained_by_no_mistake(tmp_path, capsys):
    _, printed, rows = grade(write(tmp_path / "in", **{f"ada/{NAME}": answered("bob")}), capsys)
    assert f"ada (typed 'bob'; with the numbers of 'bob', {FULL} points)" in printed
    assert (rows["ada"]["mistakes"], points(rows)["ada"] < FULL / 2) == ("", True)
    page = (tmp_path / "out" / "feedback" / "ada.html").read_text("utf-8")
    assert "This answer was checked for &#39;bob&#39;, and so with other numbers than those of &#39;ada&#39;." in page
    assert not [text for text in ("what you get if you", "do not recognise", "entries are right") if text in page]
    assert len((tmp_path / "out" / "unnamed.csv").read_text("utf-8").splitlines()) == 1


def test_a_notebook_that_is_named_after_nobody_is_judged_with_the_typed_id(tmp_path, capsys):
    folder = write(tmp_path / "in", **{NAME: answered("ada")})
    for source in (folder, folder / NAME):
        code, _, rows = grade(source, capsys)
        assert (code, [*points(rows).values()]) == (0, [FULL])


def nested(depth):
    return {"list": [nested(depth - 1)]} if depth else None


HOSTILE = {
    "points": lambda one: one.update({"points": 999, "score": 999, "max": 999}),
    **{f"answer {k}": lambda one, k=k: one.update(answer=k) for k in (7, {"array": [1]}, {"eval": "1"})},
    "too long": lambda one: one.update(answer={"text": "x" * 500_000}),
    "many numbers": lambda one: one.update(answer={"array": [0.5] * 20_000, "shape": [20_000]}),
    "shape": lambda one: one.update(answer={"array": [1.0], "shape": [2**62, 2**62]}),
    "deep": lambda one: one.update(answer=nested(300)),
    "power": lambda one: one.update(answer={"text": "9**9**9**9**9"}),
    "import": lambda one: one.update(answer={"text": "__import__('os').system('touch PWNED')"}),
    "brackets": lambda one: one.update(answer={"text": "(" * 90_000}),
    "object": lambda one: one.update(answer={"object": "Popen", "fields": {"args": "touch PWNED"}}),
    "other sheet": lambda one: one.update(sheet="../../etc"),
    "other problem": lambda one: one.update(problem=10**30),
    "long id": lambda one: one.update(student="x" * 1_000_000),
    "escape": lambda one: one.update(student=ESCAPE),
    "surrogate": lambda one: one.update(student="\ud800\0"),
    "markup": lambda one: one.update(answer={"text": ESCAPE * 20}),
    "not text": lambda one: one.update(student=["ada"]),
}


def test_hostile_notebooks_decide_nothing_and_reach_neither_terminal_nor_table_nor_page(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    people = {f"h{k:02}": as_bytes(changed(f"h{k:02}", change)) for k, change in enumerate(HOSTILE.values())}
    people["bomb"] = b'{"cells":' + b"[" * 500_000 + b"]" * 500_000 + b"}"
    people["quotes"] = b'{"text/plain": [' + b'"\\"' * 20_000
    people["keys"] = b'{"cells": [{' + b'"a": 1, ' * 100_000 + b'"a": 1}]}'
    people["ada"] = answered("ada")
    folder = write(tmp_path / "in", **{f"{s}/{NAME}": one for s, one in people.items()})
    slip = zipped({f"../../{NAME}": answered("slip")})
    write(folder, **{f"x{ESCAPE.replace('/', '')}/{NAME}": b"no", "slip/a.zip": slip})
    code, printed, rows = grade(folder, capsys)
    assert (code, len(rows), points(rows)["ada"]) == (1, len(people) + 2, FULL)
    assert (points(rows)["h00"], rows["slip"]["status"]) == (FULL, "unreadable")
    harmless = ("points", "long id", "escape", "surrogate", "not text")  # the answers are as they were
    assert max(points(rows)[f"h{k:02}"] for k, name in enumerate(HOSTILE) if name not in harmless) < FULL / 2
    written = {path: path.read_text("utf-8") for path in (tmp_path / "out").rglob("*.*")}
    for text in (printed, *written.values()):
        assert not set("\x1b\u202e\0") & set(text)
    assert not [path for path, text in written.items() if path.suffix == ".html" and "<script" in text]
    assert not any(line.startswith(("=", "@")) for line in written[tmp_path / "out" / "grades.csv"].splitlines())
    assert max(map(len, written.values())) < 300_000
    assert not list(tmp_path.rglob("PWNED"))


def test_a_submission_that_takes_too_long_or_ends_its_process_costs_no_other_one_anything(tmp_path):
    folder = write(tmp_path, **{f"{name}/{NAME}": answered(name) for name in ("ada", "bob")})
    endless = tmp_path / "bob" / "stuck.ipynb"
    os.mkfifo(endless)
    ada, bob = gather(folder, SHEET).submissions
    files = [file.__class__(file.name, file.path) for file in bob.files]  # without the fault that was seen
    right, stuck = (Request(sheet_name(COURSE, "01"), one) for one in (ada, bob.__class__("bob", "bob", files)))
    with open_executor(1, None) as executor:
        how = ((right, 600), (stuck, 1), (right, 600))
        first, late, second = (executor.submit(grade_within, *one).result() for one in how)
        future = executor.submit(grade_within, stuck, 600)
        with endless.open("wb"):  # which waits until the process reads
            while not future.done():
                for process in multiprocessing.active_children():
                    process.kill()
            ended = future.result()
        third = executor.submit(grade_within, right, 600).result()
        for process in multiprocessing.active_children():  # the next process is idle
            process.kill()
        last = executor.submit(grade_within, right, 600).result()
    assert [one.points for one in (first, late, second, ended, third, last)] == [FULL, 0, FULL, 0, FULL, FULL]
    assert late.reason.startswith("It took longer than 1 s.")
    assert ended.reason.startswith("It ended the process that reads it.")
    for one in (late, ended):
        assert (one.status, one.flags) == ("unreadable", {"not graded": one.reason})


def test_after_a_kill_the_next_run_writes_the_same_files(tmp_path):
    folder = write(tmp_path / "in", **{f"s{k}/{NAME}": answered(f"s{k}", wrong=[1]) for k in range(4)})

    def files(name):
        return {path.relative_to(tmp_path / name): path.read_bytes() for path in (tmp_path / name).rglob("*.*")}

    def command(name):
        return ["grade", str(folder), "--sheet", "01", "--workers", "1", "--out", str(tmp_path / name)]

    assert main(command("whole")) == 0
    run = subprocess.Popen([sys.executable, "-m", "misstep", *command("killed")], stdout=subprocess.DEVNULL)
    while run.poll() is None and not (tmp_path / "killed" / "feedback").exists():
        time.sleep(0.005)
    run.kill()
    run.wait()
    write(tmp_path, **{"killed/feedback/bob.html": b"of an earlier run with other names"})
    assert main(command("killed")) == 0
    assert {k: v for k, v in files("killed").items() if "partial" not in k.name} == files("whole")


def test_a_run_that_is_stopped_says_so_and_what_to_do(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("misstep.grading.command.as_completed", Mock(side_effect=KeyboardInterrupt))
    code, printed, rows = grade(write(tmp_path / "in", **{f"ada/{NAME}": answered("ada")}), capsys)
    assert (code, rows) == (2, {})
    assert printed.endswith("Stopped, and nothing was written. Run the same command to grade.\n")


def test_overrides_are_checked_before_anything_is_graded_and_all_faults_are_named(tmp_path, capsys):
    folder = write(tmp_path / "in", **{f"{name}/{NAME}": answered(name, wrong=[9]) for name in ("ada", "bob", "cyn")})
    table = tmp_path / "out" / "overrides.csv"
    table.parent.mkdir()
    lines = ["ada,01.9,99,", "ada,01.99,1,", "nobody,01.1,1,", "bob,01.1,much,", "bob,01.2,1,", "bob,01.2,1,"]
    table.write_text("\n".join(["student,problem,points,comment", *lines]), "utf-8")
    code, printed, rows = grade(folder, capsys)
    assert (code, rows) == (2, {})
    for fault in ("2: the points must", "3: there is no problem", "4: there is no student", "5: ", "7: bob"):
        assert f"line {fault}" in printed
    table.write_text(
        "student;problem;points;comment\nADA;01.9;1,5;Nearly.\nbob;01.1;;See page 2.\ncyn;;5;Told me.\n", "utf-8"
    )
    code, _, rows = grade(folder, capsys)
    assert (code, points(rows)) == (0, {"ada": FULL - 1.5, "bob": FULL - 3, "cyn": 5})
    assert rows["ada"]["by hand"] == "01.9: Changed by your instructor from 0 to 1 1/2 points. Nearly."
    assert "From your instructor: See page 2." in (tmp_path / "out" / "feedback" / "bob.html").read_text("utf-8")
    assert "from 19 to 5 points. Told me." in rows["cyn"]["reason"]


def test_a_text_is_never_0_without_a_word_and_the_points_by_hand_count(tmp_path, capsys):
    folder = write(tmp_path / "in", **{f"{name}/{NAME}": answered(name, text=True) for name in ("ada", "bob")})
    out = tmp_path / "out"
    (out).mkdir()
    (out / "overrides.csv").write_text("student,problem,points,comment\nbob,01.11,2,Why three?\n", "utf-8")
    code, printed, rows = grade(folder, capsys)
    assert (code, points(rows)) == (1, {"ada": FULL, "bob": FULL + 2})
    assert "A text waits for your points in overrides.csv: 01.11 of 1 student." in printed
    assert (rows["ada"]["01.11"], rows["bob"]["01.11"]) == ("to be marked", "2")
    assert rows["ada"]["reason"] == "The points of 01.11 are not yet counted: your instructor marks this text."
    assert rows["bob"]["by hand"] == "01.11: Marked by your instructor. Why three?"
    pages = {name: (out / "feedback" / f"{name}.html").read_text("utf-8") for name in ("ada", "bob")}
    assert "to be marked by your instructor,\nup to 3 points" in pages["ada"]
    assert "A rotation about any line" in pages["ada"]  # the text, for the one who marks it
    assert "marked by your instructor,\n2 of 3 points" in pages["bob"]
    report = (out / "report.html").read_text("utf-8")
    assert "1 to be marked by your instructor, 1 marked by your instructor." in report
    assert "3 of the points are for texts that are not all marked" in report


def test_wrong_answers_without_a_name_are_grouped(tmp_path, capsys):
    def odd(one):
        if one["problem"] == 4:
            one["answer"]["array"] = [7.25 * x + 3 for x in one["answer"]["array"]]

    folder = write(tmp_path / "in", **{f"{name}/{NAME}": changed(name, odd) for name in ("ada", "bob")})
    grade(folder, capsys)
    rows = list(csv.reader((tmp_path / "out" / "unnamed.csv").read_text("utf-8").splitlines()))
    assert sum(int(row[1]) for row in rows[1:] if row[0] == "01.4") == 2
    json.loads(rows[1][3])


def test_a_platforms_download_gets_its_file_and_its_zip_of_pages(tmp_path, capsys):
    source = tmp_path / "s.zip"
    source.write_bytes(zipped({"Ada L_1815_assignsubmission_file_/x.ipynb": answered("ada")}))
    roster = tmp_path / "m.csv"
    roster.write_text(
        "Identifier,Full name,ID number,Status,Grade,Maximum grade\nParticipant 1815,Ada L,ada,x,,38\n", "utf-8"
    )
    code, _, rows = grade(source, capsys, "--roster", str(roster))
    assert (code, points(rows)) == (0, {"ada": FULL})
    assert (tmp_path / "out" / "moodle.csv").read_text("utf-8").splitlines()[1].endswith(f",{38 * FULL / TOTAL:g},38")
    assert b"Ada L_1815_assignfeedback_file_01_frames.html" in (tmp_path / "out" / "feedback.zip").read_bytes()


def test_a_column_that_canvas_does_not_have_is_named(tmp_path, capsys):
    source, roster = tmp_path / "s.zip", tmp_path / "c.csv"
    source.write_bytes(zipped({f"lovelaceada_1815_501_{NAME}": answered("ada")}))
    roster.write_text(
        "Student,ID,SIS Login ID,Section,Sheet 1 (7)\n    Points Possible,,,,25\nAda,1815,ada,A,\n", "utf-8"
    )
    for options, is_told in ((), True), (("--column", "Sheet 1 (7)"), False):
        code, printed, _ = grade(source, capsys, "--roster", str(roster), *options)
        assert (code == 1, "Canvas would make a new column '01_frames'" in printed) == (is_told, is_told)


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        (["nowhere", "--sheet", "01"], "must be a folder, a zip file or a notebook"),
        ([".", "--sheet", "01"], "contains no submission"),
        ([".", "--sheet", "99"], "There is no sheet '99'"),
        ([".", "--sheet", "01", "--workers", "0"], "must be positive"),
    ],
)
def test_an_impossible_request_is_refused_with_what_to_do(tmp_path, capsys, monkeypatch, options, reason):
    monkeypatch.chdir(tmp_path)
    assert main(["grade", *options, "--out", "out"]) == 2
    assert reason in capsys.readouterr().err
