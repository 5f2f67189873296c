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


NOT_REHEARSED = {
    "changes the machine": (
        *("sudo ", "cd /srv/hub", "useradd", "chmod", "rm -rf", "apt-get"),
        "python3 -m venv /opt/venv",  # done in another folder
    ),
    "needs a container engine; container.yml runs it": ("podman", "docker", "${{ matrix.engine }}"),
    "a preparation or a check of a workflow": ("mkdir", "cp ", "grep "),
    "needs several machines": ("kubectl", "helm", "dask", "pip install ./kinlib './misstep[grading,cluster]'"),
    "needs a person": (
        "npx lighthouse",
        ".venv/bin/python -m jupyterlab",
        ".venv/bin/python -m misstep preview",
        ".venv/bin/python -m mutmut",
    ),
    "a test runs it": (
        *("npm ", "kincourse new-lecture", "misstep unnamed"),
        *(f".venv/bin/python -m misstep {command}" for command in ("grade",)),
    ),
    "the whole suite; test.yml and .ci/run run it": ("python course.py test", '"$python" course.py test'),
    "takes long or changes files; evidence.yml runs what proves something": (
        *("nox -s ", ".venv/bin/python -m nox -s "),
    ),
    "the same program as another command": (*("misstep grade ", ".venv/bin/misstep release", "python -m kincourse"),),
    "an example": ("pip install pandas", ".venv/bin/pip install pandas", "pip install my_course"),
    "the rehearsal itself": ("python tools/fresh",),
    "the standard library's server": (".venv/bin/python -m http.server",),
}
"""Commands of documents that no path runs, by how they begin, with the reason."""
