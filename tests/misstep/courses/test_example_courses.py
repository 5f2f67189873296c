"""The example courses, from the wheel of the engine alone: written, extended, checked, released, handed in, graded and marked."""

import csv
import json
import os
import re
import subprocess
import sys
import zipfile

import pytest
import submissions

from misstep.catalog import forget_package
from misstep.cli import main

SUBJECTS = {
    "alternating-current": ("01_ohm", {"voltage_2": "given.peak * np.sin(given.degrees)"}, "degrees"),
    "probability": ("01_dice", {"interval_3": "f'({given.face}, {given.face + 1}]'"}, "ends of an interval"),
    "linear-algebra": ("01_eigenvalues", {"eigenvalues_3": "np.diag(given.A)"}, "diagonal"),
}
"""For each subject its sheet, a wrong answer of a student, and the mistake that feedback names."""
STUDENTS = [f"student {k}" for k in range(20)]


@pytest.fixture(scope="module")
def engine(wheel, tmp_path_factory):
    """The folder with what the wheel of the engine has in it."""
    folder = tmp_path_factory.mktemp("engine")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    return folder


@pytest.mark.skipif(bool(submissions.sandbox_lacks()), reason=f"this machine lacks {submissions.sandbox_lacks()}")
@pytest.mark.parametrize("subject", SUBJECTS)
def test_an_example_course_from_the_wheel_to_the_platform(tmp_path, engine, hand_in, subject):
    sheet, slip, mistake = SUBJECTS[subject]
    course = tmp_path / "mine"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(engine), str(course)])}

    def misstep(*arguments, code=0, folder=course):
        command = [sys.executable, "-m", "misstep", *map(str, arguments)]
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == code, done.stdout + done.stderr
        return done.stdout

    misstep("new-course", "mine", "--subject", subject, folder=tmp_path)
    misstep("new-problem", sheet, "A product")
    problems = course / "mine" / f"lecture_{sheet}" / "problems.py"
    assert "statement of a new problem" in misstep("check", code=1)
    problems.write_text(problems.read_text("utf-8").replace("Replace this statement. ", ""), "utf-8")
    assert "solution of a new problem" in misstep("check", code=1)
    solution = course / "solutions" / sheet / f"{sheet}.ipynb"
    solution.write_text(solution.read_text("utf-8").replace("  # replace this solution", ""), "utf-8")
    misstep("check")
    assert mistake in misstep("preview", "01.2") + misstep("preview", "01.3") or mistake == "ends of an interval"
    misstep("release")
    source = json.loads((course / "solutions" / sheet / f"{sheet}.ipynb").read_text("utf-8"))
    solutions = {}
    for cell in source["cells"]:
        if found := re.search(
            r"^(\w+_\d+) = \.\.\.\n### BEGIN SOLUTION\n(.*)\n### END", "".join(cell["source"]), re.DOTALL | re.MULTILINE
        ):
            solutions[found[1]] = found[2]
    for student in STUDENTS:
        wrong = {name: f"{name} = {answer}" for name, answer in slip.items()} if student == STUDENTS[3] else {}
        hand_in(course, sheet, student, {**solutions, **wrong})
    roster = "Student,ID,SIS User ID,SIS Login ID,Section,Sheet (1)\n    Points Possible,,,,,10\n"
    (course / "roster.csv").write_text(
        roster + "".join(f'"{one}",{k},{one},{one},A,\n' for k, one in enumerate(STUDENTS)), "utf-8"
    )
    results = course / "results"
    grade = [
        "grade",
        course / "solutions" / sheet / f"{sheet}.ipynb",
        "submissions",
        "--out",
        results,
    ]
    grade += ["--roster", "roster.csv", "--column", "Sheet (1)"]
    misstep(*grade)
    first = grades(results)
    assert mistake in first[STUDENTS[3]]["mistakes"]
    assert float(first[STUDENTS[3]]["points"]) < float(first[STUDENTS[0]]["points"])

    with (results / "overrides.csv").open("a", encoding="utf-8") as stream:
        stream.write(f"{STUDENTS[3]},01.1,0.5,Talked about it.,\n")
    is_marked = subject == "alternating-current"
    assert (results / "marking.html").exists() == is_marked
    if is_marked:
        rows = "".join(f'"{student}","01.4","2.5","Clear."\r\n' for student in STUDENTS)
        (results / "marks.csv").write_text('"student","problem","points","comment"\r\n' + rows, "utf-8")
    misstep(*grade)
    second = grades(results)
    assert second[STUDENTS[3]]["01.1"] == "0.5"
    assert "Talked about it." in second[STUDENTS[3]]["by hand"]
    assert float(second[STUDENTS[0]]["points"]) == float(first[STUDENTS[0]]["points"]) + 2.5 * is_marked
    assert second[STUDENTS[0]]["points"] in (results / "canvas.csv").read_text("utf-8")
    page = next((results / "feedback").glob("*student*0*.html")).read_text("utf-8")
    assert ("Marked by your instructor: 2 1/2 points. Clear." in page) == is_marked


