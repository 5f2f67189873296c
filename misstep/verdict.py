"""Verdicts: a judgement as a card for the student, with the points, and the points of a whole sheet."""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from misstep.diagnosis.explanation import MAX_LENGTH, SENTENCE_END, Finding
from misstep.display.card import TONES, Card, Link
from misstep.display.text import points
from misstep.judge import Judgement
from misstep.problem import Template
from misstep.storage import MIME

SOLVED_MIME = "application/vnd.misstep.solved+json"
"""The MIME type by which a check tells the page that its problem has full marks. It plays no part in grading."""

RIGHT = "Right: {}."
"""What is said of the right parts of an answer."""


@dataclass(frozen=True)
class Verdict:
    """The points of one answer, and why. It displays itself as a card, and stores the answer as JSON beside the card.

    emission  the answer with its sheet, problem and student; a grader reads it and judges it again
    address   the address of the section to re-read, "" if it is not known
    worked    the steps of the worked solution, for a right answer
    further   a question for a student who has solved the problem
    is_first  whether no answer to the problem was wrong before; then the card tells the idea, and not yet the place, and so it
              does each time for a hard problem
    """

    template: Template
    judgement: Judgement
    emission: Mapping[str, Any] | None = None
    address: str = ""
    is_first: bool = False
    worked: Sequence[str] = ()
    further: str = ""

    @property
    def score(self) -> float:
        """The points earned."""
        return self.template.points * self.judgement.fraction

    @property
    def card(self) -> Card:
        """The feedback: title, points, the right parts, the message of each finding, and the section to re-read."""
        judgement, template = self.judgement, self.template
        title = f"Problem {template.number}: {TONES[judgement.state][2]}"
        full = f"{template.points} point{'s' * (template.points != 1)}"
        if judgement.state == "open":
            return Card("open", title, [f"Your text is kept. Your instructor gives up to {full} for it."])
        body: list[str | Link] = [f"{points(self.score)} of {full}."]
        right_parts = () if judgement.state == "right" else judgement.right_parts
        body += _paragraphs(
            judgement.findings,
            right_parts,
            RIGHT if judgement.fraction else f"{RIGHT} You get no points for this alone.",
            is_first=self.is_first or template.level == "Hard",
        )
        if self.worked:
            body += ["One way to it:", *self.worked]
        if judgement.state == "right" and self.further:
            body.append(f"A further question: {self.further}")
        if judgement.state not in ("right", "blank"):
            lecture, _, section = template.lecture.partition("#")
            body.append(Link(f"Re-read: section “{section}” of lecture {lecture.partition('_')[0]}.", self.address))
        return Card(judgement.state, title, body)

    def _repr_mimebundle_(self, **options: Any) -> dict[str, Any]:
        data = {MIME: self.emission} if self.emission else {}
        if self.emission and self.judgement.state == "right":
            data[SOLVED_MIME] = {name: self.emission[name] for name in ("sheet", "problem")}
        return {**self.card._repr_mimebundle_(**options), **data}


@dataclass(frozen=True)
class Tally:
    """The points of a sheet so far, and the mistakes that returned. It displays itself as a table."""

    problems: Sequence[Template]
    verdicts: Mapping[int, Verdict]
    note: str = ""
    returning: Sequence[str] = ()

    @property
    def score(self) -> float:
        """The points earned so far."""
        return sum(verdict.score for verdict in self.verdicts.values())

    def __repr__(self) -> str:  # the one of a dataclass would write every problem and every answer into the notebook
        return self._repr_markdown_()

    def _repr_markdown_(self) -> str:
        rows = ["| problem | points | state |", "| --- | --- | --- |"]
        for k, template in enumerate(self.problems, start=1):
            verdict = self.verdicts.get(k)
            state = TONES[verdict.judgement.state][2].lower() if verdict else "not checked yet"
            score = "…" if verdict and verdict.judgement.state == "open" else points(verdict.score if verdict else 0)
            rows.append(f"| {template.number} {template.title} | {score} of {template.points} | {state} |")
        total = sum(template.points for template in self.problems)
        rows.append(f"| **together** | **{points(self.score)} of {total}** | {self.note} |")
        return "\n".join([*rows, *[""] * bool(self.returning), *(f"- {sentence}" for sentence in self.returning)])


