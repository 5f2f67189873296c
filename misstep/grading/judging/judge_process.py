"""The judge: it draws the variants, reads answers as data, and computes the points. It never runs student code.

    python -m misstep.grading.judging.judge_process COURSE

COURSE is the package of an installed course, or the folder of another one.

It answers three kinds of requests from stdin on stdout. "problems" returns the numbers, titles and points of the sheet's
problems. "redacted sheet" returns a student's sheet without answers, and a seed from which the inputs of function answers
are drawn anew in every run. "verdicts" judges answers; the request has the seed of the redacted sheet, and the address of the
course's site.

The answers of each submission are judged in a process forked for them, so any number of submissions are judged at the same
time. The kernel ends that process if one answer takes longer than ANSWER_SECONDS, also inside a single call of C code; the
answers after it are judged in the next process. So a slow answer costs its own problem, and no other.

It runs in the folder of the sheet, because a robot's own sheet is described by a file there.
"""

import fcntl
import gc
import json
import os
import secrets
import signal
import sys
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import lru_cache, partial
from importlib import import_module
from typing import IO, Any, NoReturn

from misstep.catalog import Course, find_course
from misstep.display.card import Link
from misstep.display.lecture_address import page_address
from misstep.grading.judging.redraw import Draw, RedrawnSheet, redraw
from misstep.grading.sandbox.confine import set_resource_limits
from misstep.grading.sandbox.redacted_sheet import redact
from misstep.grading.sandbox.rpc import encode_message, receive_message
from misstep.judge import Finding, Judgement, judge
from misstep.problem import Problem, Template
from misstep.sheet import Sheet
from misstep.storage.deserialize import Malformed, Opaque, from_data
from misstep.storage.serialize import to_data
from misstep.verdict import Verdict, observation

ANSWER_SECONDS = 4.0
"""Processor time for all that is done with one answer, reading included. It is no wall-clock time, so that a busy machine
changes no verdict. The slowest answers that people give, tables that no mistake explains, take a tenth of it."""

Task = partial[dict[str, Any]]

UNSOLVED = {"partly", "wrong", "unreadable"}
"""The states of an answer that must be mended, for which feedback shows the figure of the problem."""

WORKERS = min(4, os.cpu_count() or 1)
"""The number of processes that draw the numbers of students."""

DRAWN_SHEETS = set[str]()
"""The sheets of which this process has drawn a figure: the first one imports and compiles what the others need."""

GC_THRESHOLD = 100_000
"""How many objects are made before garbage is collected: mutants make many, and with Python's 700 it took a sixth of the time."""

STUDENTS_KEPT = 6
"""Of how many students a process keeps the variants, with all mutants: 3 MB each. It has --jobs / WORKERS at a time."""

MEMORY_BYTES = 2 << 30
"""The most memory that the judge may use, because a short answer may need a lot of memory to read."""


def redacted_sheet(course: Course, sheet: Sheet, student: str) -> dict[str, Any]:
    """A student's sheet without answers, and the seed of this run."""
    seed = secrets.randbits(64)
    return {"seed": seed, "sheet": redact(sheet, _problems(course, sheet, student, seed))}


def verdicts(
    course: Course, sheet: Sheet, student: str, seed: int, answers: Mapping[str, Any], *, site: str = ""
) -> dict[str, Any]:
    """Judge the answers, by problem number as text: "1" is the first. A problem without an answer is blank."""
    return {k: verdict() for k, verdict in _tasks(course, sheet, student, seed, answers, site=site).items()}


def verdicts_apart(
    course: Course, sheet: Sheet, student: str, seed: int, answers: Mapping[str, Any], *, site: str = ""
) -> dict[str, Any]:
    """The same in a forked process. If an answer ends it, those that are left are judged in another one.

    Raises RuntimeError if a process ends although the answer that ended the one before is no longer read.
    """
    tasks, done, late = _tasks(course, sheet, student, seed, answers, site=site), dict[str, Any](), set[str]()
    while True:
        inbox, outbox = os.pipe()
        if not (child := os.fork()):
            _judge_in_turn(outbox, {k: task for k, task in tasks.items() if k not in done})
        os.close(outbox)
        with os.fdopen(inbox, "rb") as stream:
            while (message := receive_message(stream)) is not None:
                done |= message
        _, status = os.waitpid(child, 0)
        if (culprit := next((k for k in tasks if k not in done), None)) is None:
            return done
        if culprit in late:
            raise RuntimeError(f"The process that judges ended twice at problem {culprit}.")
        late.add(culprit)
        is_slow = os.waitstatus_to_exitcode(status) == -signal.SIGPROF
        why = f"takes more than {ANSWER_SECONDS:g} s to judge" if is_slow else "ends the process that judges it"
        tasks[culprit] = partial(tasks[culprit], data={"other": f"an answer that {why}"})


