"""The benchmarks: nobody runs twice in a row, what is saved is what was measured, and every benchmark runs."""

import doctest
import json
import re
import time
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from benchmarks import __main__ as command
from benchmarks import measure, results
from benchmarks.measure import Curve, NotHere, Row, Way, compared, in_turns
from benchmarks.results import amount, load, machine, save, times, told

BROWSER = {"viewer"}
"""Where a browser and a server are started, which tests of their own do."""


def test_in_each_round_everybody_has_a_turn_and_nobody_is_always_first():
    seen = []
    in_turns([Way(partial(seen.append, name)) for name in "abc"], rounds=3)
    rounds = ["".join(seen[k : k + 3]) for k in range(0, len(seen), 3)]
    assert rounds == ["abc", "bca", "cab", "abc"]


def test_the_first_round_does_not_count(monkeypatch):
    """By a clock of its own: on a busy machine any round may be the longest."""
    passed, pauses = [0.0], iter([50, 1, 2, 3])
    monkeypatch.setattr("benchmarks.measure.time.perf_counter", lambda: sum(passed))
    (seconds,) = in_turns([Way(lambda: passed.append(next(pauses)))], rounds=3)
    assert list(seconds) == [1, 2, 3]


def test_a_way_that_does_many_things_is_told_by_the_thing():
    one, many = (Way(partial(time.sleep, 0.02), things) for things in (1, 1000))
    (once,), (each,) = in_turns([one, many], rounds=1)
    assert once >= 0.02
    assert 0.02 / 1000 <= each < once


def test_a_peer_that_is_not_installed_leaves_a_row_without_a_verdict():
    def missing():
        raise ModuleNotFoundError("peer")

    (row,) = compared("something", Way(int), {"peer": (missing, 2.0)}, rounds=1)
    assert (row.theirs, row.figure, row.met) == (None, None, None)
    assert told(row)["peer's"] == "not installed"
    assert told(row)["result"] == "not measured"


@pytest.mark.parametrize(
    ("row", "figure", "met"),
    [
        (Row("faster", "s", 1.0, 2.0, "peer", 3.0), 3.0, True),
        (Row("by the median of the rounds", "s", 1.0, 2.0, "peer", 3.0, quartiles=(1.0, 1.9, 4.0)), 1.9, False),
        (Row("not fast enough", "s", 1.0, 4.0, "peer", 3.0), 3.0, False),
        (Row("not much slower", "s", 1.2, 1.3, "peer", 1.0, at_most=True), 1.2, True),
        (Row("too much slower", "s", 1.4, 1.3, "peer", 1.0, at_most=True), 1.4, False),
        (Row("short enough", "operations", 272, 275, at_most=True), 272, True),
        (Row("too long", "operations", 276, 275, at_most=True), 276, False),
        (Row("none is off", "tables", 0, 0, at_most=True), 0, True),
    ],
    ids=lambda value: value.what if isinstance(value, Row) else "",
)
def test_a_row_is_judged_by_what_was_wanted(row, figure, met):
    assert row.figure == pytest.approx(figure)
    assert row.met is met


def test_an_exponent_is_that_of_the_upper_range():
    """Below, a constant hides it."""
    sizes = tuple(10.0**k for k in range(9))
    curve = Curve("poses", "configurations", sizes, tuple(1e3 + size**1.5 for size in sizes))
    assert curve.exponent == pytest.approx(1.5, abs=0.1)
    assert Curve("poses", "joints", (1, 2, 4, 8), (3.0, 12.0, 48.0, 192.0)).exponent == pytest.approx(2)


@pytest.mark.parametrize(
    ("value", "unit", "said"),
    [(0.75, "s", "750 ms"), (2, "s", "2 s"), (4.2e-6, "s", "4.2 µs"), (2.7e-7, "s", "270 ns"), (3e-16, "", "3e-16")],
)
def test_amounts_are_said_as_people_say_them(value, unit, said):
    assert amount(value, unit) == said


def test_a_ratio_has_no_more_digits_than_it_means():
    assert [times(x) for x in (0.5514, 2.0, 123.4, 2345.6)] == ["0.551", "2", "123", "2,350"]


@pytest.mark.parametrize("module", [measure, results])
def test_examples_in_docstrings_run(module):
    assert doctest.testmod(module).attempted > 0
    assert doctest.testmod(module).failed == 0


# --- what is kept ---


def measured(ours=1.0):
    row = Row("poses", "s", ours, 2.0, "peer", 3.0, quartiles=(2.5, 2.9, 3.5))
    return {"forward_kinematics": ([row], [Curve("poses", "joints", (1, 2), (1e-3, 2e-3))])}


def test_what_was_saved_is_read_as_it_was_measured(tmp_path):
    path = tmp_path / "results.json"
    save(measured(), path)
    (run,) = load(path).runs["forward_kinematics"]
    (rows, curves) = measured()["forward_kinematics"]
    assert (list(run.rows), list(run.curves)) == (rows, curves)
    assert load(path).machine == machine()


