"""Points that count: with the instructor's key, typed answers earn nothing, and computed ones keep their points."""

import csv

import pytest
import submissions
from habits import solution, solved
from submissions import as_bytes, handed_in, right

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO KEY IS TRIED: this machine lacks {lacking}", allow_module_level=True)

from kincourse import find_sheet
from misstep.__main__ import main
from misstep.grading.collect.run_plan import read_released_sheet
from misstep.grading.judging.grader import Grader
from misstep.grading.judging.redraw import Draw, redraw
from misstep.sheet import SAMPLE_ID

KEY = "correct horse"

SHEET = "10_one_robot_four_ways"


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """The folder of results of a small class, graded with a key."""
    root = tmp_path_factory.mktemp("class")
    typed = right("ada", SHEET)
    for student, notebook in {SAMPLE_ID: solved(SHEET), "ada": handed_in("ada", typed, name=SHEET)}.items():
        (root / "in" / student).mkdir(parents=True)
        (root / "in" / student / f"{SHEET}.ipynb").write_bytes(as_bytes(notebook))
    (root / "key.txt").write_text(f"{KEY}\n")
    arguments = ["grade", str(solution(SHEET)), str(root / "in"), "--out", str(root / "out")]
    assert main([*arguments, "--key-file", str(root / "key.txt")]) == 0
    return root / "out"


def test_typed_answers_earn_nothing_and_computed_ones_keep_their_points(results):
    with (results / "grades.csv").open(newline="") as stream:
        rows = {row["student"]: row for row in csv.DictReader(stream)}
    honest, typed = rows[SAMPLE_ID], rows["ada"]
    assert (honest["points"], honest["points without the key"]) == ("36", "36")
    assert honest["right only for the own numbers"] == honest["reason"] == ""
    assert (typed["points"], float(typed["points without the key"])) == ("15", 33)  # some are read from drawings
    assert typed["right only for the own numbers"].startswith("10.1; 10.2; 10.3; 10.4")
    assert "was not computed from sheet.given(1)" in typed["reason"]


def test_the_report_and_the_page_say_what_the_key_did(results):
    report = (results / "report.html").read_text("utf-8")
    assert "Graded with a key" in report
    assert "1 student has answers" in report
    assert KEY not in report
    page = (results / "feedback" / "ada.html").read_text("utf-8")
    assert "With your own numbers this answer has" in page
    assert not [path for path in results.rglob("*") if path.is_file() and KEY.encode() in path.read_bytes()]


def test_a_key_that_can_be_guessed_or_is_a_file_is_refused(tmp_path, capsys):
    (file := tmp_path / "key.txt").write_text("correct horse")
    for options, message in [
        (["--key", "short"], "must have at least 8 characters; it has 5"),
        (["--key", ""], "must have at least 8 characters; it has 0"),
        (["--key", f"{file}"], f"--key takes the key itself; {file} is a file. Pass it with --key-file"),
        (["--key-file", f"{file}s"], f"The key cannot be read from {file}s: No such file"),
        (["--key", "a long key", "--key-file", f"{file}"], "not with both"),
    ]:
        assert main(["grade", str(solution(SHEET)), str(tmp_path), "--out", str(tmp_path / "out"), *options]) == 2
        assert message in capsys.readouterr().err
    with pytest.raises(ValueError, match="SHEET must be the notebook with the solution"):
        Grader(read_released_sheet(submissions.released(SHEET), key=KEY))


def test_other_numbers_have_another_answer_and_the_same_form():
    for template in (
        t for name in ("03_poe_space", "07_frame_assignment", "09_urdf") for t in find_sheet(name).problems[:3]
    ):
        own = template.variant("ada")
        first, second, again = (redraw(template, own, "ada", Draw(key, 0)) for key in (KEY, "another key", KEY))
        assert first
        assert second
        assert set(first.given) == set(own.given)
        assert first.statement == again.statement
        assert first.statement != own.statement or str(first.given) != str(own.given)
        if not callable(own.answer.value):
            assert not all(own.answer.agrees(own.answer.value, first.answer.value))


def test_other_numbers_are_drawn_until_they_can_be_used():
    """Of this problem, none of the first variants for this student shows all mistakes."""
    template = find_sheet("09_urdf").problems[3]
    assert redraw(template, template.variant("probe 2"), "probe 2", Draw(KEY, 0))


def test_what_is_read_from_a_drawing_keeps_its_numbers():
    template = find_sheet("03_poe_space").problems[4]
    assert redraw(template, template.variant("ada"), "ada", Draw(KEY, 0)) is None
