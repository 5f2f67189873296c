"""Run the cells of a submission as a notebook would: IPython, magics, displays, one cell after the other.

The output is one line of JSON for each cell, written as soon as the cell has run: if a later cell ends the process, the
answers before it are already written. The submission's code can write to the same pipe, so its reader trusts no line.

What works in Jupyter and cannot work here is passed over, and the rest of the cell runs: shell commands, packages that are
not installed here, files that are not here, the network, the keyboard, windows. A note in the output of the cell says what
was passed over. This is no gain for anybody, because a student could as well have left out the line.
"""

import ast
import dis
import os
import re
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from traceback import format_exception
from types import TracebackType
from typing import Any, cast

from IPython.core.interactiveshell import ExecutionResult, InteractiveShell
from IPython.utils.text import SList
from traitlets import Type

from misstep.display.shell import CellShell
from misstep.grading.collect.run_plan import PASSED_OVER, RERUN_SOURCE
from misstep.grading.redacted_sheet import AnswerWithheld
from misstep.grading.sandbox.course_stub import Unavailable, Withheld
from misstep.grading.sandbox.kept_output import OutputBudget, ShownDisplays, TruncatedStream
from misstep.grading.sandbox.limits import TOO_SLOW, Limits
from misstep.sheet import OpenSheet
from misstep.storage.deserialize import MIME

WARM_UP_CELLS = (
    "import numpy as np\nnp.eye(4)",
    "from IPython.display import Markdown\ndisplay(Markdown('$x$'))\nprint('text')",
    "%time 1 + 1",
    "def fails():\n    1 / 0\nfails()",
    "this is no Python",
)

FIRST_FIGURE = "%matplotlib inline\nimport matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.close('all')"
"""A further cell to run before the first submission, if matplotlib is installed."""

MAX_TRACEBACK_FRAMES = 20
"""How many frames of a traceback are kept, the last ones."""

REPEAT_INTERRUPT_SECONDS = 1.0
"""Seconds after which a cell that caught its interrupt is interrupted again."""

MAX_TRACEBACK_LINES = 200
"""How many lines of a traceback are kept, the last ones: an error may have others as its causes."""

MAX_PASSED_OVER = 50
"""How many statements of a cell are recorded as passed over."""

SHELL_MAGICS = {"conda", "mamba", "micromamba", "pip", "uv", "sx", "system"}
"""Line magics that start other programs."""

SHELL_CELL_MAGICS = {
    *["!", "bash", "cmd", "perl", "pypy", "python", "python2", "python3", "ruby", "script", "sh", "sx", "system"]
}
"""Cell magics that start other programs."""

MEASURING_MAGIC = re.compile(r"\A\s*%%(time|capture)\b.*\n")
"""Cell magics that run their cell as it is. They are left out, so that statements of the cell can be passed over."""

USES_SHEET = re.compile(r"\bsheet\.(check|given|problem|show|tally)\b")

PASSED_ERRORS = (ModuleNotFoundError, EOFError, OSError, Withheld, AnswerWithheld)
"""The errors of statements that need what is not here: a package, the keyboard, a file, the network, a program, an answer.

A statement that reads right answers is passed over too, but its error stays in the output, so that it is seen."""


class CellTimeout(BaseException):
    """A cell took too long. It is not an Exception, so that `except Exception` does not catch it."""


