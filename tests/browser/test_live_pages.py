"""Pages whose Python runs in the browser: a sheet from the id to the points, the page Your robot, and what is said meanwhile."""

import csv
import re
import subprocess
import sys
from zipfile import ZIP_DEFLATED, ZipFile

import pytest
from accessibility import violations
from browser import PYTHON_TIMEOUT_MS, unwatched, watched
from built_site import ROOT, served
from mesh_files import crane, stl, visual
from playwright.sync_api import expect

import kinlib as kl
from kincourse import find_sheet, open_sheet
from kincourse.your_robot import KNOWN

STUDENT, SHEET = "ada", "07_frame_assignment"
LECTURE = "lectures/07_frame_assignment.html"
PHONE = {"width": 390, "height": 844}


def part(page, name):
    """Find a cell by its id."""
    return page.locator(f".kinlib-cell-{name}")


def press(which, name):
    """Press a button with the keyboard."""
    which.get_by_role("button", name=name, exact=False).first.press("Enter")


def agree(page):
    press(page, "Load Python and run")


def ended(which, text="Done."):
    expect(which.locator(".kinlib-live-note")).to_have_text(text, timeout=PYTHON_TIMEOUT_MS)


def run(which, text, key="Control+Enter"):
    """Write this in the place of the code of a cell, and run it. Returns the place of its output."""
    if not which.locator("textarea").count():
        press(which, "Edit")
    which.locator("textarea").fill(text)
    which.locator("textarea").press(key)
    return which.locator(".cell_output")


# --- a sheet ---


def test_a_sheet_is_answered_on_its_page_graded_with_its_points_and_opened_without_a_network(
    chromium_without_webgl, lab_address, site_folder, tmp_path
):
    """One visit by keyboard, because Python takes long to start; then the server ends."""
    errors = []
    with unwatched(chromium_without_webgl) as page:
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        with served(site_folder) as address:
            page.goto(f"{address}/sheets/{SHEET}.html")
            page.wait_for_function("navigator.serviceWorker.controller")
            covered_until_an_id_is_typed(page)
            answered(page)
            frames_are_judged_by_the_rules(page)
            folder = tmp_path / "submitted" / STUDENT
            downloaded(page, folder)
            assert violations(page) == []
            kept_beside_another_tab(page)
            assert not errors
        page.reload()
        still_there(page)
    assert_graded(folder)


def covered_until_an_id_is_typed(page):
    statement = part(page, "show-1")
    expect(statement).to_contain_text("type your id at the top")
    expect(statement.locator(".cell_output")).to_be_hidden()
    press(statement, "Look at an example")
    expect(statement).to_contain_text("not with yours")
    expect(statement.locator(".cell_output")).to_be_visible()
    expect(page.get_by_label("Your id")).to_have_value("")
    page.get_by_label("Your id").fill(STUDENT)
    press(page, "Show my numbers")
    agree(page)
    ended(statement)
    expect(statement.locator(".katex")).not_to_have_count(0)


def answered(page):
    right = open_sheet(SHEET, STUDENT).problem(1).answer.value.tolist()
    for lengths, title in ((right[::-1], "Not yet"), (right, "07.1: Right")):
        part(page, "answer-1").locator("textarea").fill(f"lengths_1 = {lengths}")
        press(part(page, "check-1"), "Check")
        card = part(page, "check-1").locator(".cell_output [role=status]")
        expect(card).to_contain_text(title, timeout=PYTHON_TIMEOUT_MS)
        if title == "Not yet":
            link = card.get_by_role("link", name="Re-read: section “")
            assert re.fullmatch(r"\.\./lectures/\w+\.html#[\w-]+", link.get_attribute("href"))


def frames_are_judged_by_the_rules(page):
    drawn = part(page, "hand-2")
    ended(part(page, "show-2"), "")  # the numbers of a problem appear when the student comes to it
    part(page, "show-2").scroll_into_view_if_needed()
    ended(part(page, "show-2"))
    press(drawn, "Run")
    ended(drawn)
    direction, check = drawn.locator("select").first, drawn.get_by_role("button", name="Check the rules")
    direction.focus()
    page.keyboard.press("ArrowDown")
    chosen = direction.input_value()
    check.press("Enter")
    expect(drawn.locator(".kv-verdict")).to_contain_text("Not complete yet", timeout=PYTHON_TIMEOUT_MS)
    assert direction.input_value() == chosen
    expect(check).to_be_focused()


