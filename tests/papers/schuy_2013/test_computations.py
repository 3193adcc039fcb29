"""The computations by other routes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.papers.schuy_2013 import ideal_cylinder, prototype, rails, strength, stress_pattern, table_one
from varistiff.papers.schuy_2013.corrected_reading import prototype as reading
from varistiff.papers.schuy_2013.device import length_of_stiffness, stiffness, tube_of
from varistiff.sections import Circle, Square


def test_radius_of_the_ideal_cylinder_is_equation_4() -> None:
    closed = (2.0 * 350.0 * 0.01 / (math.pi * 0.387e9 * (1.0 - 0.5**4))) ** 0.25
    assert ideal_cylinder.outer_radius() == pytest.approx(closed, rel=1e-12)  # closed form


def test_length_of_stiffness_inverts_the_device() -> None:
    tube = tube_of(shear_modulus=0.6e9, section=Circle(radius=0.008), series_stiffness=800.0)
    at = length_of_stiffness(tube, wanted=120.0)
    assert stiffness(tube, active_length=at) == pytest.approx(120.0, rel=1e-9)  # two solves in double precision


def test_smallest_radius_carries_the_torque() -> None:
    radius = strength.smallest_radius(torque=7.0, allowed=13e6)
    assert 2.0 * 7.0 / (math.pi * radius**3) == pytest.approx(13e6, rel=1e-12)  # closed form


def test_active_length_is_equation_3() -> None:
    found = strength.active_length(radius=0.01, stiffness=90.0, shear_modulus=0.4e9)
    assert found == pytest.approx(0.4e9 * 0.5 * math.pi * 0.01**4 / 90.0, rel=1e-9)  # two solves in double precision


def test_utilisation_of_the_solid_circle() -> None:
    """Stress grows with the radius: the mean square is half the largest square."""
    assert stress_pattern.utilisation(section="circle") == pytest.approx(0.5, rel=1e-12)  # closed form


@pytest.mark.parametrize("reach", [0.9, stress_pattern.CORNER_REACH])
def test_edge_share_of_the_square_by_its_series(reach: float) -> None:
    """Timoshenko and Goodier, Theory of Elasticity, art. 109: Prandtl's function of the rectangle as a series."""
    a = 0.5 * 0.0141  # half the side
    x = y = reach * a
    n = np.arange(1, 400, 2)
    sign = (-1.0) ** ((n - 1) // 2)
    k = n * math.pi / (2.0 * a)

    def ratios(y: float) -> tuple[np.ndarray, np.ndarray]:
        """cosh and sinh of k y over cosh of k a, without overflow."""
        scale = np.exp(k * (abs(y) - a)) / (1.0 + np.exp(-2.0 * k * a))
        return scale * (1.0 + np.exp(-2.0 * k * abs(y))), np.sign(y) * scale * (1.0 - np.exp(-2.0 * k * abs(y)))

    def stress(x: float, y: float) -> float:
        cosh, sinh = ratios(y)
        factor = 16.0 * a / math.pi**2
        tau_xz = -factor * np.sum(sign / n**2 * sinh * np.cos(k * x))
        tau_yz = factor * np.sum(sign / n**2 * (1.0 - cosh) * np.sin(k * x))
        return math.hypot(float(tau_xz), float(tau_yz))

    share = stress(x, y) / stress(a, 0.0)
    assert stress_pattern.edge_share(section="square", reach=reach) == pytest.approx(
        share, rel=0.01
    )  # of 400 terms near a corner


@pytest.mark.parametrize("name", ["hexagon", "octagon"])  # a right angle has a logarithm; the series covers it
def test_a_corner_itself_is_free_of_stress(name: str) -> None:
    """With the interior angle beta the stress goes with the distance to the power pi/beta - 1."""
    near, nearer = (stress_pattern.edge_share(section=name, reach=reach) for reach in (0.99, 0.995))
    power = math.pi / (math.pi - 2.0 * math.pi / table_one.CORNERS[name]) - 1.0
    assert nearer / near == pytest.approx(0.5**power, rel=0.05)  # a hundredth of the size is not yet the limit


def test_larger_rails_stiffen_more() -> None:
    """A section that contains another has the larger J."""
    factors = [rails.section_factor(width=width, height=height) for width, height in ((3e-3, 1e-3), (4e-3, 2e-3))]
    assert 1.0 < factors[0] < factors[1]


def test_height_of_factor_inverts_the_section() -> None:
    height = rails.height_of_factor(width=0.008, factor=1.4)
    assert rails.section_factor(width=0.008, height=height) == pytest.approx(1.4, rel=1e-6)  # of the root's tolerance


def test_statics_follow_from_the_least_energy() -> None:
    """Pendulum and spring at rest: their energy has no slope, which is Eq. (9) with the device's stiffness."""
    tube, drive, weight = reading(), 0.5, 4.0  # rad, N m
    link = 0.5
    for _ in range(50):  # fixed point; the spring is much the stiffer
        link = drive - weight * math.sin(link) / prototype.measured_stiffness(active_length=0.091)
    step = 1e-5

    def energy(link: float) -> float:
        return float(tube.energy(np.float64(drive - link), np.float64(0.091))) + weight * (1.0 - math.cos(link))

    slope = (energy(link + step) - energy(link - step)) / (2.0 * step)
    assert slope == pytest.approx(0.0, abs=1e-7 * weight)  # of the difference quotient
    found = prototype.stiffness_from_statics(gravity_torque=weight * math.sin(link), drive_angle=drive, link_angle=link)
    assert found == pytest.approx(prototype.measured_stiffness(active_length=0.091), rel=1e-9)  # converged


def test_printed_equation_6_is_larger_than_the_square_needs() -> None:
    wide = table_one.across_flats_as_printed(section="square")
    device = tube_of(shear_modulus=0.68e9, section=Square(across_flats=wide))
    assert stiffness(device, active_length=0.01) == pytest.approx(700.0, rel=0.004)  # c_g is printed to three digits
