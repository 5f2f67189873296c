"""Gathering: whatever a folder or a platform's download holds, each student has one submission, and each oddity a sentence."""

import os
import re
import stat
import sys
import zipfile
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

if sys.platform == "win32":
    pytest.skip("grading is made of Linux", allow_module_level=True)

from misstep.grading.collect import run_plan
from misstep.grading.collect.files import UnreadableFile, list_files
from misstep.grading.collect.gather import WrongRoster, gather
from misstep.grading.collect.notebook import MAX_NOTEBOOK_BYTES, code_cells
from misstep.grading.collect.roster import read_roster
from misstep.grading.judging.result import Result
from misstep.grading.publish.platform_exports import export
from misstep.grading.publish.result_store import file_name

SHEET = "03_poe_space"
NAME = f"{SHEET}.ipynb"


def typed_id(content):
    return run_plan.typed_id(code_cells(content))


def notebook(student="ada", sheet=SHEET):
    code = f'student = \\"{student}\\"\\nsheet = open_sheet(\\"{sheet}\\", student)'
    return f'{{"cells": [{{"cell_type": "code", "source": "{code}"}}]}}'.encode()


def result(student, points, maximum, status="graded"):
    return Result(student, SHEET, points, maximum, status, "", [])


def folder(root, **names):
    """A folder with files; a path is written with __ for a slash."""
    for number, (name, content) in enumerate(names.items()):
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else notebook(content))
        os.utime(path, (1e9 + number, 1e9 + number))
    return root


def zipped(path, members):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return path


def by_student(gathered):
    return {handed.student: handed for handed in gathered.submissions}


def read(handed):
    """The bytes of what one student handed in; None if that is nothing."""
    return handed.notebooks[0].read() if handed.notebooks else None


def refusal(handed):
    with pytest.raises(UnreadableFile) as refused:
        read(handed)
    return str(refused.value)


# --- layouts ---


def test_a_folder_for_each_student(tmp_path):
    folder(tmp_path, **{f"ada/{NAME}": "ada", f"bob/{NAME}": "bob", "roster.txt": b"a list"})
    (tmp_path / "cyn").mkdir()
    gathered = gather(tmp_path, SHEET)
    assert gathered.kind == "folder"
    assert [(h.student, h.seed_id, read(h)) for h in gathered.submissions] == [
        *(("ada", "ada", notebook("ada")), ("bob", "bob", notebook("bob")), ("cyn", "cyn", None))
    ]


def test_a_flat_folder_names_students_by_files(tmp_path):
    names = ("ada.ipynb", f"bob_{NAME}", f"{SHEET}-cyn.ipynb", "d.e.ipynb")
    gathered = gather(folder(tmp_path, **dict.fromkeys(names, "x")), SHEET)
    assert list(by_student(gathered)) == ["ada", "bob", "cyn", "d.e"]


def test_a_name_is_the_same_however_its_accents_are_written(tmp_path):
    """A Mac takes an accent apart; a zip of an old Windows leaves bytes that are no UTF-8."""
    (tmp_path / "r.csv").write_text("id\nzoé\n", "utf-8")
    root = folder(tmp_path / "in", **{f"zoe\u0301/{NAME}": "zoé"})
    Path(os.fsdecode(os.fsencode(root) + b"/x\xff.ipynb")).write_bytes(notebook("x"))
    gathered = gather(root, SHEET, read_roster(tmp_path / "r.csv"))
    assert [(handed.student, bool(handed.notebooks)) for handed in gathered.submissions] == [
        ("x?", True),
        ("zoé", True),
    ]


def test_the_submitted_folder_of_nbgrader_holds_other_sheets_too(tmp_path):
    other = "05_dh_standard/05_dh_standard.ipynb"
    folder(tmp_path, **{f"ada/{SHEET}/{NAME}": "ada", f"ada/{other}": "ada", f"bob/{other}": "bob"})
    (tmp_path / "ada" / SHEET / "timestamp.txt").write_text("2026-11-01 10:00:00 UTC")
    gathered = gather(tmp_path, SHEET)
    assert gathered.kind == "nbgrader"
    assert read(by_student(gathered)["ada"]) == notebook("ada")
    assert read(by_student(gathered)["bob"]) is None


