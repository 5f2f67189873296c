"""Format results, save them in benchmarks/results.json and load them; the site's page on performance shows that file.

The file describes the kind of machine, and contains nothing else about it. It keeps the last two runs of each benchmark, so
that a reader can see how much the numbers vary.
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
"""Packages whose versions are saved with the results; `pin` is Pinocchio."""

RUNS_KEPT = 2
DIGITS = 4
"""Significant digits of each saved number."""


@dataclass(frozen=True)
class Run:
    """One run of a benchmark: its date, the rows of its table, its curves."""

    day: str
    rows: tuple[Row, ...]
    curves: tuple[Curve, ...]


@dataclass(frozen=True)
class Results:
    """All results of one kind of machine.

    machine  its processor, system and installed versions, by name
    runs     by benchmark, the latest one first
    """

    machine: Mapping[str, str]
    runs: Mapping[str, tuple[Run, ...]]


def describe_machine() -> dict[str, str]:
    """Return the kind of this machine, and the versions of the packages that are measured on it."""
    description = {
        "processor": processor_name(),
        "cores": str(os.cpu_count()),
        "system": platform.system(),
        "Python": platform.python_version(),
    }
    for name in PACKAGES:
        try:
            description[name] = version(name)
        except PackageNotFoundError:
            description[name] = "not installed"
    return description


def processor_name() -> str:
    """Return the model name of the processor."""
    try:
        lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), platform.machine())


def load(path: Path = PATH) -> Results:
    """Load saved results.

    Raises FileNotFoundError if nothing has been saved.
    """
    data = json.loads(path.read_text("utf-8"))
    runs = {name: tuple(map(_parse_run, kept)) for name, kept in data["runs"].items()}
    return Results(data["machine"], runs)


def save(measured: Mapping[str, tuple[list[Row], list[Curve]]], path: Path = PATH) -> Results:
    """Add runs to the saved results, and return all of them.

    Saved runs of another kind of machine, or of other versions, are removed, because they must not be compared with these.
    """
    machine, runs = describe_machine(), {}
    if path.exists() and (saved := load(path)).machine == machine:
        runs = dict(saved.runs)
    for name, (rows, curves) in measured.items():
        run = Run(date.today().isoformat(), tuple(rows), tuple(curves))
        runs[name] = (run, *runs.get(name, ()))[:RUNS_KEPT]
    data = {
        "machine": machine,
        "runs": {name: [_round_floats(asdict(run)) for run in kept] for name, kept in runs.items()},
    }
    path.write_text(json.dumps(data, indent=1) + "\n", "utf-8")
    return load(path)


def format_row(row: Row) -> dict[str, str]:
    """Format the cells of a row, by the headings of the table."""
    target = f"at most {row.target:g}" if row.at_most else f"{row.target:,g} x"
    if row.peer and row.at_most:
        target += " x"
    elif not row.peer:
        target = f"at most {format_quantity(row.target, row.unit)}"
    peer_value, ratio = "", ""
    if row.peer:
        peer_value = "not installed" if row.peer_value is None else format_quantity(row.peer_value, row.unit)
        ratio = "" if row.ratio_or_value is None else format_ratio(row.ratio_or_value)
    if row.quartiles:
        ratio += f" ({format_ratio(row.quartiles[0])} to {format_ratio(row.quartiles[2])})"
    return {
        "measurement": row.name,
        "kinlib": format_quantity(row.value, row.unit),
        "peer's value": peer_value,
        "peer": row.peer,
        "ratio": ratio,
        "target": target,
        "result": {True: "met", False: "missed", None: "not measured"}[row.meets_target],
    }


def format_quantity(value: float, unit: str) -> str:
    """Format a number with its unit, where seconds get the prefix that fits.

    >>> format_quantity(0.0000234, "s"), format_quantity(3, "tables"), format_quantity(3.2e-9, "")
    ('23.4 µs', '3 tables', '3e-09')
    """
    if unit != "s":
        return f"{value:.0f} {unit}" if unit else f"{value:.0e}"
    for scale, name in ((1, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if value >= scale:
            return f"{value / scale:.3g} {name}"
    return f"{value / 1e-9:.3g} ns"


def format_ratio(ratio: float) -> str:
    """Format a ratio with three significant digits, or as "over a million".

    >>> format_ratio(1.234), format_ratio(56.7), format_ratio(1234.5), format_ratio(1.4e7)
    ('1.23', '56.7', '1,230', 'over a million')
    """
    if ratio >= 1e6:
        return "over a million"
    return f"{float(f'{ratio:.3g}'):,g}"


def _parse_run(data: Mapping[str, Any]) -> Run:
    rows, curves = (
        [
            {key: tuple(value) if isinstance(value, list) else value for key, value in item.items()}
            for item in data[part]
        ]
        for part in ("rows", "curves")
    )
    for curve in curves:
        curve["peers"] = {name: tuple(seconds) for name, seconds in curve.get("peers", {}).items()}
    return Run(data["day"], tuple(Row(**row) for row in rows), tuple(Curve(**curve) for curve in curves))


def _round_floats(value: Any) -> Any:
    """Round every float inside a value to its significant digits."""
    if isinstance(value, dict):
        return {name: _round_floats(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_round_floats(part) for part in value]
    return float(f"{value:.{DIGITS}g}") if isinstance(value, float) else value
