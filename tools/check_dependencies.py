"""Check that each package and each group declares what its files import, and uses what it declares: `nox -s lint`.

deptry compares the imports of some folders with a list of requirements. The lists are those of the pyproject.toml files.
"""

import json
import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.metadata import packages_distributions
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
OURS = ("kinlib", "misstep", "kincourse")

NOT_IMPORTED = {
    "misstep": {"matplotlib": "pictures of a course's own are drawn with it, if it has any"},
    "site": {
        "furo": "site/conf.py names the theme",
        "hatchling": "builds wheels, as a program",
        "ipykernel": "notebooks name it as their kernel",
        "jupyterlite-core": "site/kinsite starts it",
        "jupyterlite-pyodide-kernel": "JupyterLite finds it by an entry point",
        "myst-nb": "site/conf.py names the extension",
        "pip": "downloads wheels, as a program",
        "sphinx-notfound-page": "site/conf.py names the extension",
        "sphinx-sitemap": "site/conf.py names the extension",
        "sphinxcontrib-katex": "site/conf.py names the extension",
        "sphinxext-opengraph": "site/conf.py names the extension",
    },
    "tests": {
        "airo-models": "tests/kinlib/urdf ask for its files by name",
        "deptry": "this file starts it",
        "jupyterlab": "course.py starts it",
        "mutmut": "nox starts it",
        "nbval": "a plug-in of pytest",
        "nox": "noxfile.py is no part of a folder",
        "pytest-xdist": "a plug-in of pytest",
        "ruff": "nox starts it",
    },
}
"""Packages that an area must declare although no file of it imports them, with the reason."""

IMPORTED_IF_THERE = {
    "kincourse": {
        "pinocchio",
        "pytransform3d",
        "roboticstoolbox",
    },  # lecture 09 reads a file with those that are installed
    "tests": {
        "websocket",
        "xacrodoc",
    },  # the lab and airo-models bring them along; only files that run beside these use them
}


@dataclass(frozen=True)
class Area:
    """Folders, the requirements that are declared for them, and others that are there when they run."""

    folders: list[str]
    declared: list[str]
    present: list[str]


def project(folder: str) -> dict[str, object]:
    """Read the pyproject.toml of a folder."""
    return tomllib.loads((ROOT / folder / "pyproject.toml").read_text("utf-8"))


def group(name: str) -> list[str]:
    """The requirements of a dependency group, without those of the groups that it includes."""
    return [item for item in project(".")["dependency-groups"][name] if isinstance(item, str)]


def areas() -> dict[str, Area]:
    """What is checked, by name."""
    packages = {name: project(name)["project"] for name in OURS}
    extras = {
        name: [item for items in one.get("optional-dependencies", {}).values() for item in items]
        for name, one in packages.items()
    }
    course = [*project(".")["project"]["dependencies"], *OURS]
    template = project("misstep/new_course/template")["project"]
    groups = [*group("lab"), *group("oracles"), *group("author"), *group("test")]
    return {
        **{name: Area([name], [*one["dependencies"], *extras[name]], []) for name, one in packages.items()},
        "notebooks": Area(["notebooks", "exercises", "solutions"], [], course),
        "site": Area(["site"], group("site"), course),
        "tests": Area(
            ["tests", "tools", "evidence", "kincourse", "misstep"],
            groups,
            [*course, *group("site"), *group("robots"), *group("benchmarks")],
        ),
        "new course": Area(
            ["misstep/new_course/template"],
            [],
            [*template["dependencies"], *template["optional-dependencies"]["instructor"], "numpy", "my_course"],
        ),
    }


def faults(name: str, area: Area) -> Iterator[str]:
    """Yield what an area imports and does not declare, or declares and does not use."""
    with tempfile.TemporaryDirectory() as folder:
        requirements, settings, report = (Path(folder) / file for file in ("r.txt", "pyproject.toml", "report.json"))
        requirements.write_text("\n".join([*area.declared, *area.present]), "utf-8")
        settings.write_text("[tool.deptry]\n", "utf-8")
        options = [f"--requirements-files={requirements}", f"--config={settings}", f"--json-output={report}"]
        left_out = ".*node_modules" if name == "new course" else ".*node_modules|.*new_course/template"
        folders = [folder for folder in area.folders if (ROOT / folder).exists()]
        command = [
            sys.executable,
            "-m",
            "deptry",
            *folders,
            *options,
            f"--exclude={left_out}",
            "--package-module-name-map=pin=pinocchio",
        ]
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if not report.exists():
            raise RuntimeError(f"deptry must write a report; it printed: {done.stderr}")
        found = json.loads(report.read_text("utf-8"))
    names = {requirement_name(text) for text in area.declared}
    for one in found:
        code, module = one["error"]["code"], one["module"]
        if code == "DEP002":
            if module in names - NOT_IMPORTED.get(name, {}).keys() - set(OURS) and not imported_by_name(module, area):
                yield f"{name} declares {module}, which no file of it imports"
        elif module not in OURS and module not in IMPORTED_IF_THERE.get(name, set()) | local_modules():
            yield f"{one['location']['file']}:{one['location']['line']} imports {module}, which {name} does not declare"
    for package, reason in NOT_IMPORTED.get(name, {}).items():
        if package not in names:
            yield f"{name} does not declare {package}: {reason}"
    if name in OURS:  # to deptry, the packages of this repository are local modules
        text = "".join(path.read_text("utf-8") for path in files_of(area) if "new_course" not in path.parts)
        for package in set(OURS) - names - {name}:
            if re.search(rf"^ *(from|import) {package}\b", text, re.MULTILINE):
                yield f"{name} imports {package}, which it does not declare"


def requirement_name(text: str) -> str:
    """The name in a requirement: `a[b]>=1; c` names a."""
    return text.partition("[")[0].partition(">")[0].partition("=")[0].partition(";")[0].strip().lower()


def imported_by_name(package: str, area: Area) -> bool:
    """Whether a file imports a module of a package by its name as text: importorskip("scipy"), python -m mypy."""
    modules = [module for module, packages in packages_distributions().items() if package in map(str.lower, packages)]
    text = "".join(path.read_text("utf-8") for path in files_of(area))
    return any(re.search(rf"""["']{module}[."' ]|-m {module}\b""", text) for module in modules)


def files_of(area: Area) -> list[Path]:
    """The Python files of an area."""
    return [path for folder in area.folders for path in (ROOT / folder).rglob("*.py")]


@cache
def local_modules() -> set[str]:
    """Modules of this repository that files of other folders import by name, except where a package has the same name."""
    paths = {path for area in areas().values() for path in files_of(area)}
    names = {path.stem for path in paths} | {path.parent.name for path in paths if path.name == "__init__.py"}
    return names - set(packages_distributions())


if __name__ == "__main__":
    all_faults = [fault for name, area in areas().items() for fault in faults(name, area)]
    sys.exit("\n".join(all_faults) or 0)