CANVAS = {
    f"lovelaceada_1815_501_{NAME}": notebook("ada"),
    f"boolegeorge_LATE_1816_502_{SHEET}-2.ipynb": notebook("bob"),
}

MOODLE = {
    f"Ada Lovelace_1815_assignsubmission_file_/{NAME}": notebook("ada"),
    f"George Boole_1816_assignsubmission_file_/my {NAME}": notebook("bob"),
    "George Boole_1816_assignsubmission_onlinetext_/onlinetext.html": b"<p>Here it is.</p>",
}

GRADESCOPE = {
    "assignment_9_export/submission_metadata.yml": """---
submission_501:
  :submitters:
  - :name: Ada Lovelace
    :sid: '0007'
    :email: ada@example.edu
  :created_at: !ruby/object:ActiveSupport::TimeWithZone
    utc: 2026-11-01 10:00:00
  :score: 0.0
submission_502:
  :submitters:
  - :name: George Boole
    :sid: 1816
    :email: bob@example.edu
  - :name: Cyn
    :sid:
    :email: cyn@example.edu
""",
    f"assignment_9_export/submission_501/{NAME}": notebook("ada"),
    f"assignment_9_export/submission_502/{NAME}": notebook("bob"),
}

CANVAS_ROSTER = """Student,ID,SIS User ID,SIS Login ID,Section,Old (1)
    Points Possible,,,,,10
"Lovelace, Ada",1815,u1,ada,A,7
"Boole, George",1816,u2,bob,A,
"Missing, Cyn",1817,u3,cyn,B,
"Student, Test",1818,,,B,
"""

DOWNLOADS = {
    "canvas": (CANVAS, ["boolegeorge_1816", "lovelaceada_1815"]),
    "moodle": (MOODLE, ["Ada Lovelace_1815", "George Boole_1816"]),
    "gradescope": (GRADESCOPE, ["0007", "1816", "cyn@example.edu"]),
}
"""By platform, what it exports, and whom it names."""


def roster(path, text, column=None):
    (path / "roster.csv").write_text(text, "utf-8-sig")
    return read_roster(path / "roster.csv", column)


@pytest.mark.parametrize("kind", DOWNLOADS)
def test_a_download_without_a_roster_goes_by_the_ids_in_the_sheets_and_says_so(tmp_path, kind):
    files, named = DOWNLOADS[kind]
    packed = zipped(tmp_path / "submissions.zip", files)
    with zipfile.ZipFile(packed) as archive:
        archive.extractall(tmp_path / "unpacked" / "submissions")
    for source in (packed, tmp_path / "unpacked"):
        gathered = gather(source, SHEET)
        assert gathered.kind == kind
        assert "no --roster" in gathered.remarks[0]
        assert {handed.seed_id for handed in gathered.submissions} == {""}
        assert {typed_id(read(handed)) for handed in gathered.submissions if read(handed)} == {"ada", "bob"}
        assert list(by_student(gathered)) == named


MOODLE_LANGUAGES = {
    "English": ("Participant ", "Identifier,Full name,Email address,Status,Grade,Maximum grade,Grade can be changed"),
    "German": ("Teilnehmer/in", "ID,Vollständiger Name,E-Mail-Adresse,Status,Bewertung,Bestwertung,Bewertung änderbar"),
    "Japanese": ("参加者", "ID,姓名,メールアドレス,ステータス,評点,最大評点,評点変更可"),
    "Arabic": ("مشارك", "المعرف,الاسم الكامل,البريد,الحالة,الدرجة,الدرجة العظمى,يمكن تغيير الدرجة"),
}


