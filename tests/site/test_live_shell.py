"""What a page reports of a cell: values, prints, figures, and errors with their line in the cell."""

import json
import subprocess
import sys
from pathlib import Path

SHELL = Path(__file__).parents[2] / "site" / "lab" / "live" / "shell.py"
CELLS = {
    "value": "print('before')\n6 * 7",
    "error": "1 + 1\n\n1 / 0",
    "called": "def divide(): return 1 / 0\n\ndivide()",
    "library": "import json\njson.loads('{')",
    "syntax": "1\n2 +",
    "keyboard": "input('name? ')",
    "window": "get_ipython().enable_gui('qt')",
    "unused": "import sympy, sys\nfrom kincourse import find_sheet, sheets\n"
    "first = [find_sheet(name).problems[0].variant('ada') for name in sheets()]\n'sympy.core' in sys.modules",
    "used": "from sympy import symbols\nsymbols('x') ** 2",
    "figure": "import matplotlib.pyplot as plt\nlines = plt.plot([1, 2])",
}

PROGRAM = """
import asyncio, json, sys
reports = []
scope = {"post": lambda text: reports.append(json.loads(text)), "LATER": {"sympy": []}}
exec(open(sys.argv[1]).read(), scope)
for name, source in json.loads(sys.argv[2]).items():
    reports.append({"kind": "begin", "name": name})
    asyncio.run(scope["run"](source))
sys.__stdout__.write(json.dumps(reports))
"""


def test_each_cell_reports_what_it_displays_and_its_error_with_the_line_in_the_cell():
    """In a process of its own, because IPython makes one shell for each process."""
    command = [sys.executable, "-c", PROGRAM, SHELL, json.dumps(CELLS)]
    reports = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    starts = [place for place, report in enumerate(reports) if report["kind"] == "begin"]
    ends = [place for place, report in enumerate(reports) if report["kind"] == "end"]
    cells = {reports[a]["name"]: reports[a + 1 : b] for a, b in zip(starts, ends, strict=True)}
    *printed, value = cells["value"]
    assert "".join(part["text"] for part in printed) == "before\n"
    assert value == {"kind": "display", "data": {"text/plain": "42"}}
    errors = {name: [(one.get("name"), one.get("line")) for one in shown] for name, shown in cells.items()}
    assert errors["error"] == [("ZeroDivisionError", 3)]
    assert errors["called"] == [("ZeroDivisionError", 1)]
    assert errors["library"] == [("JSONDecodeError", 2)]
    assert errors["syntax"] == [("SyntaxError", 2)]
    assert errors["keyboard"] == [("EOFError", 1)]
    assert "Write the value into the cell" in cells["keyboard"][0]["text"]
    assert "in raw_decode" in cells["library"][0]["traceback"]
    assert cells["window"] == []
    assert [one["data"]["text/plain"] for one in cells["unused"]] == ["False"]
    assert [one["kind"] for one in cells["used"]] == ["loading", "loaded", "display"]
    assert cells["used"][-1]["data"]["text/plain"] == "x**2"
    assert "<svg" in cells["figure"][0]["data"]["image/svg+xml"]
