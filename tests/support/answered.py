"""A question as the viewers see it."""

from traitlets import Bool, HasTraits


class Answered(HasTraits):
    """All that a viewer uses of a question is whether an answer is committed."""

    committed = Bool(False)
