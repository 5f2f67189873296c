"""Pages and tables: what a student wrote stands in them as letters, a reader finds what happened, and a spreadsheet runs nothing."""

import csv
import io
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import PurePosixPath

import pytest
from browser import browsers, watched
from hypothesis import example, given
from hypothesis import strategies as st

from misstep.grading.collect.roster import Roster
from misstep.grading.judging.result import ProblemResult, RanCell, Result
from misstep.grading.publish.csv_table import escape_formula, format_csv
from misstep.grading.publish.feedback_zip import feedback_name
from misstep.grading.publish.grades_csv import grades_table
from misstep.grading.publish.mathml import render_formula, render_markdown, render_sentence
from misstep.grading.publish.pages import feedback_page
from misstep.grading.publish.platform_exports import export
from misstep.grading.publish.report import histogram_bars, report_page
from misstep.grading.publish.shared_answers import find_matches, matches_table

EVIL = "</code></pre><script>document.title = 'owned'</script><img src=x onerror=\"document.title='owned'\">&amp;"

PNG = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="


def problem(number="03.1", points=3.0, state="right", **more):
    told = {
        "title": "Screw axes",
        "max": 3.0,
        "verdict": f"x Problem {number}\n  {points} of 3 points.",
        "statement": "Give $S_1$.",
        "mistakes": (),
    }
    return ProblemResult(number, points=points, state=state, **{**told, **more})


def result(student="ada", problems=None, **more):
    problems = problems or [problem("03.1"), problem("03.2", 1.5, "partly", mistakes=["omega x q"])]
    points, most = (sum(getattr(one, name) for one in problems) for name in ("points", "max"))
    return Result(
        student, "03_poe_space", points, most, **{"status": "graded", "reason": "", "problems": problems, **more}
    )


class Reader(HTMLParser):
    """Which elements a page has, with their attributes, and its letters."""

    def __init__(self, page):
        super().__init__()
        self.elements, self.letters = [], ""
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))

    def handle_data(self, data):
        self.letters += data


def output(text=None, **data):
    if text is not None:
        return {"output_type": "stream", "name": "stdout", "text": text}
    return {
        "output_type": "display_data",
        "metadata": {},
        "data": {kind.replace("_", "/"): v for kind, v in data.items()},
    }


@pytest.fixture
def hostile():
    """A result in which everything that a student can have a say in wants out of its place."""
    error = {"output_type": "error", "ename": EVIL, "evalue": EVIL, "traceback": [EVIL]}
    displays = [
        output(text_html=EVIL, text_plain=EVIL),
        output(image_png=EVIL),
        output(image_png='"' + PNG),
        output(EVIL),
    ]
    cells = [RanCell(EVIL, None, 0, [error, *displays]), RanCell(EVIL, 1, 1, [error, output(text_markdown=EVIL)])]
    odd = problem(
        verdict=f"x\n  {EVIL}\n  `{EVIL}`\n  ${EVIL}$\n  $\\href{{javascript:1}}{{x}}$", notes=[EVIL], mistakes=[EVIL]
    )
    return result(EVIL, [odd], reason=EVIL, notes=[EVIL], typed_id=EVIL, cells=cells)


ALLOWED = frozenset(
    re.findall(
        r"\w+",
        "html head meta title style body main h1 h2 h3 p table caption thead tbody tr th td a span article details summary "
        "pre code img strong math mrow mi mo mn svg rect text line",
    )
)


def test_nothing_that_a_student_wrote_is_more_than_letters(hostile):
    for page in (feedback_page(hostile), report_page([hostile], [])):
        told = Reader(page)
        policies = [a["content"] for _, a in told.elements if a.get("http-equiv")]
        assert policies == ["default-src 'none'; style-src 'unsafe-inline'; img-src data:"]
        assert {tag for tag, _ in told.elements} <= ALLOWED
        assert not any(name.startswith("on") for _, attributes in told.elements for name in attributes)
        links = [
            value for _, attributes in told.elements for name, value in attributes.items() if name in {"href", "src"}
        ]
        assert all(link.startswith(("#problem-", "data:image/png;base64,")) for link in links)
    assert EVIL in Reader(feedback_page(hostile)).letters


