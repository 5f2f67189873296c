"""Rehearse the paths that the documents describe, each in a fresh copy with exactly what it installs.

    python tools/fresh                              every path, on every supported Python of this machine
    python tools/fresh lab site --python 3.13       these paths, on this Python

It needs a Python with its standard library, bash and git. `paths.py` says what each path does, `documents.py` what is not rehearsed.
"""

import argparse
import sys
import time

from documents import NOT_REHEARSED
from fresh_copy import SUPPORTED, pythons
from paths import PATHS, rehearse


def main() -> int:
    """Rehearse what is asked for. Returns 1 if a path fails."""
    found = pythons()
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("paths", nargs="*", metavar="PATH", help=f"of {', '.join(PATHS)}; without any, all")
    parser.add_argument(
        "--python", action="append", choices=found, help="the version; without any, all of this machine"
    )
    asked = parser.parse_args()
    if unknown := set(asked.paths) - set(PATHS):
        parser.error(f"PATH must be one of {', '.join(PATHS)}; got {', '.join(sorted(unknown))}.")
    not_tried = [f"Python {version}: this machine does not have it" for version in SUPPORTED if version not in found]
    failed = []
    for name in asked.paths or PATHS:
        for version in asked.python or found:
            start = time.monotonic()
            result, reason = rehearse(name, found[version])
            print(f"{result:10} {name:12} Python {version} {time.monotonic() - start:6.0f} s  {reason}", flush=True)
            failed += [name] if result == "FAILED" else []
            not_tried += [f"{name}, Python {version}: {reason}"] if result == "not tried" else []
    if not asked.paths:
        not_tried += [f"{', '.join(starts)}: {reason}" for reason, starts in NOT_REHEARSED.items()]
    print("\nNot tried:", *not_tried, sep="\n  ")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
