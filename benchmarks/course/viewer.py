"""How fast the viewer answers, beside `interact` with a 3-D plot of matplotlib, and what it costs: one browser, one run.

    python -m benchmarks viewer             the slider beside interact
    python -m benchmarks.course.viewer             the rest too
    python -m benchmarks.course.viewer 10          more presses of a key, or fewer

Both stand in one notebook in JupyterLab, drawn in software, and get presses of an arrow key on a slider, in turns. The time
runs from the key's event in the page to the first change of what it asks for: a number in the pose, a picture painted.
`interact` calls a Python function that draws the links as lines and prints the pose, as courses do today.

The rest is measured on a page without a kernel, served on this machine.
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
from benchmarks.measure import NotHere, Row, row
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


FASTER = {"readout": 100.0, "picture": 5.0}
"""So many times faster than interact is wanted, to the number that a reader waits for and to the picture."""

SCROLLED = 300
"""Milliseconds, for a page to show the slider that gets the focus, which is no part of the answer to a key."""

PAUSES = {"viewer": 150, "interact": 1500}
"""Milliseconds, for all that follows to be over before the next press."""


def rows(quick: bool = False) -> Iterator[Row]:
    """From the key to the readout, and to the picture.

    Raises NotHere where there is no Chromium.
    """
    with notebook() as page:
        times = beside_interact(page, 2 if quick else 10)
    for what, wanted in FASTER.items():
        ours, theirs = times["viewer", what][1:], times["interact", what][1:]
        yield row(f"slider to {what}", ours, "interact + matplotlib", theirs, wanted=wanted)


def timed(page, cell, probe):
    """Seconds from the press of a key to the first change of what the probe reads in the output of a cell."""
    page.evaluate(TIMER, [cell, probe])
    page.keyboard.press("ArrowRight")
    return page.evaluate("window.took") / 1000


def beside_interact(page, presses):
    """Seconds to the readout and to the picture, one press after the other, in turns; the first of each is slow."""
    sliders = {"viewer": ".kv input[type=range]", "interact": ".noUi-handle"}
    drawn = {"viewer": ".kv-canvas[data-pictures]", "interact": ".jp-OutputArea-output img"}
    for cell, selector in enumerate(drawn.values()):
        run_cell(page, cell)
        page.wait_for_selector(selector, timeout=60_000)
        page.wait_for_timeout(2000)
    times = {probe: [] for probe in PROBES}
    for _ in range(presses):
        for (who, what), probe in PROBES.items():
            page.locator(sliders[who]).nth(1).focus()
            page.wait_for_timeout(SCROLLED)
            times[who, what].append(timed(page, list(sliders).index(who), probe))
            page.wait_for_timeout(PAUSES[who])
    return times


@contextmanager
def notebook():
    """Open a page of JupyterLab with the viewer in one cell and interact in the next.

    Raises NotHere where there is no Chromium.
    """
    if CHROMIUM is None:
        raise NotHere(NO_CHROMIUM)
    cells = [nbformat.v4.new_code_cell(source.strip()) for source in (VIEWER, INTERACT)]
    with browsers() as start, tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with jupyterlab(folder) as address, start().new_page(viewport={"width": 1000, "height": 1400}) as page:
            open_notebook(page, address, folder, cells)
            yield page
        time.sleep(0.5)


def ten_joints():
    """An arm of ten joints."""
    X, Y, Z = np.eye(3)
    axes = [Z, Y, X, Y, Z, X, Z, Y, X, Y]
    screws = np.array([screw(axis, (0.1 * i, 0, 0.3 + 0.05 * i)) for i, axis in enumerate(axes)])
    return kl.Chain(screws, np.eye(4), name="ten joints")


def page_costs(browser, folder):
    """Milliseconds until the first viewer answers and is drawn, draw calls of ten joints, heap over updates, worst error of the readout."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    robots = [kl.robots.puma560(), kl.robots.youbot(), kl.robots.rpr(), kl.robots.hrr()]
    address = f"http://127.0.0.1:{server.server_port}/page.html"
    with watched(browser) as page:
        static_page(folder, *map(explore, robots))
        page.goto(address)
        wait_until_drawn(page)
        marks = ["kinlib-viewer-answers", "kinlib-viewer-picture"]
        moments = page.evaluate("marks => marks.map((name) => performance.getEntriesByName(name)[0].startTime)", marks)
        worst = 0.0
        for which, robot in enumerate(robots):
            q = np.random.default_rng(1).uniform(-np.pi, np.pi, (100, robot.n))
            page.locator("[data-kinlib-viewer]").nth(which).scroll_into_view_if_needed()
            page.locator(".kv").nth(which).wait_for()
            move = """([which, postures]) => { const { model, stage } = document.querySelectorAll('.kv')[which].viewer;
                return postures.map((q) => { model.set('q', q); return stage.tree.pose(); }); }"""
            worst = max(worst, float(np.abs(np.array(page.evaluate(move, [which, q.tolist()])) - robot.fk(q)).max()))
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
    return moments, worst, calls, (heap[2] - heap[1]) / 1000


class Quiet(SimpleHTTPRequestHandler):
    """Serve files without a word."""

    def log_message(self, *_):
        """Say nothing."""


def main(presses=12):
    """Measure all, and print what was wanted beside what came."""
    with browsers() as start, tempfile.TemporaryDirectory() as name:
        (answers, drawn), worst, calls, heap = page_costs(start(), Path(name))
    with notebook() as page:
        times = {key: np.median(seconds[1:]) for key, seconds in beside_interact(page, presses).items()}
    ratio = {what: times["interact", what] / times["viewer", what] for what in FASTER}
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
        ("first viewer of a page answers", f"{answers / 1000:.2f} s", "1 s"),
        ("first viewer of a page drawn in 3-D", f"{drawn / 1000:.2f} s", ""),
        ("draw calls, ten joints, all layers", f"{calls}", "200"),
        ("heap, 1000 updates", f"{heap:+.0f} kB", "flat"),
        ("readout against Chain.fk", f"{worst:.1e}", "1e-12"),
    ]
    print(f"{'':36}{'measured':>22}{'wanted':>10}")
    for label, measured, wanted in lines:
        print(f"{label:36}{measured:>22}{wanted:>10}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
