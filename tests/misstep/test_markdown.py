"""The subset of Markdown for explanations."""

from misstep.display.markdown import markdown_html


def test_paragraphs_and_lists():
    text = "One\nline.\n\nTwo:\n- a\n  b\n\n- c\n\n1. d\n2. e\n\nThree."
    assert markdown_html(text) == (
        "<p>One line.</p><p>Two:</p><ul><li>a b</li><li>c</li></ul><ol><li>d</li><li>e</li></ol><p>Three.</p>"
    )


def test_marks_count_only_outside_of_code_and_formulas():
    html = markdown_html("**Both** *of $a_*b*c$* and `*x*`: 2 * 3 < 7.")
    assert html.startswith("<p><strong>Both</strong> <em>of $a_*b*c$</em> and <code")
    assert html.endswith(">*x*</code>: 2 * 3 &lt; 7.</p>")


def test_a_formula_is_kept_on_one_line():
    """The site reads the formulas of a page line by line, and a line of a formula may begin like an item."""
    text = "So\n\n$$a\n\n- b \\\\ c & d \\tag{1}$$\n\nholds."
    assert markdown_html(text) == r"<p>So</p><p>$$a - b \\ c &amp; d \tag{1}$$</p><p>holds.</p>"


def test_a_link_leads_to_a_notebook_or_a_site():
    html = markdown_html("[Lecture $n$](02_exp.ipynb#The-log), [book](https://a.b/?c=1&d)")
    assert '<a href="02_exp.ipynb#The-log" ' in html
    assert ">Lecture $n$</a>" in html
    assert 'href="https://a.b/?c=1&amp;d"' in html


def test_html_is_shown_and_not_run():
    assert "<script" not in markdown_html('A <script>alert(1)</script> [a](b"onclick="c)')
    assert '"onclick' not in markdown_html('[a](b"onclick="c)')