def test_a_browser_runs_nothing_of_it_and_asks_nobody(hostile, tmp_path):
    (tmp_path / "page.html").write_text(feedback_page(hostile), "utf-8")
    with browsers() as start, watched(start(webgl=False)) as page:
        page.goto((tmp_path / "page.html").as_uri())
        page.evaluate("document.querySelectorAll('details').forEach(part => part.open = true)")
        assert page.title().startswith("</code></pre><script>")
        for width in (1100, 400):
            page.set_viewport_size({"width": width, "height": 900})
            assert page.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth")


def test_feedback_says_points_verdicts_and_why_and_shows_no_right_answer():
    odd = problem(
        "03.2", 0.0, "wrong", verdict="✗ Problem\n  0 of 3 points.\n  You took $v = \\omega$.", right={"number": 7.25}
    )
    cells = [RanCell("print(1)", None, 0, [output("shown\n"), output(image_png=PNG, text_plain="<Figure>")])]
    page = feedback_page(result(problems=[problem(), odd], reason="The run stopped.", notes=["Odd."], cells=cells))
    letters = Reader(page).letters
    for words in ("3 of 6 points", "The run stopped.", "Odd.", "✗", "not yet", "You took", "print(1)", "shown"):
        assert words in letters
    assert "<math><mrow><mi>v</mi><mo>=</mo><mi>ω</mi></mrow></math>" in page
    assert f'<img alt="&lt;Figure&gt;" src="data:image/png;base64,{PNG}">' in page
    assert "7.25" not in page


def test_feedback_shows_the_problem_that_is_not_right_and_folds_those_that_are():
    figure = '<figure><img alt="An arm" src="data:image/svg+xml;base64,AA=="></figure>'
    statement = "Give $S_1$ of **this** arm.\n\n| a |\n| --- |\n| $$x$$ |"
    wrong = problem("03.2", 0.0, "wrong", statement=statement, figure=figure, title="A wrong one")
    right = problem("03.1", statement="Solved $y$.", title="A right one", notes=["Its check cell was edited."])
    page = feedback_page(result(problems=[right, wrong]))
    assert figure in page
    assert "<msub><mi>S</mi><mn>1</mn></msub></mrow></math> of <strong>this</strong> arm." in page
    assert '<math display="block"><mrow><mi>x</mi></mrow></math></td>' in page
    assert re.findall(r'<article class="(\w+)"', page) == ["wrong"]
    folded = page[page.index('<details class="solved">') :]
    assert "A right one" in folded
    assert "Its check cell was edited." in folded
    assert "Solved" not in page
    assert "look at again" not in feedback_page(result(problems=[right]))


def test_signs_and_brackets_are_set_as_in_a_book():
    for latex, html in [
        ("(-2, 3 - 1)", '<mo stretchy="false">(</mo><mo form="prefix">−</mo><mn>2</mn>'),
        (r"\tfrac{1}{2}", "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac>"),
        (r"\begin{pmatrix} 1 \end{pmatrix}", "<mo>(</mo><mtable>"),
    ]:
        assert html in render_formula(latex)
        assert render_formula(latex).count('form="prefix"') == latex.count("(-")


def test_a_statement_has_no_html_and_no_script():
    for text in ("<script>x</script>", "[x](javascript:x)", "<img src=x onerror=x>", "$\\href{javascript:x}{x}$"):
        told = Reader(str(render_markdown(text)))
        assert {tag for tag, _ in told.elements} <= {"p", "a", "math", "mrow", "mi"}
        assert not any("javascript" in value for _, attributes in told.elements for value in attributes.values())


