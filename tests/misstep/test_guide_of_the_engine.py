"""The tutorial in misstep/docs: each command is run in order, and its problem stands in for the one that the command wrote."""

import re
import subprocess
import sys

import submissions

TUTORIAL = (submissions.ROOT / "misstep" / "docs" / "index.md").read_text("utf-8")


def test_the_tutorial_leads_to_a_course_in_which_nothing_is_missing(tmp_path):
    here, outputs = tmp_path, []
    for language, block in re.findall(r"^```(\w*)\n(.*?)^```", TUTORIAL, re.MULTILINE | re.DOTALL):
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
