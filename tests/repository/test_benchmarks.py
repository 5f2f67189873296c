"""Every benchmark runs, implementations are timed alternately, and saved results are loaded unchanged."""

import doctest
import json
import re
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from benchmarks import __main__ as command
from benchmarks import measure, results
from benchmarks.measure import Curve, MissingRequirementError, Row, Workload, compare, measure_batches, time_interleaved
from benchmarks.results import describe_machine, format_quantity, format_ratio, format_row, load, save

NEEDS_BROWSER = {"viewer"}
"""Benchmarks that start a browser and a server; tests/browser covers what they use."""


def test_each_round_times_every_workload_in_another_order():
    calls = []
    time_interleaved([Workload(partial(calls.append, name)) for name in "abc"], rounds=3)
    rounds = ["".join(calls[k : k + 3]) for k in range(0, len(calls), 3)]
    assert rounds == ["abc", "bca", "cab", "abc"]


def test_the_first_round_does_not_count(monkeypatch):
    """With a simulated clock, because on a busy machine any round may be the longest."""
    clock, pauses = [0.0], iter([50, 1, 2, 3])
    monkeypatch.setattr("benchmarks.measure.time.perf_counter", lambda: sum(clock))
    (seconds,) = time_interleaved([Workload(lambda: clock.append(next(pauses)))], rounds=3)
    assert list(seconds) == [1, 2, 3]


def test_the_time_is_divided_by_the_number_of_results(monkeypatch):
    clock = [0.0]
    monkeypatch.setattr("benchmarks.measure.time.perf_counter", lambda: sum(clock))
    one, many = (Workload(partial(clock.append, 2.0), count) for count in (1, 1000))
    assert time_interleaved([one, many], rounds=1) == [[2.0], [0.002]]


def test_a_row_without_its_peer_has_no_result():
    def missing():
        raise ModuleNotFoundError("peer")

    (row,) = compare("something", Workload(int), {"peer": (missing, 2.0)}, rounds=1)
    assert (row.peer_value, row.ratio_or_value, row.meets_target) == (None, None, None)
    assert format_row(row)["peer's value"] == "not installed"
    assert format_row(row)["result"] == "not measured"


@pytest.mark.parametrize(
    ("row", "ratio_or_value", "is_met"),
    [
        (Row("faster", "s", 1.0, 2.0, "peer", 3.0), 3.0, True),
        (Row("median of the rounds", "s", 1.0, 2.0, "peer", 3.0, quartiles=(1.0, 1.9, 4.0)), 1.9, False),
        (Row("not fast enough", "s", 1.0, 4.0, "peer", 3.0), 3.0, False),
        (Row("not much slower", "s", 1.2, 1.3, "peer", 1.0, at_most=True), 1.2, True),
        (Row("too much slower", "s", 1.4, 1.3, "peer", 1.0, at_most=True), 1.4, False),
        (Row("short enough", "operations", 272, 275, at_most=True), 272, True),
        (Row("too long", "operations", 276, 275, at_most=True), 276, False),
        (Row("no failures", "tables", 0, 0, at_most=True), 0, True),
    ],
    ids=lambda value: value.name if isinstance(value, Row) else "",
)
def test_a_row_is_compared_with_its_target(row, ratio_or_value, is_met):
    assert row.ratio_or_value == pytest.approx(ratio_or_value)
    assert row.meets_target is is_met


def test_the_exponent_is_fitted_to_the_upper_half_of_the_sizes():
    """At smaller sizes, a constant cost dominates."""
    sizes = tuple(10.0**k for k in range(9))
    curve = Curve("poses", "configurations", sizes, tuple(1e3 + size**1.5 for size in sizes))
    assert curve.exponent == pytest.approx(1.5, abs=0.1)
    assert Curve("poses", "joints", (1, 2, 4, 8), (3.0, 12.0, 48.0, 192.0)).exponent == pytest.approx(2)


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [(0.75, "s", "750 ms"), (2, "s", "2 s"), (4.2e-6, "s", "4.2 µs"), (2.7e-7, "s", "270 ns"), (3e-16, "", "3e-16")],
)
def test_seconds_are_formatted_with_a_prefix(value, unit, text):
    assert format_quantity(value, unit) == text


def test_a_ratio_has_three_significant_digits():
    assert [format_ratio(x) for x in (0.5514, 2.0, 123.4, 2345.6)] == ["0.551", "2", "123", "2,350"]


@pytest.mark.parametrize("module", [measure, results])
def test_examples_in_docstrings_run(module):
    done = doctest.testmod(module)
    assert done.attempted > 0
    assert done.failed == 0


# --- saved results ---


