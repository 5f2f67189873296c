"""Run the cells of a page in IPython, and report each output and each change of a widget as soon as it exists.

worker.js loads this file in Pyodide.
"""

import builtins
import io
import json
import logging
import os
import site
import sys
import time
import zipfile
from base64 import b64encode
from importlib import invalidate_caches
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from traceback import format_exception
from types import ModuleType
from typing import Any, ClassVar

os.environ["NOTEBOOK_STATIC_PAGE"] = "live"  # questions in the form that the page's script runs, widgets with Python
os.environ["JUPYTER_WIDGETS_ECHO"] = "0"  # the page knows what it has set
os.environ["MPLBACKEND"] = "agg"
sys.modules["jedi"] = None  # type: ignore[assignment]  # only completion needs it, and its import takes a second
sys.modules["IPython.terminal.embed"] = terminal = ModuleType("IPython.terminal.embed")  # there is no terminal
terminal.embed = None  # type: ignore[attr-defined]
# IPython would keep a history with SQLite, half a megabyte, which the shell below switches off; a cell may import it all the same
sys.modules["sqlite3"] = history = ModuleType("sqlite3")
history.__getattr__ = lambda _: Exception  # type: ignore[method-assign]

import comm  # noqa: E402
from comm.base_comm import BaseComm  # noqa: E402
from IPython.core.displayhook import DisplayHook  # noqa: E402
from IPython.core.displaypub import DisplayPublisher  # noqa: E402
from IPython.core.interactiveshell import InteractiveShell  # noqa: E402
from traitlets import Type  # noqa: E402
from traitlets.config import Config  # noqa: E402

from misstep.display.failed_answer import error_name  # noqa: E402

del sys.modules["sqlite3"]
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)  # "building the font cache"

SITE_PACKAGES = site.getsitepackages()[0]


class Later(MetaPathFinder, Loader):
    """Loads large packages when they are used, not when they are imported: many cells import SymPy and do not use it."""

    def __init__(self, files: dict[str, list[str]]) -> None:
        self.files = files

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """Return a module that is loaded with its first attribute."""
        return ModuleSpec(name, self) if name in self.files else None

    def exec_module(self, module: ModuleType) -> None:
        """Leave the module empty. LazyLoader of importlib will not do: with it, a second import loads the package."""
        module.__class__ = LateModule

    def load(self, module: ModuleType) -> None:
        """Load the files of a package, and run it."""
        module.__class__ = ModuleType
        report(kind="loading", name=module.__name__)
        for file in self.files.pop(module.__name__):
            with zipfile.ZipFile(io.BytesIO(bytes(read_now(file)))) as wheel:  # type: ignore[name-defined]  # noqa: F821
                wheel.extractall(SITE_PACKAGES)
        invalidate_caches()
        spec = PathFinder.find_spec(module.__name__)
        module.__spec__, module.__file__, module.__loader__ = spec, spec.origin, spec.loader
        module.__path__ = spec.submodule_search_locations or []
        module.__package__ = module.__name__
        report(kind="loaded")
        spec.loader.exec_module(module)


class LateModule(ModuleType):
    """A package that is loaded when somebody asks for what it does not have yet, be it a function or the path of a submodule."""

    def __getattr__(self, name: str) -> Any:
        LATER_PACKAGES.load(self)
        return getattr(self, name)


LATER_PACKAGES = Later(dict(globals().get("LATER", {})))
sys.meta_path.insert(0, LATER_PACKAGES)


def report(**output: Any) -> None:
    """Report an output to the page, after what was printed before it. `post` is a function of worker.js."""
    for stream in (sys.stdout, sys.stderr):
        stream.flush()
    origin = {"widget": PageKernel.widget} if PageKernel.widget else {}
    post(json.dumps({**output, **origin}, default=str))  # type: ignore[name-defined]  # noqa: F821


class PageComm(BaseComm):
    """Python's end of the line between a widget and the page, by which ipywidgets sends what has changed."""

    def publish_msg(self, msg_type: str, data: Any = None, metadata: Any = None, buffers: Any = None, **_: Any) -> None:
        data = dict(data or {})
        if data.get("state", {}).get("_anywidget_id", "").startswith("kinlib."):
            data["state"] = {name: value for name, value in data["state"].items() if name != "_esm"}  # the page has it
        for path, content in zip(data.pop("buffer_paths", ()), buffers or (), strict=True):
            place = data["state"]
            for name in path[:-1]:
                place = place[name]
            place[path[-1]] = b64encode(content).decode()  # JSON has no bytes, and a saved page has them like this too
        report(kind="comm", type=msg_type, id=self.comm_id, data=data)


comm.create_comm = PageComm  # before ipywidgets is imported


