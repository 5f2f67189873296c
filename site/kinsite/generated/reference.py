"""The reference: the docstrings of the three packages, module by module, in reading order.

kinsite.markdown turns the docstrings into Markdown.
"""

import importlib
import inspect
import re
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from types import ModuleType
from typing import Any

from numpy.typing import ArrayLike
from sphinx.util.inspect import stringify_signature
from sphinx.util.typing import stringify_annotation

import kinlib
from kincourse import COURSE
from kinlib.arrays.validation import Array
from kinsite.markdown import escape, prose

MODULES = {
    "Rigid motions": ["kinlib.rigid.lie", "kinlib.rigid.rpy", "kinlib.rigid.screw"],
    "Open chains": ["kinlib.chains.chain", "kinlib.chains.robots"],
    "Denavit-Hartenberg": [
        *("kinlib.dh.table", "kinlib.dh.assignment", "kinlib.dh.rules", "kinlib.dh.equivalence", "kinlib.dh.diagnosis"),
    ],
    "Closed chains": [
        *("kinlib.mechanisms.joints", "kinlib.mechanisms.mechanism"),
        *("kinlib.mechanisms.mobility", "kinlib.mechanisms.linkages"),
    ],
    "Files and symbols": ["kinlib.urdf.chains", "kinlib.urdf.robot_tree", "kinlib.symbolic"],
    "Figures": ["kinlib.view", "kinlib.view.viewer.viewer"],
    "Drawings of one lecture": [
        f"kincourse.lecture_{name}.drawings"
        for name in COURSE.lectures
        if find_spec(f"kincourse.lecture_{name}.drawings")
    ],
    "The course": ["kincourse"],
    "The engine": ["misstep", "misstep.sheet", "misstep.questions.widget", "misstep.problem", "misstep.verdict"],
}
"""The modules with a public interface, in reading order. A package lists what it exports, its modules list the rest."""

ALIASES = {name: stringify_annotation(kind, "smart") for name, kind in {"ArrayLike": ArrayLike, "Array": Array}.items()}
"""Types that a signature shows by their short names."""

OWN_NAME = re.compile(r"~?(?:kinlib|misstep|kincourse)(?:\.\w+)+")


def pages() -> Iterator[tuple[str, str]]:
    """Yield one page for each module, and an overview."""
    lists = []
    for title, names in MODULES.items():
        lists.append(f"## {title}\n")
        for name in names:
            module = importlib.import_module(name)
            yield f"reference/{name}.md", page(module)
            first_line = (inspect.getdoc(module) or "").partition("\n")[0]
            lists.append(f"- [`{name}`]({name}.md): {escape(first_line)}")
        lists.append("")
    jobs = next(block for block in re.split(r"\n\s*\n", inspect.getdoc(kinlib) or "") if block.startswith(">>>"))
    tree = "\n".join(name for names in MODULES.values() for name in names)
    yield "reference/index.md", OVERVIEW.format(jobs=jobs, lists="\n".join(lists), tree=tree)


OVERVIEW = """\
# Reference

`import kinlib as kl` provides what most lectures need: `kl.exp`, `kl.screw`, `kl.Chain`, `kl.DHTable`,
`kl.assign_frames`, `kl.Mechanism`, `kl.load_urdf`, `kl.Tree`, `kl.robots` and related functions. These pages describe everything,
module by module, in reading order.

## Twelve jobs

```pycon
{jobs}
```

{lists}

```{{toctree}}
:hidden:

{tree}
```
"""


def page(module: ModuleType) -> str:
    """Write the page of a module, in the order of its source."""
    # Names in signatures are looked for in this module first: some are exported by their package, too.
    here = f":::{{py:currentmodule}} {module.__name__}\n:::"
    parts = [f"# `{module.__name__}`", prose(inspect.getdoc(module) or ""), here]
    parts += [describe(module, name, member) for name, member in members(module)]
    return "\n\n".join(parts) + "\n"


def members(module: ModuleType) -> list[tuple[str, Any]]:
    """List the public classes and functions that a module defines; of a package, those that it exports."""
    if hasattr(module, "__path__"):
        return [(name, one) for name in module.__all__ if is_member(one := getattr(module, name))]
    package = importlib.import_module(module.__name__.rpartition(".")[0])
    exported = getattr(package, "__all__", ()) if package.__name__ not in ("kinlib", "misstep", "kincourse") else ()
    found = [(name, one) for name, one in vars(module).items() if not name.startswith("_") and name not in exported]
    own = [(name, one) for name, one in found if is_member(one) and one.__module__ == module.__name__]
    return sorted(own, key=lambda pair: inspect.getsourcelines(pair[1])[1])


def is_member(value: Any) -> bool:
    """Whether a value has a place in the reference."""
    return inspect.isclass(value) or inspect.isfunction(value)


def describe(module: ModuleType, name: str, member: Any) -> str:
    """Write a function, or a class with its methods and properties, as a directive to which other pages can refer."""
    parts = [prose(inspect.getdoc(member) or "", doctest=True)]
    if inspect.isclass(member):
        parts += [
            directive(kind, f"{part}{signature(value)}", prose(inspect.getdoc(value) or "", doctest=True))
            for part, kind, value in attributes(member)
        ]
    kind = "py:class" if inspect.isclass(member) else "py:function"
    return directive(kind, f"{name}{signature(member)}", "\n\n".join(parts), module.__name__)


def attributes(kind: type) -> Iterator[tuple[str, str, Any]]:
    """Yield the public methods and properties that a class defines and documents, or shares with others that take joint values."""
    documented = [base for base in kind.__mro__ if base is kind or base.__name__.startswith("Takes")]
    for name, value in {name: value for base in reversed(documented) for name, value in vars(base).items()}.items():
        if name.startswith("_"):
            continue
        if isinstance(value, classmethod | staticmethod):
            yield name, "py:classmethod", value.__func__
        elif value.__doc__ and (inspect.isfunction(value) or isinstance(value, property) or hasattr(value, "func")):
            yield name, "py:method" if inspect.isfunction(value) else "py:property", value


def signature(member: Any) -> str:
    """Write the signature of a function, method or class, with its types. A property has none."""
    if not callable(member):
        return ""
    parsed = inspect.signature(member)
    parameters = list(parsed.parameters.values())
    if parameters and parameters[0].name in ("self", "cls"):
        parsed = parsed.replace(parameters=parameters[1:])
    if inspect.isclass(member):
        parsed = parsed.replace(return_annotation=inspect.Signature.empty)
    text = stringify_signature(parsed, unqualified_typehints=True).replace("\n", " ")
    for name, full_type in ALIASES.items():
        text = text.replace(full_type, name)
    return OWN_NAME.sub(lambda name: link_targets().get(name[0].lstrip("~"), name[0].rpartition(".")[2]), text)


@cache
def link_targets() -> dict[str, str]:
    """Map each documented name, in the module that defines it, to the name under which its page is found."""
    modules = [importlib.import_module(name) for names in MODULES.values() for name in names]
    return {
        f"{member.__module__}.{part}": f"~{one.__name__}.{part}" for one in modules for part, member in members(one)
    }


def directive(kind: str, head: str, content: str, module: str = "") -> str:
    """Write a directive of the Python domain, fenced by more colons than any directive in its content."""
    fence = ":" * (max([2, *(len(colons) for colons in re.findall(r"^:{3,}", content, re.MULTILINE))]) + 1)
    options = f"\n:module: {module}" if module else ""
    return f"{fence}{{{kind}}} {head}{options}\n\n{content}\n{fence}"
