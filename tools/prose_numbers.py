r"""What the prose of a notebook says: its numbers, each with a witness among the cells, and its formulas, each with its check.

A decimal, a power of ten, a length or an angle in radians is witnessed by a number that a cell prints and that rounds to it,
or it is given: it stands as a literal in the code. Not asked for are counts, indices, years and whole degrees, which somebody
chose and nobody measured, nor what is quoted: code, block quotes, and a number alone in brackets or after "example", which
names an equation of a book, as (3.88) does.

A formula claims something if it is displayed with a relation sign in it, or relates more than a name to more than a value.
Then a number of ours stands in it or beside it: \tag{7}, or (7) in its paragraph or at the head of the paragraph that leads to
the display. In a block quote somebody else claims it. A cell nearby asserts it and says so, `assert ...  # (7)`.
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
    """The text without what it quotes."""
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
    """Each number that asks for a witness, as it is written, with the test that a witness passes."""
    for found in NUMBER.finditer(our_words(markdown)):
        if found["plain"]:
            yield found[0], rounds_to(found["plain"], UNITS.get(found["unit"], 1.0))
        elif found["factor"]:
            yield found[0], rounds_to(f"{found['factor']}e{found['exponent'] or found['digit']}")
        else:
            yield found[0], of_size(10.0 ** int(found["exponent"] or found["digit"]))


def rounds_to(written, unit=1.0):
    """Whether a number, in metres or in the unit, is the written one at its digits; the zeros that end 300 are none."""
    mantissa = written.partition("e")[0]
    digits = mantissa.replace(".", "").lstrip("0") if "." in mantissa else mantissa.strip("0")

    def witness(number):
        return any(float(f"{number / scale:.{max(len(digits), 1) - 1}e}") == float(written) for scale in {1.0, unit})

    return witness


def of_size(power):
    """Whether a number is this power of ten within a factor of five: a bare power names a size and no digit."""
    return lambda number: power / 5 < number < power * 5


def numbers_printed(cells):
    """What the cells print: the text of their outputs, not the coordinates in a picture, nor a question's own numbers."""
    for cell in cells:
        for output in cell.get("outputs", []):
            data = output.get("data", {})
            if "application/vnd.jupyter.widget-view+json" not in data:
                yield from numbers_of(output.get("text", "") + data.get("text/plain", ""))


def numbers_given(cells):
    """The literals of the code, and those inside of its strings, which hold tables and files."""
    for cell in cells:
        if cell.cell_type == "code":
            for node in ast.walk(ast.parse(cell.source)):
                if isinstance(node, ast.Constant) and type(node.value) in (int, float, str):
                    yield from numbers_of(node.value) if isinstance(node.value, str) else [abs(node.value)]


def numbers_of(text):
    return map(float, PRINTED.findall(text))


def witnesses(cells):
    """The numbers that the cells of an executed notebook print, or are given."""
    return {*numbers_printed(cells), *numbers_given(cells)}


def without_witness(text, witnesses):
    """The numbers in a text that nothing witnesses, as they are written there."""
    return [number for number, witness in numbers_in(text) if not any(map(witness, witnesses))]


# --- formulas ---

LABEL = r"\((\d{1,2}|[a-h])\)"
NAMED = re.compile(rf"(?:(?<![\w{{}})\\])|(?<=\\quad)){LABEL}(?!\()|\\tag\{{(\d{{1,2}}|[a-h])\}}|\\text\{{{LABEL}\}}")
CHECKED = re.compile(rf"{LABEL}(?: to {LABEL})?")
NEAR = 4
"""Cells. After a formula may come a question about it, a slider and an explanation, and then its check."""

PARAGRAPHS = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*|] ?|\d+\. ))")
FORMULA = re.compile(r"\$\$(.+?)\$\$|\$([^$]+)\$", re.DOTALL)
RELATION = re.compile(r"=|\\neq?\b|\\approx\b")
DECORATION = re.compile(r"[_^](?:\{(?:[^{}]|\{[^{}]*\})*\}|\\?\w+)|\\(?:dot|hat|mathcal|tfrac|[,;! ])|[{}'\s]")
WORD = re.compile(r"\\(?:mathrm|operatorname|text)\{[^{}]*\}|\\(?!dot|hat|mathcal|tfrac)[a-zA-Z]+")
NAME = re.compile(r"(?:d|\|)?\[?\w?\]?\|?(?:\(\w?\))?")
VALUE = re.compile(r"(?:[-+/°.,;()\[\]\s\d]|\\pi\b|\\pm\b|\\[,;! ])*")


def without_number(cells):
    """The formulas that claim something and bear no number."""
    for cell in cells:
        if cell.cell_type == "markdown":
            for before, paragraph in pairwise(["", *PARAGRAPHS.split(our_words(cell.source))]):
                for displayed, inline in FORMULA.findall(paragraph):
                    head = NAMED.match(before.strip("-|* \n")) if displayed else NAMED.search(paragraph)
                    if claims(displayed, inline) and not head and not NAMED.search(displayed):
                        yield f"{displayed or inline} in {cell.id}"


def claims(displayed, inline):
    """Whether a formula may be false: `S = (\\omega, v)` says what a letter stands for, `q_1 = 0` which case is meant."""
    left, *right = RELATION.split(displayed or inline)
    if displayed or not right:
        return bool(right)
    left = DECORATION.sub("", WORD.sub("x", left))
    return not (NAME.fullmatch(left) or all(map(VALUE.fullmatch, right)))


def named(markdown):
    """The numbers of formulas in a text."""
    return {next(filter(None, found)) for found in NAMED.findall(our_words(markdown))}


def checked(code):
    """The numbers of formulas in the comments of assertions, and of nothing else: `# (7)`, `# (2) to (4)`."""
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


def without_check(cells):
    """The numbers that the prose names and no assertion nearby, and those that an assertion names and no prose nearby."""
    formulas, checks = {}, {}
    for place, cell in enumerate(cells):
        markdown = cell.cell_type == "markdown"
        for number in named(cell.source) if markdown else checked(cell.source):
            (formulas if markdown else checks).setdefault(number, []).append(place)
    for number in sorted(formulas.keys() | checks.keys()):
        ways = [abs(one - other) for one in formulas.get(number, []) for other in checks.get(number, [])]
        if min(ways, default=NEAR + 1) > NEAR:
            cell = cells[(formulas.get(number) or checks[number])[0]]
            missing = "assertion" if number in formulas else "formula"
            yield f"({number}) of {cell.id} has no {missing} within {NEAR} cells"
