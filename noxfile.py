"""Tasks of maintainers. `nox --list` shows them; arguments after `--` go to the tool: `nox -s mutation -- screw`.

All sessions use the environment that `python course.py test` makes: `.venv/bin/python -m nox -s lint`.
"""

import json
import os
import re
import sys
from importlib.metadata import version
from pathlib import Path

import nox

nox.needs_version = ">=2025.5"
nox.options.default_venv_backend = "none"
nox.options.sessions = ["lint"]

PYTHON = sys.executable
PINS = "constraints.txt"
PACKAGES = ("kinlib", "misstep", "kincourse")
PYTHONS = re.findall(r"Python :: (3\.\d+)", Path("pyproject.toml").read_text("utf-8"))
UPLOADERS = (("twine==6.0.1", "pkginfo==1.12.0"), ("twine==6.1.0", "packaging==24.2"), ("twine", "packaging"))
"""What may upload a release: an action of GitHub brings along a version of its own, and each refuses metadata that it does not know."""
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


def run_pytest(session: nox.Session, *arguments: str, **settings: str) -> None:
    """Run pytest with this session's own arguments after the given ones."""
    session.run(PYTHON, "-m", "pytest", *arguments, *session.posargs, env=settings)


@nox.session
def lint(session: nox.Session) -> None:
    """Find mistakes without running the code: ruff, the format, types, dependencies that are not declared or not used."""
    session.run(PYTHON, "-m", "ruff", "check")
    session.run(PYTHON, "-m", "ruff", "format", "--check")
    session.run(PYTHON, "-m", "mypy")
    for package in PACKAGES:
        with session.chdir(package):
            session.run(PYTHON, "-m", "deptry", ".")
    session.run(PYTHON, "-m", "deptry", "notebooks", "exercises", "solutions")
    check_groups(session, ["site"], ["site"])
    # Some tests use what only the lab or a package of robots brings along, and only beside these.
    brought = "websocket|xacrodoc"
    folders, groups = ["tests", "tools", "evidence"], ["test", "robots", "benchmarks"]
    check_groups(session, folders, groups, f"--per-rule-ignores=DEP001={brought},DEP003={brought}")


def check_groups(session: nox.Session, folders: list[str], groups: list[str], *options: str) -> None:
    """Check that the files of some folders import only what the workspace and these dependency groups declare."""
    project = nox.project.load_toml("pyproject.toml")
    declared = [*project["project"]["dependencies"], *nox.project.dependency_groups(project, *groups)]
    ours = [*Path().iterdir(), *Path("site").iterdir()]
    for folder in ("tests", "tools", "evidence"):
        ours += Path(folder).rglob("*.py")
    own = json.dumps([path.stem for path in ours])
    requirements, settings = (Path(session.create_tmp()) / name for name in ("declared.txt", "settings.toml"))
    requirements.write_text("\n".join(declared), "utf-8")
    names = f'known_first_party = {own}\npackage_module_name_map = {{pin = "pinocchio"}}'
    settings.write_text(f'[tool.deptry]\nexclude = [".*node_modules"]\n{names}', "utf-8")
    files = (f"--requirements-files={requirements}", f"--config={settings}", "--ignore=DEP002")
    session.run(PYTHON, "-m", "deptry", *folders, *files, *options)


@nox.session
def fresh(session: nox.Session) -> None:
    """Rehearse what the documents say, in environments of exactly what each path installs: `nox -s fresh -- lab --python 3.13`."""
    session.run(PYTHON, "tools/fresh", *session.posargs)


@nox.session
def types(session: nox.Session) -> None:
    """Check types with each NumPy that constraints.txt pins: its types change from version to version."""
    for pin, older in re.findall(
        r"^(numpy==[\d.]+)(?: ; python_full_version (<)?)?", Path(PINS).read_text("utf-8"), re.MULTILINE
    ):
        python = PYTHONS[0] if older else PYTHONS[-1]
        folder = f"build/types/{pin}"
        target = (f"--target={folder}", "--no-deps", f"--python-version={python}", "--only-binary=:all:", "--upgrade")
        if pin == f"numpy=={version('numpy')}":  # its results are kept for the next run of mypy
            session.run(PYTHON, "-m", "mypy", *session.posargs)
            continue
        session.run(PYTHON, "-m", "pip", "install", "--quiet", *target, pin)
        session.run(PYTHON, "-m", "mypy", f"--python-version={python}", *session.posargs, env={"PYTHONPATH": folder})


@nox.session(name="format")
def format_code(session: nox.Session) -> None:
    """Fix what ruff can fix, and format."""
    session.run(PYTHON, "-m", "ruff", "check", "--fix", *session.posargs)
    session.run(PYTHON, "-m", "ruff", "format", *session.posargs)


@nox.session
def oracles(session: nox.Session) -> None:
    """Check that every comparison with an oracle can fail, and list which library verifies which function."""
    run_pytest(session, "--numprocesses=auto", "--dist=loadfile", "--oracles", "tests")


@nox.session
def census(session: nox.Session) -> None:
    """Judge the wrong answers of 60 students to each problem; `-- --save site/census.json` keeps the counts for the site."""
    session.run(PYTHON, "-m", "misstep", "census", *session.posargs)
    session.run(PYTHON, "evidence/checks/judge_outside.py", *session.posargs)


@nox.session
def evidence(session: nox.Session) -> None:
    """Show that the library is right and that feedback is true; every night and before a release, in about an hour."""
    session.run(PYTHON, "-m", "misstep", "census")
    judged = sorted(map(str, Path("evidence").glob("test_*.py")))  # without the benchmarks, which need a plug-in
    run_pytest(session, *judged, "--numprocesses=auto")
    whole = ("--nightly", "--oracles", "--hypothesis-profile=thorough")
    run_pytest(session, "tests", "--numprocesses=auto", "--dist=loadfile", *whole)
    run_pytest(session, "tests/fuzz", "--numprocesses=auto", "--hypothesis-profile=nightly")


