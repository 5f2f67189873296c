"""The lab in the browser: work that cannot be stored is not lost without a word."""

from browser import unwatched

SHEET = "exercises/03_poe_space/03_poe_space.ipynb"
WINDOW = {"width": 1200, "height": 1000}

FULL = "() => { IDBObjectStore.prototype.put = () => { throw new DOMException('full', 'QuotaExceededError'); }; }"

HAS_STORED = """async (text) => {
    const result = (request) => new Promise((done, fail) => { request.onsuccess = () => done(request.result); request.onerror = fail; });
    const name = (await indexedDB.databases()).map(({ name }) => name).find((name) => name.startsWith('JupyterLite Storage'));
    const store = (await result(indexedDB.open(name))).transaction('files').objectStore('files');
    return JSON.stringify(await result(store.getAll())).includes(text);
}"""
"""Whether a notebook that the browser has stored contains a text."""


def write(page, text):
    """Replace the text of the first answer."""
    page.locator(".jp-CodeCell .cm-content", has_text="screws_1 =").first.click()
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)


def test_a_browser_that_cannot_store_work_shows_a_message_and_offers_the_download(
    chromium_without_webgl, lab_address, tmp_path
):
    with unwatched(chromium_without_webgl, viewport=WINDOW) as page:
        page.add_init_script("delete globalThis.WebAssembly")  # no Python has to start
        page.goto(f"{lab_address}/lab/notebooks/index.html?path={SHEET}")
        page.locator(".jp-Notebook .jp-CodeCell").first.wait_for()
        write(page, "screws_1 = 'early words'")
        page.wait_for_function(HAS_STORED, arg="early words", polling=500)
        page.evaluate(FULL)
        write(page, "screws_1 = 'not to be lost'")
        page.get_by_text("This browser cannot store your work").wait_for()
        with page.expect_download() as taken:
            page.get_by_role("button", name="Download the notebook").click()
        taken.value.save_as(tmp_path / "sheet.ipynb")
        assert "not to be lost" in (tmp_path / "sheet.ipynb").read_text("utf-8")
