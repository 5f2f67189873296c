"""How fast, how soon and how right, beside those that others use: one command, one table.

    python -m benchmarks                    all but grading, in some minutes; leave the machine alone meanwhile
    python -m benchmarks --all              grading too, which takes a quarter of an hour
    python -m benchmarks frames viewer      some of them
    python -m benchmarks --save             and keep the results, which the site's page on performance shows
    python -m benchmarks --quick            everything so small that the numbers mean nothing: does it run?

A peer is measured where it is installed: they are the dependency group `peers` of pyproject.toml. The benchmarks are modules
of their own, made to be read; measure.py holds what they share.
"""

import argparse
import warnings
from importlib import import_module

from benchmarks.measure import Curve, Row
from benchmarks.results import amount, machine, save, told

SUITE = {
    **dict.fromkeys(
        ("forward_kinematics", "jacobians", "exponentials", "importing", "symbolic", "frames", "loops"), "library"
    ),
    **dict.fromkeys(("viewer", "grading"), "course"),
}
"""The folder of each benchmark, in the order in which they run."""

SLOW = {"grading"}
WIDTHS = {"what": 50, "kinlib": 9, "peer's": 13, "peer": 37, "ratio": 32, "wanted": 22, "result": 12}
"""Letters for each column."""


def main(*words: str) -> None:
    """Measure what the words name, and print a line as soon as it is known."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("names", nargs="*", choices=[*SUITE, []], metavar="NAME", help=", ".join(SUITE))
    parser.add_argument("--all", action="store_true", help="the slow ones too")
    parser.add_argument("--save", action="store_true", help="keep the results in benchmarks/results.json")
    parser.add_argument("--quick", action="store_true", help="small sizes, one round: only to try it")
    chosen = parser.parse_args(words or None)
    if chosen.save and chosen.quick:
        parser.error("what --quick measures means nothing: it is not saved")
    names = chosen.names or [name for name in SUITE if chosen.all or name not in SLOW]
    print(", ".join(f"{name} {value}" for name, value in machine().items()))
    print(line({name: name for name in WIDTHS}))
    for name in names:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # some peers warn on their way
                measured = run(name, chosen.quick)
        except Exception as error:  # a browser or a peer may fail in any way, and the others are measured all the same
            print(f"{name} was not measured: {error}")
            continue
        if chosen.save:
            save({name: measured})


def run(name: str, quick: bool) -> tuple[list[Row], list[Curve]]:
    """Measure one benchmark, and print its rows and its curves.

    Raises NotHere or ModuleNotFoundError for what it cannot do without.
    """
    benchmark = import_module(f"benchmarks.{SUITE[name]}.{name}")
    rows, curves = [], []
    for row in benchmark.rows(quick):
        rows.append(row)
        print(line(told(row)), flush=True)
    for curve in benchmark.curves(quick) if hasattr(benchmark, "curves") else ():
        curves.append(curve)
        print(growth(curve), flush=True)
    return rows, curves


def line(cells: dict[str, str]) -> str:
    """A line of the table."""
    return " ".join(f"{text:{WIDTHS[head]}}" for head, text in cells.items()).rstrip()


def growth(curve: Curve) -> str:
    """A curve in one line."""
    points = ", ".join(f"{size:,.0f}: {amount(s, 's')}" for size, s in zip(curve.sizes, curve.seconds, strict=True))
    return f"{curve.what}, by {curve.of}: {points}; grows with the power {curve.exponent:.2f}"


if __name__ == "__main__":
    main()