def test_the_last_two_runs_are_kept_the_last_one_first(tmp_path):
    path = tmp_path / "results.json"
    for ours in (1.0, 2.0, 3.0):
        save(measured(ours), path)
    save({"loops": ([], [])}, path)
    assert [run.rows[0].ours for run in load(path).runs["forward_kinematics"]] == [3.0, 2.0]
    assert set(load(path).runs) == {"forward_kinematics", "loops"}


def test_numbers_of_another_machine_are_not_mixed_with_those_of_this_one(tmp_path, monkeypatch):
    path = tmp_path / "results.json"
    save(measured(), path)
    monkeypatch.setattr(results, "processor", lambda: "another one")
    save({"loops": ([], [])}, path)
    assert set(load(path).runs) == {"loops"}


def test_what_is_saved_says_of_the_machine_only_what_kind_it_is(tmp_path):
    import getpass
    import socket

    path = tmp_path / "results.json"
    save(measured(), path)
    said = json.loads(path.read_text("utf-8"))
    assert set(said["machine"]) == {"processor", "cores", "system", "Python", *results.PACKAGES}
    for secret in (socket.gethostname(), getpass.getuser(), str(Path.home())):
        assert secret not in said["machine"].values()


def test_the_page_on_performance_shows_every_row_that_is_kept_and_says_each_picture_in_words():
    import built_site  # noqa: F401 - it lets kinsite be found
    from kinsite import performance

    shown = dict(performance.pages())
    page = shown.pop("performance.md")
    kept = load()
    for name, (last, *_) in kept.runs.items():
        assert f"## {name.replace('_', ' ').capitalize()}\n" in page
        for row in last.rows:
            (line,) = [line for line in page.splitlines() if line.startswith("| ") and telling(row) <= words_of(line)]
            assert line.endswith(f"| {told(row)['result']} |")
    pictures = dict(re.findall(r"^!\[([^\]]{20,})\]\((\S+\.svg)\)$", page, re.MULTILINE))
    assert set(pictures.values()) == set(shown)
    assert len(shown) == sum(len(runs[0].curves) for runs in kept.runs.values())


def telling(row):
    """What a line of the page must hold to be that of a row."""
    return {row.what, *([row.peer] if row.peer else []), amount(row.ours, row.unit)}


def words_of(line):
    return {cell.strip().replace("\\", "") for cell in line.split(" | ")} | {line.split(" | ")[0].removeprefix("| ")}


# --- the command ---


@pytest.mark.filterwarnings("ignore")  # peers warn while they are loaded, and on their way
@pytest.mark.parametrize("name", [name for name in command.SUITE if name not in command.SLOW | BROWSER])
def test_each_benchmark_runs(name, capsys):
    rows, curves = command.run(name, quick=True)
    assert rows
    for row in rows:
        assert row.ours >= 0
        assert np.isfinite(row.ours)
        assert row.theirs is None or row.theirs > 0
        assert row.wanted >= 0
    for curve in curves:
        assert len(curve.sizes) == len(curve.seconds) > 2
        assert np.isfinite(curve.exponent)
    assert len(capsys.readouterr().out.splitlines()) == len(rows) + len(curves)


def test_the_command_prints_a_table_and_says_what_could_not_be_measured(monkeypatch, capsys):
    def run(name, quick):
        if name == "viewer":
            raise NotHere("there is no browser")
        print(command.line(told(measured()["forward_kinematics"][0][0])))
        return [], []

    monkeypatch.setattr(command, "run", run)
    command.main("frames", "viewer", "--quick")
    kind, head, row, missing = capsys.readouterr().out.splitlines()
    assert kind.startswith("processor")
    assert head.split() == ["what", "kinlib", "peer's", "peer", "ratio", "wanted", "result"]
    assert row.split()[-3:] == ["2", "x", "met"]
    assert missing == "viewer was not measured: there is no browser"


def test_the_command_saves_where_it_is_asked_to(monkeypatch, tmp_path):
    monkeypatch.setattr(command, "run", lambda *_, **__: measured()["forward_kinematics"])
    monkeypatch.setattr(command, "save", partial(save, path=tmp_path / "results.json"))
    command.main("frames")
    assert not list(tmp_path.iterdir())
    command.main("frames", "--save")
    assert set(load(tmp_path / "results.json").runs) == {"frames"}


def test_numbers_that_mean_nothing_are_not_saved(capsys):
    with pytest.raises(SystemExit):
        command.main("--quick", "--save")
    assert "means nothing" in capsys.readouterr().err


def test_a_name_that_is_no_benchmark_is_refused_with_those_that_are(capsys):
    with pytest.raises(SystemExit):
        command.main("speed")
    assert "forward_kinematics" in capsys.readouterr().err
