"""Reading: what a file stores is found whatever an editor did to it, and each file that is no notebook has a reason."""

import json
import zipfile
from contextlib import suppress
from pathlib import PurePosixPath

import pytest
from hypothesis import given
from hypothesis import strategies as st
from submissions import NAME, SHEET, answered, as_bytes, emissions, released, write, zipped

from misstep.grading.collect.notebook import Unreadable, choose, read_work
from misstep.grading.collect.submissions import SourceFile, list_files
from misstep.storage import MIME

CODE = "cell_type", "code"


def ada():
    return as_bytes(answered("ada"))


def without_metadata(notebook):
    for cell in notebook["cells"]:
        cell.pop("id")
        cell["metadata"] = {}
    return notebook


def with_output(data):
    notebook = answered("ada")
    notebook["cells"][1]["outputs"] = [{"output_type": "display_data", "metadata": {}, "data": data}]
    return as_bytes(notebook)


EDITED = {
    "BOM": lambda: b"\xef\xbb\xbf" + ada(),
    "CRLF": lambda: ada().replace(b"\n", b"\r\n"),
    "latin": lambda: ada().replace(b"Problem", b"Pr\xffblem"),
    "Colab": lambda: as_bytes(without_metadata(answered("ada"))),
    "Plotly": lambda: with_output({"application/vnd.plotly.v1+json": {"z": [[0.5, float("nan")] * 2000]}}),
    "film": lambda: with_output({"text/html": '\\"[{' * 50_000, "application/json": [list(range(20_000))] * 3}),
}


@pytest.mark.parametrize("how", EDITED)
def test_an_editor_and_long_outputs_cost_no_answer(how):
    work = read_work(EDITED[how](), SHEET)
    assert (sorted(work.answers), work.ids, list(work.stale)) == (list(range(1, 12)), ["ada"], [])


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b" \n", "The file is empty"),
        (b"%PDF-1.4", "a PDF"),
        (zipped({"a": b""}), "a zip archive"),
        (b"\x1f\x8b", "a compressed archive"),
        (b"<!DOCTYPE html>", "a web page"),
        (b"print(1)", "not a notebook"),
        (b'{"cells": [{"cell_type": "code", ', "cut off or damaged"),
        (b'{"cells":' + b"[" * 200_000, "nested too deeply"),
        (b"[1, 2]", "JSON but not a notebook"),
        (b'{"worksheets": []}', "it has no cells"),
    ],
)
def test_what_is_no_notebook_has_a_reason(content, reason):
    with pytest.raises(Unreadable, match=reason):
        read_work(content, SHEET)


def test_the_answer_that_was_checked_last_counts():
    notebook = answered("ada")
    first = next(cell for cell in notebook["cells"] if cell["id"] == "check-1")
    again = json.loads(json.dumps(first)) | {"execution_count": 90}
    emissions({"cells": [again]})[0]["answer"] = {"number": 7.0}
    notebook["cells"].insert(0, again)
    assert read_work(as_bytes(notebook), SHEET).answers[1] == ('{"number": 7.0}', "ada")


def test_a_sheet_that_was_not_run_is_known_and_another_sheet_too(tmp_path):
    assert read_work(as_bytes(released()), SHEET).is_sheet
    assert not read_work(as_bytes(answered("ada")), "02_motions").is_sheet
    write(tmp_path, **{"x.ipynb": answered("ada")})
    with pytest.raises(Unreadable, match=r"x\.ipynb has no cell of the sheet 02_motions"):
        choose(list_files(tmp_path), "02_motions")


def test_of_several_notebooks_the_newest_with_answers_counts(tmp_path):
    old, new = answered("ada", wrong=[1]), answered("ada", wrong=[2])
    archive = tmp_path / "work.zip"
    with zipfile.ZipFile(archive, "w") as members:
        members.writestr("../../../evil.ipynb", b"{}")
        members.writestr("__MACOSX/._X.ipynb", b"\0")
        members.writestr(".ipynb_checkpoints/X.ipynb", as_bytes(old))
        for name, minute, content in (("b.ipynb", 1, old), ("a/X.ipynb.txt", 3, new), ("Y.ipynb", 5, released())):
            members.writestr(zipfile.ZipInfo(name, (2036, 1, 1, 0, minute, 0)), as_bytes(content))
    chosen = choose([SourceFile(PurePosixPath("work.zip"), archive)], SHEET)
    assert chosen.work.answers == read_work(as_bytes(new), SHEET).answers
    assert chosen.name == "X.ipynb"
    assert list(chosen.notes) == ["Of 3 notebooks of this sheet, X.ipynb counts, the newest with answers."]
    assert [path.name for path in tmp_path.iterdir()] == ["work.zip"]
    names = (NAME, f"{SHEET} (2).ipynb", f"{SHEET} (10).ipynb")
    copies = [SourceFile(PurePosixPath(name), tmp_path / name) for name in names]
    write(tmp_path, **{one.name.name: answered("ada") for one in copies})
    assert choose(copies, SHEET).name == f"{SHEET} (10).ipynb"


def test_a_file_that_is_too_large_is_refused_before_it_is_in_memory(tmp_path, monkeypatch):
    monkeypatch.setattr("misstep.grading.collect.submissions.MAX_BYTES", 1000)
    bomb = write(tmp_path, **{"x.zip": zipped({"x.ipynb": b" " * 100_000})})
    with pytest.raises(Unreadable, match=r"x\.ipynb has over"):
        choose(list_files(bomb / "x.zip"), SHEET)


KEYS = ["cells", *CODE, "outputs", "data", MIME, "sheet", "problem", "student", "answer", "source"]
JSON = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=5)
    | st.sampled_from([SHEET, "code", "ada"]),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.sampled_from(KEYS), inner, max_size=5),
    max_leaves=30,
)


@given(JSON, st.binary(max_size=3), st.integers(0, 400))
def test_any_bytes_are_read_or_refused_with_a_sentence(data, noise, place):
    content = json.dumps({"cells": [data, {"cell_type": "code", "outputs": [{"data": {MIME: data}}]}]}).encode()
    for changed in (content, content[:place] + noise + content[place:]):
        with suppress(Unreadable):
            assert all(json.loads(text) is None or text for text, _ in read_work(changed, SHEET).answers.values())