def downloaded(page, folder):
    press(part(page, "tally"), "Run")
    points = f"{find_sheet(SHEET).problems[0].points} of {find_sheet(SHEET).points}"
    expect(part(page, "tally").locator(".cell_output")).to_contain_text(points, timeout=PYTHON_TIMEOUT_MS)
    with page.expect_download() as taken:
        press(page, "Download with my answers")
    taken.value.save_as(folder / taken.value.suggested_filename)


def kept_beside_another_tab(page):
    other = page.context.new_page()
    other.goto(page.url)
    part(other, "answer-3").locator("textarea").fill("table_3 = 3")
    expect(part(page, "answer-3").locator("textarea")).to_have_value("table_3 = 3")
    other.close()


def still_there(page):
    """The numbers come by themselves, and the card of an answer is there, until the answer changes or fails."""
    field = page.get_by_label("Your id")
    field.fill("grace")
    expect(part(page, "answer-3").locator("textarea")).to_have_value("table_3 = 3")
    answer, check = part(page, "answer-1"), part(page, "check-1")
    expect(answer.locator("textarea")).to_have_value(re.compile(r"^lengths_1 = \["))
    expect(page.locator(".kinlib-live-id")).to_contain_text(f"numbers of the id “{STUDENT}”", timeout=PYTHON_TIMEOUT_MS)
    expect(check.locator(".cell_output")).to_contain_text("07.1: Right")
    another_id_and_back(page, field, check.locator(".cell_output"))
    answer.locator("textarea").fill("lengths_1 = [")
    expect(check).to_contain_text("This card belongs to an answer that you have changed since")
    press(check, "Check")
    expect(answer.locator(".cell_output")).to_contain_text("SyntaxError", timeout=PYTHON_TIMEOUT_MS)
    expect(check.locator(".cell_output")).to_have_text("")
    press(check, "Check")
    ended(check, "Not checked, because your answer ended with an error. Mend it, and press Check again.")
    answer.get_by_label("Your answer to problem 1", exact=True).fill("")
    press(check, "Check")
    expect(check.locator(".cell_output")).to_contain_text("Nothing here yet")  # and not of the answer before
    answer.get_by_label("Your answer to problem 1", exact=True).fill("while True: pass")
    press(check, "Check")
    press(check, "Stop")
    expect(check.locator(".cell_output")).to_have_text("")


def another_id_and_back(page, field, card):
    """An id that was typed while Python loads stays; the card of another id goes, and comes back with it."""
    expect(field).to_have_value("grace")
    press(page, "Show my numbers")
    expect(card).to_have_text("")
    field.fill(STUDENT)
    press(page, "Show my numbers")
    expect(card).to_contain_text("07.1: Right")


def assert_graded(folder):
    """Grade the sheet in the folder of one student, and compare the points of its first problem."""
    out, points = folder.parents[1] / "results", str(find_sheet(SHEET).problems[0].points)
    command = (sys.executable, "-m", "misstep", "grade", folder.parent, "--sheet", SHEET[:2], "--out", out)
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    with (out / "grades.csv").open(encoding="utf-8") as file:
        [graded] = csv.DictReader(file)
    assert (graded["student"], graded["points"], graded["07.1"]) == (STUDENT, points, points)


# --- the page Your robot, which has a form and the cells of a lecture ---

TABLE = str(KNOWN["UR5e"][0])
CHANGED = "urdf-alone"
"""The cell that is changed, the fourth."""


