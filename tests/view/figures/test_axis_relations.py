"""The six relations of two axes: each picture shows, and describes, the relation that its axes have."""

import numpy as np
import pytest

from kinlib.view import draw_axis_relation, draw_axis_relations
from kinlib.view.figures.axis_relations import SECOND_AXES

X, Y, Z = np.eye(3)


def test_the_gallery_has_a_picture_of_each_relation_with_its_own_description():
    gallery = draw_axis_relations()
    names = [picture.caption.partition(":")[0] for picture in gallery.pictures]
    assert names == ["skew", "intersecting", "parallel", "antiparallel", "coincident", "coincident, opposite"]
    assert len({picture.alt for picture in gallery.pictures}) == len(SECOND_AXES)
    assert gallery.html().count("<figure") == len(SECOND_AXES)


@pytest.mark.parametrize(("direction", "relation"), [(Z, "parallel"), (-Z, "antiparallel"), (Y, "skew")])
def test_parallel_axes_have_more_than_one_normal(direction, relation):
    picture = draw_axis_relation((Z, 0 * Z), (direction, X))
    assert picture.caption.startswith(f"{relation}:")
    dotted = picture.svg.count('stroke-dasharray="1.5 3.5"')
    assert dotted == (0 if relation == "skew" else 3)
