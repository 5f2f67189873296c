"""How many faults the tests of a module notice: each is planted by itself, and its tests should fail.

    python course.py mutation screw             every fault that mutmut can plant in kinlib/screw.py
    python course.py mutation loops 100         a hundred of them, drawn at random
    python course.py mutation loops again       those that its tests let pass the last time
    python course.py mutation practice.judge

What survived is printed as the line that it made, with its function. A test should kill it; if none can, because the
faulty line does the same, tests/mutation.toml says why. There the tests of each module and its last score stand too.

mutmut forks a process for each fault from one that has imported all. It runs in build/mutation/<module>, on a copy, where

    PYTHONPATH=. mutmut browse

shows more. Two things are ours. It leaves decorated functions alone, so that properties are written without their @ in
the copy. And faults are not counted where no test should look: in a text with blanks, which is for people, who proofread
it, and in zip's strict, which asserts what the lines before it made sure of.
"""

import ast
import json
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
NOTES = tomllib.loads((ROOT / "tests/mutation.toml").read_text("utf-8"))
UNNOTICED = {0: "survived", 33: "never run", 5: "never run"}
MEMORY = 8 * 2**30

SETTINGS = """
[tool.mutmut]
source_paths = ["kinlib"]
only_mutate = ["{path}"]
also_copy = ["conftest.py", "course.py"]
pytest_add_cli_args = ["--hypothesis-profile=mutation", "-p", "no:cacheprovider"]
pytest_add_cli_args_test_selection = {tests}
timeout_multiplier = 4.0
timeout_constant = 2.0
use_git_change_detection = false
"""


def main(module: str, count: str = "") -> None:
    """Plant faults in a module and say which ones its tests let pass."""
    folder, path = prepared(module)
    faults = {name: fault for name, fault in planted(folder, path).items() if fault}
    explained = NOTES["explained"].get(module, {})
    for fault in set(explained) - set(faults.values()):
        print(f"explained, and no fault any more: {fault}")
    last = folder.with_name(f"{module}.json")
    if count == "again":
        faults = {
            name: fault for name, fault in json.loads(last.read_text("utf-8")).items() if faults.get(name) == fault
        }
    elif count:
        faults = dict(random.Random(module).sample(sorted(faults.items()), min(int(count), len(faults))))
    run = [sys.executable, "tests/mutation.py", "--mutmut", "run", "--max-children=1", *faults]
    said = folder / "log.txt"
    with said.open("w") as log:
        done = subprocess.run(run, stdout=log, stderr=log, check=False, preexec_fn=bounded, env=environment())
    if done.returncode:
        sys.exit(f"mutmut stopped; it needs tests that pass. It said:\n{said.read_text('utf-8')[-3000:]}")
    codes = json.loads((folder / f"mutants/{path}.meta").read_text("utf-8"))["exit_code_by_key"]
    survivors = {name: fault for name, fault in faults.items() if codes[name] in UNNOTICED}
    last.write_text(json.dumps(survivors), "utf-8")
    left = {name: fault for name, fault in survivors.items() if fault not in explained}
    for name, fault in left.items():
        print(f"{UNNOTICED[codes[name]]}: {fault}        ({name})")
    killed = len(faults) - len(survivors)
    print(f"{module}: {len(faults)} faults, {killed} killed, {len(survivors) - len(left)} explained, {len(left)} left")
    sys.exit(bool(left))


def prepared(module: str) -> tuple[Path, str]:
    """A copy of kinlib and its tests, in which mutmut may work, with the settings for one module."""
    path = f"kinlib/{module.replace('.', '/')}.py"
    folder = ROOT / "build/mutation" / module
    shutil.rmtree(folder, ignore_errors=True)
    for name in ("kinlib", "tests"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "node_modules"))
    for name in ("conftest.py", "course.py"):
        shutil.copy(ROOT / name, folder)
    tests = [f"tests/{name}" for name in NOTES["modules"][module]["tests"]]
    settings = SETTINGS.format(path=path, tests=json.dumps(tests))
    (folder / "pyproject.toml").write_text((ROOT / "pyproject.toml").read_text("utf-8") + settings, "utf-8")
    (folder / path).write_text(undecorated((ROOT / path).read_text("utf-8")), "utf-8")
    return folder, path


