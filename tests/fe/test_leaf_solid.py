"""The solid leaf itself: exact solutions, limits, energy, refinement."""

from __future__ import annotations

import math

import numpy as np
import pytest

pytest.importorskip("ngsolve")

from varistiff.core.errors import InputError
from varistiff.fe.leaf_problem import LeafProblem, LeafResult, Motion, SlidingContact, TurnedEnd, UprightContact
from varistiff.fe.leaf_solve import solve

STEEL, WIDTH, THICKNESS = 194e9, 0.02545, 0.00316
RIGIDITY = STEEL * WIDTH * THICKNESS**3 / 12.0


def leaf(hold: object, *, poissons_ratio: float = 0.0, **more: object) -> LeafProblem:
    return LeafProblem(STEEL, poissons_ratio, WIDTH, THICKNESS, hold, **more)


def swing(angle: float, poissons_ratio: float = 0.0, radius: float = 0.0) -> LeafProblem:
    """A roller on a link about the clamp, 0.3 m long; the load is the moment about the clamp."""
    x, y = 0.3 * math.cos(angle), 0.3 * math.sin(angle)
    motion = Motion(rate=(-y, x), acceleration=(-x, -y))
    return leaf(SlidingContact((x, y), radius), poissons_ratio=poissons_ratio, tail=0.02, motion=motion)


@pytest.mark.parametrize("angle", [0.5, -1.5])
def test_an_end_moment_bends_a_plain_leaf_to_an_arc(angle: float) -> None:
    """E I angle/length and a circle, up to (h/R)^2 = 5e-4 at the tighter one; half the width of the strip is exact."""
    length = 0.2
    result = solve(leaf(TurnedEnd(angle), length=length))
    curved = (THICKNESS * angle / length) ** 2
    assert result.load == pytest.approx(RIGIDITY * angle / length, rel=curved)
    assert result.stiffness == pytest.approx(RIGIDITY / length, rel=3.0 * curved)
    assert result.energy == pytest.approx(0.5 * RIGIDITY * angle**2 / length, rel=curved)
    turn = angle * result.arc / length
    circle = np.stack([np.sin(turn), 1.0 - np.cos(turn)], axis=1) * length / angle
    for column in result.points[:, :, :2].transpose(1, 0, 2):
        np.testing.assert_allclose(column, circle, atol=2e-4 * length)
    assert result.stress == pytest.approx(0.5 * STEEL * THICKNESS * abs(angle) / length, rel=2.0 * math.sqrt(curved))


def test_a_small_deflection_is_the_linear_beam() -> None:
    """3 E I w/L^3 less shear, 0.6 (h/L)^2 for G = E/2 and a force spread over the section."""
    length, rise = 0.05, 1e-6
    result = solve(leaf(SlidingContact((length, rise))))
    expected = 3.0 * RIGIDITY * rise / length**3
    assert result.load == pytest.approx(expected * (1.0 - 0.6 * (THICKNESS / length) ** 2), rel=1e-4)
    assert result.stiffness == pytest.approx(expected / rise, rel=4e-3)
    assert result.contact_slope == pytest.approx(1.5 * rise / length, rel=3e-3)
    assert result.arc_length == pytest.approx(length, rel=1e-6)


def test_work_of_the_load_is_the_energy() -> None:
    """Gauss quadrature of the load over the deflection; the mesh is another at every point, so 1e-4."""
    low, high = 0.2, 0.4
    nodes, weights = np.polynomial.legendre.leggauss(3)
    angles = 0.5 * (low + high) + 0.5 * (high - low) * nodes
    work = sum(weight * solve(swing(angle)).load for angle, weight in zip(angles, weights, strict=True))
    stored = solve(swing(high)).energy - solve(swing(low)).energy
    assert 0.5 * (high - low) * work == pytest.approx(stored, rel=1e-4)


@pytest.mark.parametrize("radius", [-0.002, 0.02])
def test_stiffness_is_the_derivative_of_the_load(radius: float) -> None:
    step = 1e-3
    low, middle, high = (solve(swing(0.3 + change, radius=radius)) for change in (-step, 0.0, step))
    assert middle.stiffness == pytest.approx((high.load - low.load) / (2.0 * step), rel=2e-3)


@pytest.fixture(scope="module")
def wide() -> LeafResult:
    """A wide leaf with a third of Poisson's ratio, to a small error."""
    return solve(swing(0.3, poissons_ratio=0.3), tolerance=1e-3)


