"""Benchmarks compare what is the same, run as they say, and keep each result with its set-up; the page shows every result."""

import getpass
import importlib.util
import json
import socket
from pathlib import Path

import numpy as np
import pytest
from kinsite.generated import performance
from library_rows import CHECK, ROWS, in_new_process

FOLDER = Path(__file__).parents[2] / "evidence" / "benchmarks"
RESULTS = json.loads((FOLDER / "results.json").read_text("utf-8"))


@pytest.fixture(scope="module")
def keeping():
    """The conftest.py of the benchmarks, which keeps the results."""
    spec = importlib.util.spec_from_file_location("benchmark_options", FOLDER / "conftest.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.filterwarnings("ignore")  # peers emit warnings
@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.name)
def test_each_library_computes_what_kinlib_computes(row):
    if "import pinocchio" in row.setup:
        pytest.importorskip("pinocchio", reason="no pinocchio here (the wheel `pin` does not exist for Windows)")
    kinlib = next(other for other in ROWS if other.operation == row.operation)
    for size in (1, 3):
        names, expected = {}, {}
        exec(row.lines(size), names)
        exec(kinlib.lines(size), expected)
        names["found"] = eval(row.call, names)
        found, right = eval(row.same, names), eval(kinlib.call, expected)
        np.testing.assert_allclose(np.reshape(found, right.shape), right, rtol=0, atol=1e-12)


def test_a_new_process_runs_the_lines_of_a_row():
    assert 0 < in_new_process(CHECK, 1) < 1e3
    names = {}
    exec(CHECK.lines(1), names)
    assert "halves swapped" in str(eval(CHECK.call.replace("_repr_mimebundle_()", "judgement"), names))


def test_measured_rows_replace_those_before_and_keep_their_own_set_up(keeping):
    kept = {
        "set_ups": [{"date": "one"}, {"date": "two"}],
        "rows": [
            {"section": "fk", "library": "kinlib", "size": 1, "warmed": 1.0, "set_up": 0},
            {"section": "fk", "library": "kinlib", "size": 2, "warmed": 2.0, "set_up": 1},
        ],
    }
    measured = [{"section": "fk", "library": "kinlib", "size": 1, "fresh": 0.123456, "warmed": 3.0}]
    now = keeping.merged(kept, measured, {"date": "three"})
    assert json.loads(keeping.dumps(now)) == {
        "set_ups": [{"date": "three"}, {"date": "two"}],
        "rows": [
            {"section": "fk", "library": "kinlib", "size": 1, "fresh": 0.1235, "warmed": 3.0, "set_up": 0},
            {"section": "fk", "library": "kinlib", "size": 2, "warmed": 2.0, "set_up": 1},
        ],
    }


def test_a_set_up_names_neither_the_machine_nor_its_user(keeping):
    for set_up in (keeping.describe_set_up(), *RESULTS["set_ups"]):
        assert set(set_up) == {"date", "processor", "cores", "load", "system", "packages"}
        assert not {socket.gethostname(), getpass.getuser(), str(Path.home())} & set(map(str, set_up.values()))


def test_the_page_on_performance_shows_each_row_with_its_set_up():
    page = dict(performance.pages())["performance.md"]
    for row in RESULTS["rows"]:
        each = row["size"] if "fresh" in row else 1
        shown = f"{row['megabytes']:.0f} MB" if "megabytes" in row else performance.seconds(row["warmed"] / each)
        fresh = performance.seconds(row["fresh"] / each) if "fresh" in row else ""
        assert any(is_line_of(line, row, shown) and fresh in line for line in page.splitlines()), row
    for set_up in RESULTS["set_ups"]:
        assert f" on {set_up['date']}: {set_up['processor']}" in page


def is_line_of(line, row, shown):
    """Whether a line of the page shows a row: in a table of batches its first cell is the size, elsewhere the name."""
    first, *others = line.removeprefix("| ").split(" | ")
    is_batch = row["section"] in {"exp", "log", "fk", "jacobian"}
    return first.replace("\\", "") == (f"{row['size']:,}" if is_batch else row["library"]) and any(
        shown in cell for cell in others
    )


@pytest.mark.parametrize("is_measured", [True, False])
def test_the_guide_for_instructors_has_the_times_that_were_measured(is_measured, monkeypatch):
    rows = [{"section": "grading", "library": "nbgrader", "size": 9, "warmed": 2.5, "set_up": 0}] * is_measured
    set_up = {"date": "today", "processor": "fast", "cores": 2, "load": 0.1, "packages": {}}
    monkeypatch.setattr(performance, "load", lambda: (rows, [set_up]))
    guide = (FOLDER.parents[1] / "site" / "instructors.md").read_text("utf-8")
    assert performance.GRADING_MARK in guide
    written = performance.with_grading_times(guide)
    assert performance.GRADING_MARK not in written
    assert (
        "On today, 9 submissions took on fast with 2 cores and a load of 0.1: `nbgrader` 2.5 s." in written
    ) == is_measured
