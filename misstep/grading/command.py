"""Grade a sheet: a folder or a download of submissions in, a folder of results out. Nothing of a submission is run.

    misstep grade submissions/ --sheet 03 --out results/

site/instructors.md says what the results are. Each file is written completely or not at all, and the same submissions give the
same files. So a run that was ended in any way is simply started again.
"""

import argparse
from collections import Counter, defaultdict
from collections.abc import Sequence
from concurrent.futures import as_completed
from dataclasses import replace
from hashlib import sha256
from io import BytesIO
from pathlib import Path, PurePosixPath
from urllib.parse import quote
from zipfile import ZipFile, ZipInfo

from misstep.catalog import Course, find_course
from misstep.grading.collect.roster import export, read_roster, sheet_column
from misstep.grading.collect.submissions import CANVAS, MOODLE, Gathered, gather
from misstep.grading.escape import csv_text, format_points, printable
from misstep.grading.judging import Request, SheetName
from misstep.grading.overrides import read_overrides
from misstep.grading.pages import report_page
from misstep.grading.result import ABSENT, FLAGS, Result
from misstep.grading.similarity import shared_answers, unnamed_rows
from misstep.grading.workers import grade_within, open_executor

PLATFORMS = {"moodle": MOODLE, "canvas": CANVAS}
"""Those that take pages back, with the names of their files."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("submissions", type=Path, help="a folder, the zip file of a platform, or one notebook")
    parser.add_argument("--sheet", required=True, help="03, 03_poe_space, or the .json file of a robot's sheet")
    parser.add_argument("--out", type=Path, required=True, metavar="RESULTS", help="the folder for the results")
    parser.add_argument("--roster", type=Path, metavar="CSV", help="the list of students, as the platform exports it")
    parser.add_argument("--id-column", metavar="NAME", help="the column of the roster with the ids that students type")
    parser.add_argument("--column", metavar="NAME", help="the column of the sheet on the platform (default: the sheet)")
    parser.add_argument("--typed-ids", action="store_true", help="take the numbers of the ids typed in the sheets")
    parser.add_argument("--gradebook", type=Path, metavar="FOLDER", help="the nbgrader course whose gradebook to fill")
    parser.add_argument("--workers", type=int, default=2, metavar="N", help="how many at a time (default: 2)")
    parser.add_argument("--scheduler", metavar="tcp://HOST:PORT", help="of a Dask cluster, instead of workers here")
    parser.add_argument("--seconds", type=float, default=60.0, help="how long one student may take (default: 60)")


def run(options: argparse.Namespace) -> int:
    """Grade, and return the exit code: 0 done, 1 something needs the eyes of the instructor, 2 impossible request."""
    if options.workers < 1 or options.seconds <= 0:
        raise ValueError(f"--workers and --seconds must be positive; got {options.workers} and {options.seconds:g}.")
    name = sheet_name(find_course(), options.sheet)
    sheet = name.find()
    roster = read_roster(options.roster, options.id_column) if options.roster else None
    gathered = gather(options.submissions, sheet.name, roster)
    students = [one.student for one in gathered.submissions]
    overrides = read_overrides(options.out, sheet, students)
    if options.gradebook:
        from misstep.grading.gradebook import open_course, record  # here, because nbgrader takes a second to import

        gradebook = open_course(options.gradebook, sheet.name)
    requests = [Request(name, one, overrides.get(one.student, ()), options.typed_ids) for one in gathered.submissions]
    results = with_flags_of_class(grade_all(requests, options))
    attention = [*gathered.remarks, *sentences(results)]
    if options.gradebook:
        attention += record(gradebook, sheet.name, results)
    title = sheet_column(roster, sheet.name, options.column) if roster else ""
    if roster and roster.kind == "canvas" and title not in roster.columns:
        attention.append(f"Canvas would make a new column {title!r}. Name the one of the sheet with --column.")
    write_all(options.out, sheet.name, gathered, results, attention)
    if roster and roster.kind != "own":
        points = {one.student: one.points for one in results if one.status != ABSENT or one.points}
        text = export(roster, points, sheet.points, title)
        write(options.out / f"{roster.kind}.csv", text.encode())
    counts = sorted(Counter(result.status for result in results).items())
    summary = f"{len(results)} student{'s' * (len(results) != 1)}: {', '.join(f'{number} {status}' for status, number in counts)}."
    for line in [summary, *attention, f"The results are in {options.out}: open report.html, then grades.csv."]:
        print(printable(line))  # the one place from which names of files and students reach the terminal
    return 1 if attention else 0


def sheet_name(course: Course, text: str) -> SheetName:
    """Return the sheet that is meant by a number, a name, or the path of a robot's file or of a notebook.

    Raises ValueError if there is none.
    """
    path = Path(text)
    is_file = path.suffix in (".json", ".ipynb")
    folder, stem = (str(path.parent.resolve()), path.stem) if is_file else (str(Path.cwd()), text.strip("/"))
    matching = [name for name in course.sheets() if name == stem or name.partition("_")[0] == stem]
    name = matching[0] if len(matching) == 1 else stem
    return SheetName(name, "" if matching else folder, course.site)


def grade_all(requests: Sequence[Request], options: argparse.Namespace) -> list[Result]:
    """Grade all students, with a bar that shows how far it is, in the order of the requests."""
    from tqdm import tqdm

    with open_executor(options.workers, options.scheduler) as executor:
        futures = [executor.submit(grade_within, request, options.seconds) for request in requests]
        try:
            for future in tqdm(as_completed(futures), total=len(futures), desc=requests[0].sheet.name, disable=None):
                future.result()
            return [future.result() for future in futures]
        except BaseException as error:
            for future in futures:
                future.cancel()
            if isinstance(error, KeyboardInterrupt):
                raise ValueError("Stopped, and nothing was written. Run the same command to grade.") from None
            raise


def with_flags_of_class(results: Sequence[Result]) -> list[Result]:
    """Return the results with the flags that need a look at several students."""
    owners: dict[str, set[str]] = defaultdict(set)
    for result in results:
        for id_ in result.typed:
            owners[id_.casefold()].add(result.student)
    shared = shared_answers(results)
    flagged = []
    for result in results:
        others = sorted({who for id_ in result.typed for who in owners[id_.casefold()]} - {result.student})
        added = {"same id": f"also {', '.join(others[:5])}"} if others else {}
        added |= {"same answers": shared[result.student]} if result.student in shared else {}
        flagged.append(replace(result, flags={**result.flags, **added}))
    return flagged


def sentences(results: Sequence[Result]) -> list[str]:
    """Return what needs the eyes of an instructor: a sentence for each kind, with all names."""
    lines = []
    for flag, text in FLAGS.items():
        flagged = [(one.student, one.flags[flag].rstrip(".")) for one in results if flag in one.flags]
        named = [f"{student} ({about})" if about and flag != "absent" else student for student, about in flagged]
        if flag == "unmarked":  # of everybody, as a rule
            counts = Counter(about for _, about in flagged).items()
            named = [f"{about} of {count} student{'s' * (count > 1)}" for about, count in counts]
        if named:
            lines.append(f"{text}: {', '.join(named)}.")
    return lines


# --- files ---


def write(path: Path, content: bytes) -> None:
    """Write a file completely or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.partial")
    partial.write_bytes(content)
    partial.replace(path)


