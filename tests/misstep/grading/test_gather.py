"""Gathering: whatever a folder or a platform's download holds, each file has its student."""

import os
import sys
import zipfile

import pytest
from submissions import NAME, SHEET, write, zipped

from misstep.grading.collect.roster import export, read_roster
from misstep.grading.collect.submissions import gather

X = b"{}"

CANVAS = {f"lovelaceada_1815_501_{NAME}": X, f"boolegeorge_LATE_1816_502_{SHEET}-2.ipynb": X}

MOODLE = {
    f"Ada Lovelace_1815_assignsubmission_file_/{NAME}": X,
    f"George Boole_1816_assignsubmission_file_/my {NAME}": X,
    "George Boole_1816_assignsubmission_onlinetext_/onlinetext.html": b"<p>Here it is.</p>",
}

GRADESCOPE = {
    "assignment_9_export/submission_metadata.yml": b"""---
submission_501:
  :submitters:
  - :name: Ada Lovelace
    :sid: '0007'
    :email: ada@example.edu
  :created_at: !ruby/object:ActiveSupport::TimeWithZone
    utc: 2026-11-01 10:00:00
submission_502:
  :submitters:
  - :name: George Boole
    :sid: 1816
  - :name: Cyn
    :sid:
    :email: cyn@example.edu
""",
    f"assignment_9_export/submission_501/{NAME}": X,
    f"assignment_9_export/submission_502/{NAME}": X,
}


def students(source, roster=None):
    """For each student the names of the files."""
    return {one.student: [file.name.name for file in one.files] for one in gather(source, SHEET, roster).submissions}


@pytest.mark.parametrize(
    ("names", "found"),
    [
        ([f"ada/{NAME}", f"bob/{NAME}", "roster.txt"], "ada bob"),
        (["ada.ipynb", f"bob_{NAME}", f"{SHEET}-cyn.ipynb", "d.e.ipynb", "ada (1).ipynb"], "ada bob cyn d.e"),
        ([f"A/ada/{NAME}", f"A/bob/{NAME}", f"B/cyn/{NAME}", "A/notes.txt"], "ada bob cyn"),
        ([f"ada/{NAME}", f"bob/week 3/{NAME}", f"cyn/{NAME}", "dan/sketch.pdf"], "ada bob cyn dan"),
        (["ada.ipynb.txt", "bob.ipynb.json", "roster.csv"], "ada bob"),
        (["A/ada.zip", f"A/bob/{NAME}", "A/bob/data.csv", f"A/cyn/{NAME}"], "ada bob cyn"),
        ([f"ada/{SHEET}/{NAME}", "ada/05_dh/05_dh.ipynb", "bob/05_dh/05_dh.ipynb"], "ada bob"),
        ([f"ada/.ipynb_checkpoints/{NAME}", f"ada/{NAME}", f"__MACOSX/ada/{NAME}"], "ada"),
        ([f"zoe\u0301/{NAME}"], "zo\u00e9"),
    ],
)
def test_folders_as_people_nest_them(tmp_path, names, found):
    write(tmp_path, **dict.fromkeys(names, X))
    assert " ".join(students(tmp_path)) == found
    (tmp_path.parent / f"{tmp_path.name}.zip").write_bytes(zipped(dict.fromkeys(names, X)))
    assert " ".join(students(tmp_path.parent / f"{tmp_path.name}.zip")) == found


def test_what_cannot_be_read_is_listed_with_its_student(tmp_path):
    write(tmp_path, **{f"ada/{NAME}": X, "secret/x.ipynb": X})
    (tmp_path / "empty").mkdir()
    for name in ("link", "pipe"):
        (tmp_path / name).mkdir()
    (tmp_path / "link" / NAME).symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "pipe" / NAME)
    walk, denied = os.walk, PermissionError(13, "Permission denied", str(tmp_path / "secret"))

    def refusing(top, onerror):
        for current, folders, names in walk(top):
            if "secret" in folders:
                folders.remove("secret")
                onerror(denied)
            yield current, folders, names

    with pytest.MonkeyPatch.context() as patch:  # root may read everything
        patch.setattr(os, "walk", refusing)
        found = gather(tmp_path, SHEET).submissions
    faults = {one.student: one.files[0].fault for one in found}
    assert faults == {
        "ada": "",
        "empty": "The folder is empty.",
        "link": f"{NAME} is a link, or no regular file. Hand in the notebook itself.",
        "pipe": f"{NAME} is a link, or no regular file. Hand in the notebook itself.",
        "secret": "The folder cannot be read: Permission denied.",
    }


@pytest.mark.parametrize(
    ("kind", "files", "named"),
    [
        ("canvas", CANVAS, ["boolegeorge_1816", "lovelaceada_1815"]),
        ("moodle", MOODLE, ["Ada Lovelace_1815", "George Boole_1816"]),
        ("gradescope", GRADESCOPE, ["0007", "1816", "cyn@example.edu"]),
    ],
)
def test_a_download_is_known_packed_and_unpacked(tmp_path, kind, files, named):
    packed = write(tmp_path, **{"in/s.zip": zipped(files), "in/roster.csv": b"id"}) / "in" / "s.zip"
    with zipfile.ZipFile(packed) as archive:
        archive.extractall(tmp_path / "unpacked" / "submissions")
    for source in (packed, packed.parent, tmp_path / "unpacked"):
        gathered = gather(source, SHEET)
        assert (gathered.platform, [one.student for one in gathered.submissions]) == (kind, named)
        assert {one.id for one in gathered.submissions} == {""}
        assert "no --roster" in gathered.remarks[0]


