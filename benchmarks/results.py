"""What was measured, in words and as a file: benchmarks/results.json, from which the site draws its page on performance.

The file holds what is measured and the kind of machine, and nothing else of the machine. Of each benchmark it keeps the
last two runs, so that a reader sees how far to trust a number.
"""

import json
import os
import platform
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from datetime import date
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from benchmarks.measure import Curve, Row

PATH = Path(__file__).with_name("results.json")
PACKAGES = (
    "numpy",
    "AutoDH",
    "ipywidgets",
    "jupyterlab",
    "matplotlib",
    "modern-robotics",
    "nbgrader",
    "pin",
    "pytransform3d",
    "roboticstoolbox-python",
    "scipy",
    "sympy",
)
"""Whose versions say what was measured; `pin` is Pinocchio."""

KEPT = 2
DIGITS = 4


@dataclass(frozen=True)
class Run:
    """One run of a benchmark: its day, the rows of its table, its curves."""

    day: str
    rows: tuple[Row, ...]
    curves: tuple[Curve, ...]


@dataclass(frozen=True)
class Results:
    """All that was measured on one kind of machine.

    machine  what is known of it, by name
    runs     by benchmark, the last one first
    """

    machine: Mapping[str, str]
    runs: Mapping[str, tuple[Run, ...]]


def machine() -> dict[str, str]:
    """The kind of machine that this is, and the versions that were measured."""
    found = {
        "processor": processor(),
        "cores": str(os.cpu_count()),
        "system": platform.system(),
        "Python": platform.python_version(),
    }
    for name in PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed"
    return found


def processor() -> str:
    """What the processor calls itself."""
    try:
        lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), platform.machine())


def load(path: Path = PATH) -> Results:
    """Read what was saved.

    Raises FileNotFoundError where nothing was.
    """
    data = json.loads(path.read_text("utf-8"))
    runs = {name: tuple(map(_run, kept)) for name, kept in data["runs"].items()}
    return Results(data["machine"], runs)


def save(measured: Mapping[str, tuple[list[Row], list[Curve]]], path: Path = PATH) -> Results:
    """Add runs to what was saved. Runs on another kind of machine, or of other versions, are dropped: nobody may compare them."""
    here, runs = machine(), {}
    if path.exists() and (before := load(path)).machine == here:
        runs = dict(before.runs)
    for name, (rows, curves) in measured.items():
        run = Run(date.today().isoformat(), tuple(rows), tuple(curves))
        runs[name] = (run, *runs.get(name, ()))[:KEPT]
    data = {"machine": here, "runs": {name: [_rounded(asdict(run)) for run in kept] for name, kept in runs.items()}}
    path.write_text(json.dumps(data, indent=1) + "\n", "utf-8")
    return load(path)


def told(row: Row) -> dict[str, str]:
    """A row in words, by the heads of the table."""
    wanted = f"at most {row.wanted:g}" if row.at_most else f"{row.wanted:,g} x"
    if row.peer and row.at_most:
        wanted += " x"
    elif not row.peer:
        wanted = f"at most {amount(row.wanted, row.unit)}"
    figure = "" if row.figure is None or not row.peer else times(row.figure)
    return {
        "what": row.what,
        "kinlib": amount(row.ours, row.unit),
        "peer's": "" if not row.peer else "not installed" if row.theirs is None else amount(row.theirs, row.unit),
        "peer": row.peer,
        "ratio": figure + (f" ({times(row.quartiles[0])} to {times(row.quartiles[2])})" if row.quartiles else ""),
        "wanted": wanted,
        "result": {True: "met", False: "missed", None: "not measured"}[row.met],
    }


def amount(value: float, unit: str) -> str:
    """A number with its unit, as people say it.

    >>> amount(0.0000234, "s"), amount(3, "tables"), amount(3.2e-9, "")
    ('23.4 µs', '3 tables', '3e-09')
    """
    if unit != "s":
        return f"{value:.0f} {unit}" if unit else f"{value:.0e}"
    for scale, name in ((1, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if value >= scale:
            return f"{value / scale:.3g} {name}"
    return f"{value / 1e-9:.3g} ns"


def times(ratio: float) -> str:
    """A ratio in two or three digits; beyond a million nobody counts.

    >>> times(1.234), times(56.7), times(1234.5), times(1.4e7)
    ('1.23', '56.7', '1,230', 'over a million')
    """
    if ratio >= 1e6:
        return "over a million"
    return f"{float(f'{ratio:.3g}'):,g}"


def _run(data: Mapping[str, Any]) -> Run:
    rows = (Row(**{name: tuple(v) if isinstance(v, list) else v for name, v in row.items()}) for row in data["rows"])
    curves = (
        Curve(**{name: tuple(v) if isinstance(v, list) else v for name, v in curve.items()}) for curve in data["curves"]
    )
    return Run(data["day"], tuple(rows), tuple(curves))


def _rounded(value: Any) -> Any:
    """The same with numbers of so many digits as mean something."""
    if isinstance(value, dict):
        return {name: _rounded(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_rounded(part) for part in value]
    return float(f"{value:.{DIGITS}g}") if isinstance(value, float) else value
