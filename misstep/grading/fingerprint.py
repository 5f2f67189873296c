"""Fingerprints: a digest of everything that a result depends on. The next run grades only what has another one.

Pages and tables are written again in each run, so nothing that only they need is part of it.
"""

import json
from collections.abc import Sequence
from hashlib import sha256

from misstep.grading.code_digest import code_digest
from misstep.grading.collect.run_plan import ReleasedSheet


def fingerprint(sheet: ReleasedSheet, way: str, parts: Sequence[str | bytes | None]) -> str:
    """A digest of everything that a result depends on.

    way    how submissions run: the limits, and whether in the sandbox
    parts  what belongs to one submission
    """
    robot = sheet.folder / f"{sheet.name}.json"
    common = [
        code_digest(sheet.course, sheet.name),
        sheet.name,
        sheet.site,
        sheet.opening,
        sheet.key,
        sha256(sheet.solution).hexdigest(),
        sorted(sheet.checks.items()),
        way,
        robot.read_text("utf-8") if robot.exists() else "",
    ]
    encoded = [part.encode(errors="surrogatepass") if isinstance(part, str) else part for part in parts]
    digests = [part if part is None else sha256(part).hexdigest() for part in encoded]
    return sha256(json.dumps([*common, digests]).encode()).hexdigest()
