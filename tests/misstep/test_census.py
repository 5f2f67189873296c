"""The census of a course: it is saved as the site reads it, and judges answers by hand."""

import json

from circuits_course import write_course

from misstep.cli import main

BY_HAND = """
from types import SimpleNamespace

def answers_by_hand(number, given, answer):
    return [SimpleNamespace(label="nothing", value="0", right=False, is_named_by=lambda text: True)]
"""


def test_the_counts_are_saved_with_answers_by_hand_from_a_module_of_this_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ohm_by_hand.py").write_text(BY_HAND, "utf-8")
    options = ["--students", "2", "--by-hand", "ohm_by_hand", "--save", "c.json"]
    assert main(["census", "--course", str(write_course(tmp_path)), *options]) == 0
    census = json.loads((tmp_path / "c.json").read_text("utf-8"))
    assert census["students"] == 2
    assert [row["number"] for row in census["problems"]][:2] == ["01.1", "01.2"]
    assert all(row["wrong"] > 0 and row["examples"] == {} and row["by_hand"] == 2 for row in census["problems"])
    assert {what for row in census["problems"] for what in row["counts"]} <= {"unnamed"}
    assert "01_ohm" in census["inseparable"]
