"""axe, which finds faults of accessibility in a page, in the light and in the dark theme."""

from browser import emulate_theme
from built_site import SITE

COLOUR_RULES = "['color-contrast', 'link-in-text-block']"
"""What differs between the themes."""


def violations(page, within="html"):
    """List what axe finds on the open page, as (theme, rule, start of the element).

    The drawn half of a formula is left out: screen readers read its MathML, its letters have the colour of their line, and axe
    would spend most of its time on what is behind each letter. axe takes the heading of a column for empty if it has nothing
    but a formula; screen readers read its MathML.
    """
    page.wait_for_load_state("networkidle")
    page.evaluate((SITE / "node_modules" / "axe-core" / "axe.min.js").read_text("utf-8"))
    context, found = f"{{ include: '{within}', exclude: '.katex-html' }}", []
    for theme, only in (("light", "undefined"), ("dark", COLOUR_RULES)):
        emulate_theme(page, theme)
        rules = page.evaluate(f"axe.run({context}, {{ resultTypes: ['violations'], runOnly: {only} }})")["violations"]
        found += [
            (theme, rule["id"], node["html"][:200])
            for rule in rules
            for node in rule["nodes"]
            if not (rule["id"] == "empty-table-header" and page.locator(node["target"][0]).locator("math").count())
        ]
    return found
