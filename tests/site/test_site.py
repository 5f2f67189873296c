"""The course site: it builds without a warning, and every page opens in a real browser without a fault, a stranger or a burden."""

import doctest
import gzip
import json
import os
import re
import subprocess
import sys
from contextlib import contextmanager
from functools import cache
from urllib.parse import unquote, urlsplit

import pytest
from browser import browsers, watched
from built_site import ROOT, SITE, build_site, served
from kinsite import STRICT, cell_outputs, execute, gallery, mistakes, reference, sphinx_source

KB = 1000
TEXT, LECTURE = 200 * KB, 450 * KB
"""What a page may weigh with all that it fetches, compressed, besides the viewer's bundle."""

KINDS = {
    "front": "index.html",
    "lecture": "lectures/03_poe_space.html",
    "sheet": "sheets/03_poe_space.html",
    "gallery": "robots/index.html",
    "arm": "robots/puma560.html",
    "linkage": "robots/four_bar.html",
    "mistakes": "mistakes/03_poe_space.html",
    "reference": "reference/kinlib.chains.chain.html",
    "glossary": "glossary.html",
    "notation": "notation.html",
    "errata": "lectures/errata.html",
    "instructors": "instructors.html",
    "progress": "progress.html",
    "performance": "performance.html",
    "search": "search.html?q=screw",
    "missing": "no/such/page.html",
    "phone": "lectures/00_start_here.html",
}

PHONE = {"width": 360, "height": 780}
SIDEWAYS = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


@pytest.fixture(scope="module")
def built():
    """The folder of pages. Its notebooks run only if they or kinlib have changed since the last build."""
    return build_site()


@pytest.fixture(scope="module")
def address(built):
    with served(built) as address:
        yield address


@pytest.fixture(scope="module")
def start():
    with browsers() as start:
        yield start


@pytest.fixture(scope="module")
def chromium(start):
    return start()


@pytest.fixture(scope="module")
def flat(start):
    """A browser that draws no WebGL: a hundred arms would take it minutes without a graphics card."""
    return start(webgl=False)


@pytest.fixture
def page(chromium):
    with watched(chromium, viewport={"width": 1200, "height": 900}) as page:
        yield page


@pytest.fixture(scope="module")
def pages(built):
    return sorted(
        path.relative_to(built).as_posix() for path in built.rglob("*.html") if not {"_static", "lab"} & set(path.parts)
    )


# --- every page ---


def test_every_page_opens_without_a_fault_and_every_link_leads_somewhere(flat, address, built, pages):
    """One browser opens them all; `watched` fails at the first word on a console and the first request to a stranger."""
    assert len(pages) > 60
    broken = []
    with watched(flat, viewport=PHONE) as page:
        for name in pages:
            answer = page.goto(f"{address}/{name}")
            assert answer.status == 200
            links = page.eval_on_selector_all(
                "a[href], link[href], img[src], script[src]", "found => found.map(e => e.href || e.src)"
            )
            for link in links:
                where = urlsplit(link)
                if f"{where.scheme}://{where.netloc}" == address:
                    broken += faults_of_link(built, name, where)
            if (wide := page.evaluate(SIDEWAYS)) > 0:
                broken.append(f"{name} is {wide} pixels wider than a phone")
    assert not broken, broken[:5]


def faults_of_link(built, name, where):
    """Why a link within the site leads nowhere, if it does."""
    target = built / unquote(where.path).lstrip("/")
    target = target / "index.html" if target.is_dir() else target
    if not target.exists():
        yield f"{name} names {where.path}, which is not there"
    elif where.fragment and target.suffix == ".html" and unquote(where.fragment) not in anchors(target):
        yield f"{name} names {where.path}#{where.fragment}, which the page lacks"


@cache
def anchors(path):
    return set(re.findall(r'\bid="([^"]+)"', path.read_text("utf-8")))


def test_every_page_says_what_it_is(built, pages):
    """A title and a description of its own, a language, one main heading, an icon, a picture for those who share it."""
    titles = {}
    for name in pages:
        text = (built / name).read_text("utf-8")
        assert text.count("<h1") == 1, f"{name} has {text.count('<h1')} main headings"
        for part in ('lang="en"', 'icon" href=', 'name="viewport"'):
            assert part in text, f"{name} lacks {part}"
        assert "noindex" not in text, f"{name} hides from search engines"
        for part in ('name="description"', 'property="og:image"'):
            assert part in text or name in ("404.html", "search.html"), f"{name} lacks {part}"
        titles.setdefault(re.search(r"<title>(.*?)</title>", text)[1], []).append(name)
    # A lecture and its sheet are titled differently, and so is everything else
    assert not {title: names for title, names in titles.items() if len(names) > 1}


