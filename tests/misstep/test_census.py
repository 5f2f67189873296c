"""The census of a course: it is saved as the site reads it, and judges answers by hand."""

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


BY_HAND = """
from types import SimpleNamespace

def answers_by_hand(number, given, answer):
    return [SimpleNamespace(label="nothing", value="0", right=False, is_named_by=lambda text: True)]
"""


def test_answers_by_hand_are_read_from_a_module_of_this_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ohm_by_hand.py").write_text(BY_HAND, "utf-8")
    options = [
        "--course",
        str(write_course(tmp_path)),
        "--students",
        "2",
        "--by-hand",
        "ohm_by_hand",
        "--save",
        "c.json",
    ]
    main(["census", *options])
    assert {row["by_hand"] for row in json.loads((tmp_path / "c.json").read_text("utf-8"))["problems"]} == {2}
