"""The census of a course: it is saved as the site reads it, beside what else the file has."""

import json

from misstep.cli import main
from misstep.new_course import write_course


def test_the_counts_are_saved_beside_those_of_others_and_without_answers(tmp_path, capsys):
    saved = tmp_path / "c.json"
    saved.write_text('{"outside": 1}', "utf-8")
    write_course(tmp_path / "dice", "probability")
    course = str(tmp_path / "dice" / "dice")
    assert main(["census", "--course", course, "--students", "2", "--save", str(saved)]) == 0
    census = json.loads(saved.read_text("utf-8"))
    assert (census["students"], census["outside"]) == (2, 1)
    assert [row["number"] for row in census["problems"]][:2] == ["01.1", "01.2"]
    assert all(row["wrong"] > 0 and row["examples"] == {} for row in census["problems"])
    assert {what for row in census["problems"] for what in row["counts"]} <= {"unnamed"}
    assert "01_dice" in census["inseparable"]
    assert "| 01.2 |" in capsys.readouterr().out
