"""What the fillet, the rails and the bore do to a splined tube."""

from __future__ import annotations

import math

import pytest

from varistiff.sections import HollowCircle, SplinedTube

from .shapes import SPLINED

ROOT = 1.5 * math.pi - math.asin(0.002 / 0.011)  # angle inside the material between a rail's side and the tube


def tube(**changes: float) -> SplinedTube:
    return SplinedTube(**(SPLINED | changes))


def test_constant_goes_to_the_sharp_one_with_the_fillet() -> None:
    """J falls to the sharp value: the area r^2 times the stress squared, which goes with r^(2 pi/ROOT - 2)."""
    sharp = tube().torsion_constant
    excess = [tube(root_fillet=radius).torsion_constant / sharp - 1.0 for radius in (4e-4, 1e-4, 2.5e-5)]
    assert excess == sorted(excess, reverse=True)
    assert 0.0 < excess[-1] < 3e-4
    power = math.log(excess[1] / excess[2]) / math.log(4.0)
    assert power == pytest.approx(2.0 * math.pi / ROOT, rel=0.03)


def test_modulus_falls_with_the_fillet_and_is_zero_without() -> None:
    moduli = [tube(root_fillet=radius).torsion_modulus for radius in (1e-3, 4e-4, 1e-4, 2.5e-5)]
    assert moduli == sorted(moduli, reverse=True)
    assert moduli[-1] > 0.0
    assert tube().torsion_modulus == 0.0
    power = math.log(moduli[2] / moduli[3]) / math.log(4.0)
    assert power == pytest.approx(1.0 - math.pi / ROOT, rel=0.05)  # the stress of a sharp corner, cut off at r


def test_largest_stress_sits_in_the_fillet() -> None:
    section = tube(root_fillet=4e-4)
    for x, y in section.properties().stress_points:
        assert 0.011 < math.hypot(x, y) < 0.0115


def test_rails_shrunk_to_nothing_leave_the_tube() -> None:
    """The excess of J goes with the square of a small rail."""
    plain = HollowCircle(outer_radius=0.011, inner_radius=0.0087).torsion_constant
    excess = [tube(rail_width=2.0 * h, rail_height=h).torsion_constant / plain - 1.0 for h in (4e-4, 2e-4)]
    assert 0.0 < excess[1] < excess[0] < 0.05
    assert excess[0] / excess[1] == pytest.approx(4.0, rel=0.25)


def test_one_rail_moves_the_shear_centre_not_off_its_axis() -> None:
    """With two rails or more the symmetry holds it on the axis; one rail pulls it along its own line."""
    one = tube(rails=1).properties()
    assert abs(one.shear_centre[1]) < 1e-12
    assert one.centroid[0] > 1e-5
    assert tube(rails=2).properties().shear_centre == (0.0, 0.0)


def test_constant_grows_with_every_rail_and_with_its_size() -> None:
    for name, values in {
        "rails": (1, 3, 6),
        "rail_width": (0.002, 0.004, 0.006),
        "rail_height": (0.001, 0.0025, 0.004),
    }.items():
        found = [tube(**{name: value}).torsion_constant for value in values]
        assert found == sorted(found)


def test_solid_shaft_with_rails() -> None:
    """Without a bore; the rails add to the circle's J, less than their polar moment."""
    solid = tube(inner_radius=0.0)
    circle = 0.5 * math.pi * 0.011**4
    polar = sum(solid.properties().second_moments[:2])
    assert circle < solid.torsion_constant < polar