class SubmissionShell(CellShell):
    """An IPython shell that records displays and errors instead of printing them."""

    no_input = "input() cannot be used while a sheet is graded. Write the value into the cell instead."
    display_pub_class = Type(ShownDisplays)
    errors: Sequence[dict[str, Any]] = ()
    passed_over: Sequence[str] = ()
    source = ""

    async def run_code(self, code_obj: Any, result: ExecutionResult | None = None, *, async_: bool = False) -> bool:
        """Run one statement; whether the cell stops here. A statement that needs what is not here is passed over.

        The names that it would have set are set to a placeholder, unless they have a value.
        """
        _keep_figures_inline()
        errors = self.errors
        has_failed = bool(await super().run_code(code_obj, result, async_=async_))
        error = result.error_in_exec if result else None
        if not has_failed or result is None or not isinstance(error, PASSED_ERRORS):
            return has_failed
        result.error_in_exec = None
        if not isinstance(error, AnswerWithheld):
            self.errors = errors
            start = min((line for *_, line in code_obj.co_lines() if line), default=1)
            lines = self.source.splitlines()[start - 1 :]
            self.pass_over(f"{lines[0].strip() if lines else 'a statement'} ({type(error).__name__}: {error})")
        for step in dis.get_instructions(code_obj):
            if step.opname == "STORE_NAME":
                self.user_ns.setdefault(
                    step.argval, Unavailable(f"{step.argval} is not available while a sheet is graded.")
                )
        return False

    def pass_over(self, what: str) -> None:
        """Record what was passed over."""
        self.passed_over = [*self.passed_over, " ".join(what.split())[:200]][:MAX_PASSED_OVER]

    def run_line_magic(self, magic_name: str, line: str, _stack_depth: int = 1) -> Any:
        """Run a line magic, unless it starts a program or is one of a kernel; figures are always inline."""
        if magic_name in SHELL_MAGICS or self.find_line_magic(magic_name) is None:
            return self.pass_over(f"%{magic_name} {line}")
        return super().run_line_magic(magic_name, "inline" if magic_name == "matplotlib" else line, _stack_depth + 1)

    def run_cell_magic(self, magic_name: str, line: str, cell: str) -> Any:
        """Run a cell magic, unless it starts a program or is one of a kernel."""
        if magic_name in SHELL_CELL_MAGICS or self.find_cell_magic(magic_name) is None:
            return self.pass_over(f"%%{magic_name} {line}")
        return super().run_cell_magic(magic_name, line, cell)

    def system(self, cmd: str) -> None:
        """Pass over the line `!cmd`."""
        self.pass_over(f"!{cmd}")
        self.user_ns["_exit_code"] = 0

    def getoutput(self, cmd: str, split: bool = True, depth: int = 0) -> Any:
        """Pass over the expression `!cmd`, which has no lines then."""
        self.pass_over(f"!{cmd}")
        return SList() if split else ""

    def report_error(self, error: BaseException, trace: TracebackType | None) -> None:
        """Record an error; that of a timeout without the place, because two runs are not interrupted at the same one."""
        is_timeout = isinstance(error, CellTimeout)
        shown = format_exception(
            type(error), error, None if is_timeout else trace, limit=-MAX_TRACEBACK_FRAMES, chain=not is_timeout
        )
        lines = "".join(shown).splitlines()
        output = {
            "output_type": "error",
            "ename": type(error).__name__[:200],
            "evalue": str(error)[:2000],
            "traceback": [line[:1000] for line in lines[-MAX_TRACEBACK_LINES:]],
        }
        self.errors = [*self.errors, output]


class OneImportAtATime(ast.NodeTransformer):
    """Splits `import pandas, numpy`, so that the packages that are installed are imported."""

    def visit_Module(self, node: ast.Module) -> ast.Module:
        """Split the imports that are statements of the cell itself."""
        node.body = [
            ast.copy_location(one, statement)
            for statement in node.body
            for one in (
                [ast.Import(names=[name]) for name in statement.names]
                if isinstance(statement, ast.Import)
                else [statement]
            )
        ]
        return node


def new_shell(warm_up: Sequence[str] = ()) -> SubmissionShell:
    """Make the shell that is forked for each submission. It has already run some cells, because first calls are slow."""
    shell = SubmissionShell.start()
    shell.ast_transformers.append(OneImportAtATime())
    first_figure = [FIRST_FIGURE] if "matplotlib.pyplot" in sys.modules else []
    for source in (*WARM_UP_CELLS, *first_figure, *warm_up):
        _run_cell(shell, source)
    shell.reset(new_session=True)
    return shell


