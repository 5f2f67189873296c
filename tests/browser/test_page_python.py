"""Widgets and sheets on their pages, with the Python of the page: by keyboard alone, and graded as the page says."""

import csv
import subprocess
import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

import numpy as np
import pytest
from browser import unwatched, watched
from built_site import ROOT
from lab_page import PYTHON_TIMEOUT_MS
from playwright.sync_api import expect

from kincourse import find_sheet, open_sheet

STUDENT, SHEET = "ada", "03_poe_space"


@pytest.fixture(scope="module")
def pages(site_folder, site_address):
    """The address of the site, whose pages can run Python."""
    if not (site_folder / "lab").exists():
        pytest.skip("NO LAB WAS BUILT: its files could not be downloaded.")
    return site_address


def press(page, element, key="Enter"):
    element.focus()
    page.keyboard.press(key)


def test_frames_that_are_placed_by_keyboard_are_judged_by_the_rules_on_the_page(chromium, pages):
    with watched(chromium) as page:
        page.goto(f"{pages}/lectures/07_frame_assignment.html")
        page.locator("div.cell", has_text="assign(").first.scroll_into_view_if_needed()
        check = page.get_by_role("button", name="Check the rules").first
        panel = page.locator(".kv-assign").first
        direction = panel.locator("select").first
        direction.focus()
        page.keyboard.press("ArrowDown")
        chosen = direction.input_value()
        press(page, check)
        expect(panel.locator(".kv-verdict")).to_have_text("Waiting for Python …")
        press(page, page.get_by_role("button", name="Load Python and run"))
        expect(panel.locator(".kv-verdict")).to_contain_text("Not complete yet", timeout=2 * PYTHON_TIMEOUT_MS)
        assert direction.input_value() == chosen
        expect(check).to_be_focused()


class QuietHandler(SimpleHTTPRequestHandler):
    def log_message(self, *arguments):
        pass


def test_a_sheet_is_answered_on_its_page_graded_with_its_points_and_opened_without_a_network(
    chromium_without_webgl, pages, site_folder, tmp_path
):
    """One visit by keyboard, because Python takes long to start; then the server ends."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(QuietHandler, directory=str(site_folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    errors = []
    with unwatched(chromium_without_webgl) as page:
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        page.goto(f"http://127.0.0.1:{server.server_address[1]}/sheets/{SHEET}.html")
        page.wait_for_function("navigator.serviceWorker.controller")
        page.get_by_label("Your id").fill(STUDENT)
        show = page.get_by_role("button", name="Show my numbers")
        press(page, show)
        press(page, page.get_by_role("button", name="Load Python and run"))
        statement, answer, check, tally = (
            page.locator(f".kinlib-cell-{name}") for name in ("show-1", "answer-1", "check-1", "tally")
        )
        expect(statement.locator(".kinlib-live-note")).to_have_text("Done.", timeout=PYTHON_TIMEOUT_MS)
        expect(statement.locator("td .katex")).not_to_have_count(0)
        last = page.locator("[class*=kinlib-cell-show-] .kinlib-live-note").last
        expect(last).to_have_text("")  # its numbers appear when the student comes to it
        right = np.array(open_sheet(SHEET, STUDENT).problem(1).answer.value)
        for screws, title in ((-right, "Not yet"), (right, "03.1: Right")):
            answer.locator("textarea").fill(f"screws_1 = np.array({screws.tolist()})")
            press(page, check.get_by_role("button", name="Check"))
            expect(check.locator(".cell_output [role=status]")).to_contain_text(title, timeout=PYTHON_TIMEOUT_MS)
        last.scroll_into_view_if_needed()
        expect(last).to_have_text("Done.", timeout=PYTHON_TIMEOUT_MS)
        press(page, tally.get_by_role("button", name="Run"))
        expect(tally.locator(".cell_output")).to_contain_text(
            f"2 of {find_sheet(SHEET).points}", timeout=PYTHON_TIMEOUT_MS
        )
        with page.expect_download() as taken:
            press(page, page.get_by_role("button", name="Download with my answers"))
        folder = tmp_path / "submitted" / STUDENT
        taken.value.save_as(folder / taken.value.suggested_filename)
        assert not errors
        server.shutdown()
        server.server_close()
        page.reload()
        field = page.get_by_label("Your id")
        field.fill("grace")
        assert "screws_1 = np.array" in answer.locator("textarea").input_value()
        # the numbers of the id come by themselves, and the card of the answer is there, until the answer changes or fails
        expect(page.locator(".kinlib-live-id")).to_contain_text(
            f"numbers of the id “{STUDENT}”", timeout=PYTHON_TIMEOUT_MS
        )
        card = check.locator(".cell_output")
        expect(card).to_contain_text("03.1: Right")
        another_id_and_back(page, field, show, card)
        answer.locator("textarea").fill("screws_1 = [")
        expect(check).to_contain_text("This card belongs to an answer that you have changed since")
        press(page, check.get_by_role("button", name="Check"))
        expect(answer.locator(".cell_output")).to_contain_text("SyntaxError", timeout=PYTHON_TIMEOUT_MS)
        expect(card).to_have_text("")
    assert_graded(folder, "2")


def another_id_and_back(page, field, show, card):
    """An id that was typed while Python loads stays; the card of another id goes, and comes back with it."""
    assert field.input_value() == "grace"
    press(page, show)
    expect(card).to_have_text("")
    field.fill(STUDENT)
    press(page, show)
    expect(card).to_contain_text("03.1: Right")


def test_a_problem_is_covered_until_it_has_the_numbers_of_an_id(chromium_without_webgl, pages):
    with watched(chromium_without_webgl) as page:
        page.goto(f"{pages}/sheets/{SHEET}.html")
        covered = page.locator(".kinlib-cell-show-1")
        expect(covered).to_contain_text("type your id at the top")
        expect(covered.locator(".cell_output")).to_be_hidden()
        covered.get_by_role("button", name="Look at an example").click()
        expect(covered).to_contain_text("not with yours")
        expect(covered.locator(".cell_output")).to_be_visible()


def assert_graded(folder, points):
    """Grade the sheet in the folder of one student, and compare the points of its first problem."""
    out = folder.parents[1] / "results"
    command = (sys.executable, "-m", "misstep", "grade", folder.parent, "--sheet", SHEET[:2], "--out", out)
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    with (out / "grades.csv").open(encoding="utf-8") as file:
        [graded] = csv.DictReader(file)
    assert (graded["student"], graded["points"], graded["03.1"]) == (STUDENT, points, points)
