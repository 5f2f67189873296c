"""The house: clean code, imports that run downwards, notebooks without output, and files that say what they need and why."""

import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from tidy_notebooks import MARK, tidied

ROOT = Path(__file__).parents[2]
MADE = {".venv", ".uv", ".ipynb_checkpoints"}
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))


def run(*command):
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, encoding="utf-8", check=False)


def files(pattern):
    """What is committed, or would be by the next commit."""
    listed = run("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", pattern)
    if listed.returncode == 0:
        paths = [ROOT / name for name in listed.stdout.split("\0") if name]
    else:  # unpacked from an archive: everything counts but what course.py and Jupyter made
        paths = [path for path in ROOT.rglob(pattern) if not MADE & set(path.parts)]
    return sorted({path for path in paths if path.is_file()})


@pytest.fixture(scope="session")
def committed(tmp_path_factory):
    """The files as git holds them: whoever has worked in a notebook and saved it should still see the tests pass."""
    folder = tmp_path_factory.mktemp("committed")
    done = run("git", "checkout-index", "--all", f"--prefix={folder.as_posix()}/")
    return folder if done.returncode == 0 else ROOT


# --- clean code ---

NO_NOTEBOOKS = ["--config", 'extend-exclude = ["*.ipynb"]']


def finds_nothing(command, *options, where=ROOT):
    done = subprocess.run(
        [sys.executable, "-m", *command.split(), *options],
        cwd=where,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    if done.returncode:
        pytest.fail(f"{command} says:\n{done.stdout}\n{done.stderr}", pytrace=False)


@pytest.mark.parametrize("command", ["ruff check", "ruff format --diff"])
def test_ruff_finds_nothing(command, committed):
    finds_nothing(command, *NO_NOTEBOOKS)
    finds_nothing(command, "notebooks", "solutions", "exercises", where=committed)


def test_mypy_finds_nothing():
    finds_nothing("mypy")


# --- imports ---


def lint_imports(folder, *options):
    """Check the contracts of the pyproject.toml in a folder, on the packages that lie there."""
    script = "import sys; from importlinter.cli import lint_imports; sys.exit(lint_imports(no_cache=True))"
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    done = [sys.executable, "-P", "-c", script]
    return subprocess.run(done, cwd=folder, env=environment, capture_output=True, encoding="utf-8", check=False)


def test_the_import_contracts_are_kept():
    done = lint_imports(ROOT)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize(
    ("module", "line"),
    [
        ("kinlib/rigid/screw.py", "from kinlib.chains.chain import Chain"),
        ("kinlib/rigid/screw.py", "def later():\n    import kinlib.view.drawing.picture"),
        ("kinlib/dh/table.py", "import misstep.text"),
        ("misstep/text.py", "from kinlib import exp"),
        ("misstep/judge.py", "from kincourse.catalog import COURSE"),
        ("misstep/grading/collect/files.py", "from misstep.grading.publish import pages"),
        ("kincourse/lecture_01_frames/problems.py", "from kincourse.lecture_02_matrix_exponential import problems"),
    ],
)
def test_an_import_that_breaks_a_contract_is_reported(tmp_path, module, line):
    for package in ("kinlib", "misstep", "kincourse"):
        shutil.copytree(
            ROOT / package, tmp_path / package, ignore=shutil.ignore_patterns("*.js", "static", "__pycache__")
        )
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    changed = tmp_path / module
    changed.write_text(f"{changed.read_text('utf-8')}\n\n{line}\n", "utf-8")
    done = lint_imports(tmp_path)
    assert done.returncode == 1
    assert "BROKEN" in done.stdout, done.stdout + done.stderr


def test_importing_kinlib_loads_numpy_dataclasses_and_nothing_else():
    """Not even the rest of the standard library: a lecture's first cell is waited for."""
    script = (
        "import sys, numpy.typing, dataclasses; known = {*sys.modules}; import kinlib; print(*{*sys.modules} - known)"
    )
    done = run(sys.executable, "-c", script)
    assert done.returncode == 0, done.stderr
    loaded = {name for name in done.stdout.split() if name.split(".")[0] != "kinlib"}
    assert not loaded, f"load these where they are first used: {sorted(loaded)}"


# --- what is committed ---


def test_no_file_names_the_host_of_a_registry():
    """Where packages come from is the business of each machine: a mirror, a proxy, a disk."""
    dots = ["pypi org", "pythonhosted org", "npmjs org", "npmjs com", "yarnpkg com", "anaconda org", "crates io"]
    hosts = re.compile(rb"\b(" + "|".join(dots).replace(" ", r"\.").encode() + rb")\b")
    named = {path.relative_to(ROOT).as_posix(): hosts.search(path.read_bytes()) for path in files("*")}
    assert not {name: found[0] for name, found in named.items() if found}


def test_versions_are_pinned_in_one_place():
    assert not files("*uv.lock"), "the pins are constraints.txt: uv's lock names the registry that it asked"


def faults_of(notebook, is_lecture=True):
    """Why this notebook should not be committed as it is."""
    if "widgets" in notebook["metadata"]:
        yield "the state of its widgets is saved in it"
    for number, cell in enumerate(notebook["cells"]):
        outputs = cell.get("outputs", [])
        marked = MARK in "".join(cell["source"])
        if not marked and (outputs or cell.get("execution_count")):
            yield f"cell {number} has output or a count of its runs, and no mark {MARK}"
        if marked and bool(outputs) != bool(cell["execution_count"]):
            yield f"cell {number} needs both its output and a count of its runs, or nbval compares nothing"
        if marked and is_lecture and not outputs:
            yield f"cell {number} is marked {MARK} and keeps no output: run it"
        for output in outputs:
            shown = output.get("data", {"text/plain": output.get("text", "")})
            text = "".join(shown.get("text/plain", ""))
            if set(shown) != {"text/plain"} or output.get("name") == "stderr":
                yield f"cell {number} keeps {sorted(shown)}: only printed text is compared"
            if text.count("\n") > 15 or re.search(r"\.\d{11}", text):
                yield f"cell {number} keeps more than 15 lines or 10 decimals: round it, so that every machine agrees"


@pytest.mark.parametrize("path", files("*.ipynb"), ids=lambda path: path.relative_to(ROOT).as_posix())
def test_a_committed_notebook_holds_no_output_but_short_checked_text(path, committed):
    in_git = committed / path.relative_to(ROOT)
    path = in_git if in_git.exists() else path
    faults = list(faults_of(json.loads(path.read_text("utf-8")), is_lecture=path.parent.name == "notebooks"))
    assert not faults, f"{faults[:3]}: try nox -s tidy -- notebooks/*.ipynb"
    assert path.stat().st_size <= 150_000, "at most 150 kB: what makes it large belongs in a file, or in kinlib"


def a_notebook(source="1 / 3", metadata=None, count=None, **output):
    cell = {"cell_type": "code", "metadata": {}, "source": [source], "execution_count": count}
    return {"cells": [{**cell, "outputs": [output] if output else []}], "metadata": metadata or {}}


CHECKED = MARK + "\n1 / 3"


@pytest.mark.parametrize(
    "notebook",
    [
        a_notebook(text="0.333"),
        a_notebook(count=1),
        a_notebook(metadata={"widgets": {}}),
        a_notebook(CHECKED),
        a_notebook(CHECKED, text="0.333"),
        a_notebook(CHECKED, count=1, data={"text/plain": "<Figure>", "image/png": "..."}),
        a_notebook(CHECKED, count=1, data={"text/plain": ["0.3333333333333333"]}),
        a_notebook(CHECKED, count=1, text="0\n" * 20),
        a_notebook(CHECKED, count=1, text="a warning", name="stderr"),
    ],
)
def test_a_notebook_to_tidy_is_noticed(notebook):
    assert list(faults_of(notebook))


@pytest.mark.parametrize(
    "notebook",
    [
        a_notebook(),
        a_notebook(CHECKED, count=1, text="0.333"),
        a_notebook(CHECKED, count=1, data={"text/plain": "1"}),
        tidied(a_notebook(count=7, metadata={"widgets": {}}, data={"image/png": "..."})),
        tidied(a_notebook(CHECKED, count=7, execution_count=7, data={"text/plain": "1", "image/png": "..."})),
    ],
)
def test_a_tidy_notebook_is_let_be(notebook):
    assert not list(faults_of(notebook))


# --- what the project says of itself ---


def name_of(requirement):
    return re.match(r"[\w.-]+", requirement)[0].lower().replace("_", "-")


def dependencies():
    project = PROJECT["project"]
    groups = [*PROJECT["dependency-groups"].values(), *project.get("optional-dependencies", {}).values()]
    named = [
        *PROJECT["build-system"]["requires"],
        *project["dependencies"],
        *(item for group in groups for item in group),
    ]
    return {name_of(requirement) for requirement in named if isinstance(requirement, str)}


def test_contributing_says_why_each_dependency_is_here():
    lines = (ROOT / "CONTRIBUTING.md").read_text("utf-8").partition("## Dependencies")[2].partition("\n## ")[0]
    assert set(re.findall(r"^- `([\w.-]+)`: \w.{9}", lines, re.MULTILINE)) == dependencies()


def test_every_dependency_is_pinned():
    pins = {name_of(line) for line in (ROOT / "constraints.txt").read_text("utf-8").splitlines() if line[0] not in "# "}
    assert dependencies() - pins == set(), "run: nox -s pin"


PACKAGES = {
    name: tomllib.loads((ROOT / name / "pyproject.toml").read_text("utf-8"))
    for name in ("kinlib", "misstep", "kincourse")
}


def test_the_workspace_installs_what_the_packages_say():
    """The three packages are installed together from the root; their wheels are built from their own folders."""
    projects = [package["project"] for package in PACKAGES.values()]
    needed = {name_of(item) for project in projects for item in project["dependencies"]} - set(PACKAGES)
    assert needed <= {name_of(item) for item in PROJECT["project"]["dependencies"]}
    scripts = {name: target for project in projects for name, target in project.get("scripts", {}).items()}
    assert PROJECT["project"]["scripts"] == scripts
    assert PROJECT["project"]["entry-points"] == PACKAGES["kincourse"]["project"]["entry-points"]
    assert PROJECT["tool"]["hatch"]["build"]["targets"]["wheel"] == {"packages": [*PACKAGES]}
    assert [item for item in PACKAGES["misstep"]["project"]["dependencies"] if name_of(item) != "numpy"] == []


def test_what_an_extra_needs_is_installed_for_the_tests():
    extras = PACKAGES["misstep"]["project"]["optional-dependencies"].values()
    assert {name_of(item) for items in extras for item in items} <= dependencies() | {"ipython"}


def test_the_version_is_said_once_everywhere():
    import kincourse
    import kinlib
    import misstep

    version = PROJECT["project"]["version"]
    assert kinlib.__version__ == misstep.__version__ == kincourse.__version__ == version
    assert f"\nversion: {version}\n" in (ROOT / "CITATION.cff").read_text("utf-8")
    assert f"## [{version}]" in (ROOT / "CHANGELOG.md").read_text("utf-8")
