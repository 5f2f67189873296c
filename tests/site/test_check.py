"""A site is published only if it has every page and a complete lab."""

import json

import check
import pytest


@pytest.fixture
def built(tmp_path):
    """A complete site of nearly empty files."""
    notebooks = [f"{folder}/{path.stem}.html" for folder, paths in check.NOTEBOOKS.items() for path in paths]
    packages = {name: {"file_name": f"{name}.whl"} for name in ("kincourse", "numpy")}
    wheels = [f"lab/static/pyodide/{name}.whl" for name in packages]
    for name in (*check.FILES, *notebooks, *wheels, check.LOCK_FILE):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(f"<a {check.RUN_LINK}>")
    (tmp_path / check.LOCK_FILE).write_text(json.dumps({"packages": packages}))
    return tmp_path


@pytest.mark.parametrize(
    ("name", "text", "faults"),
    [
        ("lab/notebooks/index.html", None, ["lab/notebooks/index.html"]),
        ("lectures/03_poe_space.html", None, ["lectures/03_poe_space.html"]),
        ("lab/static/pyodide/numpy.whl", None, ["lab/static/pyodide/numpy.whl"]),
        (
            "sheets/05_dh_standard.html",
            "a site that was built without a lab",
            ["sheets/05_dh_standard.html: the link that runs it in the browser"],
        ),
        (
            check.LOCK_FILE,
            '{"packages": {"numpy": {"file_name": "numpy.whl"}}}',
            [f"{check.LOCK_FILE}: kincourse"],
        ),
    ],
)
def test_what_a_site_lacks_is_named(built, name, text, faults):
    assert list(check.missing(built)) == []
    (built / name).unlink()
    if text:
        (built / name).write_text(text)
    assert list(check.missing(built)) == faults


@pytest.mark.parametrize(
    "text", ["the *fixed* axes", "see `fk`", "$q$", r"\alpha", "an _own_ frame", "[x](y.md)", "to to turn"]
)
def test_literal_markup_and_a_doubled_word_are_named(tmp_path, text):
    (tmp_path / "page.html").write_text(
        f'<article role="main"><p>Before</p><p>Here is <b>{text}</b>.</p></article>', "utf-8"
    )
    (fault,) = check.literal_markup(tmp_path)
    assert fault.startswith("page.html: ")
    assert text in fault.replace("\\\\", "\\")


def test_code_signatures_and_quotations_are_no_literal_markup(tmp_path):
    prose = '<code>a*b*c</code><dt class="sig py">f(*args, **options)</dt> q_1 and q_2, 3 * 4 * 5 \u201cfor for\u201d'
    (tmp_path / "page.html").write_text(f'<article role="main"><p>{prose}</p></article>', "utf-8")
    assert list(check.literal_markup(tmp_path)) == []


def test_no_page_shows_literal_markup(site_folder):
    assert list(check.literal_markup(site_folder)) == []