def test_refinement_converges(wide: LeafResult) -> None:
    coarse, fine = wide.level_loads[:2]
    assert wide.error == pytest.approx(abs(fine - coarse) / fine)
    assert wide.error < 5e-4
    assert wide.unknowns > 3000


def test_plate_effect_stays_in_its_bounds(wide: LeafResult) -> None:
    plain = solve(swing(0.3)).load
    assert plain < wide.load < plain / (1.0 - 0.3**2)


def test_mid_plane_and_stress_for_pictures(wide: LeafResult) -> None:
    count, width = wide.arc.size, wide.across.size
    assert wide.points.shape == (count, width, 3)
    assert wide.stress_upper.shape == wide.stress_lower.shape == (count, width)
    np.testing.assert_allclose(wide.points[:, ::-1, 2], -wide.points[:, :, 2], atol=1e-12)
    # pushed up: compressed above, stretched below, and nothing in the free end
    assert wide.stress_upper[2, width // 2] < 0.0 < wide.stress_lower[2, width // 2]
    assert abs(wide.stress_lower[-1, width // 2]) < 1e-3 * wide.stress
    edge = np.abs(wide.points[:, 0, 1] - wide.points[:, width // 2, 1])
    assert edge.max() > 1e-6  # anticlastic
    contact = int(np.argmin(np.abs(wide.arc - wide.arc_length)))
    np.testing.assert_allclose(wide.points[contact, :, 0], 0.3 * math.cos(0.3), atol=3e-3)


def test_past_a_right_angle() -> None:
    """Slope 125 degrees at the contact: the horizontal force has turned round."""
    from varistiff.elastic.roller_contact import roller_contact

    problem = LeafProblem(200e9, 0.0, 0.02, 0.0005, SlidingContact((0.02, 0.12)), motion=Motion((1.0, 0.0)))
    beam = roller_contact(*map(np.asarray, (0.02, 0.12, 0.0)), np.asarray(problem.flexural_rigidity))
    result = solve(problem)
    assert result.contact_slope == pytest.approx(float(beam.slope), rel=1e-3)
    assert result.contact_force == pytest.approx(float(beam.force), rel=1e-3)
    assert result.arc_length == pytest.approx(float(beam.arc_length), rel=1e-4)


def test_upright_contact_is_the_gradient_of_its_energy() -> None:
    """Without a potential of its own in the contact, the load must come out of the energy."""
    step = 1e-4

    def problem(x: float) -> LeafProblem:
        return LeafProblem(210e9, 0.0, 0.05, 0.0005, UprightContact((x, 0.02025)), motion=Motion(rate=(1.0, 0.0)))

    low, middle, high = (solve(problem(0.05 + change)) for change in (-step, 0.0, step))
    assert middle.load == pytest.approx((high.energy - low.energy) / (2.0 * step), rel=2e-3)
    assert middle.stiffness == pytest.approx((high.load - low.load) / (2.0 * step), rel=5e-3)


@pytest.mark.parametrize(
    "build, field, words",
    [
        (lambda: LeafProblem(0.0, 0.3, 0.01, 0.001, TurnedEnd(0.1), length=0.1), "youngs_modulus", "positive"),
        (lambda: LeafProblem(1e9, 0.5, 0.01, 0.001, TurnedEnd(0.1), length=0.1), "poissons_ratio", "nu < 0.5"),
        (lambda: LeafProblem(1e9, 0.3, 0.01, 0.001, TurnedEnd(0.1)), "length", "finite"),
        (lambda: LeafProblem(1e9, 0.3, 0.01, 0.001, SlidingContact((0.1, 0.1)), tail=math.inf), "tail", "finite"),
        (lambda: LeafProblem(1e9, 0.3, 0.01, 0.001, UprightContact((0.1, 0.0))), "centre", "positive"),
        (lambda: solve(leaf(SlidingContact((0.1, -0.01)))), "leaf", "does not touch"),
        (lambda: solve(leaf(SlidingContact((-0.1, 0.1)))), "leaf", "slips off"),
        (lambda: solve(leaf(TurnedEnd(0.1), length=0.1), tolerance=0.0), "tolerance", "allowed"),
        (lambda: solve(leaf(TurnedEnd(0.0), length=0.1)), "angle", "not 0"),
    ],
)
def test_refusals_are_one_clear_line(build: object, field: str, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        build()
    assert caught.value.field == field
    assert "\n" not in str(caught.value)