# --- rosters ---


def roster(path, text, column=None):
    (path / "roster.csv").write_text(text, "utf-8-sig")
    return read_roster(path / "roster.csv", column)


MOODLE_LANGUAGES = {
    "English": ("Participant ", "Identifier,Full name,Email address,Status,Grade,Maximum grade,Grade can be changed"),
    "German": ("Teilnehmer/in", "ID,Vollständiger Name,E-Mail-Adresse,Status,Bewertung,Bestwertung,Bewertung änderbar"),
}


@pytest.mark.parametrize(("language", "with_numbers"), [("English", False), ("German", True)])
def test_a_worksheet_of_moodle_is_known_in_every_language_and_filled_in(tmp_path, language, with_numbers):
    word, header = MOODLE_LANGUAGES[language]
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
    ids = ["0007", "0008"] if with_numbers else [row[2] for row in rows]
    assert (read.kind, read.columns, [*read.by_id.values()]) == ("moodle", titles, ids)
    source = write(tmp_path, **{"s.zip": zipped(MOODLE)}) / "s.zip"
    assert [one.student for one in gather(source, SHEET, read).submissions if one.files] == ids[:2]
    filled = [line.split(";") for line in export(read, {ids[0]: 6.25}, 12, SHEET).splitlines()]
    assert filled[0] == titles
    place = titles.index(header.split(",")[4])
    assert [line[place] for line in filled[1:]] == ["12,5", "7,50", ""]


@pytest.mark.parametrize(
    ("header", "delimiter"),
    [
        ("Student,ID,SIS User ID,SIS Login ID,Section,Old (1)", ","),
        ("LastName,FirstName,ID,SIS Login ID,Section,Old (1)", ";"),
        ("学生,ID,SIS 用户 ID,SIS 登录 ID,班级,Old (1)", ","),
    ],
)
def test_a_gradebook_of_canvas_is_known_and_its_test_student_is_none(tmp_path, header, delimiter):
    titles = header.split(",")
    rows = [["    Points Possible", *[""] * (len(titles) - 2), "10"]]
    for name, key, login in (
        ("Lovelace-Ada", "1815", "ada"),
        ("Boole-George", "1816", "bob"),
        ("Student-Test", "1818", "a8" * 16),
    ):
        student = name.split("-") if "FirstName" in header else [name]
        rows.append([*student, key, *([] if "FirstName" in header else [f"u{key}"]), login, "A", "7"])
    read = roster(tmp_path, "\n".join(delimiter.join(row) for row in [titles, *rows]))
    assert (read.kind, [*read.by_id.values()]) == ("canvas", ["ada", "bob"])
    source = write(tmp_path, **{"s.zip": zipped({**CANVAS, f"studenttest_1818_503_{NAME}": X})}) / "s.zip"
    gathered = gather(source, SHEET, read)
    assert [(one.student, one.id) for one in gathered.submissions] == [("ada", "ada"), ("bob", "bob")]
    assert gathered.remarks == ["Left out, because it is the platform's test student: studenttest."]
    filled = [line.split(delimiter) for line in export(read, {"ada": 12.0}, 24, SHEET).splitlines()]
    assert filled[0][:-1] == titles[: len(filled[0]) - 1]
    assert [line[-1] for line in filled[1:]] == ["24", "12", "", ""]


def test_gradescopes_list_gets_two_columns_and_a_student_without_sid_is_found_by_email(tmp_path):
    read = roster(
        tmp_path, "First Name,Last Name,SID,Email,Sections\nA,L,0007,ada@x,S\nC,N,,cyn@example.edu,S\nG,B,1816,b@x,S\n"
    )
    source = write(tmp_path, **{"s.zip": zipped(GRADESCOPE)}) / "s.zip"
    assert [one.student for one in gather(source, SHEET, read).submissions] == ["0007", "1816", "cyn@example.edu"]
    assert export(read, {"0007": 9.5}, 19, SHEET).splitlines()[:2] == [
        f"First Name,Last Name,SID,Email,Sections,{SHEET},{SHEET} - Max Points",
        "A,L,0007,ada@x,S,9.5,19",
    ]


def test_a_roster_names_those_without_a_file_and_spells_ids(tmp_path):
    read = roster(tmp_path, "name;id\nA;Ada\nB;bob\nC;cyn\n")
    source = write(tmp_path / "in", **{f"A/ADA/mine/{NAME}": X, "B/bob.ipynb": X, f"B/eve/{NAME}": X})
    gathered = gather(source, SHEET, read)
    assert [(one.student, one.id, len(one.files)) for one in gathered.submissions] == [
        *(("Ada", "Ada", 1), ("bob", "bob", 1), ("cyn", "cyn", 0), ("eve", "eve", 1))
    ]
    assert gathered.remarks == ["Not in the roster, and so not in the file for the platform: eve."]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("a,b\n1,2\n", "must be an export of Canvas"),
        ("id,name\nada,A\nADA,B\n", "repeats ada"),
        ("Identifiant,Name,Nr,Status,Note,Best\nParticipant 1,A,1,x,,gut\nParticipant 2,B,2,x,,gut\n", "not a scale"),
    ],
)
def test_a_list_that_cannot_be_the_roster_is_refused_with_the_reason(tmp_path, text, reason):
    write(tmp_path / "in", **{"ada.ipynb": X, "bob.ipynb": X})
    with pytest.raises(ValueError, match=reason):
        gather(tmp_path / "in", SHEET, roster(tmp_path, text))


if sys.platform == "win32":
    pytest.skip("pipes and rights of folders are those of Unix", allow_module_level=True)
