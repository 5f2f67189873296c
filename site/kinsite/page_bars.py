"""Bars that show how many pages Sphinx has read and written."""

from typing import Any

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from tqdm import tqdm


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the functions of this module with Sphinx."""
    bars: dict[str, Any] = {}

    def start(kind: str, total: int) -> None:
        bars[kind] = tqdm(desc=kind, total=total, unit="page")

    def count(kind: str) -> None:
        if kind in bars:
            bars[kind].update()
            if bars[kind].n == bars[kind].total:
                bars[kind].close()

    def before_reading(_: Sphinx, __: BuildEnvironment, names: list[str]) -> None:
        start("Reading", len(names))

    app.connect("env-before-read-docs", before_reading)
    app.connect("source-read", lambda *_: count("Reading"))
    app.connect("env-updated", lambda _, env: start("Writing", len(env.found_docs)))
    app.connect("html-page-context", lambda *_: count("Writing"))
    return {"parallel_read_safe": False, "parallel_write_safe": False}