def test_nothing_of_a_page_weighs_too_much(built, pages):
    """Counted without a browser: the page and every file that it names, each compressed."""
    heavy = {}
    for name in pages:
        text = (built / name).read_text("utf-8")
        eager = re.sub(r'<img loading="lazy"[^>]*>', "", text)
        named = set(re.findall(r'(?:src|href)="([^"#?]+\.(?:css|js|svg|png))(?:\?[^"]*)?"', eager))
        base = built if name == "404.html" else (built / name).parent  # the one page that names all from the top
        files = {(base / found.lstrip("/")).resolve() for found in named if "//" not in found}
        fonts = {built / "_static/katex/fonts" / f"KaTeX_{font}-Regular.woff2" for font in ("Main", "Size1", "Size2")}
        fonts |= {built / "_static/katex/fonts/KaTeX_Math-Italic.woff2"} if "katex" in text else set()
        weight = sum(compressed(path) for path in {built / name, *files, *fonts} if path.name != "viewer.js")
        if weight > (LECTURE if name.startswith("lectures/") else TEXT):
            heavy[name] = weight
    assert not heavy


def compressed(path):
    data = path.read_bytes()
    return len(data) if path.suffix in (".woff2", ".png") else len(gzip.compress(data, 6))


# --- each kind of page, as people meet it ---


@pytest.mark.parametrize("kind", KINDS)
def test_axe_finds_nothing_in_light_and_in_dark(chromium, address, kind):
    axe = (SITE / "node_modules" / "axe-core" / "axe.min.js").read_text("utf-8")
    size = PHONE if kind == "phone" else {"width": 1200, "height": 900}
    opened = unwatched if kind == "missing" else watched
    with opened(chromium, viewport=size) as page:
        page.goto(f"{address}/{KINDS[kind]}")
        page.wait_for_load_state("networkidle")
        page.evaluate(axe)
        for theme in ("light", "dark"):
            page.emulate_media(color_scheme=theme)
            page.wait_for_timeout(300)  # colours fade from one theme to the other
            found = page.evaluate("axe.run(document, { resultTypes: ['violations'] })")["violations"]
            told = [(fault["id"], node["html"][:200]) for fault in found for node in fault["nodes"]]
            assert not told, f"{theme}: {json.dumps(told[:4], indent=1)}"
        assert page.evaluate(SIDEWAYS) <= 0, "the page is wider than the window"


@contextmanager
def unwatched(browser, **settings):
    """A page that is not there is a fault on the console, as it should be."""
    context = browser.new_context(**settings)
    yield context.new_page()
    context.close()


# --- questions, sliders and what is remembered ---

RECALL = '[data-misstep-question="03/recall-2"]'
ORDER = '[data-misstep-question="03/order"]'


def test_a_question_explains_the_choice_and_the_first_one_stands(page, address):
    page.goto(f"{address}/lectures/03_poe_space.html")
    page.locator(f"{RECALL} button").nth(0).click()
    reply = page.locator(f"{RECALL} .kinlib-reply")
    assert "A is not correct" in reply.inner_text()
    assert "A twist does not know which point you call the tool" in reply.inner_text()
    assert "The correct answer is C: The velocity of the point of the body" in reply.inner_text()
    page.locator(f"{RECALL} button").nth(2).dispatch_event("click")
    assert "A is not correct" in reply.inner_text()


def test_a_prediction_uncovers_the_arm_and_is_compared_below(page, address):
    """Before it, neither the arm is there nor its explanation; afterwards both are, and a reload remembers."""
    page.goto(f"{address}/lectures/03_poe_space.html")
    waiting = page.locator('[data-kinlib-after="03/order"]')
    told = page.locator('[data-misstep-explain="03/order"]')
    waiting.scroll_into_view_if_needed()
    waiting.locator(".kv-cover").wait_for()
    assert not told.get_by_text("You moved joint 1 first").is_visible()
    page.locator(f"{ORDER} button").nth(0).focus()
    page.keyboard.press("Enter")
    waiting.locator(".kv-canvas").wait_for(state="visible")
    assert "A is not correct" in told.inner_text()
    assert "You moved joint 1 first" in told.inner_text()
    assert "moved joint 1 first" not in page.locator(ORDER).inner_text()
    page.reload()
    waiting.scroll_into_view_if_needed()
    waiting.locator(".kv-canvas").wait_for(state="visible")
    assert "A is not correct" in page.locator('[data-misstep-explain="03/order"]').inner_text()


