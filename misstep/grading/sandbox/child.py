"""The life of one submission: read what to run, go into the cage, run it, write what it gave.

A forked child of the server comes here with two pipes and never returns.
"""

import json
import os
import tempfile

from misstep.grading.sandbox.confine import Cage, holes, restrict
from misstep.grading.sandbox.course_stub import CourseStub
from misstep.grading.sandbox.limits import Limits, Missing
from misstep.grading.sandbox.redacted_sheet import laid_out
from misstep.grading.sandbox.run_cells import Shell, line, run_cells, write

HIGH = 250
"""Where the two pipes go: out of the way of what a notebook opens, below the limit of open files."""


def live(cage: Cage | None, shell: Shell, stub: CourseStub, inbox: int, outbox: int) -> None:
    """Read, be confined, run, write. Without a cage there are still limits, and a session of its own."""
    os.setsid()  # a group is killed as a whole, across pid namespaces: be in none with whoever grades
    inbox, outbox = _only(inbox, outbox)
    with os.fdopen(inbox, "rb") as stream:
        message = json.loads(stream.read())
    limits = Limits(**message["limits"])
    try:
        if cage:
            cage.enter(limits)
        else:
            restrict(limits)
            os.chdir(tempfile.mkdtemp())
    except Missing as missing:
        write(outbox, line({"missing": str(missing)}))
        os._exit(0)
    if "probe" in message:
        write(outbox, line({"holes": holes(cage.hidden) if cage else []}))
        os._exit(0)
    stub.lay_out(laid_out(message.pop("paper")))
    run_cells(shell, message.pop("cells"), limits.cell_seconds, lambda told: write(outbox, line(told)))
    os._exit(0)


def _only(*descriptors: int) -> list[int]:
    """Close every open file but these, put nothing at the three standard places, and move these behind them."""
    kept = [os.dup2(descriptor, HIGH + k, inheritable=False) for k, descriptor in enumerate(descriptors)]
    os.closerange(3, HIGH)
    os.closerange(HIGH + len(kept), os.sysconf("SC_OPEN_MAX"))
    nothing = os.open("/dev/null", os.O_RDWR)
    for standard in range(3):
        os.dup2(nothing, standard)
    os.close(nothing)
    return kept
