"""What can be read of a lecture, in order, in each of its forms: in JupyterLab, as a plain notebook, on the site, in the PDF.

A reading is a list of marks and passages. A mark says that a cell or a section begins, that a question is asked or explained,
or that a blank step is checked. What is covered until a question is answered is no part of a reading; code that is folded is,
because GitHub and the PDF do not fold it, and a click opens it elsewhere.
"""

import base64
import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from html.parser import HTMLParser
from typing import Any

from giveaways import Passage, passages_of
from nbformat import NotebookNode

from misstep.questions.item import KINDS, Item

WIDGETS = "application/vnd.jupyter.widget-state+json"
VIEW = "application/vnd.jupyter.widget-view+json"
ATTRIBUTES = {"alt": "alternative text", "aria-label": "alternative text", "title": "title", "data-label": "caption"}
BLOCKS = frozenset(
    ["p", "li", "div", "pre", "script", "h1", "h2", "section", "table", "figcaption", "summary", "br", "text", "button"]
)
"""What is read as a whole. A table is, because its rows speak of the options one after the other."""
VOID = frozenset(["area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"])


@dataclass(frozen=True)
class Mark:
    """What begins here: a "cell", a "section" by its title, what is "asked" or "explained", a "blank"."""

    kind: str
    name: str = ""


Reading = list[Mark | Passage]


def notebook_reading(notebook: NotebookNode, questions: Mapping[str, Item], with_widgets: bool) -> Reading:
    """Read an executed notebook, as JupyterLab shows it or, without widgets, as a page like GitHub's does."""
    return [*_notebook(notebook, questions, with_widgets)]


def _notebook(notebook: NotebookNode, questions: Mapping[str, Item], with_widgets: bool) -> Iterator[Mark | Passage]:
    by_text = {f"{KINDS[item.kind]}: {item.text}": name for name, item in questions.items()}
    by_question = {f"The question was: {item.text}": name for name, item in questions.items()}
    state = notebook.metadata.get("widgets", {}).get(WIDGETS, {}).get("state", {}) if with_widgets else {}
    for cell in notebook.cells:
        yield Mark("cell", cell.id)
        if cell.cell_type == "markdown":
            yield from _markdown(cell.source, cell.id)
            continue
        yield from code(cell.source, cell.id)
        for output in cell.outputs:
            data = output.get("data", {})
            plain = output.get("text", "") or data.get("text/plain", "")
            asked = by_text.get(plain.splitlines()[0] if plain else "")
            explained = next((name for text, name in by_question.items() if text in plain), "")
            if asked or explained:
                yield Mark("asked" if asked else "explained", asked or explained)
            elif with_widgets and VIEW in data:
                yield from _widget(state, data[VIEW]["model_id"], cell.id)
            elif html := data.get("text/html") or data.get("image/svg+xml"):
                yield from page_reading(html, cell.id)
            else:
                yield Passage("output", data.get("text/latex") or data.get("text/markdown", ""), cell.id)
                yield from (Passage("output", line, cell.id) for line in plain.splitlines())
                yield Passage("output", plain, cell.id)


def code(source: str, cell: str) -> Iterator[Mark | Passage]:
    """Read the source of a cell. A name of a question or of a blank step in it is no text; the latter is a mark."""
    for number in re.findall(r'\battempt\(\s*"([\w.]+)"', source):
        yield Mark("blank", number)
    source = re.sub(r'\b(ask|explain|attempt)\(\s*f?"[^"]*"', r"\1(", source)
    yield from (Passage("code", line, cell) for line in source.splitlines())
    yield Passage("code", source, cell)


def _markdown(source: str, cell: str) -> Iterator[Mark | Passage]:
    for text in re.split(r"(?m)^(?=##? )", source):
        if title := re.match(r"##? (.*)", text):
            yield Mark("section", title[1])
        yield from (Passage("text", part, cell) for part in passages_of(text))


def _widget(state: Mapping[str, Any], model: str, cell: str) -> Iterator[Mark | Passage]:
    """Read a widget and what is in it, as far as it is shown; a viewer that waits for a prediction is covered."""
    values = state.get(model, {}).get("state", {})
    if values.get("covered"):
        return
    for name in ("description", "tooltip", "message", "placeholder"):
        if isinstance(values.get(name), str):
            yield Passage("caption", values[name], cell)
    for label in values.get("_options_labels", []):
        yield Passage("caption", f"{values.get('description', '')} {label}", cell)
    if isinstance(values.get("value"), str):
        yield from page_reading(values["value"], cell)
    for output in values.get("outputs", []):
        yield from page_reading(output.get("data", {}).get("text/html", ""), cell)
    yield from _strings(values.get("scene"), cell)
    for child in values.get("children", []):
        yield from _widget(state, child.removeprefix("IPY_MODEL_"), cell)


def _strings(data: Any, cell: str) -> Iterator[Passage]:
    """Read the texts of a viewer: captions and the steps of a player."""
    if isinstance(data, str):
        yield from (Passage("viewer", part, cell) for part in passages_of(re.sub(r"<[^>]+>", " ", data)))
    elif isinstance(data, Mapping | list):
        for value in data.values() if isinstance(data, Mapping) else data:
            yield from _strings(value, cell)


