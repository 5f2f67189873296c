"""HTML pages that need no other file, readable on a phone, in a dark theme, on paper and by a screen reader.

Everything that a template fills in is escaped, and the page forbids scripts and requests to other hosts. So even if
something of a submission reached the page unescaped, it would have no effect.
"""

import base64
import binascii
import re
from collections.abc import Mapping
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from misstep.display.text import points
from misstep.grading.judging.result import ProblemResult, RanCell, Result
from misstep.grading.publish.mathml import render_markdown, render_sentence

PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"

TALLY_CELL = re.compile(r"\A\s*sheet\.tally\(\)\s*")
"""The cell of a sheet that shows its points."""

SHOW_CELL = re.compile(r"\A\s*sheet\.show\((\d{1,3})\)\s*")
"""The cell of a sheet that shows a problem. Feedback shows it as the judge has drawn it."""

STATE_LABELS = {
    "right": ("✓", "right"),
    "partly": ("◐", "partly right"),
    "wrong": ("✗", "not yet right"),
    "blank": ("…", "no answer yet"),
    "unreadable": ("?", "unreadable"),
    "unmarked": ("✎", "not marked yet"),
    "missing": ("–", "no answer received"),
}
"""For each state of a problem its sign and its words, so that no meaning depends on colour alone."""


def format_points(value: float) -> str:
    """Points with at most two decimals, for tables and averages.

    >>> format_points(2.0), format_points(2 / 3)
    ('2', '0.67')
    """
    return f"{value:.2f}".rstrip("0").rstrip(".")


def render_output(output: Mapping[str, Any]) -> str | Markup:
    """An output of a cell as text, or as a picture if it is one; never as HTML, because it comes from student code."""
    picture = png_of(output)
    if picture is None:
        return text_of(output)
    return Markup('<img alt="{}" src="data:image/png;base64,{}">').format(text_of(output)[:200] or "a picture", picture)


def png_of(output: Mapping[str, Any]) -> str | None:
    """The PNG picture of an output as base64; None if the output has no picture."""
    picture = output.get("data", {}).get("image/png")
    picture = "".join(picture.split()) if isinstance(picture, str) else ""
    return picture if _is_png(picture) else None


def outputs_of(cell: RanCell) -> list[Mapping[str, Any]]:
    """The student's outputs of a cell: without problems, and without verdicts, which need the judge."""
    is_ours = cell.problem is not None or TALLY_CELL.fullmatch(cell.source) or SHOW_CELL.fullmatch(cell.source)
    return [output for output in cell.outputs if not is_ours or output.get("output_type") == "error"]


def text_of(output: Mapping[str, Any]) -> str:
    """The text of an output: of a display, of a stream, or the traceback of an error."""
    if output.get("output_type") == "error":
        return "\n".join(map(str, output.get("traceback", ()))) or f"{output.get('ename')}: {output.get('evalue')}"
    data = output.get("data", {"text/plain": output.get("text", "")})
    return next((data[kind] for kind in ("text/markdown", "text/plain") if isinstance(data.get(kind), str)), "")


def _is_png(text: str) -> bool:
    try:
        return base64.b64decode(text, validate=True).startswith(PNG_SIGNATURE)
    except (binascii.Error, ValueError):
        return False


def verdict_lines(problem: ProblemResult) -> list[str]:
    """The lines of a verdict without its title, which the page has already."""
    return [line.strip() for line in problem.verdict.splitlines()[1:] or [problem.verdict] if line.strip()]


def render_part(part: str, problem: ProblemResult) -> Markup:
    """The "problem" of a result, or the "card" with its verdict, as feedback shows it, for the page of another program."""
    macros: Any = ENVIRONMENT.get_template("problem.html").module
    return Markup("<style>{}</style>{}").format(macros.style(), getattr(macros, part)(problem))


def render_page(template: str, **values: Any) -> str:
    """The HTML of a page from one of the templates."""
    return ENVIRONMENT.get_template(template).render(**values) + "\n"


def feedback_page(result: Result) -> str:
    """The page of one student: the student's code, its outputs, and the verdicts. It has no data of other students.

    The right answers are not on it, so that the student can try again.
    """
    remarks = [line for line in (result.reason, *result.notes) if line]
    return render_page(
        "feedback.html",
        result=result,
        remarks=remarks,
        patterns=[str(one) for one in result.recurrences if one.returns or one.is_slip],
        unsolved=[(k, one) for k, one in enumerate(result.problems, start=1) if one.state != "right"],
        solved=[(k, one) for k, one in enumerate(result.problems, start=1) if one.state == "right"],
        is_safe=result.is_safe,
    )


ENVIRONMENT = Environment(
    loader=PackageLoader("misstep.grading.publish", "templates"),
    autoescape=True,
    auto_reload=False,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
)
ENVIRONMENT.filters |= {
    "sentence": render_sentence,
    "statement": render_markdown,
    "decimals": format_points,
    "points": points,
    "as_html": render_output,
    "outputs": outputs_of,
}
ENVIRONMENT.globals |= {"STATE_LABELS": STATE_LABELS, "verdict_lines": verdict_lines, "Markup": Markup}
