"""The judge: it draws the variants, reads answers as data, and computes the points. It never runs student code.

    python -m misstep.grading.judging.judge_process COURSE

COURSE is the package of an installed course, or the folder of another one.

It answers three kinds of requests from stdin on stdout. "problems" returns the numbers, titles and points of the sheet's
problems. "redacted sheet" returns a student's sheet without answers, and a seed from which the inputs of function answers
are drawn anew in every run. "verdicts" judges answers; the request has the seed of the redacted sheet, and the address of the
course's site.

Students who are graded in different threads are graded at the same time, each thread's in a forked process of its own. The
kernel ends that process if one answer takes longer than the request allows, also inside a single call of C code; the answers after
it are judged in the next process. So a slow answer costs its own problem, and no other. A process also ends after a few
students, and earlier after an answer that could not be read or needed much memory: what such an answer leaves behind is gone
for the next student.

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
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cache, lru_cache, partial
from importlib import import_module
from itertools import chain
from resource import RUSAGE_SELF, getrusage
from typing import IO, Any, NoReturn, cast

from misstep.catalog import Course, find_course
from misstep.display.card import Link
from misstep.display.lecture_address import page_address
from misstep.grading.judging.redraw import Draw, RedrawnSheet, redraw
from misstep.grading.redacted_sheet import redact
from misstep.grading.rpc import encode_message, receive_message
from misstep.grading.sandbox.confine import set_resource_limits
from misstep.grading.sandbox.limits import Limits
from misstep.judge import Finding, Judgement, judge
from misstep.problem import Problem, Template
from misstep.sheet import SAMPLE_ID, Sheet
from misstep.storage.deserialize import Malformed, Opaque, from_data
from misstep.storage.serialize import to_data
from misstep.verdict import Verdict, observation

Task = partial[dict[str, Any]]

UNSOLVED = {"partly", "wrong", "unreadable"}
"""The states of an answer that must be mended, for which feedback shows the figure of the problem."""

GC_THRESHOLD = 100_000
"""How many objects are made before garbage is collected: mutants make many, and with Python's 700 it took a sixth of the time."""

STUDENTS_PER_PROCESS = 8
"""After so many students a process ends. The kernel copies each page of memory to which a new process writes, and with one
process for each student this took 40 of 160 ms."""

MAX_KEPT_MEMORY_KB = 400_000
"""A process that has used more memory than this ends after the student. Judging sheet 03 takes 120,000."""

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


@lru_cache(maxsize=1)
def _variants(course: Course, sheet: str, student: str) -> list[Problem]:
    """A student's variants, kept because they are needed for the redacted sheet and soon again for the verdicts."""
    return [template.variant(student) for template in course.find_sheet(sheet).problems]


@lru_cache(maxsize=1)
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


