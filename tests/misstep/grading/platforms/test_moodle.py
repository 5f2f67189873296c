"""A class on Moodle in German, from the download and the roster to the file that the platform takes back; test_gather has the others."""

import csv
import io
import unicodedata
import zipfile

import pytest
import submissions
from submissions import SHEET, as_bytes, handed_in, mistaken, released, right

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO CLASS IS GRADED: this machine lacks {lacking}", allow_module_level=True)

from misstep.__main__ import main

NAME, COPY = f"{SHEET}.ipynb", f"{SHEET} (1).ipynb"
FULL = "28"
"""The points of `right`, which leaves out what asks for formulas."""


def typed_as(student, typed):
    """The sheet with right answers to the numbers of one id, and another one typed in it."""
    return {NAME: as_bytes(handed_in(typed, right(student)))}


CLASS = {
    "s01": ({NAME: as_bytes(handed_in("s01", right("s01")))}, FULL),
    "s02": ({"my answers.ipynb": as_bytes(handed_in("s02", right("s02"), first="%matplotlib widget"))}, FULL),
    "s03": ({NAME: as_bytes(handed_in("s03", mistaken("s03")))}, None),
    "s04": ({NAME: released().read_bytes()}, "0"),
    "s05": ({NAME: released().read_bytes(), COPY: as_bytes(handed_in("s05", right("s05")))}, FULL),
    "s06": ({"answers.pdf": b"%PDF-1.7"}, "0"),
    "s07": ({NAME: b""}, "0"),
    "s08": ({"02_matrix_exponential.ipynb": released("02_matrix_exponential").read_bytes()}, "0"),
    "s09": (typed_as("s01", "s01"), None),
    "s10": ({}, ""),
    "müller.7": (typed_as("müller.7", "MÜLLER.7"), FULL),
    "josé.3": (typed_as("josé.3", unicodedata.normalize("NFD", "josé.3")), FULL),
}
"""By id, the files that are handed in, and the points in the file for the platform; None for less than half of them."""

ROSTER = "ID;Vollständiger Name;ID-Nummer;Status;Bewertung;Bestwertung;Bewertung kann geändert werden\n"


@pytest.fixture(scope="module")
def walk(tmp_path_factory):
    """The roster, the folder of results, and what was printed."""
    folder = tmp_path_factory.mktemp("moodle")
    roster = ROSTER
    with zipfile.ZipFile(folder / "download.zip", "w") as archive:
        for key, (student, (files, _)) in enumerate(CLASS.items(), start=501):
            for name, content in files.items():
                archive.writestr(f"Zoë Müßig {key}_{key}_assignsubmission_file_/{name}", content)
            roster += f"Teilnehmer/in{key};Zoë Müßig {key};{student};;;37,00;Ja\n"
    (folder / "roster.csv").write_text(roster, "utf-8-sig")
    sheet = str(submissions.ROOT / "solutions" / SHEET / NAME)
    arguments = [sheet, str(folder / "download.zip"), "--roster", str(folder / "roster.csv")]
    printed = io.StringIO()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdout", printed)
        assert main(["grade", *arguments, "--out", str(folder / "results")]) == 0
    return roster, folder / "results", printed.getvalue()


def test_the_file_for_the_platform_has_its_own_form_and_the_points_of_each_student(walk):
    roster, results, _ = walk
    text = (results / "moodle.csv").read_text("utf-8")
    (head, *before), (new_head, *after) = (csv.reader(io.StringIO(t), delimiter=";") for t in (roster, text))
    assert new_head == head
    assert [row[:4] for row in after] == [row[:4] for row in before]
    points = {row[2]: row[4] for row in after}
    assert list(points) == list(CLASS)
    for student, (_, wanted) in CLASS.items():
        if wanted is None:
            assert float(points[student].replace(",", ".")) < float(FULL) / 2
        else:
            assert points[student] == wanted, student


def test_each_student_who_handed_something_in_gets_a_page_back_and_what_is_said_is_true(walk):
    _, results, printed = walk
    with zipfile.ZipFile(results / "feedback.zip") as archive:
        names = archive.namelist()
        pages = {archive.read(name) for name in names}
    assert pages < {
        path.read_bytes() for path in (results / "feedback").iterdir()
    }  # who submitted nothing has a page, too
    handed = [key for key, (files, _) in enumerate(CLASS.values(), start=501) if files]
    assert sorted(int(name.split("_")[1]) for name in names) == handed
    assert printed.startswith("12 of 12 submissions: 1 absent, 3 broken, 8 graded. ")
    report = (results / "report.html").read_text("utf-8")
    assert "11 students" in report
    assert not [student for student in CLASS if student in report]