def run_cells(shell: SubmissionShell, sources: Sequence[str], limits: Limits, report: Callable[[bytes], None]) -> None:
    """Run the cells in order, each within its limits of time, and report the outputs of each as a line of JSON.

    A cell with the source RERUN_SOURCE runs again, in their order, those before it that failed or handed in nothing: what
    they need may be further down. Where `sheet` is no open sheet any more, the last one is put back before it is used.
    """
    signal.signal(signal.SIGPROF, _interrupt)
    signal.signal(signal.SIGALRM, _interrupt)
    budget = OutputBudget()
    opened: OpenSheet | None = None
    done: list[list[dict[str, Any]]] = []

    def run(source: str) -> list[dict[str, Any]]:
        nonlocal opened
        shell.passed_over = []
        if opened and USES_SHEET.search(source) and not isinstance(shell.user_ns.get("sheet"), OpenSheet):
            shell.user_ns["sheet"] = opened
            shell.pass_over("the variable sheet, which had another value or none, is the sheet again")
        signal.setitimer(signal.ITIMER_PROF, limits.cell_seconds, REPEAT_INTERRUPT_SECONDS)
        signal.setitimer(signal.ITIMER_REAL, limits.cell_wall_seconds, REPEAT_INTERRUPT_SECONDS)
        try:
            outputs = _run_cell(shell, source)
        except CellTimeout:  # the signal arrived outside of the cell's own code
            outputs = []
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.setitimer(signal.ITIMER_REAL, 0)
        if isinstance(sheet := shell.user_ns.get("sheet"), OpenSheet):
            opened = sheet
        notes = "".join(f"{PASSED_OVER}{what}\n" for what in shell.passed_over)
        return [*outputs, {"output_type": "stream", "name": "stderr", "text": notes}] if notes else outputs

    for number, source in enumerate(sources):
        if source == RERUN_SOURCE:
            outputs = []
            for k, first in enumerate(done):
                if _needs_second_pass(first):
                    outputs += run(sources[k])
                else:
                    outputs += [output for output in first if output.get("ename") == "CellTimeout"]
        else:
            outputs = run(source)
            done.append(outputs)
        report(budget.encode_cell(number, outputs))


def _needs_second_pass(outputs: Sequence[Mapping[str, Any]]) -> bool:
    """Whether a cell failed, other than by its time, or handed in nothing for its problem."""
    return any(
        output.get("ename", "CellTimeout") != "CellTimeout"
        or (isinstance(emission := output.get("data", {}).get(MIME), dict) and emission.get("answer") is None)
        for output in outputs
    )


def _run_cell(shell: SubmissionShell, source: str) -> list[dict[str, Any]]:
    publisher = cast("ShownDisplays", shell.display_pub)
    publisher.outputs, shell.errors = [], []
    captured = {"stdout": TruncatedStream(), "stderr": TruncatedStream()}
    originals = sys.stdout, sys.stderr
    sys.stdout, sys.stderr = captured.values()
    shell.source = source = MEASURING_MAGIC.sub("", source, count=1) if MEASURING_MAGIC.match(source) else source
    try:
        shell.run_cell(source, store_history=False)
    finally:
        sys.stdout, sys.stderr = originals
    streams = [
        {"output_type": "stream", "name": name, "text": text}
        for name, stream in captured.items()
        if (text := stream.getvalue())
    ]
    return [*streams, *publisher.outputs, *shell.errors]


def write_all(descriptor: int, data: bytes) -> None:
    """Write all of the data to a descriptor, in as many steps as it takes."""
    while data:
        data = data[os.write(descriptor, data) :]


def _interrupt(*_: Any) -> None:
    raise CellTimeout(TOO_SLOW)


def _keep_figures_inline() -> None:
    """Once matplotlib is imported, let its functions that choose a window do nothing, because there is none."""
    for name, function in (("matplotlib", "use"), ("matplotlib.pyplot", "switch_backend")):
        module = sys.modules.get(name)
        if module and getattr(module, function, _keep_backend) is not _keep_backend:
            if name == "matplotlib.pyplot":
                InteractiveShell.instance().enable_matplotlib("inline")
            setattr(module, function, _keep_backend)


def _keep_backend(*_: object, **__: object) -> None:
    """Do nothing, because there is no window: figures are drawn inline."""
