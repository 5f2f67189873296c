"""The page on which a person marks answers in prose: 300 students, in a real browser, without a network."""

import csv

from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.publish.marking_page import marking_page
from misstep.grading.publish.overrides import apply_overrides, read_overrides

STUDENTS = [f"student {k:03}" for k in range(300)]
RUBRIC = {"map": [["Reason", {"number": 2.0}], ["Clarity", {"number": 1.0}]]}
HOSTILE = '</script><img src=x onerror="document.title=1">'


def result_of(student):
    text = HOSTILE if student == STUDENTS[1] else f"Because of {student}."
    problem = ProblemResult("01.4", "Why?", 0.0, 3, "unmarked", "", "Say why.", answer={"text": text}, right=RUBRIC)
    return Result(student, "01_ohm", 0.0, 3.0, "graded", "", [problem])


def test_no_page_is_made_where_nothing_is_to_be_marked():
    assert not marking_page([Result("ada", "01_ohm", 0.0, 3.0, "graded", "", [])], {})


def test_marks_of_three_hundred_students_reach_the_grades(chromium, tmp_path):
    results = [result_of(student) for student in STUDENTS]
    (tmp_path / "marking.html").write_text(marking_page(results, {}), "utf-8")
    page = chromium.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto((tmp_path / "marking.html").as_uri())
    for points, clarity, comment in (("2", "1", ""), ("1.5", "0", 'Say "why", too.')):
        page.get_by_label("Reason (0 to 2)").fill(points)
        page.get_by_label("Clarity (0 to 1)").fill(clarity)
        page.get_by_label("Comment for the student").fill(comment)
        page.keyboard.press("Alt+ArrowRight")
    page.get_by_label("Reason (0 to 2)").fill("7")
    assert "from 0 to the most" in page.get_by_role("status").inner_text()
    page.reload()
    assert "2 of 300 answers are marked here" in page.get_by_role("status").inner_text()
    page.get_by_role("button", name="Next", exact=True).click()
    assert page.locator("#text").inner_text() == HOSTILE
    assert page.title() == "Marking"
    with page.expect_download() as download:
        page.get_by_role("button", name="Save marks.csv").click()
    download.value.save_as(tmp_path / "marks.csv")
    page.close()
    assert not errors
    with (tmp_path / "marks.csv").open(newline="", encoding="utf-8") as stream:
        assert len(list(csv.DictReader(stream))) == 2
    marks = read_overrides(tmp_path)
    marked = [apply_overrides(one, marks.get(one.student, ())) for one in results[:3]]
    assert [one.points for one in marked] == [3.0, 1.5, 0.0]
    assert [one.problems[0].state for one in marked] == ["right", "partly", "unmarked"]
    assert marked[1].problems[0].notes == [
        'Marked by your instructor: 1 1/2 points. Reason: 1.5 of 2; Clarity: 0 of 1. Say "why", too.'
    ]
    again = marking_page(results, marks)
    assert '"points": 1.5' in again
