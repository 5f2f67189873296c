"""The census of a course: it is saved as the site reads it, and judges answers from outside."""

import json

from circuits_course import write_course

from misstep.cli import main

OUTSIDE = """
from types import SimpleNamespace

def made(label, value, right=False, words=()):
    return SimpleNamespace(label=label, value=value, right=right, has_name=True, earns_nothing=False, is_held_out=False,
        is_named_by=lambda text: any(word in text for word in words))

def outside_answers(number, given, answer, neighbour):
    return [made("nothing", "0"), made("as it is", answer, right=True), made("a word", "eight", right=True)]
"""


def test_the_counts_are_saved_with_answers_from_a_module_of_this_folder(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ohm_outside.py").write_text(OUTSIDE, "utf-8")
    options = ["--students", "2", "--outside", "ohm_outside", "--save", "c.json"]
    assert main(["census", "--course", str(write_course(tmp_path)), *options]) == 0
    census = json.loads((tmp_path / "c.json").read_text("utf-8"))
    assert census["students"] == census["outside"]["students"] == 2
    assert [row["number"] for row in census["problems"]][:2] == ["01.1", "01.2"]
    assert all(row["wrong"] > 0 and row["examples"] == {} and row["outside"] == {} for row in census["problems"])
    assert {what for row in census["problems"] for what in row["counts"]} <= {"unnamed"}
    counted = census["outside"]["problems"].values()
    assert all(row.get("wrong", 0) + row.get("unreadable", 0) == 2 for row in counted)  # "0" is no letter and no table
    assert all(row["right forms"] == 4 and row["refused"] == 2 for row in counted)
    assert "01_ohm" in census["inseparable"]