def test_feedback_links_to_the_section_to_reread_and_to_nothing_that_a_student_wrote():
    address = "https://example.org/lectures/03_poe_space.html#the-product"
    reread = "Re-read: section “The product” of lecture 03, Product of exponentials (PoE), space frame."
    verdict = f"✗ Problem\n  1 1/3 of 3 points.\n  Got https://evil.example and {reread}\n  {reread}"
    wrong = problem(points=4 / 3, state="partly", verdict=verdict, address=address)
    pages = [Reader(feedback_page(result(problems=[replace(wrong, address=link)]))) for link in (address, "")]
    links = [[a["href"] for tag, a in page.elements if tag == "a" and a["href"][0] != "#"] for page in pages]
    assert links == [[address], []]
    assert all(page.letters.count(reread) == 2 and "1 1/3 of 3" in page.letters for page in pages)


def test_what_the_sheet_says_of_points_where_nobody_judges_is_left_out():
    tally, check = RanCell("sheet.tally()", None, 1, [output("SURROGATE")]), RanCell("x", 1, 0, [output("SURROGATE")])
    failed = RanCell(
        "sheet.check(1, x)", 1, 2, [{"output_type": "error", "ename": "E", "evalue": "e", "traceback": ["TRACE"]}]
    )
    page = feedback_page(result(cells=[check, tally, failed]))
    assert "SURROGATE" not in page
    assert "TRACE" in page


def test_what_was_graded_without_a_sandbox_says_so_everywhere():
    unsafe = result(is_safe=False)
    for text in (feedback_page(unsafe), report_page([unsafe], []), *grades_table([unsafe, unsafe]).splitlines()[1:]):
        assert "--unsafe-no-sandbox" in text
    assert "--unsafe-no-sandbox" not in feedback_page(result()) + report_page([result()], []) + grades_table([result()])


# --- formulas ---


def test_a_formula_becomes_mathematics_or_stays_as_typed():
    for latex in (
        *(r"\text{<script>x</script>}", r"\style{color:red}{x}", r"\href{javascript:x}{x}"),
        *("{", "^^", r"\left(", r"\frac{" * 400),
    ):
        told = Reader(str(render_formula(latex)))
        assert {tag for tag, _ in told.elements} <= {"code", "math", "mrow", "mi", "mo", "mtext", "mn"}
        assert not any(attributes for _, attributes in told.elements)


@given(st.text(alphabet="$`\\{}^_&<>abx1 \n'\"", max_size=40))
def test_any_sentence_is_mathematics_code_and_letters(text):
    told = Reader(str(render_sentence(text)))
    assert {tag for tag, _ in told.elements} <= {
        *("code", "math", "mrow", "mi", "mo", "mn", "msub", "msup", "msubsup", "mtext", "mspace"),
    }
    if "$" not in text and "`" not in text:
        assert told.letters == text


# --- mistakes across the problems ---


def with_mistakes(student, *made):
    """A student with the mistake of this name in each problem, or "" for none, where all of them can be made."""
    possible = sorted({*made, "degrees"} - {""})
    problems = [
        problem(f"03.{k}", possible=possible, explanations=[[[name]]] if name else [])
        for k, name in enumerate(made, start=1)
    ]
    return result(student, problems)


def test_mistakes_across_the_problems_are_on_the_page_of_feedback_and_counted_in_the_report():
    letters = Reader(feedback_page(with_mistakes("ada", "omega x q", "omega x q", "", "sign"))).letters
    assert "Returning mistake: “omega x q” explains answers in 2 of the 4 answered problems" in letters
    assert "Probably a slip: “sign” explains answers in 1 of the 4 answered problems" in letters
    assert "degrees" not in letters
    assert "Across the problems" not in feedback_page(result())
    class_ = [with_mistakes(student, "sign", "sign", "") for student in ("ada", "bob")]
    class_ += [with_mistakes("cyn", "sign", "", ""), with_mistakes("dan", "degrees", "", "")]
    cells = r'<tr><th scope="row">(.*)</th><td class="number">(\d+)</td><td class="number">(\d+)</td></tr>'
    assert re.findall(cells, report_page(class_, [])) == [("sign", "2", "1"), ("degrees", "0", "1")]
    assert "Mistakes across the problems" not in report_page([result()], [])


# --- report ---


