"""The XML of a URDF, read without trust: elements that know the line where they stand.

A URDF comes from anywhere. It is read whole or refused, within bounds on its size and depth, and nothing that it names is
opened or fetched: a document type, which is how entities grow or reach for other files, is refused before its first
entity. Each refusal is a ValueError with the line.
"""

import math
import os
import re
from dataclasses import dataclass, field
from io import BytesIO, StringIO
from pathlib import Path
from typing import Any

from kinlib.arrays import validation

LARGEST = 4_000_000
"""The largest file that is read, in bytes: ten times what a humanoid takes, and read in two seconds at most."""

DEEPEST = 100
"""How deep elements may stand in each other. A mesh of a link stands at the fifth place, simulators go on to the tenth."""

LONGEST = 1000
"""The longest name and the longest list of numbers, in letters: more is no name, and would drown the message about it."""

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)

OTHERS = {"sdf": "an SDF file", "mujoco": "a MuJoCo file", "COLLADA": "a mesh", "html": "a page of the web"}
"""What files with another first element are; people have them beside their URDF."""


@dataclass(frozen=True, slots=True, eq=False)
class Element:
    """An element of the file: its tag, the line where it begins, what it says, in what it stands, what stands in it."""

    tag: str
    line: int
    attributes: dict[str, str]
    inside: "Element | None" = field(default=None, repr=False)
    children: list["Element"] = field(default_factory=list, repr=False)

    def refusal(self, why: str) -> ValueError:
        """The error to raise for this element: it names the line, the element, the one that it is part of, and why.

        >>> elbow = Element("joint", 7, {"name": "elbow"})
        >>> Element("axis", 8, {"xyz": "0 0"}, elbow).refusal("it is too short.")
        ValueError('Line 8, <axis> in <joint name="elbow">: it is too short.')
        """
        part_of = f" in {self.inside}" if self.inside and "name" not in self.attributes else ""
        return ValueError(f"Line {self.line}, {self}{part_of}: {why}")

    def __str__(self) -> str:
        name = f' name="{self.attributes["name"][:60]}"' if "name" in self.attributes else ""
        return f"<{self.tag:.60}{name}>"

    def only(self, tag: str) -> "Element | None":
        """The child with a tag, or None. Raises ValueError where there are two."""
        found = [child for child in self.children if child.tag == tag]
        if len(found) > 1:
            raise self.refusal(f"it has <{tag}> twice, in lines {found[0].line} and {found[1].line}. Which one holds?")
        return found[0] if found else None

    def word(self, attribute: str) -> str:
        """What an attribute says. Raises ValueError where it is missing or empty, and for a macro left in it."""
        if not (word := self.attributes.get(attribute, "")):
            came = " ".join(self.attributes) or "nothing"
            raise self.refusal(f"it should say {attribute}=...; it says {came:.200}.")
        if len(word) > LONGEST:
            raise self.refusal(f'{attribute}="{word[:20]}..." runs on for {len(word)} letters.')
        if "${" in word or "$(" in word:
            raise self.refusal(f'{attribute}="{word}" is for xacro to work out. {EXPAND}')
        return word

    def numbers(self, attribute: str, count: int) -> list[float]:
        """The finite numbers that an attribute holds. Raises ValueError for anything else, and for another count.

        >>> Element("axis", 7, {"xyz": "0 0 1"}).numbers("xyz", 3)
        [0.0, 0.0, 1.0]
        """
        words = self.word(attribute).split()
        for word in words:
            if not NUMBER.fullmatch(word) or not math.isfinite(float(word)):
                blanks = " Numbers are separated by blanks." if re.search("[,;]", word) else ""
                raise self.refusal(f'{attribute} should hold finite numbers; got "{word}".{blanks}')
        if len(words) != count:
            raise self.refusal(f'{attribute} should hold {count} numbers; got {len(words)}: "{" ".join(words)}".')
        return [float(word) for word in words]


EXPAND = "Expand the file first, as in: xacro robot.urdf.xacro > robot.urdf."


