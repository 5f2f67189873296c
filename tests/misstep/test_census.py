"""The census of a course that has no answers by hand: it is saved as the site reads it."""

import json

from circuits_course import write_course

from misstep.cli import main


def test_the_counts_are_saved_with_the_students_and_without_examples(tmp_path):
    saved = tmp_path / "census.json"
    code = main(["census", "--course", str(write_course(tmp_path)), "--students", "2", "--save", str(saved)])
    census = json.loads(saved.read_text("utf-8"))
    assert census["students"] == 2
    assert [row["number"] for row in census["problems"]][:2] == ["01.1", "01.2"]
    assert all(row["wrong"] > 0 and row["examples"] == {} for row in census["problems"])
    assert {what for row in census["problems"] for what in row["counts"]} <= {"unnamed"}
    assert "01_ohm" in census["inseparable"]
    assert code == 0