@pytest.mark.parametrize("language", MOODLE_LANGUAGES)
def test_a_worksheet_of_moodle_is_known_by_its_cells_in_every_language(tmp_path, language):
    """Header and first cell as Moodle's language packs have them: recordid, hiddenuser, status, grade, maxgrade, ..."""
    word, header = MOODLE_LANGUAGES[language]
    for with_numbers in (False, True):
        titles = [*header.split(","), "..."]
        rows = [
            [f"{word}1815", "Ada Lovelace", "ada@example.edu", "✓ x", "", "24,00", "+", "-"],
            [f"{word}1816", "George Boole", "bob@example.edu", "✓ x", "7,50", "24,00", "+", "-"],
            [f"{word}1817", "Cyn", "cyn@example.edu", "- x", "", "24,00", "+", "-"],
        ]
        if with_numbers:
            titles.insert(2, "ID ...")
            for row, number in zip(rows, ("0007", "0008", ""), strict=True):
                row.insert(2, number)
        read = roster(tmp_path, "\n".join(";".join(row) for row in [titles, *rows]))
        assert (read.kind, read.columns) == ("moodle", titles)
        assert read.ids == (["0007", "0008"] if with_numbers else [row[2] for row in rows])
        source = zipped(tmp_path / "s.zip", MOODLE)
        students = {handed.student for handed in gather(source, SHEET, read).submissions if handed.notebooks}
        assert students == set(read.ids[:2])
        graded = [result(read.ids[0], 12.5, 24), result(read.ids[1], 0, 24, "absent")]
        filled = [line.split(";") for line in export(read, graded).splitlines()]  # separated as Moodle wrote it
        assert filled[0] == titles
        place = titles.index(header.split(",")[4])
        assert [line[place] for line in filled[1:]] == ["12,5", "7,50", ""]


CANVAS_TABLES = {
    "English": "Student,ID,SIS User ID,SIS Login ID,Section,Old (1)",
    "two names": "LastName,FirstName,ID,SIS Login ID,Section,Old (1)",
    "Chinese": "学生,ID,SIS 用户 ID,SIS 登录 ID,班级,Old (1)",
}


@pytest.mark.parametrize("language", CANVAS_TABLES)
def test_a_gradebook_of_canvas_is_known_by_its_cells_and_its_test_student_is_none(tmp_path, language):
    titles = CANVAS_TABLES[language].split(",")
    names = [["Lovelace", "Ada"], ["Boole", "George"], ["Student", "Test"]]
    has_two = language == "two names"
    logins = ["ada", "bob", "a8f5f167f44f4964e6c998dee827110c"]
    rows = [["    Points Possible", *[""] * (len(titles) - 2), "10"]]
    for name, key, login in zip(names, ("1815", "1816", "1818"), logins, strict=True):
        student = name if has_two else ["-".join(name)]
        rows.append([*student, key, *([] if has_two else [f"u{key}"]), login, "A", "7"])
    for delimiter in ",;":
        read = roster(tmp_path, "\n".join(delimiter.join(row) for row in [titles, *rows]))
        assert (read.kind, read.ids) == ("canvas", ["ada", "bob"])
        members = {**CANVAS, f"studenttest_1818_503_{NAME}": notebook("x")}
        gathered = gather(zipped(tmp_path / "s.zip", members), SHEET, read)
        assert list(by_student(gathered)) == ["ada", "bob"]
        assert gathered.remarks == ["Left out, because it is the platform's test student: studenttest."]
        graded = [result("ada", 12, 24), result("bob", 0, 24, "absent")]
        filled = [line.split(delimiter) for line in export(read, graded).splitlines()]
        assert filled[0][:-1] == titles[: len(filled[0]) - 1]
        assert [line[-1] for line in filled[1:]] == ["24", "12", "", ""]


def test_a_list_of_ones_own_stays_one(tmp_path):
    for text in (
        "id,name\ns1,A\ns2,B\n",
        "id,name,email,group,year\nstud1,A,a@b,1,\nstud2,B,b@b,2,\n",
        "ID,Name,Group,Email\nin20000,A,1,a@b\n",
        "name;id\nA;1\nB;2\n",
    ):
        assert roster(tmp_path, text).kind == "own"


