"""The page on which a person marks answers in prose: one file, which needs no network and keeps what is entered in the browser.

It shows one answer after the other, with the criteria of its rubric and a comment, and saves marks.csv, which the next
`misstep grade` reads from the folder of results.
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from misstep.grading.judging.result import Result

PAGE = Path(__file__).with_name("templates") / "marking.html"


def marking_page(results: Sequence[Result], marks: Mapping[str, Sequence[Any]]) -> str:
    """The page for all answers that a person marks; "" if there are none.

    marks  by student, what was decided before
    """
    known = {(student, one.problem): one for student, several in marks.items() for one in several}
    answers = []
    for result in results:
        for problem in result.problems:
            if problem.state != "unmarked":
                continue
            mark = known.get((result.student, problem.number))
            rubric = [[name, points["number"]] for name, points in problem.right["map"]]
            answers.append(
                {
                    "student": result.student,
                    "problem": problem.number,
                    "title": problem.title,
                    "statement": problem.statement,
                    "text": problem.answer["text"],
                    "rubric": rubric,
                    "max": problem.max,
                    "points": mark.points if mark else None,
                    "comment": mark.comment if mark else "",
                }
            )
    if not answers:
        return ""
    answers.sort(key=lambda one: (one["problem"], one["student"]))
    # In a script element, only these signs could end it.
    data = json.dumps({"sheet": results[0].sheet, "answers": answers}, ensure_ascii=False).replace("<", "\\u003c")
    return PAGE.read_text("utf-8").replace("{{data}}", data)