def _judge_in_turn(outbox: int, tasks: Mapping[str, Task]) -> NoReturn:
    """Write each verdict as soon as it is there, and exit. The kernel ends this process if one of them takes too long."""
    try:
        with os.fdopen(outbox, "wb") as stream:
            for k, task in tasks.items():
                signal.setitimer(signal.ITIMER_PROF, ANSWER_SECONDS)
                message = encode_message({k: task()})
                signal.setitimer(signal.ITIMER_PROF, 0)
                stream.write(message)
                stream.flush()
    finally:
        os._exit(0)


def _tasks(
    course: Course, sheet: Sheet, student: str, seed: int, answers: Mapping[str, Any], *, site: str
) -> dict[str, Task]:
    """For each problem, the function that judges its answer."""
    return {
        str(k): partial(_verdict, template, problem, page_address(template.lecture, site), data=answers.get(str(k)))
        for k, (template, problem) in enumerate(
            zip(sheet.problems, _problems(course, sheet, student, seed), strict=True), start=1
        )
    }


def _problems(course: Course, sheet: Sheet, student: str, seed: int) -> list[Problem]:
    problems = _variants(course, sheet.name, student)
    if isinstance(sheet, RedrawnSheet):
        problems = _redrawn(course, sheet.name, student, sheet.draw)
    return [problem.with_inputs(seed) for problem in problems]


@lru_cache(maxsize=STUDENTS_KEPT)
def _variants(course: Course, sheet: str, student: str) -> list[Problem]:
    """A student's variants, cached because they are needed for the redacted sheet and soon again for the verdicts."""
    return [template.variant(student) for template in course.find_sheet(sheet).problems]


@lru_cache(maxsize=STUDENTS_KEPT)
def _redrawn(course: Course, sheet: str, student: str, draw: Draw) -> list[Problem]:
    """A student's variants, some of them with other numbers."""
    templates, problems = course.find_sheet(sheet).problems, _variants(course, sheet, student)
    return [
        (k in draw.problems and redraw(template, own, student, draw)) or own
        for k, (template, own) in enumerate(zip(templates, problems, strict=True), start=1)
    ]


def _verdict(template: Template, problem: Problem, address: str, *, data: Any) -> dict[str, Any]:
    verdict = Verdict(template, _judge_answer(problem, data), address=address)
    card, seen = verdict.card, observation(template, problem, [verdict.judgement])
    return {
        "state": verdict.judgement.state,
        "fraction": verdict.judgement.fraction,
        "mistakes": verdict.judgement.mistakes,
        "possible": seen.possible,
        "explanations": seen.explanations,
        "text": card.text(),
        "statement": problem.statement,
        "figure": figure_html(problem) if verdict.judgement.state in UNSOLVED else "",
        "address": card.body[-1].address if isinstance(card.body[-1], Link) else "",
        "right": to_data(problem.answer.value),
    }


def figure_html(problem: Problem) -> str:
    """The figure of a problem as HTML; "" if it has none, or if it cannot be drawn."""
    try:
        figure = problem.figure() if problem.figure else None
        bundle = figure._repr_mimebundle_() if figure is not None and hasattr(figure, "_repr_mimebundle_") else {}
    except Exception:  # a figure is not worth a grade
        return ""
    return str(bundle.get("text/html", ""))


def _judge_answer(problem: Problem, data: Any) -> Judgement:
    """Judge one answer. An answer that raises an error is unreadable."""
    answer = problem.answer
    try:
        value = from_data(data)
        if isinstance(value, Opaque):
            return _unreadable(problem, f"Expected {answer.expected}; got {value}.")
        return judge(problem, value)
    except Malformed as error:
        return _unreadable(problem, f"The data of this answer has no known form. {error}")
    except Exception as error:  # whatever error an answer causes, the other problems must still be judged
        return _unreadable(
            problem, f"Expected {answer.expected}; the answer could not be judged: {type(error).__name__}."
        )


