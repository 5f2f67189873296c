"""The response time of the viewer, compared with `interact` and a 3-D plot of matplotlib in one browser, and its costs.

    python -m benchmarks viewer              the slider compared with interact
    python -m benchmarks.course.viewer       all measurements
    python -m benchmarks.course.viewer 10    with another number of key presses

Both are in one notebook in JupyterLab, without a graphics card. An arrow key is pressed on a slider of each in turns. The time
is measured from the key's event in the page to the first change of a number in the pose, or of the picture. `interact` calls a
Python function that draws the links as lines and prints the pose, as many courses do.

The other costs are measured on a page without a kernel, served by this machine.
"""

import gzip
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import nbformat
import numpy as np
from browser import (
    CHROMIUM,
    NO_CHROMIUM,
    browsers,
    jupyterlab,
    open_notebook,
    run_cell,
    static_page,
    wait_until_drawn,
    watched,
)

import kinlib as kl
from benchmarks.measure import MissingRequirementError, Row, timed_row
from kinlib.rigid.screw import screw
from kinlib.view import explore
from kinlib.view.viewer.scene import LAYERS
from kinlib.view.viewer.viewer import STATIC

VIEWER = "import kinlib as kl\nfrom kinlib.view import explore\nexplore(kl.robots.puma560())"
INTERACT = """
import numpy as np
from matplotlib import pyplot as plt
from ipywidgets import interact
%matplotlib inline
robot = kl.robots.puma560()
def draw(q1=0.0, q2=0.0, q3=0.0, q4=0.0, q5=0.0, q6=0.0):
    q = [q1, q2, q3, q4, q5, q6]
    path = np.vstack([np.zeros(3), robot.link_poses(q)[:, :3, 3], robot.fk(q)[:3, 3]])
    axes = plt.figure().add_subplot(projection="3d")
    axes.plot(*path.T, "o-")
    axes.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    plt.show()
    print(robot.fk(q).round(4))
interact(draw, **{f"q{i}": (-3.14, 3.14, 0.01) for i in range(1, 7)})
"""
TIMER = """([cell, probe]) => { window.took = new Promise((done, fail) => {
    const output = document.querySelectorAll('.jp-CodeCell')[cell].querySelector('.jp-Cell-outputWrapper');
    const state = () => [...output.querySelectorAll(probe.of)].map((node) => node[probe.what] ?? node.dataset[probe.what]).join();
    const before = state();
    let begun = 0;
    const seen = new MutationObserver(() => {
        const now = state();
        if (!begun || !now || now === before) return;
        seen.disconnect();
        // reading a pixel back waits until the picture is there
        if (probe.what === 'pictures') output.querySelector(probe.of).getContext('2d').getImageData(0, 0, 1, 1);
        done(performance.now() - begun);
    });
    seen.observe(output, { subtree: true, childList: true, characterData: true, attributes: true });
    addEventListener('keydown', () => { begun = performance.now(); }, { capture: true, once: true });
    setTimeout(() => fail('nothing changed in 30 s'), 30000);
}); }"""
PROBES = {
    ("viewer", "readout"): {"of": ".kv-pose td", "what": "textContent"},
    ("viewer", "picture"): {"of": ".kv-canvas", "what": "pictures"},
    ("interact", "readout"): {"of": ".jp-OutputArea-output pre", "what": "textContent"},
    ("interact", "picture"): {"of": ".jp-OutputArea-output img", "what": "src"},
}


MIN_SPEEDUP = {"readout": 100.0, "picture": 5.0}
"""How many times faster than interact the viewer must be, for the number in the pose and for the picture."""

SCROLL_PAUSE_MS = 300
"""Milliseconds that a page gets to scroll to the slider with the focus, which is not part of the response to a key."""

PRESS_PAUSE_MS = {"viewer": 150, "interact": 1500}
"""Milliseconds between two presses, so that the response to the first one is complete."""


def rows(quick: bool = False) -> Iterator[Row]:
    """Compare the times from the key press to the readout and to the picture.

    Raises MissingRequirementError if there is no Chromium.
    """
    with notebook() as page:
        times = response_times(page, 2 if quick else 10)
    for result, target in MIN_SPEEDUP.items():
        own, peer = times["viewer", result][1:], times["interact", result][1:]
        yield timed_row(f"slider key press to {result}", own, "interact + matplotlib", peer, target=target)


def response_time(page, cell, probe):
    """Return the seconds from a key press to the first change of what the probe reads in the output of a cell."""
    page.evaluate(TIMER, [cell, probe])
    page.keyboard.press("ArrowRight")
    return page.evaluate("window.took") / 1000


def response_times(page, presses):
    """Return the seconds to the readout and to the picture of both, for each press, in turns; the first press is slow."""
    sliders = {"viewer": ".kv input[type=range]", "interact": ".noUi-handle"}
    drawn = {"viewer": ".kv-canvas[data-pictures]", "interact": ".jp-OutputArea-output img"}
    for cell, selector in enumerate(drawn.values()):
        run_cell(page, cell)
        page.wait_for_selector(selector, timeout=60_000)
        page.wait_for_timeout(2000)
    times = {probe: [] for probe in PROBES}
    for _ in range(presses):
        for (widget, what), probe in PROBES.items():
            page.locator(sliders[widget]).nth(1).focus()
            page.wait_for_timeout(SCROLL_PAUSE_MS)
            times[widget, what].append(response_time(page, list(sliders).index(widget), probe))
            page.wait_for_timeout(PRESS_PAUSE_MS[widget])
    return times