def write_all(out: Path, sheet: str, gathered: Gathered, results: Sequence[Result], attention: Sequence[str]) -> None:
    """Write the pages and tables of a class."""
    pages = {f"{file_name(one.student)}.html": one.page.encode() for one in results if one.status != ABSENT}
    for old in set((out / "feedback").glob("*.html")) - {out / "feedback" / name for name in pages}:
        old.unlink()  # of an earlier run that knew the students by other names
    for name, page in pages.items():
        write(out / "feedback" / name, page)
    write(out / "grades.csv", grades_table(results).encode())
    header = ["problem", "answers", "each number beside the right one", "an example", "right there"]
    write(out / "unnamed.csv", csv_text(header, unnamed_rows(results)).encode())
    write(out / "report.html", report_page(results, sheet, attention).encode())
    if gathered.platform in PLATFORMS:
        handed_in, buffer = [one for one in gathered.submissions if one.files], BytesIO()
        with ZipFile(buffer, "w") as archive:
            for one in handed_in:  # each page has the same date, so that equal pages give equal bytes
                upload = ZipInfo(feedback_name(gathered.platform, one.files[0].name, sheet))
                archive.writestr(upload, pages[f"{file_name(one.student)}.html"])
        write(out / "feedback.zip", buffer.getvalue())


def grades_table(results: Sequence[Result]) -> str:
    """Return the grades as CSV, with a row for each result, of which there is at least one."""
    last = ["reason", "mistakes", "id in the sheet", "file", "by hand"]
    header = ["student", "points", "max", "status", *(one.number for one in results[0].problems), *last]
    rows = []
    for one in results:
        told = (one.reason, *one.notes, one.flags.get("unmarked"))
        flags = [f"{FLAGS[flag]}: {about}" for flag, about in one.flags.items() if about and about not in told]
        first = [one.student, format_points(one.points), format_points(one.max), one.status]
        points = ["to be marked" if each.state == "open" else format_points(each.points) for each in one.problems]
        reason = " | ".join(filter(None, [one.reason, *one.notes, *flags]))
        mistakes = "; ".join(f"{problem.number} {name}" for problem in one.problems for name in problem.mistakes)
        changes = " | ".join(f"{problem.number}: {problem.note}" for problem in one.problems if problem.note)
        rows.append([*first, *points, reason, mistakes, ", ".join(one.typed), one.file, changes])
    return csv_text(header, rows)


def file_name(student: str) -> str:
    """Return a file name for a student: readable if the id is, different for each id, and never a path.

    >>> file_name("ada"), file_name("../ö"), file_name("")
    ('ada', '%2E.%2F%C3%B6', '%')
    """
    name = quote(student, safe=" @+,=", errors="surrogatepass")
    name = name.replace(".", "%2E", 1) if name.startswith(".") else name
    digest = sha256(student.encode(errors="surrogatepass")).hexdigest()[:16]
    return (name if len(name) <= 100 else f"{name[:80]}%{digest}") or "%"


def feedback_name(kind: str, path: PurePosixPath, sheet: str) -> str:
    """Return the name of a page by which a platform assigns it to its student.

    Source: mod/assign/feedback/file/importziplib.php of Moodle; infer_comment_context_from_filename of Canvas.

    >>> feedback_name("moodle", PurePosixPath("Ada Lovelace_1815_assignsubmission_file_/x.ipynb"), "03_poe_space")
    'Ada Lovelace_1815_assignfeedback_file_03_poe_space.html'
    >>> feedback_name("canvas", PurePosixPath("lovelaceada_LATE_1815_99_x-2.ipynb"), "03_poe_space")
    'lovelaceada_LATE_1815_99_feedback.html'
    """
    match = next(filter(None, map(PLATFORMS[kind].fullmatch, path.parts)))
    if kind == "moodle":
        return f"{match['name'].replace('_', ' ')}_{match['key']}_assignfeedback_file_{sheet}.html"
    return f"{match.string[: match.start('file')]}feedback.html"
