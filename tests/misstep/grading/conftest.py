"""What tests of grading share."""

import pytest


@pytest.fixture(scope="module")
def grade_habit():
    """A function that grades a habit on a sheet."""
    from habits import graders  # what it imports needs Linux or macOS

    with graders() as grade:
        yield grade
