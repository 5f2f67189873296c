"""The course site: it builds without a warning, and every page opens in a real browser without a fault, a stranger or a burden."""

import gzip
import json
import os
import re
import subprocess
import sys
import threading
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from browser import browsers, watched

ROOT = Path(__file__).parents[1]
SITE = ROOT / "site"
sys.path.insert(0, str(SITE))

from kinsite import execute  # noqa: E402
from serve import serve  # noqa: E402

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
    "reference": "reference/chain.html",
    "glossary": "glossary.html",
    "progress": "progress.html",
    "search": "search.html?q=screw",
    "missing": "no/such/page.html",
    "phone": "lectures/00_start_here.html",
}


@pytest.fixture(scope="module")
def built():
    """The folder of pages. Its notebooks run only if they or kinlib have changed since the last build."""
    done = subprocess.run(
        [sys.executable, SITE / "build.py"], cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if "none on the path" in done.stderr and not os.environ.get("CI"):
        pytest.skip(f"NO SITE WAS BUILT: {done.stderr}")
    assert done.returncode == 0, f"{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return execute.ROOT / "build" / "site" / "html"


@pytest.fixture(scope="module")
def address(built):
    server = serve(built, 0)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_address[1]}"
    server.shutdown()
    server.server_close()
    thread.join()


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
    return sorted(path.relative_to(built).as_posix() for path in built.rglob("*.html") if "_static" not in path.parts)


# --- every page ---


def test_every_page_opens_without_a_fault_and_every_link_leads_somewhere(flat, address, built, pages):
    """One browser opens them all; `watched` fails at the first word on a console and the first request to a stranger."""
    assert len(pages) > 60
    broken = []
    with watched(flat) as page:
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
        if name not in ("search.html", "404.html"):
            for part in ('<meta name="description"', '<meta property="og:image"'):
                assert part in text, f"{name} lacks {part}"
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
        files = {(built / name).parent.joinpath(found).resolve() for found in named if "//" not in found}
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


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("kind", KINDS)
def test_axe_finds_nothing(chromium, address, kind, theme):
    axe = (SITE / "node_modules" / "axe-core" / "axe.min.js").read_text("utf-8")
    size = {"width": 390, "height": 844} if kind == "phone" else {"width": 1200, "height": 900}
    opened = unwatched if kind == "missing" else watched
    with opened(chromium, viewport=size, color_scheme=theme) as page:
        page.goto(f"{address}/{KINDS[kind]}")
        page.wait_for_load_state("networkidle")
        page.evaluate(axe)
        found = page.evaluate("axe.run(document, { resultTypes: ['violations'] })")["violations"]
        told = [
            (fault["id"], node["html"][:200], node["failureSummary"][:300])
            for fault in found
            for node in fault["nodes"]
        ]
        assert not told, json.dumps(told[:4], indent=1)
        wide = page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
        assert wide <= 0, f"the page is {wide} pixels wider than the window"


@contextmanager
def unwatched(browser, **settings):
    """A page that is not there is a fault on the console, as it should be."""
    context = browser.new_context(**settings)
    yield context.new_page()
    context.close()
