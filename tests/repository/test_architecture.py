"""Import contracts, notebooks without output, consistent dependencies and versions, and a wheel with every file."""

import copy
import json
import os
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

from tidy_notebooks import TAG, is_checked, tidied

ROOT = Path(__file__).parents[2]
GENERATED = {".venv", ".ipynb_checkpoints"}
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))


def run(*command, **options):
    return subprocess.run(command, cwd=ROOT, capture_output=True, encoding="utf-8", check=False, **options)


def files(pattern):
    """List the files that are committed, or would be by the next commit."""
    listed = run("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", pattern)
    if listed.returncode == 0:
        paths = [ROOT / name for name in listed.stdout.split("\0") if name]
    else:  # unpacked from an archive: all files except those that course.py and Jupyter generated
        paths = [path for path in ROOT.rglob(pattern) if not GENERATED & set(path.parts)]
    return sorted({path for path in paths if path.is_file()})


# --- imports ---


def test_the_import_contracts_are_kept():
    """Those of pyproject.toml, of the packages in this folder."""
    script = "import sys; from importlinter.cli import lint_imports; sys.exit(lint_imports(no_cache=True))"
    done = run(sys.executable, "-P", "-c", script, env={**os.environ, "PYTHONPATH": str(ROOT)})
    assert done.returncode == 0, done.stdout


def test_a_lecture_is_imported_by_itself_alone_and_imports_nothing_that_lists_lectures():
    """import-linter has no pattern for the names of lectures, and a new one need not be listed."""
    for path in sorted((ROOT / "kincourse").rglob("*.py")):
        own = path.relative_to(ROOT / "kincourse").parts[0]
        imported = set(re.findall(r"\b(?:from|import) kincourse\.(\w+)", path.read_text("utf-8")))
        assert {name for name in imported if name.startswith("lecture_")} <= {own}, path
        if own.startswith("lecture_"):
            assert not imported & {"catalog", "new_sheet", "robot_sheets", "table_of_lectures"}, path


def test_importing_kinlib_loads_numpy_dataclasses_and_nothing_else():
    """Not even other modules of the standard library, because students wait for the first cell of a lecture."""
    script = "import sys, __future__, numpy.typing, dataclasses; known = {*sys.modules}; import kinlib; print(*{*sys.modules} - known)"
    done = run(sys.executable, "-c", script)
    assert done.returncode == 0, done.stderr
    loaded = {name for name in done.stdout.split() if name.split(".")[0] != "kinlib"}
    assert not loaded, f"load these where they are first used: {sorted(loaded)}"


# --- what is committed ---


def test_no_file_names_the_host_of_a_registry():
    """Each machine configures where its packages come from: a mirror, a proxy or a folder."""
    dots = ["pypi org", "pythonhosted org", "npmjs org", "npmjs com", "yarnpkg com", "anaconda org", "crates io"]
    hosts = re.compile(rb"\b(" + "|".join(dots).replace(" ", r"\.").encode() + rb")\b")
    matches = {path.relative_to(ROOT).as_posix(): hosts.search(path.read_bytes()) for path in files("*")}
    assert not {name: match[0] for name, match in matches.items() if match}


def differences(notebook):
    """Yield why a notebook must not be committed: it is not tidy, or a checked output differs from machine to machine."""
    if tidied(copy.deepcopy(notebook)) != notebook:
        yield "it has outputs, or what differs from run to run: try python tests/support/tidy_notebooks.py notebooks/*.ipynb"
    for number, cell in enumerate(notebook["cells"]):
        for output in cell.get("outputs", []):
            text = "".join(output.get("data", {}).get("text/plain", output.get("text", "")))
            if not text or output.get("name") == "stderr" or text.count("\n") > 15 or re.search(r"\.\d{11}", text):
                yield f"cell {number} must show printed text, of at most 15 lines and 10 decimals"


def test_a_committed_notebook_has_no_output_except_short_checked_text(committed):
    for name in (path.relative_to(ROOT) for path in files("*.ipynb")):
        path = committed / name if (committed / name).exists() else ROOT / name
        notebook = json.loads(path.read_text("utf-8"))
        assert list(differences(notebook)) == [], name
        if path.parent.name == "notebooks":
            marked = [cell for cell in notebook["cells"] if is_checked(cell)]
            assert all(cell["outputs"] for cell in marked), f"{name}: run the cells with the tag {TAG}"
        assert path.stat().st_size <= 150_000, f"{name}: at most 150 kB; move large content to kinlib"


# --- dependencies ---


def name_of(requirement):
    return re.match(r"[\w.-]+", requirement)[0].lower().replace("_", "-")


def test_every_dependency_is_pinned():
    project = PROJECT["project"]
    groups = [*PROJECT["dependency-groups"].values(), *project.get("optional-dependencies", {}).values()]
    requirements = [
        *PROJECT["build-system"]["requires"],
        *project["dependencies"],
        *(item for group in groups for item in group),
    ]
    named = {name_of(requirement) for requirement in requirements if isinstance(requirement, str)}
    pins = {name_of(line) for line in (ROOT / "constraints.txt").read_text("utf-8").splitlines() if line[0] not in "# "}
    assert named - pins == set(), "write it anew: guides/dependencies.md"


def test_the_wheel_has_every_file_of_the_packages(tmp_path):
    done = run(sys.executable, "-P", "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path))
    assert done.returncode == 0, done.stderr
    (wheel,) = tmp_path.glob("*.whl")
    built = {name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name}
    paths = [path for package in ("kinlib", "misstep", "kincourse") for path in (ROOT / package).rglob("*")]
    packed = {path.relative_to(ROOT).as_posix() for path in paths if path.is_file() and path.suffix != ".pyc"}
    assert built == {file for file in packed if ".ipynb_checkpoints" not in file and "node_modules" not in file}
