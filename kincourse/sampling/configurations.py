"""Joint configurations as students type them, as formulas need them, and in words."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from misstep.display.text import number


class Configuration(NamedTuple):
    """A joint configuration: typed (n,) in degrees and metres, q (n,) in radians and metres, and both in words."""

    typed: Array
    q: Array
    words: str


def configuration_from_typed(chain: Chain, typed: Sequence[float]) -> Configuration:
    """Complete a configuration of a chain from its joint values in degrees and metres."""
    is_angle = np.array([kind != "P" for kind in chain.joint_types])
    values = np.array(typed)
    words = [f"{number(value)} {'degrees' if angle else 'm'}" for value, angle in zip(typed, is_angle, strict=True)]
    return Configuration(values, np.where(is_angle, np.radians(values), values), ", ".join(words))
