"""Shapes made of a few numbers: what the binding passes on. The bodies are checked in C++."""
from fractions import Fraction
import pickle

import numpy as np
import pytest

import ecods
from scenes import at, box


def test_boxes_and_prisms_are_exact():
    crate = ecods.box([1, 2, 3])
    assert isinstance(crate, ecods.ConvexSolid)
    assert sorted(map(tuple, crate.vertices)) == [(x, y, z) for x in (-0.5, 0.5) for y in (-1, 1) for z in (-1.5, 1.5)]
    roof = ecods.prism([[0, 0], [3, 0], [0, 1]], 4)
    assert ecods.distance(roof, crate.at(at(0, 0, 5))) == 1.5
    assert ecods.depth(crate, crate.at(at(0.75))).depth == 0.25


@pytest.mark.parametrize("made, radii", [
    (ecods.cylinder(0.3, 2, 11), (0.3, 0.3)),
    (ecods.cone(0.3, 2, 11), (0.3, 0.3)),
])
def test_polygons_are_around_their_circle(made, radii):
    bottom = [v for v in made.solid.vertices if v[2] == -1]
    bottom.sort(key=lambda v: np.arctan2(v[1], v[0]))
    assert len(bottom) == 11
    for p, q in zip(bottom, bottom[1:] + bottom[:1]):
        px, py, qx, qy = map(Fraction, (p[0], p[1], q[0], q[1]))
        assert (px * qy - py * qx)**2 >= Fraction(radii[0])**2 * ((px - qx)**2 + (py - qy)**2)
        assert px * px + py * py <= (Fraction(radii[0]) + Fraction(made.deviation))**2


def test_circumscribed_is_a_record():
    made = ecods.ellipsoid([1, 2, 3], 2)
    assert len(made.solid.vertices) == 162
    assert 0.05 < made.deviation < 0.06
    assert "deviation=0.05" in repr(made)
    copy = pickle.loads(pickle.dumps(made))
    assert copy.solid.digest == made.solid.digest and copy.deviation == made.deviation


def test_height_fields_and_clouds():
    heights = np.array([[0, 0, 0, 0], [0, 1, 2, 0], [0, 0, 0, 0.0]])
    surface = ecods.height_field(heights, [1, 2])
    assert surface.form == ecods.MeshForm.surface
    assert surface.vertices[6].tolist() == [2, 2, 2]
    hill = ecods.height_field(heights, [1, 2], -1)
    assert isinstance(hill, ecods.Solid)
    assert ecods.locate([2, 2, 1], hill).side == ecods.Side.inside
    assert not ecods.intersects(surface, ecods.box([0.25, 0.25, 0.25]).at(at(2, 2, 1)))
    cloud = ecods.point_cloud([[0, 0, 0], [0, 0, 3]])
    assert ecods.distance(cloud, ecods.box([2, 2, 2]).at(at(0, 0, 5))) == 1


def test_a_dent_has_a_depth_and_a_remedy():
    vertices, faces = box()
    vertices[5][2] += 2.0**-50
    with pytest.raises(ecods.NotSolid, match=r"ConvexSolid\.hull\(points\)") as caught:
        ecods.ConvexSolid(vertices, faces)
    assert caught.value.reason == ecods.NotSolidReason.dent
    assert caught.value.depth == 2.0**-50
    assert len(ecods.ConvexSolid.hull(vertices).vertices) == 8


def test_rows_that_are_not_aligned():
    numbers = np.zeros(9)
    rows = numbers[1:].reshape(4, 2)  # at an address that 16 does not divide
    rows[:] = [[0, 0], [1, 0], [1, 1], [0, 1]]
    assert ecods.prism(rows, 1).digest == ecods.prism([[0, 0], [1, 0], [1, 1], [0, 1]], 1).digest