def test_a_worksheet_with_a_scale_is_refused_and_one_with_two_columns_of_ids_names_them(tmp_path):
    head = "Identifiant,Name,Nummer,Kennung,Status,Bewertung,Best"
    text = f"{head}\nParticipant 1,A B,1,a,x,,{{0}}\nParticipant 2,C D,2,c,x,,{{0}}"
    with pytest.raises(ValueError, match="grade the assignment with points, not a scale"):
        roster(tmp_path, text.format("gut"))
    read = roster(tmp_path, text.format("10"))
    assert gather(folder(tmp_path / "in", **{f"1/{NAME}": "1"}), SHEET, read).remarks == [
        "The ids are read from the column 'Nummer' of the roster, and not from 'Kennung'. Name another column with --id-column."
    ]
    assert roster(tmp_path, text.format("10"), "Kennung").ids == ["a", "c"]


def class_on(platform, ids, root, absent=()):
    """The submissions of a class on a platform, and its roster; whatever the platform lets students type in is an id of them."""
    files = {
        "canvas": "x{n}_{n}_9{n}_" + NAME,
        "moodle": "Ada B_{n}_assignsubmission_file_/" + NAME,
        "gradescope": "submission_{n}/" + NAME,
        "nbgrader": f"{{id}}/{SHEET}/{NAME}",
        "folder": f"{{id}}/{NAME}",
    }[platform]
    table = {
        "canvas": ("Student,ID,SIS User ID,SIS Login ID,Section", '"A, B",{n},,{id},S'),
        "moodle": ("Identifier,Full name,ID number,Status,Grade,Maximum grade", "Participant {n},A B,{id},x,,10"),
        "gradescope": ("First Name,Last Name,SID,Email,Sections", "A,B,{id},{n}@x,S"),
    }.get(platform, ("id,name,group,seat,room", "{id},A B,1,7,"))
    here = {n: name for n, name in enumerate(ids, start=1) if name not in absent}
    members = {files.format(n=n, id=name): notebook(name) for n, name in here.items()}
    if platform == "gradescope":
        people = (f"submission_{n}:\n  :submitters:\n  - :sid: '{name}'\n" for n, name in here.items())
        members["submission_metadata.yml"] = "".join(people)
    lines = [table[0], *(table[1].format(n=n, id=name) for n, name in enumerate(ids, start=1))]
    (root / "roster.csv").write_text("\n".join(lines), "utf-8")
    return zipped(root / "s.zip", members), read_roster(root / "roster.csv")


@pytest.mark.parametrize("platform", ["canvas", "moodle", "gradescope", "nbgrader", "folder"])
def test_everybody_is_found_whatever_their_ids_are_and_who_handed_nothing_in(tmp_path, platform):
    for ids in (("0071815", "0071816", "0081815"), ("s1815", "t1815", "s1816"), ("ada01", "bob01", "jörg")):
        source, known = class_on(platform, (*ids, "zoe"), tmp_path, absent=("zoe",))
        gathered = gather(source, SHEET, known)
        assert gathered.remarks == []
        assert {one.student: read(one) for one in gathered.submissions} == {name: notebook(name) for name in ids} | {
            "zoe": None
        }
        assert {one.seed_id for one in gathered.submissions} == {*ids, "zoe"}


def test_a_student_without_sid_is_found_by_the_email_address(tmp_path):
    _, known = class_on("gradescope", ("s1", "s2", ""), tmp_path)
    list_of = zipped(
        tmp_path / "t.zip",
        {
            "submission_1/x.ipynb": notebook("s1"),
            "submission_metadata.yml": ("submission_1:\n  :submitters:\n  - :name: A\n    :email: 1@X\n"),
        },
    )
    assert [one.student for one in gather(list_of, SHEET, known).submissions if one.notebooks] == ["s1"]


def test_a_roster_of_another_course_stops_the_run_and_says_why(tmp_path):
    _, other = class_on("canvas", ("eve", "dan"), tmp_path)
    (tmp_path / "other").mkdir()
    source, _ = class_on("folder", ("s1", "s2", "eve"), tmp_path / "other")
    with pytest.raises(
        WrongRoster,
        match=r"2 of 3 submissions are not in the roster, for example s1, s2\. Its column 'SIS Login ID' has, for example, eve",
    ):
        gather(source, SHEET, other)