def test_the_report_counts_and_draws_and_names_nobody():
    mistaken = problem("03.1", 0.0, "wrong", mistakes=["omega x q", "omega x q"])
    made = {"ada": problem(), "bob": mistaken, "cyn": mistaken, "dan": problem()}
    class_ = [result(student, [one]) for student, one in made.items()]
    told = Reader(report_page(class_, find_matches(class_)))
    assert not set(made) & set(re.findall(r"\w+", told.letters))
    assert [
        attributes["aria-label"] for tag, attributes in told.elements if "aria-label" in attributes and tag == "svg"
    ] == [
        f"Points of {what}: 0 points: 2; 1 points: 0; 2 points: 0; 3 points: 2"
        for what in ("the whole sheet", "problem 03.1")
    ]
    for words in ("omega x q (2)", "1.5 of 3 points", "2 right, 2 not yet right."):
        assert words in told.letters


@given(st.integers(1, 60), st.data())
def test_a_histogram_counts_everybody_once(most, data):
    values = data.draw(st.lists(st.floats(0, most), max_size=30))
    bars = histogram_bars(values, most)
    assert sum(bar.count for bar in bars) == len(values)
    assert len({bar.label for bar in bars}) == len(bars) <= 10


# --- matches ---


def answered(student, value, right, state="wrong"):
    one = problem("03.1", state=state, answer=value, right=right)
    return result(student, [one, replace(one, number="03.2")])


def array(*numbers):
    return {"array": list(numbers), "shape": [len(numbers)]}


def test_an_answer_that_is_right_for_another_is_listed_with_how_much_it_says():
    formula = {"text": "a*cos(q1)"}  # copied letter by letter
    class_ = [
        answered("ada", array(1, 2), array(1, 2), "right"),
        answered("bob", array(1, 2.0005), array(5, 6)),
        answered("cyn", array(1, 2, 0), array(7, 8)),
        answered("dan", {"text": "M"}, {"text": "e"}),
        answered("eve", {"text": "M"}, {"text": "M"}, "right"),
        answered("fay", {"text": "M"}, {"text": "M"}, "right"),
        answered("gil", None, array(1, 2), "blank"),
        answered("hal", formula, {"symbolic": "a*cos(q_1)"}, "right"),
        answered("ida", formula, {"symbolic": "b*cos(q_1)"}),
    ]
    found = find_matches(class_)
    wanted = [("bob", ("ada", "gil"), 2), ("dan", ("eve", "fay"), 2), ("ida", ("hal",), 2)]
    assert sorted((m.student, m.problem, tuple(m.others), m.shared_count) for m in found) == [
        (student, number, others, count) for student, others, count in wanted for number in ("03.1", "03.2")
    ]
    assert 'bob,03.1,"ada, gil",2,2' in matches_table(found).splitlines()


def test_what_cannot_be_compared_or_read_matches_nobody():
    """The judge found that it is no answer; it may be any JSON at all."""
    for data in ({"other": "x"}, {"function": "f", "outputs": [array(1)]}):
        assert find_matches([answered("ada", data, array(1)), answered("bob", array(2), data)]) == []
    for data in (7, False, "text", [1], {"array": 10**400, "shape": []}, {"map": {"a": 10**400}}):
        assert find_matches([answered("ada", array(1), array(1)), answered("bob", data, array(2), "unreadable")]) == []


# --- tables ---


@given(st.text(max_size=20) | st.text(alphabet="=+-@\t\r＝1 ", max_size=6))
@example("=cmd|' /C calc'!A0")
def test_a_cell_begins_as_no_formula_or_is_a_number(cell):
    told = escape_formula(cell)
    assert told.removeprefix("'") == cell.removeprefix("'")
    assert told[:1] not in {*"=+-@＝\t\r"} or told == "-" or float(told.replace(",", ".")) is not None


@given(st.lists(st.lists(st.text(alphabet='a",;\n ', max_size=5), min_size=2, max_size=2), max_size=4))
def test_a_table_reads_back_as_it_was(rows):
    assert list(csv.reader(io.StringIO(format_csv(["x", "y"], rows)))) == [
        ["x", "y"],
        *([escape_formula(cell) for cell in row] for row in rows),
    ]


