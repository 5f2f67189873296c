r"""Check the prose of a notebook: each number must come from a cell, and each formula must be asserted in a cell nearby.

A decimal, a power of ten, a length or an angle in radians needs a source: a number that a cell prints and that rounds to it,
or a literal in the code. No source is needed for counts, indices, years and whole degrees, because they are chosen and not
measured. The same holds for quotations: code, block quotes, and a number alone in brackets or after "example", which refers
to an equation of a book, as (3.88) does.

A formula makes a claim if it is displayed with a relation sign in it, or if it relates more than a name to more than a value.
Then it needs a number: \tag{7}, or (7) in its paragraph or at the beginning of the paragraph before the display. In a block
quote, the claim is somebody else's. A cell nearby must assert the formula and name its number: `assert ...  # (7)`.
"""

import ast
import io
import re
import tokenize
from itertools import pairwise

QUOTED = [
    r"(?ms)```.*?```|`[^`]*`|^>.*?$",  # code, and block quotes
    r"(?<=\])\([^)]*\)",  # the address of a link
    r"\(\d+\.\d+\)|\b(?:example|section|exercise) \d+(?:\.\d+)+",  # an equation of a book, and its examples
]


def our_words(markdown):
    """Return the text without its quotations."""
    for quoted in QUOTED:
        markdown = re.sub(quoted, " ", markdown)
    return markdown


# --- numbers ---

UNITS = {"km": 1e3, "cm": 1e-2, "mm": 1e-3}
POWER = r"(?:(?P<factor>\d+(?:\.\d+)?) ?\\cdot ?)?10\^(?:\{(?P<exponent>-?\d+)\}|(?P<digit>\d))"
DECIMAL = r"\d+\.\d+(?:e-?\d+)?|\d+e-?\d+"
GAP = r"\$?(?:\\[,;]| )?(?:\\text\{ ?)?"
MEASURED = rf"\d+(?={GAP}(?:[ckm]?m|rad|radians?)\b)"
NUMBER = re.compile(rf"(?<![\w.])(?:{POWER}|(?P<plain>{DECIMAL}|{MEASURED})(?:{GAP}(?P<unit>[ckm]m\b))?)(?![\d.]*\d)")
PRINTED = re.compile(r"\d+\.?\d*(?:e[-+]?\d+)?")


def numbers_in(markdown):
    """Yield each number that needs a source, as it is written, with a function that tests whether a number is its source."""
    for found in NUMBER.finditer(our_words(markdown)):
        if found["plain"]:
            yield found[0], rounds_to(found["plain"], UNITS.get(found["unit"], 1.0))
        elif found["factor"]:
            yield found[0], rounds_to(f"{found['factor']}e{found['exponent'] or found['digit']}")
        else:
            yield found[0], of_size(10.0 ** int(found["exponent"] or found["digit"]))


def rounds_to(written, unit=1.0):
    """Return a test: does a number, in metres or in the unit, round to the written one? Final zeros, as in 300, do not count as digits."""
    mantissa = written.partition("e")[0]
    digits = mantissa.replace(".", "").lstrip("0") if "." in mantissa else mantissa.strip("0")

    def source(number):
        return any(float(f"{number / scale:.{max(len(digits), 1) - 1}e}") == float(written) for scale in {1.0, unit})

    return source


def of_size(power):
    """Return a test: is a number this power of ten within a factor of five? A bare power of ten only gives a size."""
    return lambda number: power / 5 < number < power * 5


def numbers_printed(cells):
    """Yield the numbers that the cells print as text: not the coordinates in a picture, and not the numbers in a question."""
    for cell in cells:
        for output in cell.get("outputs", []):
            data = output.get("data", {})
            if "application/vnd.jupyter.widget-view+json" not in data:
                yield from numbers_of(output.get("text", "") + data.get("text/plain", ""))


def numbers_given(cells):
    """Yield the literals of the code, and the numbers in its strings, which contain tables and files."""
    for cell in cells:
        if cell.cell_type == "code":
            for node in ast.walk(ast.parse(cell.source)):
                if isinstance(node, ast.Constant) and type(node.value) in (int, float, str):
                    yield from numbers_of(node.value) if isinstance(node.value, str) else [abs(node.value)]


def numbers_of(text):
    return map(float, PRINTED.findall(text))


def sources(cells):
    """Return the numbers that the cells of an executed notebook print or contain as literals."""
    return {*numbers_printed(cells), *numbers_given(cells)}


def numbers_without_source(text, sources):
    """Return the numbers in a text that have no source, as they are written there."""
    return [number for number, source in numbers_in(text) if not any(map(source, sources))]


