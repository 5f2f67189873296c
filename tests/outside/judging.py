"""What feedback says to the answers from outside, counted: PYTHONPATH=.:tests python -m outside.judging --examples"""

import argparse
import re
from collections import Counter
from types import SimpleNamespace

from kincourse import find_sheet, sheets
from misstep.judge import judge
from outside import EARNS_NOTHING, NAMELESS, outside_answers

COUNTED = ("told", "unnamed", "false", "full marks", "refused", "undeserved", "blamed")
"""The maker's word is on the card; no name, a false claim, full marks of a wrong answer; a right form that has not full marks; a
mark for what was found by a wrong method; a part that is right among those of which something wrong is said."""


def says_a_fact(message):
    """Return whether a message says what was done, and not only what leads to the same answer."""
    return bool(re.search(r"\bYou\b", message)) and not message.startswith(("This is ", "Several mistakes"))


def found(made, judgement, answer):
    """Yield what is counted of an answer: "wrong" or "right form", and what of COUNTED is so."""
    if made.right:
        yield "right form"
        if judgement.state != "right":
            yield "refused"
        return
    if judgement.state == "unreadable":
        yield "unreadable"
        return
    yield "wrong"
    if has_name := made.did != NAMELESS:  # a tutor could say what was done
        yield "with a name"
    named = [finding for finding in judgement.findings if finding.mistake]
    if judgement.state == "right":
        yield "full marks"
    elif has_name and not named:
        yield "unnamed"
    said = " ".join(f"{one.mistake} {one.message}" for one in judgement.findings).casefold()
    if any(word.casefold() in said for word in made.did):
        yield "told"
    elif any(says_a_fact(one.message) for one in named):
        yield "false"
    if judgement.state in {"partly", "wrong"}:
        agrees = answer.agrees(answer.read(made.value), answer.value)
        right = {part for part, is_right in zip(answer.parts, agrees, strict=True) if is_right}
        yield from ["blamed"] * any(right.intersection(finding.parts) for finding in judgement.findings)
    if made.label in EARNS_NOTHING and 0 < judgement.fraction < 1:
        yield "undeserved"


def counts_of(template, student):
    """Return how often each of COUNTED is so, and for each the answers with what was said."""
    counts, examples = Counter(), {}
    problems = template.variant(student), template.variant(f"the neighbour of {student}")
    given, neighbour = (SimpleNamespace(**one.given, **one.shown) for one in problems)
    answer = problems[0].answer
    for made in outside_answers(template.number, given, answer.value, neighbour):
        judgement = judge(problems[0], made.value)
        said = " | ".join(f"{one.mistake}: {one.text}" for one in judgement.findings)
        for what in found(made, judgement, answer):
            counts[what] += 1
            examples.setdefault(what, []).append(f"{template.number}, {made.label}: {said}")
    return counts, examples


def main():
    """Print the counts of all problems."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=1, help="how many students (1)")
    parser.add_argument("--sheet", choices=sheets(), default="", help="a single sheet, such as 03_poe_space")
    parser.add_argument("--examples", action="store_true", help="print what has no name, and what is judged wrongly")
    options, total = parser.parse_args(), Counter()
    for template in (one for name in sheets() if options.sheet in {"", name} for one in find_sheet(name).problems):
        for k in range(options.students):
            counts, examples = counts_of(template, f"student {k}")
            total.update(counts)
            for what in COUNTED[1:] if options.examples else ():
                for one in examples.get(what, ()):
                    print(f"{what}: {one}")
        print(template.number, dict(sorted(counts.items())))
    told = f"{total['wrong']} wrong answers, {total['with a name']} of them with a name"
    print(told, *(f"{what}: {total[what]}" for what in COUNTED), sep="\n")


if __name__ == "__main__":
    main()