def test_a_list_like_that_of_gradescope_that_a_student_hands_in_is_one_more_file(tmp_path):
    listed = b"submission_1:\n  :submitters:\n  - :sid: bob\n"
    gathered = gather(
        folder(tmp_path, **{f"ada/{NAME}": "ada", f"bob/{NAME}": "bob", "bob/submission_metadata.yml": listed}), SHEET
    )
    assert (gathered.kind, list(by_student(gathered))) == ("folder", ["ada", "bob"])


def test_a_roster_that_cannot_be_one_is_told_why(tmp_path):
    for text, message in [
        ("a,b\n1,2\n", "has the columns a, b. A roster must be an export of Canvas"),
        ("id,name\nada,A\nADA,B\n", "column 'id' has the id 'ada' 2 times"),
        ("Student,ID,Section\n,,\n", "ids in the column .* --id-column"),
        (CANVAS_ROSTER.replace(",1816,", ",1815,"), "column 'ID' has the key '1815' for ada, bob"),
        ("", "has the columns none"),
        ("a" * 5000, "has the columns a{300}. A roster"),
        (f"id\n{'x' * 200_000}\n", r"cannot be read as a table \(CSV in UTF-8\): field larger"),
    ]:
        with pytest.raises(ValueError, match=message):
            roster(tmp_path, text)
    with pytest.raises(ValueError, match="ids in the column matriculation"):
        roster(tmp_path, CANVAS_ROSTER, "Matriculation")


# --- which file ---


def test_of_several_files_all_are_graded_first_the_one_with_the_name_of_the_sheet(tmp_path):
    for number, (names, chosen) in enumerate(
        [
            (["a.ipynb", NAME], NAME),
            ([f"{SHEET}-1.ipynb", f"{SHEET} (2).ipynb"], f"{SHEET} (2).ipynb"),
            ([f"{SHEET}-Copy1.ipynb", "other.ipynb"], f"{SHEET}-Copy1.ipynb"),
            (["mine.ipynb"], "mine.ipynb"),
            ([NAME.upper(), "z.ipynb"], NAME.upper()),
        ]
    ):
        (handed,) = gather(folder(tmp_path / str(number), **{f"ada/{n}": "ada" for n in names}), SHEET).submissions
        assert handed.notebooks[0].path.name == chosen
        assert {file.path.name for file in handed.notebooks} == set(names)
    folder(tmp_path / "other", **{"ada/a.ipynb": "ada", "ada/b.ipynb": notebook("ada", "05_dh_standard")})
    (handed,) = gather(tmp_path / "other", SHEET).submissions
    assert handed.notebooks[0].path.name == "a.ipynb", "the one that opens the sheet"


def test_a_file_that_is_no_notebook_is_handed_on_so_that_its_reason_is_told(tmp_path):
    (handed,) = gather(folder(tmp_path, **{"ada/sheet.pdf": b"%PDF-1.7"}), SHEET).submissions
    assert read(handed) == b"%PDF-1.7"
    assert handed.notes == ["No notebook was handed in, only: sheet.pdf."]


def test_more_notebooks_than_one_student_needs_are_not_graded_and_are_named(tmp_path):
    """Each further one would be a guess."""
    folder(tmp_path, **{f"ada/{SHEET} ({number}).ipynb": "ada" for number in range(5)})
    (handed,) = gather(tmp_path, SHEET).submissions
    assert [file.path.name for file in handed.notebooks] == [f"{SHEET} ({number}).ipynb" for number in (4, 3, 2)]
    assert handed.notes == [
        f"5 notebooks were handed in; at most 3 are graded, so not: {SHEET} (1).ipynb, {SHEET} (0).ipynb."
    ]


@pytest.mark.parametrize("names", [("Ada", "ada"), ("zo\u00e9", "zoe\u0301")], ids=ascii)
def test_ids_that_are_almost_the_same_stay_two_students_and_are_named(tmp_path, names):
    for form in ("{}.ipynb", f"{{}}/{NAME}"):
        root = tmp_path / str(len(form))
        gathered = gather(folder(root, **{form.format(name): name for name in names}), SHEET)
        assert {one.student: typed_id(read(one)) for one in gathered.submissions} == {name: name for name in names}
        assert "differ only in capitals or in the form of their letters" in gathered.remarks[0]
        assert all(repr(name) in gathered.remarks[0] for name in names)