def undecorated(source: str) -> str:
    """The same module with `@property def f` written as `f = property(f_plain)`, and so for every decorator that is a name."""
    tree = ast.parse(source)
    for body in [tree.body, *(node.body for node in tree.body if isinstance(node, ast.ClassDef))]:
        for place, node in reversed(list(enumerate(body))):
            match node:
                case ast.FunctionDef(name=name, decorator_list=[ast.Name(id=decorator)]):
                    if decorator not in {"staticmethod", "classmethod", "abstractmethod"}:
                        node.name, node.decorator_list = f"{name}_plain", []
                        body.insert(place + 1, *ast.parse(f"{name} = {decorator}({name}_plain)").body)
    return ast.unparse(tree)


def planted(folder: Path, path: str) -> dict[str, str]:
    """Every fault by its name in mutmut: the function, and the line that it made; "" for one that is not counted."""
    os.chdir(folder)  # where its settings stand
    from mutmut.mutation.file_mutation import mutate_file_contents

    made = mutate_file_contents(path, (folder / path).read_text("utf-8"))
    functions = {node.name: node for node in ast.walk(ast.parse(made.code)) if isinstance(node, ast.FunctionDef)}
    prefix = path.removesuffix(".py").replace("/", ".")
    return {f"{prefix}.{name}": told(functions, name) for name in made.mutant_names}


def told(functions: dict[str, ast.FunctionDef], name: str) -> str:
    """The function, and the line that a fault made there."""
    stem = name.rpartition("__mutmut_")[0]
    right, wrong = functions[f"{stem}__mutmut_orig"], functions[name]
    right.name = wrong.name = "function"
    if bare(right) == bare(wrong):
        return ""
    before, after = (ast.unparse(node).splitlines() for node in (right, wrong))
    new = [line.strip() for line in after if line not in before] or [
        f"no {line.strip()}" for line in before if line not in after
    ]
    return f"{stem.removeprefix('x').strip('ǁ_').replace('ǁ', '.').removesuffix('_plain')}: {' '.join(new)}"


def bare(function: ast.FunctionDef) -> str:
    """The function without what its texts with blanks say, and without zip's strict."""
    copy = ast.parse(ast.unparse(function))
    for node in ast.walk(copy):
        match node:
            case ast.Constant(value=str(text)) if " " in text:
                node.value = " "
            case ast.Call(func=ast.Name(id="zip")):
                node.keywords = []
    return ast.dump(copy)


def mutmut(*words: str) -> None:
    """mutmut itself, with two changes to how it runs the tests that reach a fault: quick ones first, and by another way.

    It names them to pytest, which does not take back an id with a backslash; so all are collected, and those kept.
    """
    from mutmut.__main__ import cli
    from mutmut.runners.harness import PytestRunner
    from mutmut.state import state
    from mutmut.utils.file_utils import change_cwd

    class Chosen:
        def __init__(self, tests: Iterable[str]) -> None:
            seconds = state().duration_by_test
            self.seconds = {plain(test): seconds[test] for test in tests}

        def pytest_collection_modifyitems(self, items: list[Any]) -> None:
            items[:] = sorted(
                (item for item in items if plain(item.nodeid) in self.seconds),
                key=lambda item: self.seconds[plain(item.nodeid)],
            )

    def plain(test: str) -> str:  # pytest escapes a backslash once more each time that it collects a test
        return re.sub(r"\\+", "/", test)

    def run_tests(runner: PytestRunner, *, mutant_name: str | None, tests: Iterable[str]) -> int:
        plugins = [Chosen(tests)] if tests else []
        with change_cwd("mutants"):
            return int(runner.execute_pytest(runner._pytest_args_regular_run([]), plugins=plugins))

    PytestRunner.run_tests = run_tests
    # The choice between the right function and the faulty one takes two calls: what recurses goes three times as deep.
    sys.setrecursionlimit(3 * sys.getrecursionlimit())
    cli(words)


def environment() -> dict[str, str]:
    """One thread for each fault, and no other kinlib than the copy."""
    return os.environ | {"OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


def bounded() -> None:
    """A fault may ask for any amount of memory."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


if __name__ == "__main__":
    if sys.argv[1] == "--mutmut":
        mutmut(*sys.argv[2:])
    else:
        main(*sys.argv[1:])
