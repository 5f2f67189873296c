"""Read the XML of an untrusted URDF into elements with line numbers.

A URDF may come from anywhere, so its size is limited, and nothing that it refers to is opened or downloaded. A
document type declaration is refused before its first entity, because entities can expand without limit or refer to other
files. Each error is a ValueError with the line.
"""

import math
import os
import re
from dataclasses import dataclass, field
from pathlib import Path

from kinlib.arrays import validation

MAX_BYTES = 4_000_000
"""The largest file that is read: ten times the size of a humanoid robot's, and read in at most two seconds."""


@dataclass(frozen=True, slots=True, eq=False)
class Element:
    """An XML element: its tag, the line where it begins, its attributes, its parent element and its child elements."""

    tag: str
    line: int
    attributes: dict[str, str]
    parent: "Element | None" = field(default=None, repr=False)
    children: list["Element"] = field(default_factory=list, repr=False)

    def error(self, why: str) -> ValueError:
        """Build the error to raise for this element: its message has the line, the element, its parent and the reason."""
        part_of = f" in {self.parent}" if self.parent and "name" not in self.attributes else ""
        return ValueError(f"Line {self.line}, {self}{part_of}: {why}")

    def __str__(self) -> str:
        name = f' name="{self.attributes["name"][:60]}"' if "name" in self.attributes else ""
        return f"<{self.tag:.60}{name}>"

    def child(self, tag: str) -> "Element | None":
        """Return the child with a tag, or None. Raises ValueError if there are several."""
        found = [child for child in self.children if child.tag == tag]
        if len(found) > 1:
            raise self.error(f"it must have at most one <{tag}>; got two, lines {found[0].line} and {found[1].line}.")
        return found[0] if found else None

    def text(self, attribute: str) -> str:
        """Return the value of an attribute. Raises ValueError if it is missing or empty, or has a macro of xacro."""
        if not (value := self.attributes.get(attribute, "")):
            given = " ".join(self.attributes) or "none"
            raise self.error(f"it must have the attribute {attribute}=...; its attributes are: {given:.200}.")
        if "${" in value or "$(" in value:
            raise self.error(f'{attribute}="{value}" must be evaluated by xacro first. {EXPAND_HINT}')
        return value

    def numbers(self, attribute: str, count: int, default: list[float] | None = None) -> list[float]:
        """Read the finite numbers of an attribute; if it is missing, it has its default. Raises ValueError for anything else."""
        if default is not None and attribute not in self.attributes:
            return default
        words = self.text(attribute).split()
        for word in words:
            if not NUMBER.fullmatch(word) or not math.isfinite(float(word)):
                hint = " Separate numbers by spaces." if re.search("[,;]", word) else ""
                raise self.error(f'{attribute} must consist of finite numbers; got "{word}".{hint}')
        if len(words) != count:
            raise self.error(f'{attribute} must have {count} numbers; got {len(words)}: "{" ".join(words)}".')
        return [float(word) for word in words]


NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)

EXPAND_HINT = "Expand the file: xacro robot.urdf.xacro > robot.urdf"


def read_robot(path_or_text: str | os.PathLike[str]) -> Element:
    """Read the <robot> element of a URDF, from a path or from its text.

    Raises ValueError, with the line if there is one, if the file is missing, a directory, empty, too large or not XML, if its
    root is another element, and if it has a document type or macros of xacro.
    """
    # A document type is refused where it begins, so no entity is ever declared. By itself expat opens and downloads nothing.
    from xml.parsers import expat

    text = _text(path_or_text)
    # A text in triple quotes often begins with an empty line, but XML must begin with its declaration: remove and count it.
    document = text.lstrip()
    above = len(text.splitlines()) - len(document.splitlines())
    parser, elements, opened = expat.ParserCreate(), list[Element](), list[Element]()

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, above + parser.CurrentLineNumber, attributes, opened[-1] if opened else None)
        if tag.startswith("xacro:"):
            raise element.error(f"a macro must be evaluated by xacro first. {EXPAND_HINT}")
        (opened[-1].children if opened else elements).append(element)
        opened.append(element)

    def refuse(*_: object) -> None:
        raise ValueError(
            f"Line {above + parser.CurrentLineNumber}, <!DOCTYPE>: a URDF must have no document type, which is not safe. Remove it."
        )

    parser.StartElementHandler, parser.EndElementHandler = start, lambda _tag: opened.pop()
    parser.StartDoctypeDeclHandler = refuse
    try:
        parser.Parse(document, True)
    except (expat.ExpatError, LookupError, UnicodeError) as error:
        raise ValueError(
            f"Line {above + parser.ErrorLineNumber}: the file must be XML in UTF-8; {str(error).partition(':')[0]}. Is a tag not closed?"
        ) from error
    root = elements[0]
    if root.tag != "robot":
        raise root.error("the first element must be <robot>. Pass the URDF of the robot, and not SDF or MJCF.")
    return root


def _text(path_or_text: str | os.PathLike[str]) -> str | bytes:
    """The text itself, or the bytes of the file at a path."""
    if not isinstance(path_or_text, str | os.PathLike):
        raise ValueError(f"path_or_text must be the path or text of a URDF; got {validation.describe(path_or_text)}.")
    if isinstance(path_or_text, str) and path_or_text.lstrip("\ufeff \t\r\n")[:1] in {"<", ""}:
        content: str | bytes = path_or_text.removeprefix("\ufeff")
    else:
        try:
            with Path(path_or_text).open("rb") as file:
                content = file.read(MAX_BYTES + 1)
        except OSError as error:
            raise ValueError(
                f"There is no file {path_or_text!r:.200} to be read: {error.strerror}. Pass the path of a URDF, or its text."
            ) from error
    if not content.strip():
        raise ValueError("A URDF must begin with <robot name=...>; got an empty text or file.")
    if len(content) > MAX_BYTES:
        raise ValueError(f"A URDF must have at most {MAX_BYTES / 1e6:.0f} MB; this one has more. Remove embedded data.")
    return content