def test_capitals_make_no_difference_to_the_roster_unless_two_students_want_one_id(tmp_path):
    (tmp_path / "r.csv").write_text("id\nada\nBob\nstra\u00dfe\nstrasse\n", "utf-8")
    read = read_roster(tmp_path / "r.csv")
    one = gather(folder(tmp_path / "one", **{f"ADA/{NAME}": "ada", f"strasse/{NAME}": "x"}), SHEET, read)
    assert [(handed.student, bool(handed.notebooks)) for handed in one.submissions] == [
        *[("ada", True), ("Bob", False), ("strasse", True), ("stra\u00dfe", False)]
    ]
    two = gather(folder(tmp_path / "two", **{f"ADA/{NAME}": "1", f"Ada/{NAME}": "2", f"Bob/{NAME}": "3"}), SHEET, read)
    students = by_student(two)
    assert {name for name, handed in students.items() if handed.notebooks} == {"ADA", "Ada", "Bob"}
    assert "Not in the roster, and so not in the file for the platform: ADA, Ada." in two.remarks


def test_a_file_named_after_a_friend_does_not_replace_the_friends_file(tmp_path):
    gathered = gather(folder(tmp_path, **{"ada.ipynb": "ada", f"ada_{NAME}": "eve", "ada (1).ipynb": "ada"}), SHEET)
    (handed,) = gathered.submissions
    assert {typed_id(file.read()) for file in handed.notebooks} == {"ada", "eve"}
    assert "'ada' has 3 notebooks" in gathered.remarks[0]
    assert "look whether all are of this student" in gathered.remarks[0]


def test_two_submissions_of_one_id_on_a_platform_are_both_graded(tmp_path):
    of_ada = "submission_{}:\n  :submitters:\n  - :sid: '0007'\n"
    members = {"e/submission_metadata.yml": of_ada.format(1) + of_ada.format(2)}
    source = zipped(tmp_path / "s.zip", members)
    with zipfile.ZipFile(source, "a") as archive:
        for number, year in ((1, 2025), (2, 2026)):
            archive.writestr(
                zipfile.ZipInfo(f"e/submission_{number}/{NAME}", (year, 1, 1, 0, 0, 0)), notebook(str(year))
            )
    (handed,) = gather(source, SHEET).submissions
    assert [typed_id(file.read()) for file in handed.notebooks] == ["2026", "2025"]
    assert handed.notes == ["2 submissions have this id."]


def test_an_empty_folder_and_a_file_that_is_no_download(tmp_path):
    (tmp_path / "empty").mkdir()
    (tmp_path / "x.tar").write_bytes(b"tar")
    with pytest.raises(ValueError, match="neither a folder nor a zip"):
        gather(tmp_path / "x.tar", SHEET)
    with pytest.raises(ValueError, match="neither a folder nor a zip"):
        gather(tmp_path / "nowhere", SHEET)
    with pytest.raises(ValueError, match="no submission"):
        gather(tmp_path / "empty", SHEET)


# --- what is not to be trusted ---


def test_links_and_pipes_in_a_folder_are_not_followed(tmp_path):
    secret = tmp_path / "secret"
    folder(secret, **{NAME: b"SECRET"})
    root = folder(tmp_path / "in", **{f"ada/{NAME}": "ada"})
    for student in ("bob", "eve"):
        (root / student).mkdir()
    (root / "bob" / NAME).symlink_to(secret / NAME)
    (root / "cyn").symlink_to(secret)
    os.mkfifo(root / "eve" / NAME)
    students = by_student(gather(root, SHEET))
    assert list(students) == ["ada", "bob", "cyn", "eve"]
    assert "a link to another place" in refusal(students["bob"])
    assert "a link to another place" in refusal(students["cyn"])
    assert "not a regular file" in refusal(students["eve"])


def linked(name):
    info = zipfile.ZipInfo(name)
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    return info


