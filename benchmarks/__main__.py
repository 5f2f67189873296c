"""Measure speed, start-up time and accuracy of kinlib and of other packages, and print one table.

    python -m benchmarks                    all but the slow ones, in a few minutes; run nothing else meanwhile
    python -m benchmarks --all              the slow ones too: first_answer, grading and hub, which take most of an hour
    python -m benchmarks frames viewer      only these benchmarks
    python -m benchmarks --save             also save the results, which the site's page on performance shows
    python -m benchmarks --quick            very small sizes: checks that the benchmarks run, and gives no useful numbers

A peer is measured if it is installed: the peers are the dependency group `peers` of pyproject.toml. Each benchmark is a
module that can be read by itself; measure.py contains what they share.
"""

import argparse
import warnings
from importlib import import_module

from benchmarks.measure import Curve, Row
from benchmarks.results import describe_machine, format_quantity, format_row, save

SUITE = {
    **dict.fromkeys(
        ("forward_kinematics", "jacobians", "exponentials", "importing", "symbolic", "frames", "loops"), "library"
    ),
    **dict.fromkeys(("viewer", "first_answer", "grading", "hub"), "course"),
}
"""The folder of each benchmark, in the order in which they run."""

SLOW = {"first_answer", "grading", "hub"}
"""Benchmarks that run only by name or with --all."""

WIDTHS = {
    "measurement": 50,
    "kinlib": 9,
    "peer's value": 13,
    "peer": 37,
    "ratio": 32,
    "target": 22,
    "result": 12,
}
"""Number of characters of each column."""


def main(*arguments: str) -> None:
    """Run the benchmarks that the arguments name, and print each row as soon as it is measured."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("names", nargs="*", choices=[*SUITE, []], metavar="NAME", help=", ".join(SUITE))
    parser.add_argument("--all", action="store_true", help="include the slow benchmarks")
    parser.add_argument("--save", action="store_true", help="save the results in benchmarks/results.json")
    parser.add_argument("--quick", action="store_true", help="small sizes and one round, to check that everything runs")
    options = parser.parse_args(arguments or None)
    if options.save and options.quick:
        parser.error("--save cannot be combined with --quick, because its numbers are not meaningful")
    names = options.names or [name for name in SUITE if options.all or name not in SLOW]
    print(", ".join(f"{name} {value}" for name, value in describe_machine().items()))
    print(format_line({heading: heading for heading in WIDTHS}))
    for name in names:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # some peers emit warnings
                measured = run(name, options.quick)
        except Exception as error:  # a browser or a peer may fail in any way; the other benchmarks still run
            print(f"{name} was not measured: {error}")
            continue
        if options.save:
            save({name: measured})


def run(name: str, quick: bool) -> tuple[list[Row], list[Curve]]:
    """Run one benchmark, and print its rows and its curves.

    Raises MissingRequirementError or ModuleNotFoundError if the machine lacks something that the benchmark needs.
    """
    benchmark = import_module(f"benchmarks.{SUITE[name]}.{name}")
    rows, curves = [], []
    for row in benchmark.rows(quick):
        rows.append(row)
        print(format_line(format_row(row)), flush=True)
    for curve in benchmark.curves(quick) if hasattr(benchmark, "curves") else ():
        curves.append(curve)
        print(format_curve(curve), flush=True)
    return rows, curves


def format_line(cells: dict[str, str]) -> str:
    """Format a line of the table."""
    return " ".join(f"{text:{WIDTHS[heading]}}" for heading, text in cells.items()).rstrip()


def format_curve(curve: Curve) -> str:
    """Format a curve as one line."""
    pairs = zip(curve.sizes, curve.seconds, strict=True)
    points = ", ".join(f"{size:,.0f}: {format_quantity(seconds, 's')}" for size, seconds in pairs)
    return f"{curve.name}, by {curve.size_name}: {points}; grows with the power {curve.exponent:.2f}"


if __name__ == "__main__":
    main()
