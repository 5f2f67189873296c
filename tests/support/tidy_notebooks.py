"""Remove the outputs of notebooks before a commit, except the text of cells with the tag nbval-check-output.

    python tests/support/tidy_notebooks.py notebooks/01_frames.ipynb ...

nbval compares the outputs of these cells. nbstripout does not know the tag, and it removes the execution count, without
which nbval compares nothing.
"""

import json
import sys
from pathlib import Path

TAG = "nbval-check-output"


def is_checked(cell):
    return TAG in cell["metadata"].get("tags", ())


def tidied(notebook):
    """Return the notebook without what differs from run to run or from machine to machine."""
    notebook["metadata"].pop("widgets", None)
    notebook["metadata"]["language_info"] = {"name": "python"}
    for cell in notebook["cells"]:
        cell["metadata"].pop("execution", None)
        if cell["cell_type"] == "code":
            marked = is_checked(cell)
            cell["execution_count"] = 1 if marked and cell["outputs"] else None
            cell["outputs"] = [text_of(output) for output in cell["outputs"] if marked]
    return notebook


def text_of(output):
    if "execution_count" in output:
        output["execution_count"] = 1
    if "data" in output:
        output["data"] = {"text/plain": output["data"].get("text/plain", "")}
    return output


if __name__ == "__main__":
    for path in map(Path, sys.argv[1:]):
        text = json.dumps(tidied(json.loads(path.read_text("utf-8"))), indent=1, ensure_ascii=False)
        path.write_text(text + "\n", "utf-8", newline="\n")