def _answer_parts(course: Course, message: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield the parts of the answer to a request: each verdict is one, by its problem number.

    The kernel ends this process if a verdict takes too long. Verdicts that are done are left out.
    """
    try:
        sheet = course.find_sheet(message["sheet"])
        if message.get("redraw"):
            sheet = RedrawnSheet(sheet.name, sheet.title, sheet.problems, Draw(*message["redraw"]))
        if message["request"] == "problems":
            yield {"problems": [[template.number, template.title, template.points] for template in sheet.problems]}
            return
        if message["request"] == "redacted sheet":
            yield redacted_sheet(course, sheet, message["student"])
            return
        tasks = _tasks(course, sheet, message["student"], message["seed"], message["answers"], site=message["site"])
    except Exception as error:  # whatever is wrong with this request, the next one is another
        yield {"error": f"{type(error).__name__}: {error}"[:500]}
        return
    for k, task in tasks.items():
        if k not in message["done"]:
            signal.setitimer(signal.ITIMER_PROF, message.get("answer_seconds", Limits.answer_seconds))
            yield {k: task()}
            signal.setitimer(signal.ITIMER_PROF, 0)


class JudgingProcess:
    """A forked process that answers requests, until it ends itself after a student."""

    def __init__(self, course: Course) -> None:
        (inbox, requests), (parts, outbox) = os.pipe(), os.pipe()
        self._number = os.fork()
        for descriptor in (inbox, outbox) if self._number else (requests, parts):
            os.close(descriptor)
        if not self._number:
            _answer_students(course, inbox, outbox)
        self._requests, self._parts = os.fdopen(requests, "wb", 0), os.fdopen(parts, "rb")

    def ask(self, message: Mapping[str, Any]) -> tuple[dict[str, Any], bool]:
        """Send a request: the parts of its answer, and whether these are all; if not, the process has ended."""
        answer = dict[str, Any]()
        with suppress(BrokenPipeError):
            self._requests.write(encode_message(message))
        while part := receive_message(self._parts):
            answer |= part
        return answer, part is not None

    def end(self) -> int:
        """Let it end. The exit code is 0 if it ended between two requests, and negative for a signal."""
        self._requests.close()
        self._parts.close()
        return os.waitstatus_to_exitcode(os.waitpid(self._number, 0)[1])


def _answer_students(course: Course, inbox: int, outbox: int) -> NoReturn:
    """Write each part of an answer as soon as it is there, and an empty one after the last."""
    try:
        judged, is_spoiled = 0, False
        with os.fdopen(inbox, "rb") as requests, os.fdopen(outbox, "wb", 0) as parts:
            while (
                judged < STUDENTS_PER_PROCESS and not is_spoiled and (message := receive_message(requests)) is not None
            ):
                for part in chain(_answer_parts(course, message), [{}]):
                    parts.write(encode_message(part))
                    is_spoiled |= any(
                        "unreadable" in verdict.values() for verdict in part.values() if isinstance(verdict, dict)
                    )
                is_spoiled |= getrusage(RUSAGE_SELF).ru_maxrss > MAX_KEPT_MEMORY_KB
                judged += message["request"] == "verdicts"
        os._exit(0)
    finally:
        os._exit(1)


def _answer_thread(course: Course, inbox: int, outbox: IO[bytes], lock: IO[bytes]) -> NoReturn:
    """Answer the requests of a thread, which come one after the other."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)  # why a process has ended is needed here
    process = cast("JudgingProcess | None", None)
    with os.fdopen(inbox, "rb") as stream:
        while (message := receive_message(stream)) is not None:
            if process and _import_sympy(message):
                process.end()
                process = None
            answer, late, limits = dict[str, Any](), set[str](), list[str]()
            while "error" not in answer:
                process = process or JudgingProcess(course)
                parts, is_complete = process.ask({**message, "done": list(answer)})
                answer |= parts
                if is_complete:
                    break
                exit_code, process = process.end(), None
                if exit_code == 0:  # it has ended after the student before, and read nothing of this request
                    continue
                numbers = map(str, range(1, len(course.find_sheet(message["sheet"]).problems) + 1))
                culprit = next(k for k in numbers if k not in answer)
                if culprit in late or message["request"] != "verdicts":
                    answer = {"error": f"The process of the judge ended at problem {culprit}."}
                late.add(culprit)
                is_slow = exit_code == -signal.SIGPROF
                seconds = message.get("answer_seconds", Limits.answer_seconds)
                why = f"takes more than {seconds:g} s to judge" if is_slow else "ends the process that judges it"
                limits.append(f"answer {culprit} {why}")
                message.setdefault("answers", {})[culprit] = {"other": f"an answer that {why}"}
            if message["request"] == "verdicts" and "error" not in answer:
                answer = {"verdicts": answer, "limits": limits}
            _send({**answer, "id": message["id"]}, outbox, lock)
    os._exit(0)


def main(course_reference: str) -> None:
    """Answer requests until stdin ends, those of each thread of the grader in a process that forks the ones that judge."""
    gc.set_threshold(GC_THRESHOLD)
    course = find_course(course_reference)
    set_resource_limits({"AS": MEMORY_BYTES})
    inbox, outbox = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints must not mix with the messages
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel clears away the processes that have answered
    threads = dict[int, IO[bytes]]()
    with tempfile.TemporaryFile() as lock:  # several processes write to the same pipe
        while (message := receive_message(inbox)) is not None:
            if message["request"] == "problems":
                for answer in _answer_parts(course, message):
                    _send({**answer, "id": message["id"]}, outbox, lock)
                _warm_up(course, message["sheet"])  # while the server of submissions starts
                continue
            thread = message["thread"]
            if thread not in threads:
                _warm_up(course, message["sheet"])
                reader, writer = os.pipe()
                if not os.fork():
                    for descriptor in (writer, *(other.fileno() for other in threads.values())):
                        os.close(descriptor)  # so that it ends when this process does
                    _answer_thread(course, reader, outbox, lock)
                os.close(reader)
                threads[thread] = os.fdopen(writer, "wb", 0)
            threads[thread].write(encode_message(message))


def _send(answer: Mapping[str, Any], outbox: IO[bytes], lock: IO[bytes]) -> None:
    """Write the whole of an answer before another process writes one."""
    message = encode_message(answer)
    fcntl.lockf(lock, fcntl.LOCK_EX)
    outbox.write(message)
    outbox.flush()
    fcntl.lockf(lock, fcntl.LOCK_UN)


@cache
def _warm_up(course: Course, sheet: str) -> None:
    """Do before the forks what every process needs: import the sheet, draw its numbers and a first figure once."""
    with suppress(Exception):  # the answer to the request has the error
        problems = _variants(course, sheet, SAMPLE_ID)
        figure_html(next(problem for problem in problems if problem.figure))
    gc.collect()
    gc.freeze()  # a collection in a fork would touch every object, and so copy every page of memory


def _import_sympy(message: Mapping[str, Any]) -> bool:
    """Import SymPy if the answers need it, and whether this was the first time: then the next processes have it from their start."""
    text = json.dumps(message.get("answers"))
    if "sympy" in sys.modules or not ('"symbolic"' in text or '"matrix"' in text):
        return False
    import_module("sympy")
    return True


if __name__ == "__main__":
    try:
        main(sys.argv[1])
    except (BrokenPipeError, KeyboardInterrupt):  # the process that grades has ended
        os._exit(1)