# --- formulas ---

LABEL = r"\((\d{1,2}|[a-h])\)"
NAMED = re.compile(rf"(?:(?<![\w{{}})\\])|(?<=\\quad)){LABEL}(?!\()|\\tag\{{(\d{{1,2}}|[a-h])\}}|\\text\{{{LABEL}\}}")
CHECKED = re.compile(rf"{LABEL}(?: to {LABEL})?")
NEAR = 4
"""Largest distance of a formula from its assertion, in cells: a question, a slider and an explanation may lie between.

A cell that only shows one thing, such as a widget that an earlier cell has made, belongs to that cell and is not counted.
"""

PARAGRAPHS = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*|] ?|\d+\. ))")
FORMULA = re.compile(r"\$\$(.+?)\$\$|\$([^$]+)\$", re.DOTALL)
RELATION = re.compile(r"=|\\neq?\b|\\approx\b")
DECORATION = re.compile(r"[_^](?:\{(?:[^{}]|\{[^{}]*\})*\}|\\?\w+)|\\(?:dot|hat|mathcal|tfrac|[,;! ])|[{}'\s]")
WORD = re.compile(r"\\(?:mathrm|operatorname|text)\{[^{}]*\}|\\(?!dot|hat|mathcal|tfrac)[a-zA-Z]+")
NAME = re.compile(r"(?:d|\|)?\[?\w?\]?\|?(?:\(\w?\))?")
VALUE = re.compile(r"(?:[-+/°.,;()\[\]\s\d]|\\pi\b|\\pm\b|\\[,;! ])*")


def formulas_without_number(cells):
    """Yield the formulas that make a claim and have no number."""
    for cell in cells:
        if cell.cell_type == "markdown":
            for before, paragraph in pairwise(["", *PARAGRAPHS.split(our_words(cell.source))]):
                for displayed, inline in FORMULA.findall(paragraph):
                    head = NAMED.match(before.strip("-|* \n")) if displayed else NAMED.search(paragraph)
                    if claims(displayed, inline) and not head and not NAMED.search(displayed):
                        yield f"{displayed or inline} in {cell.id}"


def claims(displayed, inline):
    """Return whether a formula makes a claim: `S = (\\omega, v)` only defines a symbol, `q_1 = 0` only names a case."""
    left, *right = RELATION.split(displayed or inline)
    if displayed or not right:
        return bool(right)
    left = DECORATION.sub("", WORD.sub("x", left))
    return not (NAME.fullmatch(left) or all(map(VALUE.fullmatch, right)))


def named(markdown):
    """Return the numbers of formulas in a text."""
    return {next(filter(None, found)) for found in NAMED.findall(our_words(markdown))}


def checked(code):
    """Yield the numbers of formulas in the comments of assertions, but not of other lines: `# (7)`, `# (2) to (4)`."""
    asserted = {
        line
        for node in ast.walk(ast.parse(code))
        if isinstance(node, ast.Assert)
        for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)
    }
    for token in tokenize.generate_tokens(io.StringIO(code).readline):
        if token.type == tokenize.COMMENT and token.start[0] in asserted:
            for first, last in CHECKED.findall(token.string):
                yield from every(first, last or first)


def every(first, last):
    if first.isdigit():
        return [str(number) for number in range(int(first), int(last) + 1)]
    return [chr(letter) for letter in range(ord(first), ord(last) + 1)]


def only_shows(code):
    """Return whether a cell only shows one thing: `turning`, `explain("03/order")`.

    >>> [only_shows(code) for code in ("turning", "slide(draw, rotation)", "turning; rotation", "assert a == b")]
    [True, True, False, False]
    """
    match ast.parse(code).body:
        case [ast.Expr(ast.Name() | ast.Call())]:
            return True
    return False


def formulas_without_check(cells):
    """Yield the numbers of formulas without an assertion nearby, and of assertions without a formula nearby."""
    formulas, checks, shown = {}, {}, 0
    for index, cell in enumerate(cells):
        markdown = cell.cell_type == "markdown"
        shown += not markdown and only_shows(cell.source)
        place = index - shown
        for number in named(cell.source) if markdown else checked(cell.source):
            (formulas if markdown else checks).setdefault(number, {})[place] = cell.id
    for number in sorted(formulas.keys() | checks.keys()):
        ways = [abs(one - other) for one in formulas.get(number, ()) for other in checks.get(number, ())]
        if min(ways, default=NEAR + 1) > NEAR:
            first = next(iter((formulas.get(number) or checks[number]).values()))
            missing = "assertion" if number in formulas else "formula"
            yield f"({number}) of {first} has no {missing} within {NEAR} cells"
