"""The page of independent checks: which implementation each public function is compared with, read from the tests."""

import sys
from collections import Counter
from collections.abc import Iterator

from kinsite.execute import ROOT
from kinsite.markdown import table

HEAD = """\
# Independent checks

Each public function of kinlib that computes is compared with an implementation that we did not write: a package or a number
printed in a document. Where no other implementation exists, the test checks an axiom, or text written by hand. This table is read
from the tests. `python course.py test --oracles` checks that each comparison can fail: the test must fail without its oracle, and
when the function is wrong by 1e-7.
"""


def pages() -> Iterator[tuple[str, str]]:
    """Yield the page: one row for each function, with its oracles and the number of tests that use each."""
    sys.path.append(str(ROOT / "evidence" / "checks"))
    import oracle_table

    rows = []
    for name, comparisons in oracle_table.table().items():
        counts = Counter(comparison.oracle for comparison in comparisons)
        oracles = "; ".join(oracle + (f" ({count} tests)" if count > 1 else "") for oracle, count in counts.items())
        rows.append((f"`{name.removeprefix('kinlib.')}`", oracles))
    yield "independent_checks.md", f"{HEAD}\n{table(['function', 'compared with'], rows)}\n"
