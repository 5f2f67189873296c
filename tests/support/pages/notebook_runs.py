"""Keep what nbval executes, so that neither other tests nor the build of the site execute a notebook again.

nbval starts a new kernel for each notebook, executes its cells one after the other, and compares the outputs of those that are
tagged nbval-check-output. All of them are kept here, where `kinsite.execute.execute` reads them from the cache.
"""

from pathlib import Path

import nbformat
import pytest
from kinsite.execute import ROOT, cache_outputs, code_cells
from nbval.plugin import IPyNbCell

from kinlib.view.drawing.picture import ENVIRONMENT_VARIABLE

OUTPUTS: dict[Path, list[list]] = {}
"""The outputs of the cells of each notebook that have been executed so far."""


class Recorder:
    """A pytest plugin that keeps what nbval executes."""

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_setup(self, item):
        """Let the kernel of a notebook, which starts before its first cell, write what a page of the site needs."""
        with pytest.MonkeyPatch.context() as patch:
            if isinstance(item, IPyNbCell):
                patch.setenv(ENVIRONMENT_VARIABLE, "1")
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item):
        """Keep the outputs of a cell that has passed; after the last one, cache those of its notebook."""
        result = yield
        if isinstance(item, IPyNbCell) and item.path.is_relative_to(ROOT):
            keep(item)
        return result


def keep(cell: IPyNbCell):
    """Keep the outputs of a cell, and cache those of its notebook unless a cell is missing, has raised or written to stderr."""
    if cell.cell_num == 0:
        OUTPUTS[cell.path] = []
    kept = OUTPUTS.get(cell.path, [])
    if len(kept) == cell.cell_num:
        kept.append(cell.test_outputs)
    notebook = nbformat.read(cell.path, as_version=4)
    wrong = [one for outputs in kept for one in outputs if one.output_type == "error" or one.get("name") == "stderr"]
    if len(kept) == len(code_cells(notebook)) and not wrong:
        for code, outputs in zip(code_cells(notebook), kept, strict=True):
            code.outputs = outputs
        cache_outputs(notebook, cell.path)
