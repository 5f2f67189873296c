"""exp, log, fk and Jacobians beside other libraries, and a check of a sheet: in a new process, and in one that has computed much."""

import time
from statistics import median

import pytest
from library_rows import CHECK, ROWS, SIZES, Row, in_new_process


# The largest batch comes first, so that in the warmed process memory has been obtained from the system before.
@pytest.mark.filterwarnings("ignore")
@pytest.mark.benchmark(timer=time.thread_time)
@pytest.mark.parametrize(
    ("row", "size"),
    [(row, size) for row in (*ROWS, CHECK) for size in reversed(SIZES) if size <= row.largest],
    ids=lambda value: value.name if isinstance(value, Row) else f"{value:,}",
)
def test_speed(row, size, benchmark, pytestconfig):
    names = {}
    exec(row.lines(size), names)
    benchmark.extra_info |= {"section": row.operation, "library": row.library, "size": size}
    benchmark.extra_info["fresh"] = median(
        in_new_process(row, size) for _ in range(pytestconfig.getoption("processes"))
    )
    benchmark(eval(f"lambda: {row.call}", names))
