"""The reference: what kinlib's docstrings say, module by module, in the order in which the library is read.

The docstrings are plain text, made to be read where they stand; so they are laid out here and not parsed as markup.
"""

import importlib
import inspect
import re
from collections.abc import Iterator
from functools import cache
from types import ModuleType
from typing import Any

from numpy.typing import ArrayLike
from sphinx.util.inspect import stringify_signature
from sphinx.util.typing import stringify_annotation

from kinlib.arrays.validation import Array

MODULES = {
    "Rigid motions": ["kinlib.rigid.lie", "kinlib.rigid.rpy", "kinlib.rigid.screw"],
    "Open chains": ["kinlib.chains.chain", "kinlib.chains.robots"],
    "Denavit-Hartenberg": [
        *("kinlib.dh.table", "kinlib.dh.assignment", "kinlib.dh.rules", "kinlib.dh.equivalence", "kinlib.dh.diagnosis"),
    ],
    "Closed chains": [
        *("kinlib.mechanisms.joints", "kinlib.mechanisms.mechanism", "kinlib.mechanisms.closure"),
        *("kinlib.mechanisms.mobility", "kinlib.mechanisms.linkages"),
    ],
    "Files and symbols": ["kinlib.urdf.chains", "kinlib.symbolic"],
    "What people look at": ["kinlib.view", "kinlib.view.drawing.picture", "kinlib.view.viewer.viewer"],
    "The course": ["kincourse"],
    "The engine": ["misstep", "misstep.sheet", "misstep.questions.widget", "misstep.problem", "misstep.verdict"],
}
"""The modules that others may rely on, in reading order. Packages show what they export, and their modules the rest."""

SPECIAL = re.compile(r"([\\`*_{}\[\]<>$|~^#])")
ALIASES = {name: stringify_annotation(kind, "smart") for name, kind in {"ArrayLike": ArrayLike, "Array": Array}.items()}
"""Types whose names say more than what they stand for."""

OURS = re.compile(r"~?(?:kinlib|misstep|kincourse)(?:\.\w+)+")
DEFINED = re.compile(r"^(\S.{,40}?)(?:  +|(?<=\)) +(?=->))(\S.*)$")
"""A line in two columns, or one that says which shapes become which."""


def pages() -> Iterator[tuple[str, str]]:
    """One page a module, and one that leads to them."""
    lists = []
    for title, names in MODULES.items():
        lists.append(f"## {title}\n")
        for name in names:
            module = importlib.import_module(name)
            yield f"reference/{name}.md", page(module)
            lists.append(f"- [`{name}`]({name}.md): {escape(first_line(module))}")
        lists.append("")
    tree = "\n".join(name for names in MODULES.values() for name in names)
    yield "reference/index.md", OVERVIEW.format(lists="\n".join(lists), tree=tree)


OVERVIEW = """\
# Reference

`import kinlib as kl` gives you what most lectures need: `kl.exp`, `kl.screw`, `kl.Chain`, `kl.DHTable`,
`kl.assign_frames`, `kl.Mechanism`, `kl.load_urdf`, `kl.robots` and their neighbours. Here is everything, module by
module, in the order in which the library is best read.

{lists}

```{{toctree}}
:hidden:

{tree}
```
"""


def page(module: ModuleType) -> str:
    """What a module offers, in the order in which it stands there."""
    parts = [f"# `{module.__name__}`", prose(inspect.getdoc(module) or "")]
    for name, member in members(module):
        parts.append(described(module, name, member))
    return "\n\n".join(parts) + "\n"


def members(module: ModuleType) -> list[tuple[str, Any]]:
    """The public classes and functions that a module defines; of a package, those that it exports."""
    if hasattr(module, "__path__"):
        found = [(name, getattr(module, name)) for name in module.__all__]
        return [(name, member) for name, member in found if inspect.isclass(member) or inspect.isfunction(member)]
    package = importlib.import_module(module.__name__.rpartition(".")[0])
    exported = getattr(package, "__all__", ()) if package.__name__ not in ("kinlib", "misstep", "kincourse") else ()
    own = [
        (name, member)
        for name, member in vars(module).items()
        if not name.startswith("_")
        and name not in exported
        and (inspect.isclass(member) or inspect.isfunction(member))
        and member.__module__ == module.__name__
    ]
    return sorted(own, key=lambda pair: inspect.getsourcelines(pair[1])[1])