def test_your_robot_is_examined_and_cells_are_run_changed_and_stopped(chromium_without_webgl, lab_address, tmp_path):
    """One visit, because Python takes long to start."""
    allowed = ["clipboard-read", "clipboard-write"]
    with watched(chromium_without_webgl, viewport=PHONE, permissions=allowed) as page:
        page.goto(f"{lab_address}/lectures/your_robot.html")
        a_wrong_sign_is_explained_and_corrected(page, tmp_path)
        a_zip_with_meshes_is_opened(page, tmp_path)
        runs_the_cells_above_first(page)
        shows_outputs_and_an_error_with_its_line(page)
        stops_a_cell_that_never_ends(page)
        press(part(page, "yr-answer"), "Edit")
        part(page, "yr-answer").locator("textarea").fill("answer = 1")
        page.reload()
        typed = page.get_by_role("textbox", name="Code of cell")
        assert [area.input_value() for area in typed.all()] == ["while True: pass", "answer = 1"]
        page.get_by_role("button", name="Reset cell 4").click()
        page.reload()
        assert [area.input_value() for area in typed.all()] == ["answer = 1"]
        the_form_is_kept_and_an_empty_check_hides_the_answer(page)


def a_wrong_sign_is_explained_and_corrected(page, folder):
    file = folder / "arm.urdf"
    file.write_text(kl.to_urdf(KNOWN["UR5e"][0].to_chain().changed(name="<b>arm</b>")), encoding="utf-8")
    answer, drawing = page.locator(".your-robot-result").all()
    expect(answer).to_be_hidden()
    page.get_by_label("A URDF file, or a zip archive with its meshes").set_input_files(file)
    expect(page.locator("form.your-robot")).to_contain_text("The answer names it.")
    page.get_by_label("A DH table").fill(TABLE.replace("-0.425", "0.425"))
    page.get_by_role("button", name="Check", exact=True).click()
    expect(page.locator(".kinlib-live-ask")).to_be_in_viewport()  # the page scrolls smoothly
    expect(answer).to_be_hidden()
    agree(page)
    expect(answer).to_contain_text("For the same q the tool differs by up to 0.85 m", timeout=PYTHON_TIMEOUT_MS)
    expect(answer).to_contain_text("Row 2: a has the wrong sign.")
    expect(answer.locator("tr", has_text="first wrong row")).to_contain_text("-0.425")
    expect(answer.locator("details[open] pre").first).to_contain_text("-0.425")
    expect(drawing.locator("[data-kinlib-viewer]")).to_have_count(1, timeout=PYTHON_TIMEOUT_MS)
    page.get_by_role("button", name="Start with the robot of the form").click()
    problem = part(page, "yr-practise").locator(".cell_output")
    expect(problem).to_contain_text("points)", timeout=PYTHON_TIMEOUT_MS)


def a_zip_with_meshes_is_opened(page, folder):
    answer, drawing = page.locator(".your-robot-result").all()
    choose = page.get_by_label("A URDF file, or a zip archive with its meshes").set_input_files
    choose({"name": "broken.zip", "mimeType": "", "buffer": b"no archive"})
    expect(page.get_by_label("The text of a URDF file")).to_have_value("")  # and not the robot before it
    mesh = "package://crane_description/meshes/arm.stl"
    with ZipFile(folder / "robot.zip", "w", ZIP_DEFLATED) as files:
        files.writestr("crane-main/urdf/crane.urdf", crane(visual(mesh), '<drake:name value="not declared"/>'))
        files.writestr("crane-main/meshes/arm.stl", stl())
    choose(folder / "robot.zip")
    expect(page.locator("form.your-robot")).to_contain_text("1 of 1 meshes were found.")
    page.get_by_label("A DH table").fill("no table")
    page.get_by_role("button", name="Check", exact=True).click()
    expect(answer).to_contain_text("No table was found", timeout=PYTHON_TIMEOUT_MS)
    expect(answer.locator(".kinlib-live-note")).to_have_text("Not compared.")
    expect(answer).not_to_contain_text("0.85 m")
    page.get_by_label("A DH table").fill("")
    page.get_by_role("button", name="Check", exact=True).click()
    expect(answer).to_contain_text("crane: 1 joint.", timeout=PYTHON_TIMEOUT_MS)
    expect(drawing.locator("[data-kinlib-viewer]")).to_have_count(1, timeout=PYTHON_TIMEOUT_MS)
    expect(drawing).not_to_contain_text("not shown")


