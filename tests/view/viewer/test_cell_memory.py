"""What a reader has set survives running the cell again, and only in the same cell, for the same widget of the same data."""

from types import SimpleNamespace

import IPython
import numpy as np
import pytest

import kinlib as kl
from kinlib.view import assign, drive, explore, play_assignment, play_row, slide, slide_frames
from kinlib.view.figures.arm import draw_arm

ARM = kl.robots.rpr()
LINKAGE = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
CLOSED = LINKAGE.assembly_modes(hold={"A": 1.0})
FRAMES = kl.assign_frames(ARM, convention="standard").frames


@pytest.fixture
def run(monkeypatch):
    """Run a function as a cell of a notebook, by the id of the cell; None is a cell without an id, as in nbclient."""

    def run_cell(cell, function):
        request = {"metadata": {"cellId": cell} if cell else {}}
        shell = SimpleNamespace(kernel=SimpleNamespace(get_parent=lambda: request))
        monkeypatch.setattr(IPython, "get_ipython", lambda: shell)
        return function()

    monkeypatch.setattr("kinlib.view.viewer.widget._kept", {})
    return run_cell


WIDGETS = {
    "arm": (lambda: explore(ARM), "q", [0.1, 0.2, 0.3]),
    "layers": (lambda: explore(ARM), "shown", ["axes"]),
    "frames": (lambda: slide_frames(lambda x: {"s": np.eye(4), "b": kl.exp([0, 0, x, 0, 0, x])}, "x", [0, 1]), "at", 1),
    "steps": (lambda: play_assignment(ARM, convention="standard"), "at", 5),
    "motions": (lambda: play_row([0.8, 0.6, 0.6, 1.4]), "at", 2.0),
    "linkage": (lambda: drive(LINKAGE, CLOSED[0], curves=[CLOSED[:1], CLOSED[1:]]), "variant", "curve 2"),
    "placed by hand": (lambda: assign(ARM, "standard"), "frames", FRAMES),
    "pictures": (lambda: slide(lambda x: draw_arm(ARM, [x, 0, 0]), "joint 1", [0, 1, 2]), "at", 2),
}


@pytest.mark.parametrize(("make", "name", "value"), WIDGETS.values(), ids=list(WIDGETS))
def test_what_the_reader_sets_is_there_when_the_cell_is_run_again(run, make, name, value):
    setattr(run("one", make), name, value)
    for cell, kept in (("one", True), ("one", True), ("another", False), (None, False)):
        found = getattr(run(cell, make), name)
        assert np.array_equal(np.asarray(found), np.asarray(value)) == kept, cell


def test_a_changed_cell_begins_anew(run):
    run("one", lambda: explore(ARM)).q = [0.1, 0.2, 0.3]
    assert run("one", lambda: explore(ARM, start=[0.5, 0, 0])).q == [0.5, 0, 0]
    assert run("one", lambda: explore(kl.robots.youbot())).q == [0] * 5
