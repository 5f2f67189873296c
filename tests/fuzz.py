"""Fuzzing: for minutes on end, odd documents are fed to what reads them, and each new fault is shown once, made small.

    python tests/fuzz.py urdf --minutes 10

A target is a module fuzz_<name> beside this one: `cases()` draws what is fed, and `check(case)` fails for whatever should
not come of it. test_fuzz.py runs the same for a few examples in every run of the tests.
"""

import argparse
import faulthandler
import random
import sys
import time
import traceback
import warnings
from collections import Counter
from contextlib import suppress
from importlib import import_module

import hypothesis
from hypothesis import HealthCheck, settings

TARGETS = ("urdf", "dh", "answers", "formulas", "notebooks")

SECONDS = 1.0
"""The most processor time that one case may take."""

HANGS = 60
"""Seconds after which a case ends the hunt, with the line where it hangs."""

ROUND = 1000
"""Examples of one seed. Each round begins anew, and what was found in the one before is only counted."""

PATIENCE = 60.0
"""Seconds in which a fault is made small; after that it is shown as it is."""

QUIET = settings(
    max_examples=ROUND,
    deadline=None,
    database=None,
    derandomize=False,
    print_blob=False,
    report_multiple_bugs=False,
    suppress_health_check=list(HealthCheck),
)


class Slow(AssertionError):
    """A case took longer than it may."""


class Over(KeyboardInterrupt):
    """The time is over, for this fault or for the hunt. Hypothesis stops at once for this and nothing else."""


def timed(target, case):
    """Check a case, and its time; a slow one once more, for first times load and draw what later ones find."""
    for _ in range(2):
        began = time.process_time()
        target.check(case)
        if (seconds := time.process_time() - began) <= SECONDS:
            return
    raise Slow(f"it took {seconds:.1f} s of processor time")


def loaded(name):
    return import_module(f"fuzz_{name}")


class Hunt:
    """A search that goes on after a fault: what was found is known by where it was raised."""

    def __init__(self, target, minutes):
        self.target, self.examples, self.found = target, 0, Counter()
        self._end = time.monotonic() + 60 * minutes

    @property
    def is_over(self):
        return time.monotonic() > self._end

    def one_round(self, seed):
        """Draw a round of cases; show the first fault among them that is new, in its smallest form."""
        raised, last = {}, self._end

        @hypothesis.seed(seed)
        @settings(QUIET)
        @hypothesis.given(self.target.cases())
        def check(case):
            nonlocal last
            if time.monotonic() > last:
                raise Over
            self.examples += 1
            faulthandler.dump_traceback_later(HANGS, exit=True, file=sys.__stderr__)
            try:
                timed(self.target, case)
            except Exception as error:
                mark = _mark(error)
                if mark in self.found:
                    self.found[mark] += 1
                    return
                last = last if raised else min(last, time.monotonic() + PATIENCE)
                raised[mark] = case, error
                raise
            finally:
                faulthandler.cancel_dump_traceback_later()

        try:
            check()
        except Over:
            pass
        except Exception:
            if not raised:  # the fault is in what draws
                raise
        for mark, (case, error) in list(raised.items())[-1:]:
            self.found[mark] = 1
            print(f"\n--- {mark}\n{case!r:.3000}\n{_told(error)}", flush=True)


def _mark(error):
    """What tells one fault from another: its type and the place where it was raised, ours and the check's."""
    frames = traceback.extract_tb(error.__traceback__)
    cause = traceback.extract_tb(error.__context__.__traceback__)[-1:] if error.__context__ else []
    last = [frame for frame in frames if "kinlib" in frame.filename or "tests" in frame.filename][-1:]
    return " < ".join([type(error).__name__, *(f"{frame.filename}:{frame.lineno}" for frame in [*last, *cause])])


def _told(error):
    """The last calls of an error, and of the one before it; the words of each cut short."""
    errors = [error.__context__, error] if error.__context__ else [error]
    return "\n".join(
        f"{''.join(traceback.format_tb(each.__traceback__, limit=-3))}{type(each).__name__}: {each!s:.600}"
        for each in errors
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("target", choices=TARGETS)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6), help="the first round's seed")
    asked = parser.parse_args()
    warnings.simplefilter("error")
    sys.stdout.reconfigure(errors="backslashreplace")
    with suppress(ImportError):  # a case that wants all memory should fail, not end us
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    hunt, seed = Hunt(loaded(asked.target), asked.minutes), asked.seed
    while not hunt.is_over:
        hunt.one_round(seed)
        seed += 1
    print(f"\n{asked.target}: {hunt.examples} examples from seed {asked.seed} on, {len(hunt.found)} faults.")
    sys.exit(bool(hunt.found))


if __name__ == "__main__":
    main()