@contextmanager
def notebook():
    """Open a page of JupyterLab with the viewer in one cell and interact in the next.

    Raises MissingRequirementError if there is no Chromium.
    """
    if CHROMIUM is None:
        raise MissingRequirementError(NO_CHROMIUM)
    cells = [nbformat.v4.new_code_cell(source.strip()) for source in (VIEWER, INTERACT)]
    with browsers() as start, tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with jupyterlab(folder) as address, start().new_page(viewport={"width": 1000, "height": 1400}) as page:
            open_notebook(page, address, folder, cells)
            yield page
        time.sleep(0.5)


def ten_joints():
    """Return an arm with ten joints."""
    X, Y, Z = np.eye(3)
    axes = [Z, Y, X, Y, Z, X, Z, Y, X, Y]
    screws = np.array([screw(axis, (0.1 * i, 0, 0.3 + 0.05 * i)) for i, axis in enumerate(axes)])
    return kl.Chain(screws, np.eye(4), name="ten joints")


def page_costs(browser, folder):
    """Measure a page without a kernel: milliseconds until the first viewer responds and is drawn, readout error, draw calls, heap."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    robots = [kl.robots.puma560(), kl.robots.youbot(), kl.robots.rpr(), kl.robots.hrr()]
    address = f"http://127.0.0.1:{server.server_port}/page.html"
    with watched(browser) as page:
        static_page(folder, *map(explore, robots))
        page.goto(address)
        wait_until_drawn(page)
        marks = ["kinlib-viewer-answers", "kinlib-viewer-picture"]
        milliseconds = page.evaluate(
            "marks => marks.map((name) => performance.getEntriesByName(name)[0].startTime)", marks
        )
        max_error = 0.0
        for which, robot in enumerate(robots):
            q = np.random.default_rng(1).uniform(-np.pi, np.pi, (100, robot.n))
            page.locator("[data-kinlib-viewer]").nth(which).scroll_into_view_if_needed()
            page.locator(".kv").nth(which).wait_for()
            move = """([which, configurations]) => { const { model, stage } = document.querySelectorAll('.kv')[which].viewer;
                return configurations.map((q) => { model.set('q', q); return stage.tree.pose(); }); }"""
            max_error = max(
                max_error, float(np.abs(np.array(page.evaluate(move, [which, q.tolist()])) - robot.fk(q)).max())
            )
    with watched(browser) as page:
        static_page(folder, explore(ten_joints(), show=LAYERS))
        page.goto(address)
        wait_until_drawn(page)
        devtools = page.context.new_cdp_session(page)
        update = """() => { const { model, stage } = document.querySelector('.kv').viewer;
            for (let k = 0; k < 1000; k += 1) { model.set('q', Array.from({ length: 10 }, (_, j) => Math.sin(k / 50 + j)));
                if (k % 50 === 0) stage.paint(); } return stage.calls; }"""
        heap = []
        for _ in range(3):
            calls = page.evaluate(update)
            devtools.send("HeapProfiler.collectGarbage")
            heap.append(devtools.send("Runtime.getHeapUsage")["usedSize"])
    server.shutdown()
    return milliseconds, max_error, calls, (heap[2] - heap[1]) / 1000


class Quiet(SimpleHTTPRequestHandler):
    """Serve files without logging."""

    def log_message(self, *_):
        """Log nothing."""


def main(presses=12):
    """Measure everything, and print the results beside the targets."""
    with browsers() as start, tempfile.TemporaryDirectory() as name:
        (answers, drawn), max_error, calls, heap = page_costs(start(), Path(name))
    with notebook() as page:
        times = {key: np.median(seconds[1:]) for key, seconds in response_times(page, presses).items()}
    ratio = {result: times["interact", result] / times["viewer", result] for result in MIN_SPEEDUP}
    lines = [
        ("key to readout, viewer", f"{1000 * times['viewer', 'readout']:.2f} ms", "4 ms"),
        (
            "key to readout, interact",
            f"{1000 * times['interact', 'readout']:.0f} ms = {ratio['readout']:.0f} x",
            "100 x",
        ),
        ("key to picture, viewer", f"{1000 * times['viewer', 'picture']:.0f} ms", ""),
        ("key to picture, interact", f"{1000 * times['interact', 'picture']:.0f} ms = {ratio['picture']:.0f} x", "5 x"),
        ("bundle, gzip", f"{len(gzip.compress((STATIC / 'viewer.js').read_bytes(), 9)) / 1000:.0f} kB", "200 kB"),
        ("first viewer of a page responds", f"{answers / 1000:.2f} s", "1 s"),
        ("first viewer of a page drawn in 3-D", f"{drawn / 1000:.2f} s", ""),
        ("draw calls, ten joints, all layers", f"{calls}", "200"),
        ("heap, 1000 updates", f"{heap:+.0f} kB", "flat"),
        ("readout against Chain.fk", f"{max_error:.1e}", "1e-12"),
    ]
    print(f"{'':36}{'measured':>22}{'target':>10}")
    for label, measured, target in lines:
        print(f"{label:36}{measured:>22}{target:>10}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
