"""Keep what nbval executes, so that neither other tests nor the build of the site execute a notebook again.

nbval starts a new kernel for each notebook, executes its cells one after the other, and compares the outputs of those that are
tagged nbval-check-output. It ignores the rest of what the kernel sends. Here all of it is recorded, and nbclient turns it
into outputs and widgets, just as if it had executed the notebook itself. `kinsite.execute.execute` reads these from the cache.
"""

from contextlib import contextmanager, nullcontext
from pathlib import Path
from unittest.mock import Mock

import nbformat
import pytest
from kinsite.execute import ROOT, cache_outputs, code_cells
from nbclient import NotebookClient
from nbval.plugin import IPyNbCell, IPyNbFile

from kinlib.view.drawing.picture import ENVIRONMENT_VARIABLE

MESSAGES: dict[Path, list[list[dict]]] = {}
"""What the kernel of each notebook has sent so far, cell by cell."""


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
        """Record the execution of a cell; after the last one, cache the outputs unless there are errors or warnings."""
        with recorded(item) if isinstance(item, IPyNbCell) else nullcontext():
            result = yield
        if isinstance(item, IPyNbCell) and item.path.is_relative_to(ROOT):
            executed = executed_notebook(item.path)
            outputs = [output for one in code_cells(executed) for output in one.outputs] if executed else []
            if executed and not any(one.output_type == "error" or one.get("name") == "stderr" for one in outputs):
                cache_outputs(executed, item.path)
        return result


@contextmanager
def recorded(cell: IPyNbCell):
    """Record what the kernel sends while a cell runs, unless an earlier cell was deselected."""
    notebook = cell.parent
    if cell.cell_num == 0:
        MESSAGES[notebook.path] = []
        record_messages(notebook)
    if len(messages := MESSAGES.get(notebook.path, [])) == cell.cell_num:
        messages.append([])
    yield


def record_messages(notebook: IPyNbFile):
    """Record every message that nbval reads from the kernel of a notebook."""
    read, messages = notebook.get_kernel_message, MESSAGES[notebook.path]

    def get_kernel_message(timeout=None, stream="iopub"):
        messages[-1].append(message := read(timeout=timeout, stream=stream))
        return message

    notebook.get_kernel_message = get_kernel_message


def executed_notebook(path: Path):
    """Turn the messages of a kernel into the outputs of its notebook. Returns None unless every cell was executed."""
    notebook = nbformat.read(path, as_version=4)
    cells, recorded_messages = code_cells(notebook), MESSAGES.get(path, [])
    if len(cells) != len(recorded_messages):
        return None
    client = NotebookClient(notebook, record_timing=False)
    client.kc = Mock()  # an Output widget sends its state to the kernel, which has ended
    client.reset_execution_trackers()
    for cell, messages in zip(cells, recorded_messages, strict=True):
        cell.outputs = []
        client.clear_before_next_output = False
        for message in messages:
            if message["msg_type"] != "status":
                client.process_message(message, cell, notebook.cells.index(cell))
    client.set_widgets_metadata()
    return notebook
