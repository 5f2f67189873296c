"""Single things have addresses: questions, formulas, mistakes, figures, and the configuration of an arm; frames; the home page."""

import json
import re
import tomllib

import pytest
from browser import watched
from built_site import SITE
from kinsite import demonstration, embeds
from kinsite.html_tree import read_html

from kincourse import find_question, open_sheet


@pytest.fixture
def page(chromium):
    with watched(chromium, viewport={"width": 1200, "height": 900}) as page:
        yield page


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("lectures/03_poe_space.html#question-03-recall-2", "question"),
        ("lectures/03_poe_space.html#formula-6", "formula (6)"),
        ("mistakes/03_poe_space.html#mistake-03-2-halves-swapped", "mistake"),
        ("lectures/03_poe_space.html#figure-the-chain", "figure"),
        ("lectures/03_poe_space.html#figure-helical-observe-2", "figure"),
        ("robots/youbot.html#figure", "figure"),
    ],
)
def test_a_single_thing_has_an_address_and_a_link_that_is_reached_with_the_keyboard(page, site_address, name, kind):
    page.goto(f"{site_address}/{name}")
    target = name.partition("#")[2]
    assert page.locator(f"[id='{target}']").count() == 1
    link = page.locator(f"a.kinlib-permalink[href='#{target}']")
    assert link.get_attribute("aria-label") == f"Link to this {kind}"
    link.focus()
    page.keyboard.press("Enter")
    assert page.url.endswith(f"#{target}")


def test_a_page_scrolls_at_once_if_reduced_motion_is_preferred(page, site_address):
    page.goto(f"{site_address}/lectures/03_poe_space.html")
    behaviour = "getComputedStyle(document.documentElement).scrollBehavior"
    found = [page.evaluate(behaviour)]
    page.emulate_media(reduced_motion="reduce")
    assert [*found, page.evaluate(behaviour)] == ["smooth", "auto"]


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


# --- frames on other pages ---


LISTENER = """addEventListener('message', ({ source, data }) => {
  for (const frame of document.querySelectorAll('iframe'))
    if (frame.contentWindow === source && data.kinlibHeight) frame.style.height = `${data.kinlibHeight}px`;
});"""
"""The script that site/instructors.md offers, so that a frame fits its content."""


def copied_frame(page, thing):
    """Press "Embed" below a thing, and return the HTML that is copied."""
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.locator(thing).get_by_role("button", name="Embed").click()
    page.get_by_role("button", name="Copied").wait_for()
    return page.evaluate("navigator.clipboard.readText()")


def test_a_question_can_be_answered_in_a_frame_on_another_page_which_fits_it(chromium_without_webgl, site_address):
    with watched(chromium_without_webgl) as page:
        page.goto(f"{site_address}/lectures/03_poe_space.html")
        html = copied_frame(page, "#question-03-recall-2")
        assert '" title="The product of exponentials in the space frame - Forward kinematics" width="100%"' in html
        body = f"<!doctype html><title>My course</title><script>{LISTENER}</script>{html}"
        page.route("**/my-course.html", lambda route: route.fulfill(content_type="text/html", body=body))
        page.goto(f"{site_address}/my-course.html")
        frame, height = page.frame_locator("iframe"), "document.querySelector('iframe').offsetHeight"
        page.wait_for_function("document.querySelector('iframe').style.height")
        before = page.evaluate(height)
        wrong = (find_question("03/recall-2").right + 1) % 3
        frame.locator(".kinlib-choice").nth(wrong).click()
        frame.get_by_text(f"{'ABC'[wrong]} is not correct").wait_for()
        page.wait_for_function(f"{height} > {before} + 50")
        back = frame.get_by_role("link", name="The product of exponentials in the space frame")
        assert back.evaluate("link => link.href") == f"{site_address}/lectures/03_poe_space.html#question-03-recall-2"
        assert back.evaluate("() => document.querySelector('base').target") == "_blank"


def test_the_frame_of_a_prediction_has_its_picture_and_its_explanation(site_folder):
    html = (site_folder / "embed/lectures/03_poe_space/question-03-order.html").read_text("utf-8")
    assert re.findall(r'data-(\S+)="03/order"', html) == ["misstep-question", "kinlib-after", "misstep-explain"]


def test_an_arm_is_embedded_in_its_present_configuration(page, site_address):
    page.goto(f"{site_address}/robots/youbot.html#q=0.1,0.2,-0.3,0.4,0.5")
    page.wait_for_function("document.querySelector('.kv')?.viewer.model.get('q')")
    address = re.search(r'src="([^"]+)"', copied_frame(page, "article"))[1]
    assert address == f"{site_address}/embed/robots/youbot/figure.html#q=0.1,0.2,-0.3,0.4,0.5"
    page.goto(address)
    page.wait_for_function("document.querySelector('.kv')?.viewer.model.get('q')[1] === 0.2")