def test_a_slider_shows_its_pictures_once_the_prediction_is_made(page, address):
    page.goto(f"{address}/lectures/04_poe_body.html")
    slides = page.locator('[data-kinlib-slides][data-kinlib-after="04/joint-1"]')
    assert slides.locator("img:visible").count() == 0
    page.locator('[data-misstep-question="04/joint-1"] button').nth(1).click()
    seen = []
    for k in (0, 6):
        slides.locator("input").fill(str(k))
        shown = slides.locator("img:visible")
        shown.scroll_into_view_if_needed()
        assert shown.count() == 1
        page.wait_for_function("image => image.complete && image.naturalWidth > 0", arg=shown.element_handle())
        seen.append(shown.get_attribute("src"))
    assert seen[0] != seen[1]
    assert slides.locator("output").inner_text() == "90"


def test_progress_is_shown_saved_forgotten_and_read_back(page, address, tmp_path):
    page.goto(f"{address}/lectures/03_poe_space.html")
    page.locator(f"{RECALL} button").nth(2).click()
    page.get_by_role("button", name="Mark this lecture as read").click()
    page.goto(f"{address}/progress.html")
    row = page.locator('tr[data-lecture="lectures/03_poe_space"]')
    told = ["✓ read", re.compile(r"^1 of \d+$"), "1", "0 of 8"]
    assert_cells(row, told)
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save a copy").click()
    copy = tmp_path / "copy.json"
    saved.value.save_as(copy)
    page.on("dialog", lambda dialog: dialog.accept())
    page.get_by_role("button", name="Delete everything").click()
    assert_cells(row, ["not yet", re.compile(r"^0 of"), "0", "0 of 8"])
    page.locator("input[type=file]").set_input_files(copy)
    page.get_by_text("Loaded, and added").wait_for()
    assert_cells(row, told)
    (tmp_path / "other.json").write_text("[1, 2]")
    page.locator("input[type=file]").set_input_files(tmp_path / "other.json")
    page.get_by_text("This file is not a copy of your progress").wait_for()
    assert_cells(row, told)


def assert_cells(row, expected):
    from playwright.sync_api import expect

    for cell, text in zip(row.locator("td").all(), expected, strict=True):
        expect(cell).to_have_text(text)


def test_a_browser_that_keeps_nothing_still_answers(chromium, address):
    """A private window, or storage that is full: the page says so, and goes on."""
    with watched(chromium) as page:
        page.add_init_script(
            "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }"
        )
        page.goto(f"{address}/lectures/03_poe_space.html")
        page.locator(f"{RECALL} button").nth(2).click()
        assert "C is correct" in page.locator(f"{RECALL} .kinlib-reply").inner_text()
        assert page.get_by_text("stores nothing for this page").count() == 1


def test_without_scripts_every_explanation_can_be_opened(chromium, address):
    with watched(chromium, java_script_enabled=False) as page:
        page.goto(f"{address}/lectures/03_poe_space.html")
        page.locator(f"{RECALL} summary").nth(2).click()
        assert page.get_by_text("Even if the body has no matter there").is_visible()
        page.locator('[data-misstep-explain="03/order"] summary').click()
        assert page.get_by_text("When the turn of joint 2 comes, joint 1 has not moved yet").is_visible()


def test_the_search_finds_words_without_asking_anybody(page, address):
    """Lectures before the pages of robots, whose tables hold every word; and a formula is told once, not three times."""
    page.goto(f"{address}/search.html?q=screw")
    page.get_by_text("Search finished").wait_for()
    found = page.locator("#search-results li")
    assert found.count() > 20
    leads = [link.rsplit("/", 2)[-2] for link in found.locator("a").evaluate_all("found => found.map(e => e.href)")]
    assert leads.index("lectures") < leads.index("robots")
    context = found.filter(has_text="DH frames for any arm").locator(".context").first
    context.wait_for()
    assert context.inner_text().count("(0,d)") == 1
    assert "\\omega" not in "".join(found.locator(".context").all_inner_texts())


