"""The settings of Sphinx for the course site. site/build.py calls Sphinx after kinsite has written the source of the pages."""

import os
import sys
import tomllib
from pathlib import Path
from urllib.parse import urlsplit

from sphinx.builders.html import StandaloneHTMLBuilder

import kinlib

HERE = Path(__file__).resolve().parent
SETTINGS = tomllib.loads((HERE / "settings.toml").read_text("utf-8"))
sys.path.insert(0, str(HERE))

project = "Forward kinematics"
project_copyright = "the kinlib authors. Code: MIT, lectures: CC BY 4.0"
version = release = kinlib.__version__

extensions = [
    "myst_nb",
    "notfound.extension",
    "sphinx_sitemap",
    "sphinxcontrib.katex",
    "sphinxext.opengraph",
    "kinsite.cell_outputs",
    "kinsite.page_template",
]

# --- reading the source ---

myst_enable_extensions = [
    "amsmath",
    "attrs_block",
    "attrs_inline",
    "colon_fence",
    "deflist",
    "dollarmath",
    "substitution",
]
myst_substitutions = {"version": release}
myst_heading_anchors = 3
exclude_patterns = ["files/**"]
nb_execution_mode = "off"  # kinsite.execute has executed the notebooks
nb_merge_streams = True
nb_code_prompt_show = "Show the code"
nb_code_prompt_hide = "Hide the code"
nb_render_markdown_format = "myst"  # statements of problems contain formulas and tables
nb_ipywidgets_js: dict[str, str] = {}
# HTML before widgets: there is no kernel, and each of our widgets has a static form for pages
nb_mime_priority_overrides = [
    ("html", "text/html", 10),
    ("html", "application/vnd.jupyter.widget-view+json", None),
]
suppress_warnings = ["mystnb.unknown_mime_type"]  # answers are stored for a grader, and show nothing
# Types of other libraries have no page here, and the build must not depend on their sites.
nitpick_ignore_regex = [("py:.*", r"(?!kinlib\.|misstep\.|kincourse\.).*")]
python_use_unqualified_type_names = True
add_module_names = False

# --- writing the pages ---

html_theme = "furo"
html_title = "Forward kinematics"
html_favicon = "static/favicon.svg"
html_static_path = ["static"]
templates_path = ["templates"]
html_css_files = ["course.css"]
html_js_files = [(name, {"defer": "defer"}) for name in ("course.js", "loader.js")]
html_baseurl = os.environ.get("KINLIB_SITE_URL", "http://127.0.0.1:8000/").rstrip("/") + "/"
# the page for missing addresses is shown at any depth, so its links must be absolute
notfound_urls_prefix = urlsplit(html_baseurl).path
html_copy_source = False
html_show_sourcelink = False
html_use_index = False
StandaloneHTMLBuilder.search = False  # Pagefind makes the index of the search
html_additional_pages = {"search": "search.html"}
html_domain_indices = False
html_math_renderer = "katex"
highlight_language = "none"  # a block without a language is a command line, and would be coloured as Python
pygments_style = "a11y-light"
pygments_dark_style = "a11y-dark"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#6b2fb3", "color-brand-content": "#6b2fb3"},
    "dark_css_variables": {"color-brand-primary": "#c9a2ff", "color-brand-content": "#c9a2ff"},
}

html_context = {"kinlib_repository": SETTINGS["repository"].rstrip("/"), "html_baseurl": html_baseurl}

katex_prerender = True
katex_css_path = "katex/katex.min.css"

sitemap_url_scheme = "{link}"
sitemap_excludes = ["404.html", "search.html"]
ogp_site_url = html_baseurl
ogp_image = "_static/opengraph.png"
ogp_image_alt = "An arm with its screw axes, and the words: where is the tool?"
ogp_social_cards = {"enable": False}
ogp_custom_meta_tags = ['<meta name="twitter:card" content="summary_large_image">']
