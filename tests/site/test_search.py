"""The search lists the page that a reader looks for among its first two results."""

import pytest
from browser import watched

QUERIES = {
    "matrix exponential": "lectures/02_", "space frame": "lectures/03_", "body frame": "lectures/04_",
    "Euler angles": "glossary.html#term-Euler-angles", "screw axis": "glossary.html#term-screw-axis",
    "adjoint": "glossary.html#term-adjoint",
    "product of exponentials": "glossary.html#term-product", "PoE": "glossary.html#term-product",
    "home pose": "lectures/03_", "DH": "glossary.html#term-Denavit", "Denavit-Hartenberg": "lectures/05_",
    "standard DH": "lectures/05_", "modified DH": "lectures/06_", "common normal": "glossary.html#term-common-normal",
    "frame assignment": "glossary.html#term-frame-assignment", "assign_frames": "reference/kinlib.dh.assignment",
    "closed chain": "lectures/08_", "Gruebler": "lectures/08_", "Grübler": "lectures/08_", "mobility": "glossary.html#term-mobility",
    "URDF": "lectures/09_", "youBot": "robots/youbot", "PUMA 560": "robots/puma560", "Bennett": "robots/bennett",
    "forward kinematics": "glossary.html#term-forward-kinematics", "Pieper": "glossary.html#term-forward-kinematics",
    "homogeneous transformation": "glossary.html#term-homogeneous-transformation", "pose": "lectures/00_",
    "twist": "glossary.html#term-twist", "gimbal lock": "lectures/08_", "halves swapped": "mistakes/",
    "sine and cosine swapped": "mistakes/",
}  # fmt: skip
"""Words that readers type, each with the beginning of the address that must be among the first two results."""

FIGURES = ("performance.html", "census.html", "independent_checks.html")


@pytest.fixture(scope="module")
def results(chromium, site_address):
    """The addresses that the search finds, best first, for each query."""
    with watched(chromium) as page:
        page.goto(f"{site_address}/search.html?q=screw")
        page.get_by_text("Search finished").wait_for()
        return page.evaluate(
            """queries => {
                const index = kinlibSearch.makeIndex(kinlibSearchData, MiniSearch);
                return Object.fromEntries(queries.map((query) => [query, kinlibSearch.find(index, query).map(({ id }) => id)])); }""",
            list(QUERIES),
        )


def test_the_page_that_is_looked_for_is_among_the_first_two(results):
    assert not {
        query: results[query][:4]
        for query, wanted in QUERIES.items()
        if not any(address.startswith(wanted) for address in results[query][:2])
    }


def test_no_page_of_figures_is_above_a_lecture(results):
    for query, addresses in results.items():
        kinds = ["figures" if address.startswith(FIGURES) else address.partition("/")[0] for address in addresses]
        if "figures" in kinds and "lectures" in kinds:
            assert kinds.index("lectures") < kinds.index("figures"), query


def test_no_result_shows_the_sign_of_a_link_to_copy(site_folder):
    data = (site_folder / "_static" / "search-data.js").read_text("utf-8")
    assert '"title":"halves swapped"' in data
    assert "¶" not in data


def test_words_that_nothing_contains_and_no_words_get_an_answer(chromium, site_address):
    with watched(chromium) as page:
        page.goto(f"{site_address}/search.html?q=xylophone%3Cb%3E")
        page.get_by_text("nothing contains “xylophone<b>”").wait_for()
        page.goto(f"{site_address}/search.html")
        page.get_by_text("Type a word into the search box").wait_for()