class PageKernel:
    """Names the cell that runs, as a kernel of Jupyter does."""

    request: ClassVar[dict[str, Any]] = {}
    widget: ClassVar[str] = ""  # whose message is being heard: what is printed meanwhile belongs to its cell

    def get_parent(self, *_: Any) -> dict[str, Any]:
        """Return the request that runs."""
        return self.request


class PageStream(io.TextIOBase):
    """A stream that reports its text."""

    def __init__(self, name: str) -> None:
        self.name, self.text, self.reported = name, "", 0.0

    def write(self, text: str) -> int:
        self.text += text
        if time.monotonic() - self.reported > 0.1:  # seconds; one report for each character would be slow
            self.flush()
        return len(text)

    def flush(self) -> None:
        text, self.text, self.reported = self.text, "", time.monotonic()
        if text:
            report(kind="stream", name=self.name, text=text)


class PagePublisher(DisplayPublisher):
    """Reports what a cell displays."""

    def publish(self, data: dict[str, Any], metadata: Any = None, source: Any = None, **_: Any) -> None:
        report(kind="display", data=data)


class PageDisplayHook(DisplayHook):
    """Publishes the value of a cell's last line like any other display."""

    def write_output_prompt(self) -> None:
        pass

    def write_format_data(self, format_dict: dict[str, Any], md_dict: dict[str, Any] | None = None) -> None:
        shell.display_pub.publish(format_dict, md_dict)


class PageShell(InteractiveShell):
    """An IPython shell without a kernel, a window and a keyboard, whose displays and errors are reported to the page."""

    display_pub_class = Type(PagePublisher)
    displayhook_class = Type(PageDisplayHook)

    def enable_gui(self, gui: str | None = None) -> None:
        """Do nothing, because there is no window."""

    def showtraceback(self, *_: Any, **__: Any) -> None:
        """Report the current error: its text, the line of the cell that led to it, and the traceback from the cell on.

        IPython would print it in colours, which takes a second for a deep recursion.
        """
        error = sys.exception()
        if error is None:
            return
        trace = error.__traceback__
        while trace and trace.tb_frame.f_globals is not self.user_ns:
            trace = trace.tb_next
        own, frame = trace, trace
        while frame:
            own, frame = (frame if frame.tb_frame.f_globals is self.user_ns else own), frame.tb_next
        report(
            kind="error",
            name=error_name(error),
            text=getattr(error, "msg", "") or str(error),
            line=own.tb_lineno if own else getattr(error, "lineno", None),
            traceback="".join(format_exception(type(error), error, trace)),
        )

    showsyntaxerror = showindentationerror = showtraceback


def refuse_input(*_: object) -> str:
    """Raise EOFError, because there is no keyboard."""
    raise EOFError("input() cannot ask on this page. Write the value into the cell, for example name = 'Ada'.")


def display_figures() -> None:
    """Display the figures of pyplot that are open, and close them, as a notebook does at the end of a cell."""
    if pyplot := sys.modules.get("matplotlib.pyplot"):
        for number in pyplot.get_fignums():
            text = io.StringIO()
            pyplot.figure(number).savefig(text, format="svg", bbox_inches="tight")
            shell.display_pub.publish({"image/svg+xml": text.getvalue()})
        pyplot.close("all")


async def run(source: str, cell: str = "", unset: str = "") -> None:
    """Run one cell; its outputs are reported while it runs.

    cell   its name: widgets that are made again by the same cell begin where the reader has left them
    unset  a variable that is blank when the cell begins, so that no earlier answer is checked in the place of this one
    """
    if unset:
        shell.user_ns[unset] = ...
    runs = PageKernel.request.get("header", {}).get("msg_id", 0) + 1
    PageKernel.request = {"header": {"msg_id": runs}, "metadata": {"cellId": cell}}
    await shell.run_cell_async(source, transformed_cell=shell.transform_cell(source), cell_id=cell)
    display_figures()
    report(kind="end")


def hear(text: str) -> None:
    """Give a widget a message of the page: {"comm": its id, "data": ...}."""
    message = json.loads(text)
    PageKernel.widget = widget = message["comm"]
    try:
        if line := comm.get_comm_manager().comms.get(widget):
            line.handle_msg({"content": {"comm_id": widget, "data": message["data"]}, "buffers": []})
            display_figures()
        report(kind="heard", id=widget)
    finally:
        PageKernel.widget = ""


builtins.input = refuse_input
shell = PageShell.instance(config=Config({"HistoryManager": {"enabled": False}}))
shell.kernel = PageKernel()  # type: ignore[attr-defined]
sys.stdout, sys.stderr = PageStream("stdout"), PageStream("stderr")
