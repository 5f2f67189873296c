"""What the feedback may do to the answers from outside: tests/evidence judges some of them in each run, evidence/ all every night.

python evidence/checks/judge_outside.py --students 2 --save site/census.json   # counts them for the page of the site
"""

import argparse
import json
import re
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from itertools import repeat
from pathlib import Path
from types import SimpleNamespace

from evidence.outside import outside_answers
from evidence.outside.right import RIGHT
from kincourse import find_sheet, sheets
from kincourse.robot_sheets.robot_sheet import TASKS, robot_sheet
from kinlib.chains.robots import rpr
from misstep.judge import judge

STUDENTS = ["a student of the tests", "another one"]

MAX_SHARE = {"full marks": 0.0, "refused": 0.0, "false": 0.01, "undeserved": 0.0, "unnamed": 0.1}
"""The largest share of the wrong answers to one problem of which this may be said."""

FALSE_BY_COINCIDENCE = {"01.2": 0.05, "09.2": 0.05}
"""The problems with more false claims: with the numbers of one student, another mistake leads to the same answer."""


def a_third_of_each_sheet():
    """Return a third of the problems of each sheet, first what is of a kind of answer that was chosen least often, or that is rare."""
    chosen, often, kinds = [], Counter(), Counter(kind for kind, _ in RIGHT.values())
    for name in sheets():
        left = list(find_sheet(name).problems)
        for _ in range(round(len(left) / 3)):
            best = min(left, key=lambda template: (often[kind_of(template)], kinds[kind_of(template)]))
            left.remove(best)
            chosen.append(best)
            often[kind_of(best)] += 1
    assert set(often) == set(kinds)
    return chosen


def kind_of(template):
    return RIGHT[template.number][0]


def tasks_of_a_robot():
    """Return the problems of a robot sheet, with the names of their tasks as numbers."""
    problems = robot_sheet("robot", rpr(), [*TASKS]).problems
    return [replace(template, number=f"robot.{task}") for task, template in zip(TASKS, problems, strict=True)]


def says_a_fact(finding):
    """Return whether a message says what was done, and not only what leads to the same answer."""
    possible = ("This is what you get", "This is also what you get", "Several mistakes")
    return bool(re.search(r"\bYou\b", finding.message)) and not finding.message.startswith(possible)


def judge_outside(template, students):
    """Return what is counted of the answers from outside of some students to a problem, and for each count its answers.

    Of the wrong ones these are full marks, no name, a false claim and undeserved marks, of the right ones that are refused.
    """
    counts, examples = Counter(), {}
    for student in students:
        problem = template.variant(student)
        neighbour = SimpleNamespace(**template.variant(f"the neighbour of {student}").given)
        given = SimpleNamespace(**problem.given)
        for made in outside_answers(template.number, given, problem.answer.value, neighbour):
            judgement = judge(problem, made.value)
            found = set(_found(made, judgement))
            counts.update(found)
            counts.update(f"held out: {what}" for what in found if made.is_held_out and not made.right)
            said = " | ".join(f"{finding.mistake}: {finding.message}" for finding in judgement.findings)
            for what in found - {"wrong", "right forms"}:
                examples.setdefault(what, []).append(f"{student}: {made.label}: {said}")
    return counts, examples


def _found(made, judgement):
    if made.right:
        yield "right forms"
        if judgement.state != "right":
            yield "refused"
        return
    if judgement.state == "unreadable":
        yield "unreadable"
        return
    yield "wrong"
    named = [finding for finding in judgement.findings if finding.mistake]
    said = " ".join(f"{finding.mistake} {finding.message}" for finding in named)
    if judgement.state == "right":
        yield "full marks"
    elif made.has_name and not named:
        yield "unnamed"
    if any(map(says_a_fact, named)) and not made.is_named_by(said):
        yield "false"
    if made.earns_nothing and 0 < judgement.fraction < 1:
        yield "undeserved"


def assert_feedback_is_true(template, students):
    """Judge the answers from outside of some students to a problem."""
    counts, examples = judge_outside(template, students)
    wrong = counts["wrong"]
    assert wrong, f"no answers to {template.number}"
    for what, share in (MAX_SHARE | {"false": FALSE_BY_COINCIDENCE.get(template.number, MAX_SHARE["false"])}).items():
        assert counts[what] <= share * wrong, examples[what][:5]


def _judged(sheet, position, students):
    template = find_sheet(sheet).problems[position]
    return template.number, *judge_outside(template, students)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=2, help="how many students (2)")
    parser.add_argument("--sheet", action="append", help="only this sheet; may be repeated")
    parser.add_argument("--examples", action="store_true", help="print the answers that were counted")
    parser.add_argument(
        "--save", type=Path, help="write the counts into this JSON file, where `misstep census` writes its own"
    )
    options = parser.parse_args()
    students = [f"student {k}" for k in range(options.students)]
    jobs = [(sheet, k) for sheet in options.sheet or sheets() for k in range(len(find_sheet(sheet).problems))]
    problems = {}
    with ProcessPoolExecutor() as pool:
        for number, counts, examples in pool.map(_judged, *zip(*jobs, strict=True), repeat(students)):
            problems[number] = dict(sorted(counts.items()))
            print(number, problems[number])
            for what, answers in examples.items() if options.examples else ():
                print(f"\n{number}, {what}:", *answers, sep="\n- ")
    if options.save:
        saved = json.loads(options.save.read_text("utf-8")) if options.save.exists() else {}
        saved["outside"] = {"students": len(students), "problems": problems}
        options.save.write_text(json.dumps(saved, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
