"""Mistakes in the order of the factors of a product of exponentials: the joints in a wrong order, M at a wrong place, or both."""

from collections.abc import Mapping, Sequence

from misstep.mistakes import Mistake

Sides = tuple[Sequence[str], Sequence[str]]
"""The names of the joints to the left of M, and of those to its right."""


def factor_order_mistakes(
    right: Sides, orders: Mapping[str, tuple[Sides, str]], places: Mapping[str, tuple[int, str]]
) -> list[Mistake]:
    """The wrong orders of the factors: e_a for joint a, and M.

    right   the right order
    orders  wrong orders of the joints by the name of the mistake, each with its message
    places  by the name of the mistake, how many joints are to the left of M, each with its message
    """
    found = []
    for order, (sides, order_text) in {"": (right, ""), **orders}.items():
        factors = [f"e_{name}" for side in sides for name in side]
        for home, (place, home_text) in {"": (len(sides[0]), ""), **places}.items():
            if order or home:
                name, text = " and ".join(filter(None, (order, home))), f"{order_text} {home_text}".strip()
                found.append(Mistake(name, [*factors[:place], "M", *factors[place:]], text))
    return found