def the_form_is_kept_and_an_empty_check_hides_the_answer(page):
    arm, table = page.locator("[name=arm]"), page.get_by_label("A DH table")
    page.get_by_label("Convention").select_option("modified")
    page.get_by_role("button", name="Example").click()
    page.reload()
    expect(arm).to_have_value("UR5e")
    expect(table).to_have_value(re.compile("Joint 6"))
    expect(page.get_by_label("Convention")).to_have_value("")  # the text of the example says no more than another one
    arm.select_option("")
    page.get_by_label("The text of a URDF file").fill("")
    table.fill("")
    page.locator(".your-robot-result").first.evaluate("(section) => { section.hidden = false; }")
    page.get_by_role("button", name="Check", exact=True).click()
    expect(page.locator(".your-robot-result").first).to_be_hidden()


def runs_the_cells_above_first(page):
    """Shift+Enter goes on to the next cell."""
    changed = part(page, CHANGED)
    run(changed, 'from kincourse import ask\nask("03/recall-2")', "Shift+Enter")
    expect(page.get_by_role("button", name="Run cell 5")).to_be_focused()
    ended(changed)
    ended(part(page, "picture"))
    changed.get_by_role("button", name="A", exact=False).first.click()
    expect(changed.get_by_text(re.compile(r"A is (not correct|correct)"))).to_be_visible()
    expect(changed.locator(".kinlib-reply .katex")).not_to_have_count(0)


def shows_outputs_and_an_error_with_its_line(page):
    changed = part(page, CHANGED)
    output = run(changed, "from IPython.display import Markdown\nMarkdown('Where $x$, there $y$ is.')")
    expect(output.locator(".together")).to_have_text(re.compile(r"x,$"), timeout=PYTHON_TIMEOUT_MS)
    run(changed, "print('before')\nfound.picture().nothing")
    ended(changed, "Ended with an error.")
    expect(output.locator(".stream")).to_have_text("before\n")
    expect(output.locator(".kinlib-live-error p")).to_have_text("✗ AttributeError in line 2 of this cell")


def stops_a_cell_that_never_ends(page):
    changed = part(page, CHANGED)
    run(changed, "while True: pass")
    press(changed, "Copy")
    expect(changed.get_by_role("button", name="Copied")).to_be_visible()
    assert page.evaluate("navigator.clipboard.readText()") == "while True: pass"  # and not the code as it was printed
    ended(changed, "Running.")
    press(changed, "Stop")
    expect(changed.locator(".kinlib-live-note")).to_contain_text("All variables are lost")
    expect(changed.get_by_role("button", name="Run cell 4")).to_have_text("Run")


# --- without Python ---


def test_nothing_is_loaded_until_the_reader_agrees_and_the_page_says_what_it_loads_or_why_it_cannot(
    chromium_without_webgl, lab_address
):
    asked, wait = [], "kinlib-live-status"
    with unwatched(chromium_without_webgl, service_workers="block") as page:
        page.clock.install()
        page.on("request", lambda request: asked.append(request.url))
        page.goto(f"{lab_address}/{LECTURE}")
        page.locator(".misstep-question .kinlib-choice").first.click()
        placed = part(page, "blanks-4")
        placed.scroll_into_view_if_needed()
        press(placed, "Check the rules")
        expect(placed.locator(".kv-verdict")).to_have_text("Waiting for Python …")
        size = re.compile(r"loads Python: \d+ MB, once")
        expect(page.get_by_role("group", name="Load Python?")).to_contain_text(size)
        press(page, "Not now")
        assert not [url for url in asked if "/lab/" in url]
        page.route("**/live/load.json", lambda route: route.abort())
        first = part(page, "blanks")
        press(first, "Run")
        agree(page)
        ended(first, "Python could not start.")
        expect(page.locator(f".{wait}")).to_contain_text("Check the connection, then press Run again.")
        page.unroute("**/live/load.json")
        page.route("**/live/worker.js", lambda route: route.fulfill(
            content_type="text/javascript",
            body="postMessage({ kind: 'bytes', received: 12.9e6, total: 37.2e6 });",
        ))  # fmt: skip
        press(first, "Run")
        expect(page.locator(f".{wait}")).to_have_text("Python is loading 12 of 38 MB")
        assert float(page.locator(f".{wait} progress").get_attribute("value")) == pytest.approx(12.9 / 37.2)
        page.clock.run_for(20_000)
        expect(page.locator(f".{wait}")).to_contain_text("No data has arrived for 20 seconds.")
