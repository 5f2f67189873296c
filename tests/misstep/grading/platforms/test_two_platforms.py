"""A class on two platforms in two languages, from the download and the roster to the file that the platform takes back."""

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

MOODLE = "ID;Vollständiger Name;ID-Nummer;Status;Bewertung;Bestwertung;Bewertung kann geändert werden\n"
CANVAS = "Estudiante,ID,ID de usuario de SIS,ID de inicio de sesión de SIS,Sección,Hoja 3 (991)\n    Points Possible,,,,,37\n"


def moodle(archive):
    roster = MOODLE
    for key, (student, (files, _)) in enumerate(CLASS.items(), start=501):
        for name, content in files.items():
            archive.writestr(f"Zoë Müßig {key}_{key}_assignsubmission_file_/{name}", content)
        roster += f"Teilnehmer/in{key};Zoë Müßig {key};{student};;;37,00;Ja\n"
    return roster


def canvas(archive):
    roster = CANVAS
    for key, (student, (files, _)) in enumerate(CLASS.items(), start=501):
        for number, (name, content) in enumerate(files.items()):
            archive.writestr(f"munoz_{'LATE_' if key % 5 == 0 else ''}{key}_{9 * key + number}_{name}", content)
        roster += f'"Muñoz, {key}",{key},,{student},A,\n'
    archive.writestr(f"studenttest_999_1_{NAME}", released().read_bytes())
    return roster + '"Student, Test",999,,0b1c2d3e4f5061728394a5b6c7d8e9f00a1b2c3d,A,\n'


PLATFORMS = {"moodle": (moodle, ";", 2, 4), "canvas": (canvas, ",", 3, 5)}
"""By platform, what it exports, what separates its cells, and the columns of the id and of the points."""


@pytest.fixture(scope="module", params=PLATFORMS)
def walk(request, tmp_path_factory):
    """The platform, the folder of results, and what was printed."""
    folder = tmp_path_factory.mktemp(request.param)
    with zipfile.ZipFile(folder / "download.zip", "w") as archive:
        roster = PLATFORMS[request.param][0](archive)
    (folder / "roster.csv").write_text(roster, "utf-8-sig")
    sheet = str(submissions.ROOT / "solutions" / SHEET / NAME)
    arguments = [sheet, str(folder / "download.zip"), "--roster", str(folder / "roster.csv")]
    printed = io.StringIO()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdout", printed)
        assert main(["grade", *arguments, "--out", str(folder / "results")]) == 0
    return request.param, roster, folder / "results", printed.getvalue()


def test_the_file_for_the_platform_has_its_own_form_and_the_points_of_each_student(walk):
    platform, roster, results, _ = walk
    _, delimiter, id_column, points_column = PLATFORMS[platform]
    text = (results / f"{platform}.csv").read_text("utf-8")
    (head, *before), (new_head, *after) = (csv.reader(io.StringIO(t), delimiter=delimiter) for t in (roster, text))
    assert new_head[:points_column] == head[:points_column]
    assert [row[:id_column] for row in after] == [row[:id_column] for row in before]
    points = {row[id_column]: row[points_column] for row in after if row[id_column] in CLASS}
    assert list(points) == list(CLASS)
    for student, (_, wanted) in CLASS.items():
        if wanted is None:
            assert float(points[student].replace(",", ".")) < float(FULL) / 2
        else:
            assert points[student] == wanted, student


def test_each_student_who_handed_something_in_gets_a_page_back_and_what_is_said_is_true(walk):
    platform, _, results, printed = walk
    with zipfile.ZipFile(results / "feedback.zip") as archive:
        names = archive.namelist()
    handed = [key for key, (files, _) in enumerate(CLASS.values(), start=501) if files]
    place = 1 if platform == "moodle" else -3
    assert sorted(int(name.split("_")[place]) for name in names) == handed
    left_out = "Left out, because it is the platform's test student: studenttest.\n" * (platform == "canvas")
    assert printed.startswith(f"{left_out}12 of 12 submissions: 1 absent, 3 broken, 8 graded. ")
    report = (results / "report.html").read_text("utf-8")
    assert "11 submissions" in report or "11 students" in report
    assert not [student for student in CLASS if student in report]