@nox.session
def formulas(session: nox.Session) -> None:
    """Change the formulas of lectures, and list the changes that no assertion notices: `nox -s formulas -- notebooks/03*.ipynb`."""
    lectures = session.posargs or sorted(str(path) for path in Path("notebooks").glob("*.ipynb"))
    session.run(PYTHON, "evidence/checks/check_formulas.py", *lectures)


@nox.session
def fuzz(session: nox.Session) -> None:
    """Fuzz until a fault is found or all examples are used: `nox -s fuzz -- -k urdf`."""
    run_pytest(session, "tests/fuzz", "-x", "--hypothesis-profile=fuzz", "--hypothesis-show-statistics")


@nox.session
def urdf(session: nox.Session) -> None:
    """Read every URDF file of three packages; downloads one of them, example-robot-data, of 131 MB, into build/."""
    folder = Path("build/example_robot_data")
    if not folder.exists():
        target = (f"--target={folder}", "--no-deps", "--only-binary=:all:", "--constraint=constraints.txt")
        session.run(PYTHON, "-m", "pip", "install", "--quiet", *target, "example-robot-data")
    run_pytest(session, "tests/kinlib/urdf/test_shipped_files.py")


@nox.session
def mutation(session: nox.Session) -> None:
    """Change a module in small ways and list the changes that no test detects: `nox -s mutation -- screw`."""
    if not session.posargs:
        session.error("Name at least one module, for example: nox -s mutation -- screw")
    names = [f"*.{module}.x*" for module in session.posargs]
    session.run(PYTHON, "-m", "mutmut", "run", *names, env=ONE_THREAD)


@nox.session
def benchmarks(session: nox.Session) -> None:
    """Measure kinlib beside its peers: `nox -s benchmarks -- -k fk`; `--keep` writes the results for the site."""
    folder = Path("build/benchmarks")
    if not folder.exists():  # not in .venv, because its plug-in would warn in every run of the tests on several cores
        target = (f"--target={folder}", "--no-deps", "--only-binary=:all:", "--constraint=constraints.txt")
        session.run(PYTHON, "-m", "pip", "install", "--quiet", *target, "pytest-benchmark", "py-cpuinfo2")
    run_pytest(
        session,
        *(*sorted(map(str, Path("evidence/benchmarks").glob("bench_*.py"))), "-pno:xdist", "-Wdefault"),
        *("--benchmark-max-time=0.3", "--benchmark-columns=median,rounds", f"--benchmark-json={folder}.json"),
        PYTHONPATH=str(folder),
    )


@nox.session
def pdf(session: nox.Session) -> None:
    """Print the lectures of the site as one PDF; needs a built site and a Chromium."""
    session.run(PYTHON, "site/pdf.py", *session.posargs)


@nox.session
def tidy(session: nox.Session) -> None:
    """Before a commit, remove the outputs of notebooks, of all or of those named, and write the lists of lectures in README and paper."""
    session.run(PYTHON, "-c", "from kincourse.table_of_lectures import *; write_lists(Path())")
    notebooks = session.posargs or [str(path) for path in sorted(Path("notebooks").glob("*.ipynb"))]
    session.run(PYTHON, "tools/tidy_notebooks.py", *notebooks)


@nox.session
def release(session: nox.Session) -> None:
    """Make the students' notebooks in exercises/ from solutions/."""
    session.run(PYTHON, "-m", "misstep", "release", *session.posargs)


@nox.session
def hooks(session: nox.Session) -> None:
    """Let git check the subject of each commit in this clone."""
    hook = (
        Path(session.run("git", "rev-parse", "--git-path", "hooks", external=True, silent=True).strip()) / "commit-msg"
    )
    hook.parent.mkdir(exist_ok=True)
    hook.write_text(f'#!/bin/sh\nexec "{PYTHON}" tools/check_commit_message.py "$1"\n', "utf-8")
    hook.chmod(0o755)


@nox.session(venv_backend="venv")
def distributions(session: nox.Session) -> None:
    """Build the wheels and source archives of the three packages in dist/, and check them; in an environment of its own."""
    session.install("build", "check-wheel-contents")
    for package in PACKAGES:
        session.run(
            "python", "-m", "build", "--outdir", "dist", package, env={"PIP_CONSTRAINT": str(Path(PINS).resolve())}
        )
    built = sorted(map(str, Path("dist").iterdir()))
    session.run("check-wheel-contents", *(path for path in built if path.endswith(".whl")))
    for uploader in UPLOADERS:
        session.install("--upgrade", *uploader)
        session.run("twine", "check", "--strict", *built)


@nox.session
def viewer(session: nox.Session) -> None:
    """Bundle the 3-D viewer; needs Node 20 or newer."""
    session.run("npm", "ci", external=True)
    session.run("npm", "run", "build", external=True)


@nox.session
def pin(session: nox.Session) -> None:
    """Write constraints.txt anew; `nox -s pin -- --upgrade` takes the newest versions, otherwise only what is new is added."""
    session.run(
        *(
            PYTHON,
            "-m",
            "uv",
            "pip",
            "compile",
            "pyproject.toml",
            "--group=test",
            "--group=installer",
            "--group=robots",
            "--group=benchmarks",
        ),
        *("--universal", "--quiet", "--no-annotate", "--custom-compile-command=nox -s pin", "-o", "constraints.txt"),
        *session.posargs,
        env={"PYTHONPATH": os.pathsep.join(filter(None, [".uv", os.environ.get("PYTHONPATH")]))},
    )
