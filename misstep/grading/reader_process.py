"""Read what students wrote: the server of the processes that do so, in steps with limits. It knows no right answer.

python -m misstep.grading.reader_process DESCRIPTOR
"""

import socket
from pkgutil import resolve_name

from misstep.grading.fork_server import greet, run_server
from misstep.grading.steps import StepProcesses, serve_steps

STEPS = {
    "plan": "misstep.grading.collect.run_plan:plan_run",
    "parse": "misstep.grading.judging.parse_output:parse_output",
    "page": "misstep.grading.publish.pages_and_tables:write_page",
    "tables": "misstep.grading.publish.pages_and_tables:write_tables",
}
"""By step, the module and the function that does it: a notebook is planned, the output of a run is parsed, a page is written, and the
answers of a class are compared and written into tables."""

GRADEBOOK_STEPS = {"autograded notebook": "misstep.grading.nbgrader.autograded:write_notebook"}
"""The step that writes a notebook for formgrader. It needs nbgrader, which takes a second to import."""

STEP_SECONDS = 5.0
"""Processor time of a step. The largest notebook that is accepted takes a fifth of it."""


def start_reader(has_gradebook: bool = False) -> StepProcesses:
    """Processes that read what students wrote."""
    return StepProcesses(
        "misstep.grading.reader_process", STEPS | (GRADEBOOK_STEPS if has_gradebook else {}), "reading"
    )


def main(parent: socket.socket, places: dict[str, str]) -> None:
    """Import what the steps need, and fork until the socket closes."""
    steps = {step: resolve_name(place) for step, place in places.items()}
    greet(parent)
    serve_steps(parent, steps)


if __name__ == "__main__":
    run_server(main)