def test_grades_hold_points_reasons_and_mistakes():
    unusual = result("=bob", reason="It stopped.", notes=["Odd."], typed_id="ada")
    rows = list(csv.DictReader(io.StringIO(grades_table([result(typed_id="ada"), unusual]))))
    assert rows[0] == {
        "student": "ada",
        "points": "4.5",
        "max": "6",
        "status": "graded",
        "03.1": "3",
        "03.2": "1.5",
        "reason": "",
        "mistakes": "03.2 omega x q",
        "id in the sheet": "ada",
        "run in": "sandbox",
        "by hand": "",
    }
    assert (rows[1]["student"], rows[1]["reason"]) == ("'=bob", "It stopped. | Odd. | The id 'ada' is in 2 sheets.")


# --- what platforms take ---


def exported(kind, header, rows, id_column, column=None):
    graded = [result("ada"), result("bob", [problem("03.1", 0.0), problem("03.2", 2 / 3)])]
    grade = header.index("Grade") if kind == "moodle" else None
    return export(Roster(kind, header, rows, header.index(id_column), 0, grade), graded, column)


def test_each_platform_takes_back_who_and_the_points_in_its_own_form():
    canvas = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Old (1)", "Sheet 03_poe_space (77)"]
    people = [
        ["=Lovelace, Ada", "1", "u1", "ada", "A", "7", ""],
        ["Boole, Bob", "2", "u2", "bob", "A", "", ""],
        ["Student, Test", "3", "", "", "A", "", ""],
    ]
    assert exported("canvas", canvas, people, "SIS Login ID") == (
        "Student,ID,SIS User ID,SIS Login ID,Section,Sheet 03_poe_space (77)\n"
        "    Points Possible,,,,,6\n"
        '"\'=Lovelace, Ada",1,u1,ada,A,4.5\n'
        '"Boole, Bob",2,u2,bob,A,0.67\n'
        '"Student, Test",3,,,A,\n'
    )
    named = exported("canvas", canvas, people, "SIS Login ID", "Sheet 3 (9)")
    assert named.startswith("Student,ID,SIS User ID,SIS Login ID,Section,Sheet 3 (9)\n")
    moodle = ["Identifier", "Full name", "ID number", "Grade", "Maximum Grade", "Last modified (grade)"]
    rows = [["Participant 1", "Ada", "ada", "", "100,00", "-"], ["Participant 3", "Cyn", "cyn", "", "100,00", "-"]]
    assert exported("moodle", moodle, rows, "ID number").splitlines()[1:] == [
        'Participant 1,Ada,ada,75,"100,00",-',  # out of its own maximum
        'Participant 3,Cyn,cyn,,"100,00",-',
    ]
    gradescope = ["First Name", "Last Name", "SID", "Email", "Sections", "Old", "Old - Max Points"]
    assert exported("gradescope", gradescope, [["Ada", "L", "ada", "a@b", "A", "1", "2"]], "SID") == (
        "First Name,Last Name,SID,Email,Sections,03_poe_space,03_poe_space - Max Points\nAda,L,ada,a@b,A,4.5,6\n"
    )
    assert exported("own", ["id"], [["ada"]], "id") is None


def test_a_page_that_goes_back_is_assigned_by_the_platform_to_its_student():
    """Moodle's importziplib.php splits the name at underscores; Canvas takes the first two numbers between them."""
    for top in ("Ada_B_1815_assignsubmission_file_", "Ada_B_1815_assignsubmission_file_any.ipynb"):
        name = feedback_name("moodle", PurePosixPath(top, "any.ipynb"), "03_poe_space")
        assert name.split("_", 4) == ["Ada B", "1815", "assignfeedback", "file", "03_poe_space.html"]
    for top in ("ada_LATE_1815_99_03_poe_space-1.ipynb", "ada_1815_99_x.ipynb"):
        parts = feedback_name("canvas", PurePosixPath(top), "03_poe_space").split("_")
        assert [int(part) for part in parts if part.isdecimal()][:2] == [1815, 99]
        assert not parts[-1].startswith("link")
    assert feedback_name("folder", PurePosixPath("ada/x.ipynb"), "03_poe_space") is None
