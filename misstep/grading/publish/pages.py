"""Pages: HTML files that stand by themselves, readable on a phone and in the dark, printed and by a screen reader.

All that a template fills in is escaped, and the page forbids itself scripts and other hosts: should anything of a submission
slip through, it does nothing.
"""

import base64
import binascii
import re
from collections.abc import Mapping
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from misstep.grading.judging.result import RanCell
from misstep.grading.publish.mathml import sentence

PNG = b"\x89PNG\r\n\x1a\n"

TALLY = re.compile(r"\s*sheet\.tally\(\)\s*")
"""The cell of a sheet that counts points."""

STATES = {
    "right": ("✓", "right"),
    "partly": ("◐", "partly right"),
    "wrong": ("✗", "not yet"),
    "blank": ("…", "nothing there"),
    "unreadable": ("?", "unreadable"),
    "missing": ("–", "no answer"),
}
"""For each state of a problem its sign and its words: no meaning rests on colour alone."""


def points(value: float) -> str:
    """Points as people write them.

    >>> points(2.0), points(2 / 3)
    ('2', '0.67')
    """
    return f"{value:.2f}".rstrip("0").rstrip(".")


def shown(output: Mapping[str, Any]) -> str | Markup:
    """What a cell gave, as text, or as a picture if it is one. Never as HTML: it comes from the student's code."""
    picture = picture_of(output)
    if picture is None:
        return text_of(output)
    return Markup('<img alt="{}" src="data:image/png;base64,{}">').format(text_of(output)[:200] or "a picture", picture)


def picture_of(output: Mapping[str, Any]) -> str | None:
    """The picture that a cell gave, as base64, if it gave one."""
    picture = output.get("data", {}).get("image/png")
    picture = "".join(picture.split()) if isinstance(picture, str) else ""
    return picture if _is_png(picture) else None


def outputs_of(cell: RanCell) -> list[Mapping[str, Any]]:
    """What a cell gave, but for verdicts: where sheets run, nobody is there who could judge."""
    is_verdict = cell.problem is not None or TALLY.fullmatch(cell.source)
    return [output for output in cell.outputs if not is_verdict or output.get("output_type") == "error"]


def text_of(output: Mapping[str, Any]) -> str:
    """What a cell gave, as text: the text behind a display, a stream, or the error with its last lines."""
    if output.get("output_type") == "error":
        return "\n".join(map(str, output.get("traceback", ()))) or f"{output.get('ename')}: {output.get('evalue')}"
    data = output.get("data", {"text/plain": output.get("text", "")})
    return next((data[kind] for kind in ("text/markdown", "text/plain") if isinstance(data.get(kind), str)), "")


def _is_png(text: str) -> bool:
    try:
        return base64.b64decode(text, validate=True).startswith(PNG)
    except (binascii.Error, ValueError):
        return False


def page(template: str, **values: Any) -> str:
    """A page from one of the templates."""
    return ENVIRONMENT.get_template(template).render(**values) + "\n"


ENVIRONMENT = Environment(
    loader=PackageLoader("misstep.grading.publish", "templates"),
    autoescape=True,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
)
ENVIRONMENT.filters |= {"sentence": sentence, "points": points, "shown": shown, "outputs": outputs_of}
ENVIRONMENT.globals["STATES"] = STATES
