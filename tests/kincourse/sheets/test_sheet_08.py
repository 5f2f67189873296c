"""Sheet 08: what is right for the mirror image of a linkage is explained by the convention that the statement fixes."""

import numpy as np

from kincourse import open_sheet
from kincourse.sampling.four_bar_geometry import FourBar
from kinlib.rigid.lie import exp, inverse, log

STUDENTS = [f"student {i}" for i in range(6)]


def test_a_mirrored_linkage_is_explained_by_the_convention():
    for student in STUDENTS:
        sheet = open_sheet("08_closed_chains", student)
        given = {k: sheet.given(k) for k in (2, 4)}
        below = FourBar(*given[2].bars).assembly_modes(-np.radians(given[2].degrees))[:, 2]
        x, y = sheet.problem(3).answer.value
        slider, A = given[4], np.radians(given[4].degrees)
        height = slider.offset + slider.crank * np.sin(A)
        other_side = slider.crank * np.cos(A) + np.sqrt(slider.rod**2 - height**2)
        answers = {2: below, 3: (x, -y), 4: other_side, 7: -sheet.problem(7).answer.value}
        for k, answer in answers.items():
            verdict = sheet.check(k, answer)
            assert verdict.score == 0
            assert "mirror image" in verdict.judgement.findings[0].message


def test_the_gap_in_coordinates_of_the_coupler_is_explained():
    for student in STUDENTS:
        sheet = open_sheet("08_closed_chains", student)
        given = sheet.given(1)
        A, B, C, D = (exp(given.S[name] * np.radians(given.degrees[name])) for name in "ABCD")
        one, two = D @ C @ given.G, A @ B
        for gap in (inverse(two) @ one, inverse(one) @ two):
            [finding] = sheet.check(1, log(gap)).judgement.findings
            assert finding.mistake == "another frame"
            assert "coordinates of the coupler" in finding.message
