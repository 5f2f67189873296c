"""The letters of the sheets' drawings: large enough, apart from each other, and each nearest to its own link."""

import re
from itertools import pairwise

import numpy as np

from kincourse import find_sheet, sheets

TEXT = re.compile(r'<text x="([-\d.]+)" y="([-\d.]+)" text-anchor="middle" font-size="([\d.]+)"[^>]*>(.*?)</text>')
LINKS = re.compile(r'<polyline points="([^"]+)" fill="none" stroke="[^"]+" stroke-width="5"')


def labels(svg):
    """The texts of a drawing, their centres and the halves of their boxes, in its own pixels."""
    for x, y, size, inside in TEXT.findall(svg):
        text, height = re.sub(r"<[^>]*>|&\w+;", "", inside), float(size)
        yield text, np.array([float(x), float(y) - 0.35 * height]), np.array([0.29 * len(text) * height, height / 2])


def distance(point, start, end):
    along = end - start
    share = np.clip((point - start) @ along / max(along @ along, 1e-9), 0, 1)
    return np.linalg.norm(point - start - share * along)


def test_letters_are_large_apart_and_nearest_to_their_own_link():
    drawn = {one.number: one.variant("ada").figure for name in sheets() for one in find_sheet(name).problems}
    pictures = {number: figure().svg for number, figure in drawn.items() if figure}
    assert len(pictures) > 50
    for number, svg in pictures.items():
        width, box = re.search(r'<svg [^>]*width="([\d.]+)"[^>]*viewBox="([^"]+)"', svg).groups()
        found = list(labels(svg))
        assert min(2 * half[1] for _, _, half in found) * float(width) / float(box.split()[2]) >= 12.9, number
        for k, (text, centre, half) in enumerate(found):
            for other, there, room in found[:k]:
                assert (np.abs(centre - there) > half + room - 1).any(), (number, text, other)
        for text, centre, _ in found:
            if match := re.fullmatch(r"L_?(\d)", text):
                points = np.array([pair.split(",") for pair in LINKS.search(svg)[1].split()], dtype=float)
                nearest = np.argmin([distance(centre, *ends) for ends in pairwise(points)])
                assert nearest == int(match[1]) - 1, (number, text)