def _unreadable(problem: Problem, message: str) -> Judgement:
    return Judgement("unreadable", findings=[Finding(problem.answer.parts, message)])


def _respond(course: Course, message: Mapping[str, Any]) -> dict[str, Any]:
    try:
        sheet = course.find_sheet(message["sheet"])
        if message.get("redraw"):
            sheet = RedrawnSheet(sheet.name, sheet.title, sheet.problems, Draw(*message["redraw"]))
        if message["request"] == "problems":
            return {"problems": [[template.number, template.title, template.points] for template in sheet.problems]}
        if message["request"] == "redacted sheet":
            return redacted_sheet(course, sheet, message["student"])
        arguments = (message[name] for name in ("student", "seed", "answers"))
        return {"verdicts": verdicts_apart(course, sheet, *arguments, site=message["site"])}
    except Exception as error:  # whatever error an answer causes, the next message is about another student
        return {"error": f"{type(error).__name__}: {error}"[:500]}


def main(course_reference: str) -> None:
    """Answer requests until stdin ends, those about students in as many processes as there are processors.

    Drawing the numbers of a student takes most of the time of grading. All requests about a student go to the same process,
    which remembers them.
    """
    gc.set_threshold(GC_THRESHOLD)
    course = find_course(course_reference)
    set_resource_limits({"AS": MEMORY_BYTES})
    inbox, outbox = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints must not mix with the messages
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel clears away the processes that have answered
    workers: list[IO[bytes]] = []
    places: dict[str, int] = {}
    with tempfile.TemporaryFile() as lock:  # several processes write to the same pipe
        while (message := receive_message(inbox)) is not None:
            if message["request"] == "problems":
                _answer(course, message, outbox, lock)
                continue
            if not workers:
                gc.collect()
                gc.freeze()  # a collection in a fork would touch every object, and so copy every page of memory
            while len(workers) < WORKERS:  # only now, because by now they need not import the sheet themselves
                workers.append(_start_worker(course, workers, outbox, lock))
            place = places.setdefault(message["student"], len(places) % len(workers))
            workers[place].write(encode_message(message))
            workers[place].flush()


def _start_worker(course: Course, others: Sequence[IO[bytes]], outbox: IO[bytes], lock: IO[bytes]) -> IO[bytes]:
    """Fork a process that answers requests about students: verdicts each in a process of their own, the others at once."""
    inbox, writer = os.pipe()
    if os.fork():
        os.close(inbox)
        return os.fdopen(writer, "wb")
    for descriptor in (writer, *(other.fileno() for other in others)):  # so that it ends when this process does
        os.close(descriptor)
    with os.fdopen(inbox, "rb") as stream:
        while (message := receive_message(stream)) is not None:
            is_apart = message["request"] == "verdicts"
            if is_apart:
                _prepare(course, message)
            if not is_apart or os.fork() == 0:
                signal.signal(signal.SIGCHLD, signal.SIG_DFL if is_apart else signal.SIG_IGN)
                _answer(course, message, outbox, lock)
                if is_apart:
                    os._exit(0)
    os._exit(0)


def _answer(course: Course, message: Mapping[str, Any], outbox: IO[bytes], lock: IO[bytes]) -> None:
    """Answer a request, and write the whole answer before another process writes one."""
    answer = encode_message({**_respond(course, message), "id": message["id"]})
    fcntl.lockf(lock, fcntl.LOCK_EX)
    outbox.write(answer)
    outbox.flush()
    fcntl.lockf(lock, fcntl.LOCK_UN)


def _prepare(course: Course, message: Mapping[str, Any]) -> None:
    """Do before the fork what the next submissions need, too: draw the variants, a first figure, and import SymPy if needed."""
    with suppress(Exception):  # the answer to the request has the error
        problems = _variants(course, message["sheet"], message["student"])
        if message["sheet"] not in DRAWN_SHEETS:
            DRAWN_SHEETS.add(message["sheet"])
            figure_html(next(problem for problem in problems if problem.figure))
        text = json.dumps(message["answers"])
        if '"symbolic"' in text or '"matrix"' in text:
            import_module("sympy")


if __name__ == "__main__":
    main(sys.argv[1])
