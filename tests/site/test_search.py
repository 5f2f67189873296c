"""The search lists the page that a reader looks for first, in the box as readers use it."""

import json
import re
from pathlib import Path

from accessibility import violations
from browser import watched

QUERIES = json.loads(Path(__file__).with_name("search_queries.json").read_text("utf-8"))
"""What readers type, each with the beginnings of the addresses that are right first."""


def test_the_page_that_is_looked_for_is_first_for_three_of_four_queries(chromium_without_webgl, site_address):
    missed = {}
    with watched(chromium_without_webgl) as page:
        page.clock.install()
        page.goto(f"{site_address}/search.html")
        for query, wanted in QUERIES.items():
            page.locator("#search input").fill(query)
            page.clock.run_for(1000)  # the page searches when the reader has stopped typing
            page.get_by_text(re.compile(rf"^(No|\d+) results? for {re.escape(query)}|^Nothing")).wait_for()
            first = page.locator(".pagefind-ui__result").first
            found = [link.get_attribute("href").lstrip("/") for link in first.locator("a").all()]
            if not any(address.startswith(tuple([wanted] if isinstance(wanted, str) else wanted)) for address in found):
                missed[query] = found
        assert violations(page) == []
    assert len(missed) <= len(QUERIES) / 4, missed
