"""Mistakes in the order of the factors of a product of exponentials: the joints in a wrong order, M at a wrong place, or both."""

from collections.abc import Mapping, Sequence

from misstep.mistakes import Mistake


def factor_order_mistakes(
    joints: Sequence[str],
    place: int,
    orders: Mapping[str, tuple[Sequence[str], str]],
    places: Mapping[str, tuple[int, str]],
) -> list[Mistake]:
    """The wrong orders of the factors: e_a for joint a, and M.

    joints  the right order of the joints
    place   how many joints are to the left of M
    orders  wrong orders of the joints by the name of the mistake, each with its message
    places  wrong places of M by the name of the mistake, each with its message

    >>> found = factor_order_mistakes("ab", 2, {"reversed": ("ba", "You ...")}, {"home first": (0, "You ...")})
    >>> [(wrong.name, wrong.value) for wrong in found][1:]
    [('reversed', ['e_b', 'e_a', 'M']), ('reversed and home first', ['M', 'e_b', 'e_a'])]
    """
    found = []
    for order, (names, order_text) in {"": (joints, ""), **orders}.items():
        for home, (before, home_text) in {"": (place, ""), **places}.items():
            factors = [f"e_{name}" for name in names]
            made = tuple(filter(None, (order, home)))
            text = " ".join(filter(None, (order_text, home_text)))
            value = [*factors[:before], "M", *factors[before:]]
            if made and value not in [known.value for known in found]:
                found.append(Mistake(" and ".join(made), value, text, names=made))
    return found
