"""Refuse a commit whose subject is no short request such as `dh: refuse duplicate labels`; `nox -s hooks` installs it in git.

Git passes the file with the message; lines that begin with # are comments.
"""

import re
import sys
from pathlib import Path

MAX_LENGTH = 72
NO_PARTICIPLES = re.compile("bring|embed|exceed|feed|need|proceed|ring|seed|shed|speed|spring|string")


def faults(message: str) -> list[str]:
    """Say what a message lacks, one sentence for each fault."""
    subject, *body = [line for line in message.splitlines() if not line.startswith("#")] or [""]
    if re.match(r"(Merge|Revert|fixup!|squash!|amend!) ", subject):
        return []
    module, colon, request = subject.partition(": ")
    verb = re.match(r"\w*", request)[0].lower()
    found = []
    if not (module and colon and request):
        found.append(
            f"The subject must name a module and what the commit does to it, 'dh: refuse ...'; got {subject!r}."
        )
    elif verb.endswith(("ed", "ing")) and not NO_PARTICIPLES.fullmatch(verb):
        found.append(f"The subject must say what to do, as in 'refuse duplicate labels'; got {verb!r}.")
    if len(subject) > MAX_LENGTH:
        found.append(f"The subject must have at most {MAX_LENGTH} characters; it has {len(subject)}.")
    if body and body[0].strip():
        found.append("The line after the subject must be empty.")
    return found


if __name__ == "__main__":
    sys.exit("\n".join(faults(Path(sys.argv[1]).read_text("utf-8"))))