def read_robot(path_or_text: str | os.PathLike[str]) -> Element:
    """Read the <robot> element of a URDF, from a path or from its text.

    Raises ValueError, with the line wherever there is one, for what is no such file: missing, a directory, empty, too
    large, not XML, another root, nested too deep, a document type, macros of xacro left in.

    >>> read_robot('<robot name="arm"><link name="base"/></robot>').children
    [Element(tag='link', line=1, attributes={'name': 'base'})]
    """
    from xml.sax import SAXParseException
    from xml.sax.xmlreader import InputSource

    from defusedxml.common import DefusedXmlException
    from defusedxml.expatreader import DefusedExpatParser

    text = _text(path_or_text)
    # A text in triple quotes starts with an empty line, and XML wants its declaration first: take it off, and count it.
    blank = len(text) - len(text.lstrip())
    source = InputSource()
    if isinstance(text, str):
        source.setCharacterStream(StringIO(text[blank:]))
        above = text.count("\n", 0, blank)
    else:
        source.setByteStream(BytesIO(text[blank:]))
        above = text.count(b"\n", 0, blank)
    builder = _builder(above)
    parser = DefusedExpatParser(forbid_dtd=True)
    parser.setContentHandler(builder)
    try:
        parser.parse(source)
    except DefusedXmlException as error:
        raise ValueError(
            f"Line {above + parser.getLineNumber()}, <!DOCTYPE>: a URDF has no document type and no entities, and those "
            "of others are not trusted. Take the declaration out."
        ) from error
    except SAXParseException as error:
        line, why = above + (error.getLineNumber() or 1), error.getMessage()
        raise ValueError(f"Line {line}: this is not XML: {why}.{_likely(why)}") from error
    except (LookupError, UnicodeError) as error:
        raise ValueError(
            f"Line {above + parser.getLineNumber()}: {error}. Save the file as UTF-8, and say so."
        ) from error
    root: Element = builder.root
    if root.tag != "robot":
        came = OTHERS.get(root.tag, f"<{root.tag:.60}>")
        raise root.refusal(f"the first element of a URDF is <robot>; this is {came}.")
    return root


def _text(path_or_text: str | os.PathLike[str]) -> Any:
    """The text itself, or the bytes of the file that a path names."""
    if not isinstance(path_or_text, str | os.PathLike):
        raise ValueError(f"A URDF is a path or a text; got {validation.describe(path_or_text)}.")
    if isinstance(path_or_text, str):
        text = path_or_text.removeprefix("\ufeff")
        if not text.strip():
            raise ValueError("The text is empty: a URDF begins with <robot name=...>.")
        if text.lstrip().startswith("<"):
            _bounded(len(text), "text")
            return text
    return _bytes(path_or_text)


def _bytes(path: str | os.PathLike[str]) -> bytes:
    if isinstance(path, str) and re.match(r"\w{2,}://", path):
        raise ValueError(f"{path!r:.200} is an address, and nothing is fetched. Save the file, and give its path.")
    try:
        if not Path(path).is_file():
            found = f"{path!r:.200} is a directory" if Path(path).is_dir() else f"There is no file {path!r:.200}"
            raise ValueError(f"{found}. Give the path of a URDF, or its text, which begins with <.")
        _bounded(Path(path).stat().st_size, "file")
        with Path(path).open("rb") as file:
            # A file may grow between the look at its size and now.
            content = file.read(LARGEST + 1)
    except OSError as error:
        raise ValueError(f"{path!r:.200} cannot be read: {error.strerror}.") from error
    _bounded(len(content), "file")
    if not content.strip():
        raise ValueError(f"The file {path!r:.200} is empty: a URDF begins with <robot name=...>.")
    return content


def _bounded(size: int, what: str) -> None:
    if size > LARGEST:
        raise ValueError(
            f"The {what} holds {size / 1e6:.1f} MB; a URDF of more than {LARGEST / 1e6:.0f} MB is not read."
        )


def _likely(why: str) -> str:
    if "invalid token" in why:
        return " Is a quote missing, is there a bare & or <, or is the file not saved as UTF-8?"
    if "mismatched tag" in why:
        return " An element opened above is not closed, or closed by another name."
    if "no element found" in why:
        return " Does the file end too early?"
    return ""


def _builder(above: int) -> Any:
    """A listener that builds the elements, in a document with so many lines above it."""
    from xml.sax.handler import ContentHandler

    class Builder(ContentHandler):
        root: Element
        line: Any

        def __init__(self) -> None:
            super().__init__()
            self.open: list[Element] = []

        def setDocumentLocator(self, locator: Any) -> None:
            self.line = locator.getLineNumber

        def startElement(self, tag: str, attributes: Any) -> None:
            element = Element(tag, above + self.line(), dict(attributes), self.open[-1] if self.open else None)
            if tag.startswith("xacro:"):
                raise element.refusal(f"a macro is for xacro to work out. {EXPAND}")
            if len(self.open) == DEEPEST:
                raise element.refusal(f"it stands {DEEPEST} elements deep. Is one above it never closed?")
            if self.open:
                self.open[-1].children.append(element)
            else:
                self.root = element
            self.open.append(element)

        def endElement(self, _tag: str) -> None:
            self.open.pop()

    return Builder()