def example_results(value=1.0):
    row = Row("poses", "s", value, 2.0, "peer", 3.0, quartiles=(2.5, 2.9, 3.5))
    curve = Curve("poses", "configurations", (1, 10, 100), (4.0, 5.0, 6.0), {"a loop": (0.3, 3.0, 30.0)})
    return {"forward_kinematics": ([row], [Curve("poses", "joints", (1, 2), (1e-3, 2e-3)), curve])}


def test_saved_results_are_loaded_unchanged(tmp_path):
    path = tmp_path / "results.json"
    save(example_results(), path)
    (run,) = load(path).runs["forward_kinematics"]
    (rows, curves) = example_results()["forward_kinematics"]
    assert (list(run.rows), list(run.curves)) == (rows, curves)
    assert load(path).machine == describe_machine()


def test_the_last_two_runs_are_kept_latest_first(tmp_path):
    path = tmp_path / "results.json"
    for value in (1.0, 2.0, 3.0):
        save(example_results(value), path)
    save({"loops": ([], [])}, path)
    assert [run.rows[0].value for run in load(path).runs["forward_kinematics"]] == [3.0, 2.0]
    assert set(load(path).runs) == {"forward_kinematics", "loops"}


def test_results_of_another_machine_are_dropped(tmp_path, monkeypatch):
    path = tmp_path / "results.json"
    save(example_results(), path)
    monkeypatch.setattr(results, "processor_name", lambda: "another one")
    save({"loops": ([], [])}, path)
    assert set(load(path).runs) == {"loops"}


def test_only_the_kind_of_machine_is_saved(tmp_path):
    import getpass
    import socket

    path = tmp_path / "results.json"
    save(example_results(), path)
    saved = json.loads(path.read_text("utf-8"))
    assert set(saved["machine"]) == {"processor", "cores", "system", "Python", *results.PACKAGES}
    for secret in (socket.gethostname(), getpass.getuser(), str(Path.home())):
        assert secret not in saved["machine"].values()


def test_the_page_on_performance_shows_every_saved_row_and_describes_each_picture():
    import built_site  # noqa: F401 - makes kinsite importable
    from kinsite.generated import performance

    pictures = dict(performance.pages())
    page = pictures.pop("performance.md")
    saved = load()
    for name, (last, *_) in saved.runs.items():
        assert f"## {name.replace('_', ' ').capitalize()}\n" in page
        for row in last.rows:
            (line,) = [
                line for line in page.splitlines() if line.startswith("| ") and expected_cells(row) <= cells_of(line)
            ]
            assert line.endswith(f"| {format_row(row)['result']} |")
    described = dict(re.findall(r"^!\[([^\]]{20,})\]\((\S+\.svg)\)$", page, re.MULTILINE))
    assert set(described.values()) == set(pictures)
    assert len(pictures) == sum(len(runs[0].curves) for runs in saved.runs.values())


@pytest.mark.parametrize(
    ("measured", "text"),
    [
        ({}, ""),
        (
            {"grading": ([Row("grading 9, each", "s", 0.2, 10, "nbgrader", 2.5), Row("memory", "MB", 200, 250)], [])},
            "grading 9, each: 200 ms, nbgrader: 2.5 s. ",
        ),
    ],
    ids=["not measured", "measured"],
)
def test_the_guide_for_instructors_has_the_times_that_were_measured(measured, text, tmp_path, monkeypatch):
    import built_site  # noqa: F401 - makes kinsite importable
    from kinsite.generated import performance

    saved = save(measured | example_results(), tmp_path / "results.json")
    monkeypatch.setattr(performance, "load", lambda: saved)
    guide = Path("site/instructors.md").read_text("utf-8")
    written = performance.with_grading_times(guide)
    assert performance.GRADING_MARK in guide
    assert performance.GRADING_MARK not in written
    assert "`python -m benchmarks grading`" in written
    assert text in written
    assert ("(performance.md#grading)" in written) == bool(measured)


@pytest.mark.parametrize(
    ("peer", "sentence"),
    [
        ((5, 6, 7, 8), "kinlib takes less time than “the peer” at every measured size."),
        ((4, 3, 2, 1), "kinlib takes no less time than “the peer” at every measured size."),
        (
            (1, 4, 16, 64),
            "kinlib takes less time than “the peer” for each measured size from 100 poses on; the curves cross at about 10.",
        ),
        (
            (64, 16, 1, 1),
            "kinlib takes less time than “the peer” for each measured size up to 10 poses; the curves cross at about 32.",
        ),
        (
            (64, 1, 1, 64),
            "kinlib takes less time than “the peer” for 1, 1,000 poses; the curves cross at about 4.6 and about 220.",
        ),
    ],
)
def test_the_sentence_about_a_curve_is_computed_from_the_times(peer, sentence):
    import built_site  # noqa: F401 - makes kinsite importable
    from kinsite.generated.performance import comparison, draw_batches

    curve = Curve("poses", "poses", (1, 10, 100, 1000), (4.0, 4.0, 4.0, 4.0), {"the peer": peer})
    assert comparison(curve) == sentence
    assert draw_batches(curve).alt.endswith(sentence)


