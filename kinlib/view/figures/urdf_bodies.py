"""Bodies of the links of a URDF: the boxes, cylinders and spheres of its <visual> elements. No file that they name is opened."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.rpy import origin
from kinlib.urdf.xml_elements import Element
from kinlib.view.figures.bodies import Primitive, box, drum, tube


def visual_solids(link: Element, T: Array) -> list[Primitive]:
    """Return what a link shows, at the pose T of its frame; nothing of meshes, nor of elements that are not as they should be.

    >>> shape = Element("sphere", 3, {"radius": "0.1"})
    >>> link = Element("link", 1, {"name": "ball"}, None, [Element("visual", 2, {}, None, [Element("geometry", 2, {}, None, [shape])])])
    >>> [solid.kind for solid in visual_solids(link, np.eye(4))]
    ['tube']
    """
    found = []
    for visual in link.children:
        geometry = next((child for child in visual.children if child.tag == "geometry"), None)
        if visual.tag != "visual" or geometry is None:
            continue
        place = next((child for child in visual.children if child.tag == "origin"), None)
        for shape in geometry.children:
            try:
                values = (
                    {name: place.numbers(name, 3) for name in ("xyz", "rpy") if name in place.attributes}
                    if place
                    else {}
                )
                found += _solid(shape, T @ origin(**values))
            except ValueError:
                continue
    return found


def _solid(shape: Element, T: Array) -> list[Primitive]:
    at, z = T[:3, 3], T[:3, 2]
    if shape.tag == "box":
        return [box(at, np.array(shape.numbers("size", 3)) / 2, axes=T[:3, :3])]
    if shape.tag == "cylinder":
        (radius,), (length,) = shape.numbers("radius", 1), shape.numbers("length", 1)
        return [drum(z, at, radius, -length / 2, length / 2)]
    if shape.tag == "sphere":
        (radius,) = shape.numbers("radius", 1)
        return [tube([*(at - 1e-4 * radius * z), radius], [*(at + 1e-4 * radius * z), radius])]
    return []