def returning(found: Iterable[tuple[str, str]]) -> list[str]:
    """Return a sentence on each mistake that was recognised in several problems.

    found  the number of the problem and the name of the mistake, for each time that one was recognised

    >>> returning([("01.1", "sign"), ("01.2", "order"), ("01.2", "sign"), ("01.2", "sign")])
    ['Returning mistake: “sign” explains answers in 2 problems (01.1, 01.2).']
    """
    where = defaultdict(list)
    for number, name in dict.fromkeys(found):
        where[name].append(number)
    return [
        f"Returning mistake: “{name}” explains answers in {len(numbers)} problems ({', '.join(numbers)})."
        for name, numbers in sorted(where.items(), key=lambda item: (-len(item[1]), item[0]))
        if len(numbers) > 1
    ]


def _paragraphs(
    findings: Sequence[Finding], right_parts: Sequence[str] = (), said_of_right: str = RIGHT, *, is_first: bool = False
) -> list[str]:
    """Return what findings say. If they have more than MAX_LENGTH characters, the first is told without its check, and of others
    the first sentence.

    right_parts    the names of the parts that are right, to be listed in front
    said_of_right  the sentence for them; without right parts, the parts of a single finding need no names
    is_first       whether this is the first try, so that only ideas are told, and no places

    >>> _paragraphs([Finding(["x"], "It is 0. Put in numbers."), Finding(["z"], "It is 0. Put in numbers.")], ["y"])
    ['Right: y.', 'X and z: It is 0. Put in numbers.']
    >>> _paragraphs([Finding(["x"], "It is 0.")])
    ['It is 0.']
    """
    texts = [one.message.partition("\n")[0] if is_first else one.message.replace("\n", " ") for one in findings]
    merged = _merged([replace(one, message=text) for one, text in zip(findings, texts, strict=True)])
    listed = _enumeration(right_parts)
    shown = listed if len(listed) < MAX_LENGTH / 4 else f"{len(right_parts)} parts"
    before = [said_of_right.format(shown)] * bool(right_parts)
    if len(merged) == 1 and right_parts and len(_enumeration(merged[0].parts)) > 60:
        merged[0] = replace(merged[0], parts=["the others"])  # because the right ones are listed
    whole = [f"{one.message} {one.check}".strip() for one in merged]
    if sum(map(len, whole)) > MAX_LENGTH:
        whole = [one.message if one is merged[0] else SENTENCE_END.split(one.message)[0] for one in merged]
    if len(merged) == 1 and not right_parts:
        return whole
    return before + [
        f"{_capitalized(_enumeration(one.parts))}: {said}" for one, said in zip(merged, whole, strict=True)
    ]


def _enumeration(names: Sequence[str]) -> str:
    """Return names as a list in words: "x, y and z"."""
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def _merged(findings: Sequence[Finding]) -> list[Finding]:
    """Return one finding for all with the same message, with the first check among them."""
    merged = []
    for message in dict.fromkeys(finding.message for finding in findings):
        several = [finding for finding in findings if finding.message == message]
        parts = [part for finding in several for part in finding.parts]
        parts.sort(key=lambda part: int(part.rpartition(" ")[2]) if part.rpartition(" ")[2].isdigit() else 99)
        name, check = next(((one.parts[0], one.check) for one in several if one.check), ("", ""))
        if check and len({one.check for one in several}) > 1:
            check = f"{_capitalized(name)}: {check}"
        merged.append(Finding(parts, message, check=check))
    return merged


def _capitalized(text: str) -> str:
    is_symbol = text[1:2] in {"_", "^"}  # q_2 is not Q_2
    return text if is_symbol else text[:1].upper() + text[1:]
