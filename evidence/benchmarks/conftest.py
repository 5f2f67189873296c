"""Options of the benchmarks, and results.json, which keeps the last measurement of each row for the site's page on performance.

pytest-benchmark runs and repeats what is timed. Its own file has a hundred numbers for each row and the name of the machine;
results.json has the medians, and for each row the set-up in which it was measured, so that rows can be measured again one by one.
"""

import json
import os
import platform
import sys
from datetime import date
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

ROOT = Path(__file__).parents[2]
RESULTS = Path(__file__).with_name("results.json")
sys.path += [str(ROOT / "tests" / "support"), str(ROOT / "tests" / "support" / "pages")]

PACKAGES = (
    *("jupyterlab", "modern-robotics", "nbgrader", "numpy", "pin", "pytest-benchmark", "pytransform3d"),
    *("roboticstoolbox-python", "scipy", "spatialmath-python"),
)
"""Packages whose versions belong to a set-up; `pin` is Pinocchio."""

KEY = ("section", "library", "size")
"""What a row measures; the rest of it is the result."""


def pytest_addoption(parser):
    """Add the options, which `nox -s benchmarks -- --help` shows."""
    group = parser.getgroup("what is measured")
    group.addoption("--keep", action="store_true", help="write the results into evidence/benchmarks/results.json")
    group.addoption("--processes", type=int, default=3, help="new processes for each row of the library; default: 3")
    group.addoption("--submissions", type=int, default=60, help="how many are graded; default: 60")


def pytest_benchmark_update_json(config, benchmarks, output_json):
    """Keep the results, if this was asked for; pytest-benchmark calls this where it writes its own file."""
    if config.getoption("keep"):
        # a benchmark that has failed has no data
        measured = [{**one.extra_info, "warmed": one.stats.median} for one in benchmarks if one.stats.data]
        kept = json.loads(RESULTS.read_text("utf-8")) if RESULTS.exists() else {"set_ups": [], "rows": []}
        RESULTS.write_text(dumps(merged(kept, measured, describe_set_up())), "utf-8")


def describe_set_up():
    """Say where and when is measured: the kind of machine, how busy it is, and the versions of what is measured."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text("utf-8").splitlines() if info.exists() else []
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return {
        "date": date.today().isoformat(),
        "processor": next(names, platform.machine()),
        "cores": os.cpu_count(),
        "load": round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else None,
        "system": platform.system(),
        "packages": {"Python": platform.python_version()} | dict(filter(None, map(installed, PACKAGES))),
    }


def installed(name):
    """Return the name and the version of a package, or None."""
    try:
        return name, version(name)
    except PackageNotFoundError:
        return None


def merged(kept, measured, set_up):
    """Put measured rows in the place of kept ones, and drop set-ups to which no row belongs any more."""
    rows = {tuple(row[key] for key in KEY): {**row, "set_up": kept["set_ups"][row["set_up"]]} for row in kept["rows"]}
    rows |= {tuple(row[key] for key in KEY): {**row, "set_up": set_up} for row in measured}
    set_ups = []
    for row in rows.values():
        if row["set_up"] not in set_ups:
            set_ups.append(row["set_up"])
    return {"set_ups": set_ups, "rows": [{**row, "set_up": set_ups.index(row["set_up"])} for row in rows.values()]}


def dumps(results):
    """Write results as JSON with a line for each row, and four digits for each time."""
    rows = [
        json.dumps({name: float(f"{x:.4g}") if isinstance(x, float) else x for name, x in row.items()})
        for row in results["rows"]
    ]
    set_ups = ",\n".join(map(json.dumps, results["set_ups"]))
    return f'{{"set_ups": [\n{set_ups}\n],\n"rows": [\n' + ",\n".join(rows) + "\n]}\n"
