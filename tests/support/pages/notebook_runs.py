"""Runs of notebooks: what nbval executes is recorded, so that the other tests need not execute the notebook again.

nbval starts a new kernel for each notebook, executes its cells one after the other, and compares the outputs of those that are
marked with NBVAL_CHECK_OUTPUT. It ignores the rest of what the kernel sends. Here all of it is recorded, and nbclient turns it
into outputs and widgets, just as if it had executed the notebook itself. The kernels write what a page needs too, so that the
site, which is built later in the same run of the tests, reads these outputs and executes nothing.
"""

import os
import re
import sys
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from unittest.mock import Mock

import nbformat
import psutil
import pytest
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode
from nbval.plugin import IPyNbCell, IPyNbFile

from kinlib.view.drawing.static_page import ENVIRONMENT_VARIABLE

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "site"))

TIMEOUT_S = 600
"""How long a cell may take before a run without nbval is given up. It is a safeguard against endless loops, not a claim."""


@dataclass(frozen=True)
class Run:
    """A notebook with its outputs and the state of its widgets, and the processor time of its kernel."""

    notebook: NotebookNode
    processor_seconds: float


class Recording:
    """What the kernel of one notebook has sent so far: a list of messages for each executed cell."""

    def __init__(self):
        self.messages = []
        self.processor_seconds = 0.0

    def run_of(self, path):
        """Turn the messages into the outputs of a notebook. Returns None unless every cell was executed."""
        notebook = nbformat.read(path, as_version=4)
        code = [(index, cell) for index, cell in enumerate(notebook.cells) if cell.cell_type == "code"]
        if len(code) != len(self.messages):
            return None
        client = NotebookClient(notebook, record_timing=False)
        client.kc = Mock()  # an Output widget sends its state to the kernel, which has ended
        client.reset_execution_trackers()
        for (index, cell), messages in zip(code, self.messages, strict=True):
            cell.outputs, cell.execution_count = [], None
            client.clear_before_next_output = False
            for message in messages:
                if message["msg_type"] != "status":
                    client.process_message(message, cell, index)
        client.set_widgets_metadata()
        return Run(notebook, self.processor_seconds)


RECORDINGS: dict[Path, Recording] = {}


class Recorder:
    """A pytest plugin that records what nbval executes."""

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_setup(self, item):
        """Let the kernel of a notebook, which starts before its first cell, write what a page of the site needs."""
        with pytest.MonkeyPatch.context() as patch:
            if isinstance(item, IPyNbCell):
                patch.setenv(ENVIRONMENT_VARIABLE, "1")
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item):
        """Record the execution of a cell; after the last one, keep the outputs for the site."""
        with recorded(item) if isinstance(item, IPyNbCell) else nullcontext():
            result = yield
        if isinstance(item, IPyNbCell):
            keep_for_the_site(item.parent)
        return result


@contextmanager
def recorded(cell: IPyNbCell):
    """Record what the kernel sends while a cell runs."""
    notebook = cell.parent
    if cell.cell_num == 0:
        RECORDINGS[notebook.path] = Recording()
        record_messages(notebook, RECORDINGS[notebook.path])
    recording = RECORDINGS.get(notebook.path)
    if recording is None or len(recording.messages) != cell.cell_num:  # earlier cells were deselected
        RECORDINGS.pop(notebook.path, None)
        yield
        return
    recording.messages.append([])
    try:
        yield
    finally:
        with suppress(psutil.Error):  # a kernel that has crashed
            used = psutil.Process(notebook.kernel.km.provisioner.pid).cpu_times()
            recording.processor_seconds = used.user + used.system


def keep_for_the_site(notebook: IPyNbFile):
    """Cache the outputs of a lecture or a released sheet, once all of its cells were executed without an error or a warning."""
    from kinsite.execute import cache_outputs, code_cells

    recording = RECORDINGS.get(notebook.path)
    if recording is None or len(recording.messages) < len(code_cells(notebook.nb)):
        return
    if not any(notebook.path.is_relative_to(ROOT / folder) for folder in ("notebooks", "exercises")):
        return
    executed = recording.run_of(notebook.path).notebook
    outputs = [output for cell in code_cells(executed) for output in cell.outputs]
    if not any(output.output_type == "error" or output.get("name") == "stderr" for output in outputs):
        cache_outputs(executed, notebook.path)


def record_messages(notebook: IPyNbFile, recording: Recording):
    """Let a recording see every message that nbval reads from the kernel."""
    read = notebook.get_kernel_message

    def get_kernel_message(timeout=None, stream="iopub"):
        message = read(timeout=timeout, stream=stream)
        recording.messages[-1].append(message)
        return message

    notebook.get_kernel_message = get_kernel_message


@cache
def run_of(path: Path) -> Run:
    """The run of a notebook: that of nbval if it executed all cells in this process, otherwise a new one.

    Fails the test that needs it if a cell raises.
    """
    run = RECORDINGS[path].run_of(path) if path in RECORDINGS else None
    if run:
        outputs = [output for cell in run.notebook.cells for output in cell.get("outputs", [])]
        if raised := next((output for output in outputs if output.output_type == "error"), None):
            pytest.fail(without_colors("\n".join(raised.traceback)), pytrace=False)
        return run
    notebook = nbformat.read(path, as_version=4)
    before = os.times()
    try:
        NotebookClient(notebook, timeout=TIMEOUT_S, resources={"metadata": {"path": path.parent}}).execute()
    except CellExecutionError as error:
        pytest.fail(without_colors(str(error)), pytrace=False)
    after = os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return Run(notebook, used)


def without_colors(text: str) -> str:
    """A traceback without the color codes of a terminal."""
    return re.sub(r"\x1b\[[\d;]*m", "", text)
