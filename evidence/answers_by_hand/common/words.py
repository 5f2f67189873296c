"""Words by which feedback may name a kind of mistake; each set belongs to one kind."""

SIGN = frozenset({"sign", "minus", "negat", "opposite", "backwards"})
OTHER_WAY = SIGN | {"other way", "wrong way", "transpos", "inver", "-\\theta", "clockwise", "R^T"}
TRANSPOSED = frozenset({"transpos", "R^T", ".T", "rows"})
INVERTED = frozenset({"inver", "other way", "wrong way", "direction of"})
SWAPPED = frozenset({"swap", "exchang", "interchang"})
PLACE = frozenset({"in front", "behind", "from the left", "from the right", "sides", "you put", "wrong place"})
ORDER = SWAPPED | PLACE | {"order", "revers"}
OMITTED = frozenset({"left out", "leave out", "missing", "forgot", "without"})
ELEMENTWISE = frozenset({"elementwise", "entry by entry", "element by element"})
DEGREES = frozenset({"degrees", "radians"})
HALF = frozenset({"half", "halved"})
DOUBLE = frozenset({"double", "twice", "two times"})
LENGTH = frozenset({"length", "unit", "norm", "divide"})
SERIES = frozenset({"series", "term", "truncated", "cut short"})
HALVES = SWAPPED | {"halves", "(v,"}
MOMENT = SIGN | {"\\times", "cross product"}
POINT = frozenset({"point", "coordinate"})
SLIDE = frozenset({"slide", "prismatic", "translation"})
PITCH = frozenset({"pitch", "lead", "climb", "2\\pi"})
AXIS = frozenset({"axis", "axes", "column"})
COPIED = frozenset({"given", "unchanged", "the old", "read in", "not moved"})
JOINT = frozenset({"joint", "row"})