def test_the_page_on_performance_shows_every_size_of_every_saved_curve_beside_its_peers():
    import built_site  # noqa: F401 - makes kinsite importable
    from kinsite.generated import performance

    page = dict(performance.pages())["performance.md"]
    lines = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines()]
    compared = [curve for runs in load().runs.values() for curve in runs[0].curves if curve.peers]
    assert compared
    for curve in compared:
        for i, size in enumerate(curve.sizes):
            times = [format_quantity(seconds[i] / size, "s") for seconds in (curve.seconds, *curve.peers.values())]
            assert any(line[0] == f"{size:,}" and [line[1], *line[2::2]] == times for line in lines if len(line) > 1)


def test_a_function_is_timed_with_each_size_and_a_loop_once(monkeypatch):
    """With a simulated clock: a call takes 1 s, and the loop takes 3 s for its two elements."""
    clock, shapes = [0.0], set()
    monkeypatch.setattr("benchmarks.measure.time.perf_counter", lambda: sum(clock))
    monkeypatch.setattr("benchmarks.measure.MIN_ELEMENTS", 40)

    def function(x):
        clock.append(1.0)
        shapes.add(np.shape(x))

    loop = Workload(lambda: clock.append(3.0), 2)
    curve = measure_batches("poses", "poses", {"kinlib": function}, {"a loop": loop}, np.zeros((100, 6)), rounds=2)
    assert shapes == {(6,), (10, 6), (100, 6)}
    assert curve == Curve("poses", "poses", (1, 10, 100), (1.0, 1.0, 1.0), {"a loop": (1.5, 15.0, 150.0)})


def expected_cells(row):
    """The cells by which the line of a row is recognised."""
    return {row.name, *([row.peer] if row.peer else []), format_quantity(row.value, row.unit)}


def cells_of(line):
    return {cell.strip().replace("\\", "") for cell in line.split(" | ")} | {line.split(" | ")[0].removeprefix("| ")}


# --- the command ---


@pytest.mark.filterwarnings("ignore")  # peers emit warnings
@pytest.mark.parametrize("name", [name for name in command.SUITE if name not in command.SLOW | NEEDS_BROWSER])
def test_each_benchmark_runs(name, capsys):
    rows, curves = command.run(name, quick=True)
    assert rows
    for row in rows:
        assert row.value >= 0
        assert np.isfinite(row.value)
        assert row.peer_value is None or row.peer_value > 0
        assert row.target >= 0
    for curve in curves:
        assert len(curve.sizes) == len(curve.seconds) > 2
        assert np.isfinite(curve.exponent)
    assert len(capsys.readouterr().out.splitlines()) == len(rows) + len(curves)


def test_the_command_prints_a_table_and_reports_a_benchmark_that_cannot_run(monkeypatch, capsys):
    def run(name, quick):
        if name == "viewer":
            raise MissingRequirementError("there is no browser")
        print(command.format_line(format_row(example_results()["forward_kinematics"][0][0])))
        return [], []

    monkeypatch.setattr(command, "run", run)
    command.main("frames", "viewer", "--quick")
    kind, head, row, missing = capsys.readouterr().out.splitlines()
    assert kind.startswith("processor")
    assert head.split() == ["measurement", "kinlib", "peer's", "value", "peer", "ratio", "target", "result"]
    assert row.split()[-3:] == ["2", "x", "met"]
    assert missing == "viewer was not measured: there is no browser"


def test_the_command_saves_results_only_with_the_option_save(monkeypatch, tmp_path):
    monkeypatch.setattr(command, "run", lambda *_, **__: example_results()["forward_kinematics"])
    monkeypatch.setattr(command, "save", partial(save, path=tmp_path / "results.json"))
    command.main("frames")
    assert not list(tmp_path.iterdir())
    command.main("frames", "--save")
    assert set(load(tmp_path / "results.json").runs) == {"frames"}


def test_results_of_quick_runs_cannot_be_saved(capsys):
    with pytest.raises(SystemExit):
        command.main("--quick", "--save")
    assert "not meaningful" in capsys.readouterr().err


def test_an_unknown_benchmark_is_refused_with_the_list_of_benchmarks(capsys):
    with pytest.raises(SystemExit):
        command.main("speed")
    assert "forward_kinematics" in capsys.readouterr().err