def test_what_the_keyboard_is_on_can_be_seen_and_the_first_tab_skips_the_navigation(page, address):
    page.goto(f"{address}/lectures/03_poe_space.html")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Skip to content"
    page.wait_for_function("document.activeElement.getBoundingClientRect().top >= 0")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.closest('article, [role=main]') !== null")
    for _ in range(12):
        drawn = page.evaluate(
            "(s => [s.outlineStyle, parseFloat(s.outlineWidth)])(getComputedStyle(document.activeElement))"
        )
        assert drawn[0] != "none", page.evaluate("document.activeElement.outerHTML")
        assert drawn[1] >= 2
        page.keyboard.press("Tab")


# --- what the pages are made of ---


def test_no_page_tells_what_a_problem_s_answer_is(built):
    """Sheets stand there as handed out: their answer cells are blank, and nothing comes from solutions/."""
    for path in sorted((built / "sheets").glob("[0-9]*.html")):
        text = re.sub(r"<[^>]+>", "", path.read_text("utf-8"))
        answers = re.findall(r"^\s*\w+_\d+ = (.*)$", text, re.MULTILINE)
        assert "BEGIN SOLUTION" not in text
        assert answers.count("...") >= 7, (path.name, answers)


@pytest.mark.parametrize(
    ("heard", "common"),
    [
        (["You turned 7 times as far.", "You turned 9 times as far."], "You turned … times as far."),
        (["Longer by 2.509 m.", "It is even."], "Longer by … m. Or: It is even."),
        (["Look at $x_1$.", "Look at $x_2$."], "Look at …."),
        (["Always 0.5."] * 3, "Always 0.5."),
    ],
)
def test_what_is_only_one_student_s_is_left_out_of_a_message(heard, common):
    assert mistakes.common_text(heard) == common


@pytest.mark.parametrize(
    "module", [cell_outputs, execute, gallery, mistakes, reference, sphinx_source], ids=lambda m: m.__name__
)
def test_the_examples_of_the_site_s_own_modules_run(module):
    assert not doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE).failed


def test_what_is_for_tests_is_not_on_a_page(built, pages):
    """But for the page that says how to write one."""
    assert [name for name in pages if "NBVAL" in (built / name).read_text("utf-8")] == ["contributing.html"]


def test_a_docstring_s_prose_stays_prose_and_its_list_a_list():
    """A bracket before a word makes no list, two blanks do; and prose may go on below a list."""
    assert reference.paragraph("A point (n, 3) on every axis") == "A point (n, 3) on every axis"
    assert reference.paragraph("q      (n,) values\n       in radians\nAnd more.") == (
        "`q`\n: (n,) values\n  in radians\n\nAnd more."
    )


def test_a_comma_stays_with_its_formula(page, address):
    """Where a line ends behind a formula, a browser would begin the next one with the comma."""
    page.set_viewport_size(PHONE)
    page.goto(f"{address}/mistakes/03_poe_space.html")
    assert page.locator(".together").count() > 20
    tops = page.evaluate(
        """[...document.querySelectorAll('.together')].map((held) => {
            const range = document.createRange();
            range.selectNodeContents(held.lastChild);
            return range.getBoundingClientRect().top - held.querySelector('.katex-html').getBoundingClientRect().bottom; })"""
    )
    assert max(tops) < 0


@pytest.mark.parametrize("size", [PHONE, {"width": 1200, "height": 900}], ids=["phone", "desk"])
def test_the_number_of_a_formula_stands_behind_its_end(page, address, size):
    """On a phone a long formula goes on beyond the edge, where its number would stand over it."""
    page.set_viewport_size(size)
    page.goto(f"{address}/lectures/03_poe_space.html")
    room = page.evaluate(
        """[...document.querySelectorAll('.katex-display:has(.tag)')].map((shown) => {
            const ends = [...shown.querySelectorAll('.base')].map((part) => part.getBoundingClientRect().right);
            return shown.querySelector('.tag').getBoundingClientRect().left - Math.max(...ends); })"""
    )
    assert len(room) > 3
    assert min(room) > 5


