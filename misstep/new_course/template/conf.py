"""The site: Sphinx makes a page from each notebook, and JupyterLite runs it in the browser of the reader.

README.md says how to build it. The reader's browser loads its Python, which is Pyodide, from Pyodide's own address.
"""

import json
import os

project = html_title = "my_course"
html_show_copyright = False
extensions = ["myst_nb", "jupyterlite_sphinx"]
html_theme = "furo"
html_copy_source = False
include_patterns = ["index.md", "instructors.md", "notebooks/*.ipynb", "exercises/*/*.ipynb"]
myst_enable_extensions = ["dollarmath"]

# A page shows what its notebook shows when it is run. Questions then have a form that works without Python.
os.environ["NOTEBOOK_STATIC_PAGE"] = "1"
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_render_markdown_format = "myst"  # statements of problems have formulas and tables
nb_mime_priority_overrides = [
    ("html", "text/html", 10),
    ("html", "application/vnd.jupyter.widget-view+json", None),
]
suppress_warnings = ["mystnb.unknown_mime_type"]  # what a check keeps for the grader is not shown

jupyterlite_config = "jupyter_lite_config.json"
jupyterlite_silence = False
jupyterlite_bind_ipynb_suffix = False  # MyST-NB reads the notebooks

LIVE = """<details><summary>Run the cells of this page</summary>

```{{notebooklite}} /{name}.ipynb
:prompt: Start
:height: 40rem
```

</details>"""


def add_live_cells(_app, name, source):
    """Below the title of each notebook, add a part that opens the same notebook with cells that run."""
    if name.startswith(("notebooks/", "exercises/")):
        notebook = json.loads(source[0])
        cell = {"cell_type": "markdown", "id": "live", "metadata": {}, "source": LIVE.format(name=name)}
        notebook["cells"].insert(1, cell)
        source[0] = json.dumps(notebook)


def setup(app):
    """Connect it to Sphinx, which calls it for each page."""
    app.connect("source-read", add_live_cells)
