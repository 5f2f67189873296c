"""The six relations of two axes: each picture shows, and describes, the relation that its axes have."""

import numpy as np

from kinlib.view import draw_axis_relations
from kinlib.view.figures.axis_relations import SECOND_AXES

X, Y, Z = np.eye(3)


def test_the_gallery_has_a_picture_of_each_relation_with_its_own_description():
    gallery = draw_axis_relations()
    names = [picture.caption.partition(":")[0] for picture in gallery.pictures]
    assert names == ["skew", "intersecting", "parallel", "antiparallel", "coincident", "coincident, opposite"]
    assert len({picture.alt for picture in gallery.pictures}) == len(SECOND_AXES)
    assert gallery.html().count("<figure") == len(SECOND_AXES)