def test_a_formula_that_does_not_set_is_no_formula():
    from sphinxcontrib.katex import KaTeXError

    assert 'class="katex"' in cell_outputs.typeset_formulas("<p>a $x^2$ b</p>")
    assert cell_outputs.typeset_formulas("<pre>$5</pre><code>$a$</code>") == "<pre>$5</pre><code>$a$</code>"
    with pytest.raises(KaTeXError, match=r"[Uu]ndefined"):
        cell_outputs.typeset_formulas(r"<p>$\nosuchthing$</p>")


def test_outputs_are_kept_until_the_cells_or_kinlib_change(tmp_path, monkeypatch):
    ran = []
    monkeypatch.setattr(execute, "run", lambda _, path: ran.append(path.name))
    path = ROOT / "notebooks" / "00_start_here.ipynb"
    for _ in range(2):
        execute.execute(path, tmp_path)
    assert len(ran) == 1
    monkeypatch.setattr(execute, "package_hash", lambda: "another kinlib")
    execute.execute(path, tmp_path)
    assert len(ran) == 2
    assert len(list(tmp_path.iterdir())) == 1, "what nobody needs any more is not kept"


def test_a_notebook_that_has_just_run_is_the_page_that_the_next_build_finds(tmp_path, monkeypatch):
    """A kernel writes more into a notebook than outputs; were it kept, every page would be made twice."""

    def run(notebook, path):
        notebook.metadata["language_info"] = {"name": "another"}
        notebook.cells[-1].metadata["execution"] = "now"

    monkeypatch.setattr(execute, "run", run)
    path = ROOT / "notebooks" / "00_start_here.ipynb"
    assert execute.execute(path, tmp_path) == execute.execute(path, tmp_path)


@pytest.mark.parametrize(
    ("source", "told"), [("1 / 0", "ZeroDivisionError"), ("import warnings\nwarnings.warn('old')", "old")]
)
def test_a_notebook_that_raises_or_complains_fails_the_build_by_name(tmp_path, monkeypatch, source, told):
    import nbformat

    monkeypatch.setattr(execute, "ROOT", tmp_path)
    path = tmp_path / "notebooks" / "broken.ipynb"
    path.parent.mkdir()
    nbformat.write(nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source)]), path)
    with pytest.raises(execute.NotebookError, match=rf"(?s)broken\.ipynb.*{told}"):
        execute.execute(path, tmp_path)


FAULTY = {
    "picture": ("![An arm that nobody drew](gone.svg)", "image file not readable: gone.svg"),
    "link": ("[Lecture 99](nowhere.md)", "'myst' cross-reference target not found: 'nowhere.md'"),
    "heading": ("[Above](#no-such-heading)", "'myst' cross-reference target not found: 'no-such-heading'"),
    "function": ("{py:func}`kinlib.rigid.lie.explode`", "py:func reference target not found: kinlib.rigid.lie.explode"),
    "alone": ("A page that no list of contents names.", "document isn't included in any toctree"),
}


@pytest.mark.usefixtures("built")  # which has fetched what Sphinx needs
def test_pages_with_faults_fail_the_build_and_each_is_named(tmp_path):
    listed = "\n".join(name for name in FAULTY if name != "alone")
    (tmp_path / "index.md").write_text(f"# Faults\n\n```{{toctree}}\n{listed}\n```\n", "utf-8")
    for name, (text, _) in FAULTY.items():
        (tmp_path / f"{name}.md").write_text(f"# A page\n\n{text}\n", "utf-8")
    words = [sys.executable, "-m", "sphinx", "-b", "html", *STRICT, "-c", SITE, tmp_path, tmp_path / "html"]
    done = subprocess.run(
        words, cwd=SITE, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    for name, (_, told) in FAULTY.items():
        assert re.search(rf"{name}\.md(:\d+)?: WARNING: {re.escape(told)}", done.stderr), f"{name}:\n{done.stderr}"


def test_a_robot_without_a_source_fails_the_build_by_name(monkeypatch):
    from dataclasses import replace

    from kinlib import robots

    nameless = replace(robots.rpr(), source="")
    monkeypatch.setattr(
        gallery, "public_functions", lambda module: [("rpr", lambda: nameless)] if module is robots else []
    )
    with pytest.raises(ValueError, match="rpr must have a source"):
        dict(gallery.pages())
