"""The sentences of cards that fit every course: on units and degrees, rounding, placeholders, and lost points.

What is said of one kind of answer alone is in misstep/answers, and the titles of cards are in misstep/display/card.py.
"""

OTHER_UNIT = "This is right in {}. Give it in {}."
"""What is said of the right numbers in another unit, with both units."""

IN_DEGREES = OTHER_UNIT.format("degrees", "radians")

LIKE_DEGREES = "This is read as {:g} rad, more than a full turn. Is it in degrees?"
"""What is said of an angle that nobody means in radians, and that is not right in degrees either."""

ROUNDED = "These are the right numbers, but rounded too much. Keep at least four significant digits."

ZERO = "This is 0, and the right number is not."

UNTOUCHED = "{}. Put in the numbers that you find."
"""What is said of a placeholder."""

IDENTITY = UNTOUCHED.format("This is the identity matrix")

RIGHT = "Right: {}."
"""What is said of the right parts of an answer."""

TOGETHER = "Right: {}. You get no points for this alone."
"""What is said of right parts that a wrong method gives as well, and that earn nothing alone."""

UNKNOWN = "We do not recognise what happened here."

STEP_BY_STEP = "Go back to what is given, and check one step at a time."