def test_paths_and_links_in_a_zip_lead_nowhere(tmp_path):
    source = tmp_path / "s.zip"
    with zipfile.ZipFile(source, "w") as archive:
        for name in ("../../ada/", "/etc/bob/", "..\\cyn\\", "C:\\dan\\"):
            archive.writestr(f"{name}{NAME}", b"x")
        archive.writestr(linked(f"eve/{NAME}"), b"/etc/passwd")
    told = {handed.student: refusal(handed) for handed in gather(source, SHEET).submissions}
    assert set(told) == {"ada", "etc", "cyn", "dan", "eve"}
    assert all("leads out of its archive" in told[name] for name in ("ada", "etc", "cyn", "dan"))
    assert "a link" in told["eve"]
    assert [path.name for path in tmp_path.iterdir()] == ["s.zip"]


def test_a_zip_bomb_is_not_unpacked(tmp_path):
    bomb = b"0" * (MAX_NOTEBOOK_BYTES + 1)
    source = zipped(tmp_path / "s.zip", {f"ada/{NAME}": bomb, f"bob/{NAME}": notebook("bob")})
    assert source.stat().st_size < 100_000
    students = by_student(gather(source, SHEET))
    assert "unpacks to 34 MB" in refusal(students["ada"])
    assert read(students["bob"]) == notebook("bob")


def test_a_zip_of_which_a_byte_was_changed_is_read_or_told_whichever_byte(tmp_path):
    """Versions, flags, kinds of compression and names: each has an error of its own in Python's library."""
    source = zipped(tmp_path / "s.zip", {f"ada/{NAME}": notebook("ada"), "ä/x.txt": b"x" * 100})
    sound, told = source.read_bytes(), []
    for place in range(len(sound)):
        for flip in (0x08, 0xFF):
            source.write_bytes(bytes([*sound[:place], sound[place] ^ flip, *sound[place + 1 :]]))
            try:
                for file in list_files(source):
                    with suppress(UnreadableFile):
                        file.read()
            except ValueError as error:
                told.append(str(error))
    assert told
    assert all(re.search(r"neither a folder nor a zip|is damaged: .*Download it again", each) for each in told)


def test_a_damaged_member_costs_one_student(tmp_path):
    source = zipped(tmp_path / "s.zip", {f"ada/{NAME}": os.urandom(5000), f"bob/{NAME}": notebook("bob")})
    data = bytearray(source.read_bytes())
    data[200:300] = bytes(100)
    source.write_bytes(data)
    students = by_student(gather(source, SHEET))
    assert "damaged" in refusal(students["ada"])
    assert read(students["bob"]) == notebook("bob")


def test_what_file_managers_leave_is_left_out(tmp_path):
    names = [f"__MACOSX/ada/._{NAME}", f"ada/.ipynb_checkpoints/{NAME}", f"ada/{NAME}", ".DS_Store"]
    found = list_files(zipped(tmp_path / "s.zip", dict.fromkeys(names, b"x")))
    assert [str(file.path) for file in found] == [f"ada/{NAME}"]


def test_a_list_of_gradescope_that_is_none_is_told(tmp_path):
    for metadata in ("just a text", "- a\n- b", "a: [1, 2", "a: &a [*a]"):
        source = zipped(tmp_path / "s.zip", {"e/submission_metadata.yml": metadata, f"e/submission_1/{NAME}": b"x"})
        with pytest.raises(ValueError, match="again"):
            gather(source, SHEET)


@given(st.lists(st.text(max_size=9) | st.sampled_from(["..", "../../etc/passwd", "ä" * 300, "ä" * 301]), unique=True))
@example(["a b", "a+b", "a%20b", "a/b", "a_b", "A", "ä", "x" * 300, "x" * 301, "", "%", ".a", "%2Ea", "\ud800", "\x00"])
def test_no_id_is_a_path_and_ids_have_files_of_their_own(students):
    names = [file_name(student) for student in students]
    assert len({*names}) == len(names)
    for name in names:
        assert re.fullmatch(r"[^./\\][^/\\]*", name), "no path, and not hidden"
        assert name.isascii()
        assert len(name) < 250
