r"""Write a text as with a keyboard: the signs of paper, terminals, LaTeX and code by what a table of DHTable has for them."""

import re

WIDE_OR_LOW = re.compile("[₀-ₜᵢⱼ\uff01-\uff5e\u3000\xa0]")
SIGNS = str.maketrans({
    **dict.fromkeys("−–—", "-"), **dict.fromkeys("·×⋅", "*"), **dict.fromkeys("º˚", "°"), **dict.fromkeys("θϑ", "theta"),
    **dict.fromkeys("α⍺", "alpha"), **dict.fromkeys("┃│║", "|"), "π": "pi", "ψ": "psi", "σ": "sigma", "⁄": "/", "’": "'", "½": "1/2",
})  # fmt: skip

REPLACEMENTS = [
    ("\theta", "theta"), ("\alpha", "alpha"), ("\frac", r"\\frac"),  # without r in front of a text, Python reads \t, \a and \f
    (r"\x1b\[[0-9;]*m|[\u200b\u200e\ufeff]|(?<= {99}) +|[\u2500-\u257f]+", ""),  # of terminals and web pages
    # LaTeX
    (r"\\(?:begin|end)\{\w+\*?\}(?:\{[^}]*\})?|\\(?:hline|(?:top|mid|bottom)rule|cline\{[^}]*\})[ \t]*\n?", "\n-\n"),
    (r"[ \t]*\\\\(?:\[[^]]*\])?[ \t]*\n?", "\n"), (r"\\(?:unit|text|math\w\w|text\w\w)\{([^{}]*)\}", r"\1"), (r"\\,|\$", ""),
    (r"\^\{? *\\circ *\}?|\\degree", "°"), (r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}", r"(\1)/(\2)"),
    (r"\\(alpha|theta|psi|pi)(?![a-zA-Z])", r"\1"), (r"(?<!-)--(?=\.?\d|pi\b)", "-"), (r"\|\||!!|&", " | "),
    # code and spreadsheets
    (r"\bM_PI_([24])\b", r"pi/\1"), (r"\b(?:M_PI|(?:np|numpy|math|Math|sp|sympy)\.(?:pi|PI)|PI|Pi)\b(?:\(\))?", "pi"),
    (r"\b(?:(?:np|numpy|math)\.)?(?:deg2rad|radians|RADIANS)\(([^()]*)\)", r"(\1)*pi/180"), (r"(?m)(^|[\t;,|]) *=", r"\1"),
    (r"(?<=\d)f\b|(?<=\d\.)f\b", ""), (r"\b(q|theta)[\[(](\d+)[\])]", r"\1\2"),
    (r"\b((?:theta|q|d)_?\{?\d+\}?)\*(?![\w(.]|-1\b)", r"\1"),  # the star of a variable
    (r"\b([a-zA-Z]+)_?(?:\{(\d+)\}|(\d+))", r"\1\2\3"),  # l_{1} and l_1
]  # fmt: skip
"""What is replaced by what, in this order."""


def plain_text(text: str) -> str:
    r"""Write a text as with a keyboard.

    >>> plain_text(r"$\theta_{1}$ & $-\frac{\pi}{2}$")
    'theta1  |  -(pi)/(2)'
    """
    import unicodedata  # for a text that is read; `import kinlib` loads no more than NumPy

    text = WIDE_OR_LOW.sub(lambda found: unicodedata.normalize("NFKC", found[0]), text).translate(SIGNS)
    for pattern, plain in REPLACEMENTS:
        text = re.sub(pattern, plain, text)
    return text
