"""The witnesses: by whom each public function has been compared, read from the tests that did it."""

import sys
from collections.abc import Iterator

from kinsite.execute import ROOT

HEAD = """\
# Who else says so

Each public function of kinlib has been compared with an implementation that we did not write: a package, a number that a
document prints, or, where nobody computes it, an axiom or words written out by hand. This table is read from the tests.
`python course.py test --oracles` doubts each of its lines: the test has to fail without its oracle, and it has to find a
difference when the function errs by a ten-millionth.

| function | compared with |
| --- | --- |
"""


def pages() -> Iterator[tuple[str, str]]:
    """The one page: a row a function, its oracles, and how many tests ask each of them."""
    sys.path.append(str(ROOT / "tests"))
    from oracles import table

    rows = []
    for name, heard in table().items():
        counts = {witness.oracle: [one.oracle for one in heard].count(witness.oracle) for witness in heard}
        asked = "; ".join(oracle + (f" ({count} tests)" if count > 1 else "") for oracle, count in counts.items())
        rows.append(f"| `{name.removeprefix('kinlib.')}` | {asked} |")
    yield "witnesses.md", HEAD + "\n".join(rows) + "\n"
