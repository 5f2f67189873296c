"""The home page, its metadata, and the configuration of an arm in the address of its page."""

import json
import re

import pytest
from browser import watched
from kinsite import demonstration

from kincourse import open_sheet


@pytest.fixture
def page(chromium):
    with watched(chromium, viewport={"width": 1200, "height": 900}) as page:
        yield page


def test_an_address_with_joint_values_opens_the_arm_in_this_configuration(page, site_address):
    read = "document.querySelector('.kv')?.viewer.model.get('q')"
    page.goto(f"{site_address}/robots/youbot.html#q=0.1,0.2,-0.3,0.4,0.5")
    page.wait_for_function(read)
    assert page.evaluate(read) == [0.1, 0.2, -0.3, 0.4, 0.5]
    page.evaluate("location.hash = '#q=1,1,1,1,1'")
    page.wait_for_function(f"{read}[0] === 1")
    page.evaluate("location.hash = '#q=1,2'")
    assert page.evaluate(read) == [1, 1, 1, 1, 1], "too few values change nothing"
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Copy a link to this configuration").click()
    page.get_by_role("button", name="Copied").wait_for()
    assert page.evaluate("navigator.clipboard.readText()") == f"{site_address}/robots/youbot.html#q=1,1,1,1,1"


def test_the_home_page_shows_the_card_of_each_wrong_answer_without_a_script(chromium, site_address):
    messages = {mistake.name: mistake.message for mistake in known_mistakes()}
    with watched(chromium, java_script_enabled=False) as page:
        page.goto(f"{site_address}/")
        answers = page.locator(".kinlib-answers details")
        assert answers.count() == len(demonstration.ATTEMPTS) == 4
        for answer, (code, mistake) in zip(answers.all(), demonstration.ATTEMPTS, strict=True):
            if answer.get_attribute("open") is None:
                answer.locator("summary").click()
            assert code in answer.inner_text()
            expected = messages[mistake].partition(". ")[2].partition("$")[0] if mistake else "2 of 2 points"
            assert expected in answer.inner_text()
            assert page.locator(".kinlib-answers details[open]").count() == 1


def known_mistakes():
    sheet = open_sheet(demonstration.SHEET, demonstration.STUDENT)
    return sheet.problem(demonstration.PROBLEM).known_mistakes


def test_the_home_page_describes_the_course_to_search_engines(site_folder):
    html = (site_folder / "index.html").read_text("utf-8")
    course = json.loads(re.search(r'<script type="application/ld\+json">(.*?)</script>', html, re.DOTALL)[1])
    assert course["@type"] == "Course"
    assert "Sitemap: http" in (site_folder / "robots.txt").read_text("utf-8")
