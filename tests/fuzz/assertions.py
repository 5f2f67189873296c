"""Claims that several fuzz targets check: an error explains itself, a pose is rigid, a verdict is complete."""

import json
import re
import signal
import traceback
from contextlib import contextmanager
from pathlib import Path

import numpy as np

import kinlib

SENTENCE = re.compile(r"\S.*[.?!)>`'\"]", re.DOTALL)

MAX_MESSAGE_LENGTH = 1500
"""A longer message only repeats the input."""

PACKAGES = tuple((Path(kinlib.__file__).parents[1] / name).as_posix() for name in ("kinlib", "misstep", "kincourse"))


def assert_explained(error, *types):
    """An explained error is one that the library raises on purpose, with a printable sentence; any other error is a fault."""
    message = str(error)
    assert type(error) in (types or (ValueError,)), f"{type(error).__name__}: {message[:300]}"
    file = Path(traceback.extract_tb(error.__traceback__)[-1].filename).as_posix()
    assert file.startswith(PACKAGES), f"this was raised in {file}: {message[:300]}"
    assert SENTENCE.fullmatch(message), f"this is not a sentence: {message[:300]!r}"
    assert len(message) <= MAX_MESSAGE_LENGTH, f"this message has {len(message)} characters: {message[:300]!r}"
    message.encode()


def assert_rigid(T):
    R = T[..., :3, :3]
    assert np.isfinite(T).all()
    np.testing.assert_allclose(np.swapaxes(R, -1, -2) @ R, np.broadcast_to(np.eye(3), R.shape), atol=1e-9)
    assert (np.linalg.det(R) > 0).all()
    assert (T[..., 3, :] == (0, 0, 0, 1)).all()


@contextmanager
def limit_processor_time(seconds):
    """Raise TimeoutError in what takes longer. When grading, the kernel ends the process of the judge instead."""

    def end(*_):
        raise TimeoutError(f"more than {seconds:g} s of processor time")

    signal.signal(signal.SIGPROF, end)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def assert_verdict(verdict):
    from misstep.grading.publish.pages import STATE_LABELS  # grading cannot be imported on Windows

    points, state, text = verdict.points, verdict.state, verdict.verdict
    assert 0 <= points <= verdict.max
    assert state in STATE_LABELS
    assert (state == "right") == (points == verdict.max)
    assert (state in {"blank", "unreadable", "wrong", "missing"}) == (points == 0)
    assert "could not be judged" not in text, text[-300:]
    assert state in {"right", "missing"} or len(text.splitlines()) > 2, "there is no reason"
    assert len(text) < 5000, text[:300]
    json.dumps(vars(verdict), allow_nan=False)
