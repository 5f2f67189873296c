"""`nox -s fresh`: every command of the documents is rehearsed or has a reason."""

import ast
from pathlib import Path

import documents
import paths
import pytest
from documents import NOT_REHEARSED
from fresh_copy import pythons
from paths import PATHS

STRINGS = {
    node.value
    for node in ast.walk(ast.parse(Path(paths.__file__).read_text("utf-8")))
    if isinstance(node, ast.Constant) and isinstance(node.value, str)
}
"""What stands in the source of the paths: also the commands of documents that they run."""

EXCUSED = tuple(start for starts in NOT_REHEARSED.values() for start in starts)


def without_reason(commands):
    """The commands that no path runs, and that no reason excuses."""
    return [one for one in commands if one not in STRINGS and not one.startswith(EXCUSED)]


def test_every_command_of_the_documents_is_rehearsed_or_has_a_reason():
    assert without_reason(documents.commands()) == []


def test_no_reason_is_about_a_command_that_no_document_gives():
    others = set(documents.commands()) - STRINGS
    assert [start for start in EXCUSED if not any(one.startswith(start) for one in others)] == []


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("guide.md", "Try:\n\n```\nmake everything\n```\n"),
        ("guide.md", "Try `python -m everything`, or not."),
        ("guide.md", "1. Then\n\n   ```\n   make everything\n   ```\n"),
        ("ci.yml", "jobs:\n  all:\n    steps:\n      - run: make everything\n"),
        ("ci.yml", "jobs:\n  all:\n    steps:\n      - name: All\n        run: |\n          make everything\n"),
        ("Containerfile", "RUN apt-get update \\\n    && make everything\n"),
    ],
)
def test_a_new_command_is_found_in_each_kind_of_document(tmp_path, name, text):
    (tmp_path / name).write_text(text, "utf-8")
    (found,) = without_reason(documents.commands_of(tmp_path / name))
    assert found.endswith("everything")


def test_code_of_other_languages_and_words_are_no_commands(tmp_path):
    (tmp_path / "guide.md").write_text("```python\nmake()\n```\nText `kl.show(arm)`.\n\n```\ntrue\n```\n", "utf-8")
    assert list(documents.commands_of(tmp_path / "guide.md")) == ["true"]


def test_a_path_fails_if_a_command_fails(monkeypatch):
    python = Path(next(iter(pythons().values())))
    for command, result in (("true", ("passed", "")), ("false", ("FAILED", "false\n"))):
        monkeypatch.setitem(PATHS, "planted", lambda place, command=command: place.run(command))
        assert paths.rehearse("planted", python) == result
