"""The guide in misstep/docs: the tutorial is done line by line; other pages name commands and kinds of answers that exist.

In the tutorial, each command is run in order, and its problem stands in for the one that the command wrote, solution included.
"""

import argparse
import importlib
import inspect
import pkgutil
import re
import shlex
import subprocess
import sys

import pytest
import submissions

import misstep.answers
from misstep.answers.base import Answer
from misstep.cli import COMMANDS

GUIDE = submissions.ROOT / "misstep" / "docs"
TUTORIAL = (GUIDE / "index.md").read_text("utf-8")


def test_the_tutorial_leads_to_a_course_in_which_nothing_is_missing(tmp_path):
    here, outputs = tmp_path, []
    for language, block in re.findall(r"^```(\w*)\n(.*?)^```", TUTORIAL, re.MULTILINE | re.DOTALL):
        if language == "python" and not block.startswith("@"):
            file = here / "solutions" / "01_dice" / "01_dice.ipynb"
            line = "two_dice_4 = given.a * given.b  # replace this solution"
            text = file.read_text("utf-8")
            assert line in text
            file.write_text(text.replace(line, block.strip()), "utf-8")
            continue
        if language == "python":
            file = here / "my_course" / "lecture_01_dice" / "problems.py"
            text = file.read_text("utf-8")
            start, end = text.index('@problem("01.4"'), text.index("SHEET = ")
            file.write_text(f"{text[:start]}{block}\n\n{text[end:]}", "utf-8")
            continue
        for line in block.splitlines():
            if line.startswith("cd "):
                here /= line.removeprefix("cd ")
                continue
            command = [sys.executable, "-m", *re.findall(r'"[^"]*"|\S+', line)]
            done = subprocess.run(
                [one.strip('"') for one in command],
                cwd=here,
                capture_output=True,
                encoding="utf-8",
                check=False,
            )
            assert done.returncode == 0, f"{line}\n{done.stdout}{done.stderr}"
            outputs.append(done.stdout)
    assert [text for text in outputs if "nothing is missing" in text] == [
        "my_course: nothing is missing in 01_dice.\n"
    ] * 2
    assert "Mistake 1" in outputs[3]
    assert (here / "exercises" / "01_dice" / "01_dice.ipynb").is_file()


@pytest.mark.parametrize("page", sorted(page.name for page in GUIDE.glob("*.md")))
def test_each_command_of_the_guide_exists_with_its_options(page):
    for line in re.findall(r"^(?:    )?misstep (.*)$", (GUIDE / page).read_text("utf-8"), re.MULTILINE):
        name, *arguments = shlex.split(line)
        parser = argparse.ArgumentParser(exit_on_error=False)
        importlib.import_module(COMMANDS[name][0]).add_arguments(parser)
        parser.parse_args(arguments)


def test_the_reference_has_each_command_and_each_kind_of_answer():
    text = (GUIDE / "reference.md").read_text("utf-8")
    assert [name for name in COMMANDS if f"`misstep {name}" not in text] == []
    for module in pkgutil.walk_packages(misstep.answers.__path__, "misstep.answers."):
        importlib.import_module(module.name)
    kinds, found = [Answer], set()
    while kinds:
        kinds += [kind for kind in kinds.pop().__subclasses__() if kind.__module__.startswith("misstep.answers.")]
        found |= {(kind.__name__, kind.__module__) for kind in kinds if not inspect.isabstract(kind)}
    assert set(re.findall(r"^\| `(\w+)` \| `(misstep\.answers\.[\w.]+)`", text, re.MULTILINE)) == found
