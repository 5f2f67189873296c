r"""Write a text as with a keyboard: the signs of paper, terminals, HTML, LaTeX and code by what a table of DHTable has for them."""

import re
from collections.abc import Callable, Sequence

WIDE_OR_LOW = re.compile("[₀-ₜᵢⱼ\uff01-\uff5e\u3000\xa0]")
SIGNS = str.maketrans({
    **dict.fromkeys("−–—", "-"), **dict.fromkeys("·×⋅", "*"), **dict.fromkeys("º˚", "°"), **dict.fromkeys("θϑ", "theta"),
    **dict.fromkeys("α⍺", "alpha"), **dict.fromkeys("┃│║", "|"), "π": "pi", "ψ": "psi", "⁄": "/", "’": "'", "½": "1/2",
})  # fmt: skip


def _one_by_one(found: re.Match[str]) -> str:
    """Return values for several names as a line for each of them."""
    values = re.split(r",\s*(?![^\[\]{}()]*[\])}])", found[2].strip())
    names = re.split(r"\s*,\s*", found[1])
    return "\n".join(map(" = ".join, zip(names, values, strict=True))) if len(names) == len(values) else found[0]


Replacements = Sequence[tuple[str, str | Callable[[re.Match[str]], str]]]

REPLACEMENTS: Replacements = [
    ("\theta", "theta"), ("\alpha", "alpha"), ("\frac", r"\\frac"),  # without r in front of a text, Python reads \t, \a and \f
    (r"\x1b\[[0-9;]*m|[\u200b\u200e\ufeff]|(?<= {99}) +|[\u2500-\u257f]+", ""),
    # HTML: the attributes of XML are a dictionary
    (r"<\w+\s([^<>]*\balpha\s*=[^<>]*?)/?>", r"{\1}"), (r"</t[dh]>\s*<t[dh][^>]*>", " | "), (r"</?(?:tr|table|br|p)\b[^>]*>", "\n"),
    (r"<su[bp]>(.*?)</su[bp]>", r"_\1"), (r"<[a-zA-Z/][^>]{0,200}>", " "),
    # LaTeX
    (r"\\(?:begin|end)\{\w+\*?\}(?:\{[^}]*\})?|\\(?:hline|(?:top|mid|bottom)rule|cline\{[^}]*\})|\\\\(?:\[[^]]*\])?", "\n"),
    (r"\\ang\{([^{}]*)\}", r"\1°"), (r"\\milli\\met(?:re|er)", "mm"), (r"\\met(?:re|er)\b", "m"),
    (r"\\(?:SI|qty)\{([^{}]*)\}\{([^{}]*)\}", r"\1 \2"), (r"\\(?:si|unit|text|math\w\w|text\w\w)\{([^{}]*)\}", r"\1"),
    (r"\^\{?\s*\\circ\s*\}?|\\degree", "°"), (r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}", r"(\1)/(\2)"), (r"\\,|\$", ""),
    (r"\\(?:cdot|times)\b", "*"), (r"\\(alpha|theta|psi|pi)(?![a-zA-Z])", r"\1"), (r"(?<!-)--(?=\.?\d|pi\b)", "-"),
    # wikis and other separators
    (r"(?m)^\s*(?:\{\|.*|\|[-}]\s*)$", ""), (r"!!|\|\||&", " | "), (r"(?m)^\s*!", "|"), (r"\(\*|\*\)", "\n"),
    # the functions and numbers of code and spreadsheets
    (r"\b(?:M_PI|PI|FRAC_PI)_([24])\b", r"pi/\1"), (r"\b(?:M_PI|(?:np|numpy|math|Math|sp|sympy)\.(?:pi|PI)|PI|Pi)\b(?:\(\))?", "pi"),
    (r"\b(?:(?:np|numpy|math)\.)?(?:deg2rad|radians|RADIANS)\(([^()]*)\)", r"\1°"), (r"(?m)(^|[\t;,|])[ ]*=", r"\1"),
    (r"\((?:float|double|real_t)\)|(?<=\d)f\b|(?<=\d\.)f\b", ""), (r"(?<=\d)\s*\*\s*([mc]m)(?:_?(?:2|to)_?m)?\b", r" \1"),
    (r"\b((?:theta|q|d)_?\{?\d+\}?)\*(?![\w(.]|-1\b)", r"\1"), (r"\bth_?(\d+)\b", r"theta\1"),  # the star of a variable
    # the names, lists and calls of code
    (r"\b(?:\w+\((\d+)\)|[a-zA-Z]+(\d+))\.(\w+)\s*=(?!=)", r"\3\1\2 ="), (r"\b([a-zA-Z]\w*)\[(\d+)\](?!\s*[\[.])", r"\1\2"),  # L(1).a
    (r"\b\w+\[(\d+)\]\.(\w+)\s*=(?!=)", lambda found: f"{found[2]}{int(found[1]) + 1} ="),  # counted from 0
    (r"\b(?!q\(|theta\(|sqrt|a?sin|a?cos|a?tan)([a-zA-Z]\w*)\(([1-9]\d?)\)", lambda found: f"{found[1]}{int(found[2]) - 1}"),
    (r"(?<=[\[,])\s*\[([^\[\],]*\d[^\[\],]*)\](?=\s*[,\]])", r"\1"), (r"(?m)^[ \t]*-[ \t]+\[([^\[\]\n]*)\]", r"\1"),  # [[0], [1]]
    (r"(?m)^[ \t]*\(?\d+\)[ \t]+(?=[-\w.])", ""), (r"(?m)^[ \t]*#define\s+(\w+)\s+", r"\1 = "), (r"\b\w+\s*<<\s*(?=\S)", ""),
    (r"(?mi)^.*?(?<![:.\w])(?:\w+_)?dh(?:_\w+)?\(((?:[^=,\n]{0,60},){3}[^=,\n]{0,60})\)\W*$", r"\1"),  # T = T @ dh(q1, 0.3, 0, pi/2)
    (r"\b([a-zA-Z]+)_?(?:\{(\d+)\}|(\d+))", r"\1\2\3"),  # l_{1} and l_1
    (r"(?m)^[ \t]*(\w+(?:[ \t]*,[ \t]*\w+)+)[ \t]*=[ \t]*(\S.*)$", _one_by_one),  # a1, a2 = 0.4, 0.3
]  # fmt: skip
"""What is replaced by what, in this order."""