def grades(results):
    with (results / "grades.csv").open(newline="", encoding="utf-8") as stream:
        return {row["student"]: row for row in csv.DictReader(stream)}


def test_check_names_the_problem_the_line_and_what_collides(tmp_path, monkeypatch, capsys):
    main(["new-course", str(tmp_path / "mine"), "--subject", "probability"])
    monkeypatch.chdir(tmp_path / "mine")
    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # two changes within a second look the same to it
    problems = tmp_path / "mine" / "mine" / "lecture_01_dice" / "problems.py"
    text = problems.read_text("utf-8")
    line = 1 + text.splitlines().index(
        '@problem("01.1", "At least one six", points=2, lecture="01_dice#Independent events")'
    )
    notebook = tmp_path / "mine" / "solutions" / "01_dice" / "01_dice.ipynb"
    for old, new, said in [
        ("Fraction(rolls, 6), ", "1 - Fraction(5, 6) ** rolls, ", "the mistake 'added' gave the same answer as the right answer"),
        ("Fraction(rolls, 6), ", "Fraction(1, 6) ** rolls, ", "the mistake 'added' gave the same answer as the mistake 'all'"),
        ("#Independent events", "#Independent", "names the section 'Independent', which is no heading of"),
        ("points=2, lecture=\"01_dice#Ind", "points=3, lecture=\"01_dice#Ind", "has 3 points, and its check cell 2"),
        ("sampler.integer(2, 4)", "sampler.integers(2, 4)", "AttributeError"),
        ('Problem, Sampler', 'Problems, Sampler', "cannot be imported: ImportError"),
        ("points=2, lecture=\"01_dice#Ind", "points=2 lecture=\"01_dice#Ind", "cannot be imported: SyntaxError"),
        ('"rolls": rolls}', '"rolls": rolls}, figure=lambda: 1 / 0', "the figure of problem 01.1: ZeroDivisionError"),
        ("[at_least_one, positive_test, step]", "[at_least_one, positive_test]", "cells of a problem 3, and the sheet has 2"),
    ]:  # fmt: skip
        assert old in text
        problems.write_text(text.replace(old, new), "utf-8")
        capsys.readouterr()
        forget_package("mine")
        assert main(["check", "--students", "3"]) == 1, said
        found = capsys.readouterr().out
        assert said in found
        assert ("01.1" in found and f"{line}:" in found) or "points" in said or "Error" in said or "cells" in said, (
            found
        )
        if "cannot be imported" in said:
            assert main(["preview", "01.1"]) == main(["new-problem", "01_dice", "One more"]) == 2
            assert capsys.readouterr().err.count(said) == 2
        if "points" in said:
            assert main(["check", "--students", "3", "--repair"]) == 0
            assert '"points": 3' in notebook.read_text("utf-8")
        problems.write_text(text, "utf-8")
        forget_package("mine")
        main(["check", "--repair", "--students", "1"])