def described(module: ModuleType, name: str, member: Any) -> str:
    """A class with what it has and does, or a function: as a directive, so that pages can refer to it."""
    if inspect.isclass(member):
        inside = [prose(inspect.getdoc(member) or "", doctest=True)]
        inside += [
            directive(kind, f"{part}{signature(value)}", prose(inspect.getdoc(value) or "", doctest=True))
            for part, kind, value in attributes(member)
        ]
        return directive("py:class", f"{name}{signature(member)}", "\n\n".join(inside), module.__name__)
    return directive(
        "py:function", f"{name}{signature(member)}", prose(inspect.getdoc(member) or "", doctest=True), module.__name__
    )


def attributes(kind: type) -> Iterator[tuple[str, str, Any]]:
    """The public methods and properties that a class itself defines and explains."""
    for name, value in vars(kind).items():
        if name.startswith("_"):
            continue
        if isinstance(value, classmethod | staticmethod):
            yield name, "py:classmethod", value.__func__
        elif inspect.isfunction(value) and value.__doc__:
            yield name, "py:method", value
        elif (isinstance(value, property) or hasattr(value, "func")) and value.__doc__:
            yield name, "py:property", value


def signature(member: Any) -> str:
    """How something is called, with its types; nothing for a property."""
    if not callable(member):
        return ""
    try:
        found = inspect.signature(member)
    except ValueError:
        return ""
    inner = list(found.parameters.values())
    if inner and inner[0].name in ("self", "cls"):
        found = found.replace(parameters=inner[1:])
    if inspect.isclass(member):
        found = found.replace(return_annotation=inspect.Signature.empty)
    written = stringify_signature(found, unqualified_typehints=True).replace("\n", " ")
    for name, spelled in ALIASES.items():
        written = written.replace(spelled, name)
    return OURS.sub(lambda name: places().get(name[0].lstrip("~"), name[0].rpartition(".")[2]), written)


@cache
def places() -> dict[str, str]:
    """Where each documented class stands: by the name of the module that defines it, the name that refers to its page."""
    found = {}
    for name in (name for names in MODULES.values() for name in names):
        module = importlib.import_module(name)
        for part, member in members(module):
            found[f"{member.__module__}.{part}"] = f"~{module.__name__}.{part}"
    return found


def directive(kind: str, head: str, inside: str, module: str = "") -> str:
    """A directive of the Python domain, fenced by more colons than what is inside."""
    fence = ":" * (max([2, *(len(found) for found in re.findall(r"^:{3,}", inside, re.MULTILINE))]) + 1)
    options = f"\n:module: {module}" if module else ""
    return f"{fence}{{{kind}}} {head}{options}\n\n{inside}\n{fence}"


def prose(text: str, doctest: bool = False) -> str:
    """A docstring as Markdown: paragraphs, aligned lists as definitions, examples as code.

    doctest  whether examples are shown; elsewhere they are left out
    """
    parts = []
    for block in re.split(r"\n\s*\n", text.strip()):
        if block.startswith(">>>"):
            parts += [f"```pycon\n{block}\n```"] if doctest else []
        elif block.startswith("    "):
            parts.append(f"```text\n{inspect.cleandoc(block)}\n```")
        else:
            parts.append(paragraph(block))
    return "\n\n".join(parts)


def paragraph(block: str) -> str:
    r"""Running text, and what is listed in two columns as definitions, in the order in which they stand.

    >>> print(paragraph("(..., 3) -> (..., 3, 3), the matrix.\nIt is skew."))
    `(..., 3)`
    : -\> (..., 3, 3), the matrix.
    <BLANKLINE>
    It is skew.
    """
    said: list[str] = []
    listed = False
    for line in block.split("\n"):
        word, _, rest = line.partition(" ")
        if listed and line.startswith("  "):
            said.append(f"  {escape(line.strip())}")
        elif found := DEFINED.match(line):
            said.append(f"\n`{found[1].strip()}`\n: {escape(found[2])}")
            listed = True
        else:
            apart = "\n" if listed or word in ("Raises", "Source:") else ""
            said.append(apart + (f"**{word}** {escape(rest)}" if word in ("Raises", "Source:") else escape(line)))
            listed = False
    return "\n".join(said).strip("\n")


def escape(text: str) -> str:
    """Plain text, safe within Markdown; `code` stays code."""
    parts = re.split(r"(`[^`]+`)", text)
    return "".join(part if part[:1] == "`" and len(part) > 1 else SPECIAL.sub(r"\\\1", part) for part in parts)


def first_line(module: ModuleType) -> str:
    """The line that says what a module is."""
    return (inspect.getdoc(module) or "").split("\n", 1)[0]
