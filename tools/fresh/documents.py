"""The commands that the documents give to a person, and that the workflows and the container run."""

import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = (
    "*.md",
    "guides/*.md",
    "site/instructors.md",
    "site/pages/*.md",
    "misstep/new_course/template/*.md",
    "deploy/*",
    ".binder/*",
    ".github/workflows/*.yml",
    ".ci/run",
)
BLOCK = re.compile(r"^ *```(.*)\n((?:(?! *```).*\n)*) *```", re.MULTILINE)
SPAN = re.compile(
    r"(?<!`)`((?:python3?|\.venv/bin/\S+|pip|nox|jupyter|podman|docker|npx|npm|sudo|kincourse|misstep) [^`]+)`"
)
STEP = re.compile(r"^( *)(?:- )?run: (?:\|\n((?:\1 +.*\n|\n)+)|(.+)\n)", re.MULTILINE)
RUN = re.compile(r"^RUN ((?:.*\\\n)*.*)", re.MULTILINE)
COMMENT = re.compile(r"^#.*\n", re.MULTILINE)


def commands() -> dict[str, list[str]]:
    """Return every command of the documents, with the documents that give it."""
    found: dict[str, list[str]] = {}
    for pattern in DOCUMENTS:
        for path in sorted(ROOT.glob(pattern)):
            if path.is_file() and path.name != "CHANGELOG.md":
                for command in commands_of(path):
                    found.setdefault(command, []).append(path.relative_to(ROOT).as_posix())
    return found


def commands_of(path: Path) -> Iterator[str]:
    """Yield the commands of one file by its kind: blocks and spans of code, steps of a workflow, instructions of a container."""
    text = path.read_text("utf-8")
    if path.suffix == ".md":
        blocks = [block for language, block in BLOCK.findall(text) if not language]
        yield from (line.strip() for block in blocks for line in block.splitlines() if line.strip())
        yield from (" ".join(span.split()) for span in SPAN.findall(BLOCK.sub("", text)))
    elif path.suffix == ".yml":
        yield from (line.strip() for _, block, line in STEP.findall(text) for line in (block or line).splitlines())
    elif path.name == "Containerfile":
        for instruction in RUN.findall(COMMENT.sub("", text)):
            yield from (part.strip() for part in re.sub(r"\s*\\\n\s*", " ", instruction).split("&&"))
    elif path.name == "requirements.txt":
        yield f"pip install -r {path.relative_to(ROOT).as_posix()}"
    elif path.name == "run":
        yield from re.findall(r"^exec (.+)", text, re.MULTILINE)