def window(reading: Reading, mark: Mark, whole: bool) -> list[tuple[Passage, str]]:
    """Return what can be read before an answer, and where: "own" cell of the question or below it, "section", or "above" it.

    whole  whether all above counts, and the titles of the sections below, which a table of contents lists; otherwise only the
           section does, because the sections before it teach the answer

    It ends where the answer is explained; without an explanation, with the section. The source of the next cell counts, too.
    """
    at = reading.index(mark)
    own, section = (_last(reading[:at], kind) for kind in ("cell", "section"))
    cells = [k for k in range(at + 1, len(reading)) if _is(reading[k], "cell")]
    sections = [k for k in range(at, len(reading)) if _is(reading[k], "section")]
    if Mark("explained", mark.name) in reading[at:]:
        end = reading.index(Mark("explained", mark.name), at)
        after = [k for k in cells if k > end][:2]
        below = reading[after[0] : after[-1]] if after and not any(k < after[-1] for k in sections) else []
    else:
        begin, after = [*cells, len(reading), len(reading)][:2]
        outputs = (k for k in range(begin, after) if _is(reading[k], "asked") or not _is_source(reading[k]))
        end, below = min(next(outputs, after), *sections[:1]), []
    headings = [(Passage("heading", one.name, ""), "section") for one in reading[end:] if _is(one, "section")]
    before = [
        (one, "own" if k >= own or (k >= section and not _is_source(one)) else "section" if k >= section else "above")
        for k, one in enumerate(reading[:end])
        if isinstance(one, Passage) and (whole or k >= section)
    ]
    sources = [(one, "section") for one in below if isinstance(one, Passage) and one.kind == "code"]
    return before + sources + headings * whole


def _last(reading: Reading, kind: str) -> int:
    return max((k for k, one in enumerate(reading) if _is(one, kind)), default=0)


def _is(one: Mark | Passage, kind: str) -> bool:
    return isinstance(one, Mark) and one.kind == kind


def _is_source(one: Mark | Passage) -> bool:
    return isinstance(one, Mark) or one.kind in ("code", "text")


def page_reading(html: str, cell: str = "") -> Reading:
    """Read a page, or an output of a cell."""
    asked = re.findall(r'data-misstep-question="([^"]+)"', html)
    html = re.sub(  # the PDF has the explanations at its end
        r"<p>(?=Compare with answer (\d+))",
        lambda found: f'<i data-misstep-explain="{asked[int(found[1]) - 1]}"></i><p>',
        html,
    )
    reader = _PageReader(cell)
    reader.feed(html)
    reader.close()
    return [*reader.found]


class _PageReader(HTMLParser):
    """Reads text and attributes; formulas by their LaTeX, pictures by their alternative text and their labels."""

    def __init__(self, cell: str) -> None:
        super().__init__()
        self.cell, self.open, self.text, self.found = cell, [], "", []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        values = {name: value or "" for name, value in attributes}
        classes = values.get("class", "").split()
        parent = self.open[-1][1] if self.open else "text"
        kind = self._kind(tag, values, classes, parent)
        if kind != "hidden" and parent != "hidden":
            if tag in BLOCKS and not self._in_table():
                self._flush(parent)
            if tag == "div" and "cell" in classes:
                self.found.append(Mark("cell"))
            self._read_attributes(values)
        self._mark(values)
        if tag not in VOID:
            self.open.append((tag, kind))

    @staticmethod
    def _kind(tag: str, values: Mapping[str, str], classes: list[str], parent: str) -> str:
        covered = {"data-misstep-question", "data-misstep-explain", "data-kinlib-after"} & set(values)
        if parent == "hidden" or covered or tag in ("style", "nav") or {"katex-html", "headerlink"} & set(classes):
            return "hidden"
        if tag == "script":
            return "viewer" if values.get("type") == "application/json" else "hidden"
        if parent == "formula":
            return "latex" if tag == "annotation" else "formula"
        return {"math": "formula", "pre": "code" if parent == "input" else "output", "h2": "section"}.get(
            tag, "input" if "cell_input" in classes else parent
        )

    def _mark(self, values: Mapping[str, str]) -> None:
        for attribute, kind in (("data-misstep-question", "asked"), ("data-misstep-explain", "explained")):
            if attribute in values:
                self.found.append(Mark(kind, values[attribute]))

    def _read_attributes(self, values: Mapping[str, str]) -> None:
        for name, kind in ATTRIBUTES.items():
            if values.get(name) and "permalink" not in values.get("class", ""):
                self.found += [Passage(kind, part, self.cell) for part in passages_of(values[name])]
        if found := re.match(r"data:image/svg\+xml;base64,(.*)", values.get("src", ""), re.DOTALL):
            labels = re.findall(r"<!--(.*?)-->", base64.b64decode(found[1]).decode())  # text drawn as outlines
            self.found += [Passage("picture", label.strip(), self.cell) for label in labels]

    def handle_endtag(self, tag: str) -> None:
        while self.open:
            last, kind = self.open.pop()
            if last == tag:
                break
        else:
            return
        if kind not in ("hidden", "formula"):
            self.text += {"td": " | ", "th": " | ", "tr": "\n"}.get(tag, "")
            if tag in BLOCKS and not self._in_table():
                self._flush(kind)

    def _in_table(self) -> bool:
        return any(tag == "table" for tag, _ in self.open)

    def handle_data(self, data: str) -> None:
        kind = self.open[-1][1] if self.open else "text"
        if kind == "latex":
            self.text += f"${data}$"
        elif kind not in ("hidden", "formula"):
            self.text += data.replace("\n", " ") if self._in_table() else data

    def close(self) -> None:
        super().close()
        self._flush("text")

    def _flush(self, kind: str) -> None:
        text, self.text = self.text, ""
        if not text.strip():
            return
        if kind == "code":
            self.found += code(text, self.cell)
        elif kind == "viewer":
            self.found += _strings(json.loads(text), self.cell)
        elif kind == "output":
            self.found += [Passage(kind, part, self.cell) for part in [*text.splitlines(), text]]
        else:
            if kind == "section":
                self.found.append(Mark("section", text.strip()))
            self.found += [Passage(kind, part, self.cell) for part in passages_of(text)]
