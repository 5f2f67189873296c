"""The numbers on the page about a class on a Hub: what `python -m benchmarks hub --save` has measured, and what follows from it.

This module contains no measured number: the tables for larger classes are computed from the saved results.
"""

import sys
from collections.abc import Iterator, Mapping
from math import ceil

from kinsite.execute import ROOT
from kinsite.generated.performance import markdown_table

sys.path.insert(0, str(ROOT))  # the benchmarks are not an installed package

from benchmarks.measure import Row
from benchmarks.results import format_quantity, load

CLASS_SIZES = (30, 100, 300, 1000)
ARRIVAL_MINUTES = 10
"""In so many minutes a whole class arrives."""

CORE_LOAD = 0.5
"""The share of their time for which the cores are then busy; with a higher share, students wait for each other."""

MEMORY_RESERVE = 1.5
"""How many times the measured memory a machine should have: for what students compute themselves, and for the system."""

MISSING = "The benchmark has not run on this kind of machine yet.\n"


def pages() -> Iterator[tuple[str, str]]:
    """Yield the part of the page `hub.md` that consists of numbers."""
    runs = load().runs.get("hub")
    yield "hub/measured.txt", measured_text({row.name: row for row in runs[0].rows}, runs[0].day) if runs else MISSING


def measured_text(rows: Mapping[str, Row], day: str) -> str:
    """Write the measured values of one run, and the needs of larger classes that follow from them."""
    table = [[name[0].upper() + name[1:], format_quantity(row.value, row.unit)] for name, row in rows.items()]
    values = {name: row.value for name, row in rows.items()}
    needs = [
        [f"{size:,}", f"{gigabytes:.0f} GB", str(cores), "0"]
        for size in CLASS_SIZES
        for gigabytes, cores in [class_needs(size, values)]
    ]
    each = MEMORY_RESERVE * values["memory of a student"] / 1e3
    return f"""\
Measured on {day}, on the machine that is described under [Performance](performance.md):

{markdown_table(("measurement", "value"), table)}

Larger classes are computed from these numbers. The memory is {MEMORY_RESERVE:g} times the measured one: what is added is for what
students compute themselves, and for the system. The cores are those that are busy for {CORE_LOAD:.0%} of the time while a whole class
arrives within {ARRIVAL_MINUTES} minutes and starts its servers; afterwards the class needs fewer.

{markdown_table(("students at once", "memory", "cores", "servers for the browser lab"), needs)}

The memory decides the price. With $n$ students at once, $h$ hours in which they work, and a price of $p$ for a GB of memory in an
hour, the Hub costs about ${each:.2f}\\,n\\,h\\,p$.
"""


def class_needs(size: int, values: Mapping[str, float]) -> tuple[float, int]:
    """Return the memory in GB and the number of cores for so many students at once.

    >>> one = {"memory of a student": 400.0, "memory of the Hub and its proxy": 200.0, "processor time to first result": 3.0}
    >>> class_needs(1000, one)
    (600.3, 10)
    """
    megabytes = size * values["memory of a student"] + values["memory of the Hub and its proxy"]
    cores = ceil(size * values["processor time to first result"] / (60 * ARRIVAL_MINUTES * CORE_LOAD))
    return MEMORY_RESERVE * megabytes / 1e3, cores