ARRAY = re.compile(r"[\[{(]\s*[\[{(]|=\s*[\[{]|[\[{][^\]}]{,999};")
IN_ARRAYS: Replacements = [
    (r"\[\s*(-?[\d.]+(?:\s*;\s*-?[\d.]+)+)\s*\]", lambda found: f"({found[1].replace(';', ' ')})"),  # a column is no row
    (r"[\]})]\s*,\s*['\"]?\w+['\"]?\s*[:=]\s*(?=[\[{(])", "\n"),  # the next one, and the name of one
    (r"(?m)^(?:(?:[^\n#%/=]*=|[^\n#%/]*?[=(:])\s*(?=[\[{])|[^\n#%/{\[]*(?=\{\s*\{))", ""),
    (r"[\]})]\s*[,;]?\s*(?=[\[{(])|;", "\n"), (r"[\[\]{}]", " "), (r"(?m)^[ \t]+", ""), (r",[ \t]+", ", "),
]  # fmt: skip
COMMENTS = [
    (r"(?<=\S)[ \t]+(?:#|//|%)[ \t]*(?=.{,99}\balpha\b)", "\n# "),  # the comment of a row may be a heading
    (r"(?m)(?<=[\d,;i])[ \t]+(?:#|//|%)[ \t].*$", ""),
]  # fmt: skip
IN_LINES = [
    (r"^\s*(?:#+|%+|//+|/?\*+|>+)\s*", ""), (r"(?i)\b(joint|link|axis|j|l|link_?joint|row|frame)[\s_-]?(\d+|(?<=\s)[ijk])\b", r"\1\2"),
    (r"^[ \r]+|[ \r,]+$", ""), (r"^(\w+):\s+(?=.*,)", r"\1, "), (r"\s+in\s+(?=(?:mm?|cm|rad|deg\w*|°)(?!\w))", "/"),
    (r"(?i)\b(?:link|joint) (?:length|offset|twist|angle) (?=(?:a|d|alpha|theta)\b)", ""),
    (r"\s+(?=[\[(](?:[a-zA-Z]+|°|i-1)[\])])", ""), (r"(?<=[\d°])\s*~\s*(?=[-+]?\d)", "~"),
]  # fmt: skip
"""What code and lists write around the rows of an array, behind a row, and around the cells of a line."""


def plain_text(text: str) -> str:
    r"""Write a text as with a keyboard.

    >>> plain_text(r"$\theta_{1}$ & $-\frac{\pi}{2}$")
    'theta1  |  -(pi)/(2)'
    """
    import html  # for a text that is read; `import kinlib` loads no more than NumPy
    import unicodedata

    text = WIDE_OR_LOW.sub(lambda found: unicodedata.normalize("NFKC", found[0]), html.unescape(text))
    return _replaced(text.translate(SIGNS), REPLACEMENTS)


def rows_in_lines(text: str) -> str:
    """Write each row of an array in a line, without brackets, and a comment only if it is a heading."""
    return _replaced(_replaced(text, IN_ARRAYS) if ARRAY.search(text) else text, COMMENTS)


def cells_of_line(line: str) -> str:
    """Remove from a line what stands around its cells."""
    line = _replaced(line, IN_LINES)
    return line.rstrip("); ") if line.count(")") > line.count("(") or line.find(";") == len(line) - 1 else line


def _replaced(text: str, replacements: Replacements) -> str:
    for pattern, plain in replacements:
        text = re.sub(pattern, plain, text)
    return text
