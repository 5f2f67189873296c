"""The paragraphs of a card: what the findings say, and not more than a student reads."""

from collections.abc import Sequence
from dataclasses import replace

from misstep.diagnosis.explanation import MAX_LENGTH, SENTENCE_END, Finding

RIGHT = "Right: {}."
"""What is said of the right parts of an answer."""

TOGETHER = "Right: {}. You get no points for this alone."
"""What is said of right parts that a wrong method gives as well, and that earn nothing alone."""


def paragraphs(
    findings: Sequence[Finding], right_parts: Sequence[str] = (), said_of_right: str = RIGHT, *, is_first: bool = False
) -> list[str]:
    """Return what findings say. Together they have at most MAX_LENGTH characters, or else no checks, or one sentence each.

    right_parts    the names of the parts that are right, to be listed in front
    said_of_right  the sentence for them; without right parts, the parts of a single finding need no names
    is_first       whether this is the first try, so that only ideas are told, and no places

    >>> paragraphs([Finding(["x"], "It is 0. Put in numbers."), Finding(["z"], "It is 0. Put in numbers.")], ["y"])
    ['Right: y.', 'X and z: It is 0. Put in numbers.']
    >>> paragraphs([Finding(["x"], "It is 0.")])
    ['It is 0.']
    """
    findings = [
        replace(one, message=one.message.partition("\n")[0] if is_first else one.message.replace("\n", " "))
        for one in findings
    ]
    listed = enumeration(right_parts)
    shown = listed if len(listed) < MAX_LENGTH / 4 else f"{len(right_parts)} parts"
    before = [said_of_right.format(shown)] * bool(right_parts)
    is_on_whole = len(findings) == 1 and not right_parts
    merged = _merged(findings)
    if len(merged) == 1 and right_parts and len(enumeration(merged[0].parts)) > 60:
        merged[0] = replace(merged[0], parts=["the others"])  # because the right ones are listed

    def texts(told: Sequence[Finding]) -> list[str]:
        return before + [_text(one, is_on_whole) for one in told]

    unchecked = [replace(one, check="") for one in merged]
    brief = [replace(one, message=SENTENCE_END.split(one.message)[0]) for one in unchecked[1:]]
    told = next(
        (told for told in (merged, unchecked) if sum(map(len, texts(told))) <= MAX_LENGTH), unchecked[:1] + brief
    )
    return texts(told)


def _text(one: Finding, is_on_whole: bool) -> str:
    said = f"{one.message} {one.check}".strip()
    return said if is_on_whole else f"{_capitalized(enumeration(one.parts))}: {said}"


def enumeration(names: Sequence[str]) -> str:
    """Return names as a list in words: "entries 1, 2, 3 and 4".

    >>> enumeration(["x"]), enumeration(["x", "y", "z"]), enumeration([f"entry {k}" for k in range(4)])
    ('x', 'x, y and z', 'entries 0, 1, 2 and 3')
    """
    kinds = {name.partition(" ")[0] for name in names if name.count(" ") == 1}
    if len(names) > 3 and len(kinds) == 1 and all(name.count(" ") == 1 for name in names) and kinds != {"the"}:
        [kind] = kinds
        plural = f"{kind[:-1]}ies" if kind.endswith("y") else f"{kind}s"
        return f"{plural} {enumeration([name.partition(' ')[2] for name in names])}"
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
