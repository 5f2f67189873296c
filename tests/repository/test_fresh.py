"""`nox -s fresh`: every command of the documents is rehearsed or has a reason, and a path that does less than it says fails."""

from pathlib import Path

import documents
import paths
import pytest
from fresh_copy import pythons
from paths import NOT_REHEARSED, PATHS

REHEARSED = {command for one in PATHS.values() for command in one.commands}


def without_reason(commands):
    """The commands that no path runs, and that no reason excuses."""
    return [one for one in commands if one not in REHEARSED and not one.startswith(tuple(NOT_REHEARSED))]


def test_every_command_of_the_documents_is_rehearsed_or_has_a_reason():
    assert without_reason(documents.commands()) == []


def test_no_path_and_no_reason_is_about_a_command_that_no_document_gives():
    given = set(documents.commands())
    assert REHEARSED - given == set()
    others = given - REHEARSED
    assert [start for start in NOT_REHEARSED if not any(one.startswith(start) for one in others)] == []


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


def forgets(place):
    place.run("true")


def breaks(place):
    place.run("echo said before; false")


@pytest.mark.parametrize(
    ("run", "commands", "result", "reason"),
    [
        (forgets, ("true",), "passed", ""),
        (forgets, ("true", "make everything"), "FAILED", "make everything"),
        (breaks, (), "FAILED", "said before"),
    ],
)
def test_a_path_fails_if_a_command_fails_or_is_forgotten(monkeypatch, run, commands, result, reason):
    monkeypatch.setitem(PATHS, "planted", paths.Path("planted", run, commands))
    found = paths.rehearse("planted", Path(next(iter(pythons().values()))))
    assert found[0] == result
    assert reason in found[1]
