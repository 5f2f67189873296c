"""The tree of a URDF: links as boxes, joints as arrows from parent to child, and a joint for which a tree has no place."""

from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.urdf.xml_elements import read_robot
from kinlib.view.drawing import svg
from kinlib.view.drawing.figure_colours import INK, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture

BOX_HEIGHT_PX, LEVEL_PX, COLUMN_PX, BORDER_PX, FONT_PX = 32.0, 84.0, 190.0, 24.0, 14.0


class Edge(NamedTuple):
    """A joint of a file: its name and type, and the names of the links that it joins."""

    name: str
    type: str
    parent: str
    child: str

    def __str__(self) -> str:
        return f"{self.name} ({self.type})"


def draw_urdf_tree(text: str, path: Sequence[str] = ()) -> Picture:
    """Draw the links and joints of a URDF as a tree, with its root at the top.

    text  the text of the URDF, or its path
    path  the names of links whose joints are drawn bold, in order: the joints from one link to another

    A joint whose child already has a parent is dashed: it closes a loop, and no tree contains it. So the file need not be a
    tree; its numbers are not read.

    Raises ValueError if the text is not a URDF.

    >>> text = '''<robot name="crane"><link name="ground"/><link name="mast"/>
    ...   <joint name="slew" type="continuous"><parent link="ground"/><child link="mast"/></joint></robot>'''
    >>> draw_urdf_tree(text).alt
    'Links and joints of crane, with the root ground at the top. From ground by slew (continuous) to mast.'
    """
    robot = read_robot(text)
    links = [element.text("name") for element in robot.children if element.tag == "link"]
    edges = [
        Edge(
            joint.text("name"),
            joint.text("type"),
            *(end.text("link") for end in map(joint.child, ("parent", "child")) if end),
        )
        for joint in robot.children
        if joint.tag == "joint"
    ]
    tree: dict[str, Edge] = {}
    for edge in edges:
        tree.setdefault(edge.child, edge)
    places = _places(links, tree)
    closing = [edge for edge in edges if tree[edge.child] is not edge]
    on_path = {frozenset(pair) for pair in pairwise(path)}
    right = max(x for x, _ in places.values())
    width = right + COLUMN_PX / 2 + BORDER_PX + (210 if closing else 60)
    height = max(y for _, y in places.values()) + BOX_HEIGHT_PX / 2 + BORDER_PX
    marks = [
        mark
        for edge in tree.values()
        for mark in _arrow(edge, places, bold=frozenset((edge.parent, edge.child)) in on_path)
    ]
    marks += [mark for edge in closing for mark in _closing_arrow(edge, places, right)]
    marks += [mark for link, place in places.items() for mark in _box(link, place, bold=link in path)]
    return Picture(svg.document(marks, width, height), _describe(robot.text("name"), tree, closing, links, path))


def _places(links: Iterable[str], tree: Mapping[str, Edge]) -> dict[str, Array]:
    """The middle of each box in pixels: depth first, each link above the middle of its children."""
    children: dict[str, list[str]] = {link: [] for link in links}
    for child, edge in tree.items():
        children[edge.parent].append(child)
    places: dict[str, Array] = {}
    columns = iter(range(len(children)))

    def put(link: str, depth: int) -> float:
        x = float(
            np.mean(
                [put(child, depth + 1) for child in children[link]] or [BORDER_PX + COLUMN_PX * (next(columns) + 0.5)]
            )
        )
        places[link] = np.array([x, BORDER_PX + BOX_HEIGHT_PX / 2 + LEVEL_PX * depth])
        return x

    for root in (link for link in children if link not in tree):
        put(root, 0)
    return places


def _box(link: str, place: Array, *, bold: bool) -> list[str]:
    half = np.array([0.5 * max(0.62 * FONT_PX * len(link) + 24, 74), BOX_HEIGHT_PX / 2])
    corners = place + half * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    return [
        svg.polygon(corners, "white", VIOLET if bold else LINK_GREY, 2.6 if bold else 1.2),
        svg.text(place, link, INK, FONT_PX),
    ]


def _arrow(edge: Edge, places: Mapping[str, Array], *, bold: bool) -> list[str]:
    half = np.array([0, BOX_HEIGHT_PX / 2])
    start, end = places[edge.parent] + half, places[edge.child] - half
    side = -1 if end[0] < start[0] - 1 else 1
    label = 0.45 * start + 0.55 * end + np.array([side * (0.29 * FONT_PX * len(str(edge)) + 12), 0])
    colour = VIOLET if bold else LINK_GREY
    return [*_stroke([start, end], colour, 3.2 if bold else 1.6), svg.text(label, str(edge), colour, FONT_PX - 1)]


def _closing_arrow(edge: Edge, places: Mapping[str, Array], right: float) -> list[str]:
    """A dashed arrow around the tree on its right."""
    out = right + COLUMN_PX / 2 + 35
    start, end = (places[link] + np.array([dx, 0]) for link, dx in ((edge.parent, 46), (edge.child, 46)))
    corners = [start, np.array([out, start[1]]), np.array([out, end[1]]), end]
    # At the height of a box, because the labels of the other joints are between the boxes.
    label = np.array([out, start[1] + LEVEL_PX * ((end[1] - start[1]) // (2 * LEVEL_PX))])
    lines = [str(edge), f"second parent of {edge.child}"]
    beside = label + np.array([0.29 * FONT_PX * max(map(len, lines)) + 8, 0])
    texts = [svg.text(beside + np.array([0, 20 * k - 10]), line, ORANGE, FONT_PX - 1) for k, line in enumerate(lines)]
    return [*_stroke(corners, ORANGE, 2.2, "--"), *texts]


def _stroke(points: Sequence[Array], colour: str, width: float, style: str = "-") -> list[str]:
    """A line through points with the head of an arrow at its end."""
    tip, along = points[-1], points[-1] - points[-2]
    along = along / np.linalg.norm(along)
    neck, across = tip - 11 * along, 5 * along[::-1] * (-1, 1)
    line = svg.polyline(np.array([*points[:-1], neck]), colour, width, style)
    return [line, svg.polygon(np.array([tip, neck + across, neck - across]), colour)]


def _describe(
    name: str, tree: Mapping[str, Edge], closing: Sequence[Edge], links: Sequence[str], path: Sequence[str]
) -> str:
    root = next(link for link in links if link not in tree)
    sentences = [f"Links and joints of {name}, with the root {root} at the top."]
    sentences += [f"From {edge.parent} by {edge} to {edge.child}." for edge in tree.values()]
    sentences += [
        f"Dashed: from {edge.parent} by {edge} to {edge.child}, which then has a second parent." for edge in closing
    ]
    if path:
        sentences.append(f"Bold: the path {', '.join(path)}.")
    return " ".join(sentences)
