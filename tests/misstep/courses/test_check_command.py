"""`misstep check`: what an author forgot or broke is named with its problem and its line."""

import sys

from misstep.catalog import forget_package
from misstep.cli import main


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