def test_a_viewer_that_waits_for_a_question_is_uncovered_in_a_frame_of_its_own(page, site_address):
    page.goto(f"{site_address}/embed/lectures/03_poe_space/figure-helical-observe-2.html")
    page.wait_for_function("document.querySelector('.kv')?.viewer.model.get('covered') === false")


def test_every_page_for_a_frame_is_complete_and_leads_back_to_its_section(site_folder):
    paths = sorted((site_folder / "embed").rglob("*.html"))
    assert len([path for path in paths if path.name.startswith("question-")]) > 100
    assert {path.parent.name for path in paths if path.name == "figure.html"} >= {"youbot", "puma560", "bennett"}
    faults = []
    for path in paths:
        text = path.read_text("utf-8")
        base = (path.parent / re.search(r'<base href="([^"]+)"', text)[1]).resolve()
        fragment = re.search(r'From <a href="\w+\.html#([^"]+)"', text)[1]
        if f'id="{fragment}"' not in base.read_text("utf-8"):
            faults.append(f"{base.name} has no #{fragment}")
        files = re.findall(r'(?:src|href)="((?:\.\./)*_[^"#?]+)', text)
        faults += [f"{path.name}: {name} is missing" for name in files if not (base.parent / name).exists()]
    assert not faults, faults[:5]


def test_what_is_removed_from_a_page_is_removed_from_its_frames(tmp_path):
    question, figure = '<div data-misstep-question="05/a"><p>Why?</p></div>', "<div data-kinlib-viewer></div>"
    taken = set()
    htmls = [read_html(html) for html in (question, figure, figure)]
    outputs = [(html, embeds.add_address(html, "row", "lectures/05", taken)) for html in htmls]
    assert [anchor for _, anchor in outputs] == ["question-05-a", "figure-row", "figure-row-2"]
    embeds.write_pages(tmp_path, "lectures/05", "Title", outputs)
    embeds.write_pages(tmp_path, "lectures/05", "Title", outputs[:2])
    assert {path.stem for path in tmp_path.rglob("*.html")} == {"question-05-a", "figure-row"}


def test_the_guide_offers_the_script_that_fits_a_frame():
    assert "".join(LISTENER.split()) in "".join((SITE / "instructors.md").read_text("utf-8").split())


# --- the home page and its metadata ---


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
            expected = messages[mistake].partition(". ")[2].partition("$")[0] if mistake else "3 of 3 points"
            assert expected in answer.inner_text()
            assert page.locator(".kinlib-answers details[open]").count() == 1


def known_mistakes():
    sheet = open_sheet(demonstration.SHEET, demonstration.STUDENT)
    return sheet.problem(demonstration.PROBLEM).known_mistakes


def test_an_answer_that_is_another_mistake_fails_the_build():
    sheet = open_sheet(demonstration.SHEET, demonstration.STUDENT)
    with pytest.raises(ValueError, match="must be the mistake 'omega x p'; the sheet names"):
        demonstration.answer_html(sheet, "np.concatenate([axis, point])", "omega x p", first=False)


def test_the_home_page_describes_the_course_to_search_engines(site_folder):
    html = (site_folder / "index.html").read_text("utf-8")
    course = json.loads(re.search(r'<script type="application/ld\+json">(.*?)</script>', html, re.DOTALL)[1])
    assert course["@type"] == "Course"
    assert "Sitemap: http" in (site_folder / "robots.txt").read_text("utf-8")


def test_the_metadata_of_every_notebook_s_page_is_valid(site_folder):
    pages = [path for folder in ("lectures", "sheets") for path in (site_folder / folder).glob("[01]*.html")]
    found = [re.search(r'ld\+json">(.*?)</script>', path.read_text("utf-8"), re.DOTALL)[1] for path in pages]
    described = [json.loads(text) for text in found]
    assert {item["learningResourceType"] for item in described} == {"lecture", "exercise"}
    assert len({item["url"] for item in described}) == len(pages) > 20


def test_without_a_repository_no_page_links_to_one(site_folder):
    settings = tomllib.loads((SITE / "settings.toml").read_text("utf-8"))
    html = (site_folder / "index.html").read_text("utf-8")
    assert "Cite, licences and reuse" in html
    assert ("Report a fault" in html) == bool(settings["repository"])
    lecture = (site_folder / "lectures" / "03_poe_space.html").read_text("utf-8")
    assert ("colab.research" in lecture) == settings["repository"].startswith("https://github.com/")
