"""Notebooks whose bytes are slow to read for a careless reader, each with right answers where it can be read at all."""

import json
from base64 import b64encode

from submissions import as_bytes, code, handed_in, names, right

MB = 1_000_000


def honest(student, **more):
    """The bytes of a notebook with right answers."""
    return as_bytes(handed_in(student, right(student), **more))


def with_cells(student, *sources):
    notebook = handed_in(student, right(student))
    notebook["cells"] += map(code, sources)
    return as_bytes(notebook)


def with_part(student, part):
    """A notebook with this text of JSON as a further member."""
    return honest(student).rstrip()[:-1] + b', "more": ' + part + b"}"


def with_image(student, size):
    notebook = handed_in(student, right(student))
    data = {"image/png": b64encode(b"\x89PNG\r\n\x1a\n" + bytes(size)).decode()}
    notebook["cells"][1]["outputs"] = [{"output_type": "display_data", "metadata": {}, "data": data}]
    return as_bytes(notebook)


NAME = names()[1]

READABLE = {
    "a comment of 194 kB with a name": lambda who: with_cells(who, f"# {' '.join([NAME] * 21_000)}"),
    "a comment of 1.8 MB with a name": lambda who: with_cells(who, f"# {' '.join([NAME] * 200_000)}"),
    "assignments on one line": lambda who: with_cells(who, f"{NAME} == 0; " * 60_000),
    "a sum of 400,000 terms": lambda who: with_cells(who, f"{NAME}_2 = {'+'.join(['1'] * 400_000)}"),
    "brackets 400,000 deep": lambda who: with_cells(who, f"{NAME}_2 = {'(' * 400_000}"),
    "100,000 names": lambda who: with_cells(who, f"{NAME}_2 = " + " = ".join(f"x{k}" for k in range(100_000)) + " = 1"),
    "an attribute of an attribute": lambda who: with_cells(who, NAME + ".a" * 300_000 + " = 1"),
    "calls that open no sheet": lambda who: with_cells(who, "# " + "open_sheet( " * 80_000),
    "white space": lambda who: with_cells(who, f"# {NAME}" + " " * 900_000 + "=", "student" + "\n" * 900_000),
    "lines of magics": lambda who: with_cells(who, f"{NAME}_2 = 1\n" + "%time 1\n" * 90_000),
    "combining letters": lambda who: with_cells(who, "# a" + "\u0301" * 900_000),
    "halves of characters": lambda who: with_part(who, b'"' + rb"\ud800" * 900_000 + b'"'),
    "an image of 20 MB": lambda who: with_image(who, 15 * MB),
    "a number of 20 MB": lambda who: with_part(who, b"0." + b"7" * 20 * MB),
}
"""By name, a function that makes the notebook of a student, which is a sheet like any other."""

FORMULA = f"""
{NAME} = '$' + '\\\\frac{{' * 30_000 + '$' + '`$' * 50_000
"""

SHOWN = """
from IPython.display import Markdown
for mark in '$`*[<\\': display(Markdown(mark * 150_000))
display({'text/plain': [[]] * 100_000, 'x/y': {}}, raw=True)
"""
"""What a cell may show that is slow to parse for a careless reader."""

UNREADABLE = {
    "lists 8,000,000 deep": (lambda who: with_part(who, b"[" * 8 * MB), "more parts"),
    "lists 200,000 deep": (lambda _: b"[" * 200_000, "nested too deeply"),
    "8,000,000 lists": (lambda who: with_part(who, b"[" + b"[]," * 8 * MB + b"[]]"), "more parts"),
    "an integer of 20 MB": (lambda who: with_part(who, b"7" * 20 * MB), "cut off or damaged"),
    "20,000 cells": (lambda who: with_cells(who, *["1"] * 20_000), "a sheet has at most 1000"),
    "40 MB": (lambda who: with_part(who, b'"' + b"x" * 40 * MB + b'"'), "Clear all outputs"),
    "markers of conflicts": (lambda who: honest(who) + b"<<<<<<< \n" * 500_000, "merge conflict: 499999 marker"),
}
"""By name, a function that makes the bytes of a file that is no notebook of this course, and a part of the reason."""


def heavy_answer(student):
    """An answer to the first problem that quotes formulas, and for which the others count."""
    return as_bytes(handed_in(student, {**right(student), 1: FORMULA}))


def nested_answer(student):
    """An answer to the first problem that is nested too deeply to be read by recursion, put in its place by hand."""
    emission = {"sheet": "03_poe_space", "problem": 1, "student": student, "answer": None}
    text = json.dumps(emission).replace("null", "[" * 900 + "]" * 900)
    source = f"import json\ndisplay({{'application/vnd.misstep.answer+json': json.loads({text!r})}}, raw=True)"
    return as_bytes(handed_in(student, {**right(student), 1: source}))
