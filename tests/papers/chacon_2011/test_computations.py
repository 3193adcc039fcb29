"""Computations of the board for Chacon et al. (2011), by other routes; inputs; signs that turn claims red."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.actuators.antagonistic_leaves import aspect_ratio
from varistiff.characteristic.evaluate import Points, evaluate
from varistiff.papers.chacon_2011 import devices, mechanism, paper_values, protection, shapes, stiffness
from varistiff.papers.chacon_2011.leaf_variants import LinearBeam, PowerSpring
from varistiff.papers.claim import Role
from varistiff.papers.claims import load_claims
from varistiff.papers.finding import find
from varistiff.papers.verdict import Verdict

from .quadrature import derivative, guided_energy, guided_length, parameter, second_derivative

EI = 2.1e11 * 0.05 * 0.0005**3 / 12.0
HEIGHT = 0.0405
PRINTED = {
    "leaf_width": "LEAF_WIDTH",
    "leaf_thickness": "LEAF_THICKNESS",
    "youngs_modulus": "YOUNGS_MODULUS",
    "yield_stress": "YIELD_STRENGTH",
    "roller_distance": "ROLLER_DISTANCE",
    "clamp_height": "CLAMP_HEIGHT",
    "aspect_ratio_soft": "ASPECT_RATIO_SOFT",
    "aspect_ratio_stiff": "ASPECT_RATIO_STIFF",
    "protecting_radius": "PROTECTING_RADIUS",
    "variation_of_device": "STIFFNESS_VARIATION",
}


def test_constants_are_the_printed_numbers() -> None:
    claims = {claim.id: claim for claim in load_claims("chacon_2011")}
    for name, constant in PRINTED.items():
        claim = claims[name]
        assert isinstance(claim.published, str)
        assert float(claim.published) * claim.factor == pytest.approx(getattr(paper_values, constant), rel=1e-12)
    numbers = {name for name, claim in claims.items() if claim.role is Role.INPUT and claim.unit != "1"}
    assert numbers <= set(PRINTED)


def test_nut_distance_is_the_aspect_ratio_solved_for() -> None:
    for ratio in (3.5, 2.0, 2.6):
        back = aspect_ratio(float(devices.nut_distance(ratio)), roller_distance=0.345, clamp_height=HEIGHT)
        assert back == pytest.approx(ratio, rel=1e-14)
    # by hand: 345 - 2 * 40.5 * 3.5 and 345 - 2 * 40.5 * 2
    assert mechanism.nut_distances() == pytest.approx((0.0615, 0.183), rel=1e-12)


def test_prototype_by_quadrature() -> None:
    unit = EI / HEIGHT**3
    for number, ratio in zip(stiffness.rest_stiffness(theory="guided"), (3.5, 2.0), strict=True):
        assert number == pytest.approx(4.0 * unit * second_derivative(ratio), rel=1e-6)  # of the differences
    for number, ratio in zip(stiffness.force_at(theory="guided", displacement=0.01), (3.5, 2.0), strict=True):
        ends = derivative(ratio + 0.01 / HEIGHT) - derivative(ratio - 0.01 / HEIGHT)
        assert number == pytest.approx(2.0 * EI / HEIGHT**2 * ends, rel=1e-6)
    assert shapes.energy_ratio() == pytest.approx(guided_energy(2.0) / guided_energy(3.5), rel=1e-10)
    lengths = (guided_length(2.0) * HEIGHT, guided_length(3.5) * HEIGHT)
    assert shapes.free_length() == pytest.approx(lengths, rel=1e-10)
    slopes = tuple(float(np.arcsin(parameter(ratio) / 4.0)) for ratio in (3.5, 2.0))
    assert shapes.steepest_slopes() == pytest.approx(slopes, rel=1e-10)


def test_stretching_and_shear_are_below_their_bound() -> None:
    # the transverse force P = 2 a EI along and across the leaf, integrated at the aspect ratio 2.0
    from .quadrature import U, W

    q, span = parameter(2.0), 2.0 * HEIGHT
    sine = q * (U - U**2)
    force = 2.0 * q / span**2 * EI
    step = span * W / np.sqrt(1.0 - sine**2)
    area, poisson = 0.05 * 0.0005, 0.3
    along = 0.5 * force**2 / (2.1e11 * area) * (step @ sine**2)
    across = 0.5 * 1.2 * force**2 * 2.0 * (1.0 + poisson) / (2.1e11 * area) * (step @ (1.0 - sine**2))
    share = (along + across) / (guided_energy(2.0) * EI / HEIGHT)
    bound = 0.01 - shapes.bending_margin(allowed=0.01)
    assert 0.2 * bound < share < bound


@pytest.mark.parametrize("theory", ["sliding", "wrapped"])
def test_exact_shapes_are_within_a_fifth_of_a_millimetre(theory: devices.Theory) -> None:
    assert 1e-4 < shapes.difference(theory=theory) < 2e-4


def test_leaf_ends_on_the_cylinder_at_the_yield_stress() -> None:
    # Eq. (3) by hand: 2.1e11 * 0.5e-3/(2 * 1.5e9)
    assert protection.radius() == pytest.approx(0.035, rel=1e-14)
    assert protection.largest_stress() == pytest.approx(1.5e9, rel=1e-12)


@pytest.mark.parametrize(
    "law", [LinearBeam(), PowerSpring(rate=3.0e5, exponent=3.0, free_span=0.2)], ids=["linear beam", "power spring"]
)
def test_loads_of_other_springs_are_derivatives_of_their_energy(law: Any) -> None:
    span, rise, step = jnp.asarray([0.06, 0.11]), jnp.asarray(0.03), 1e-4
    u = [np.asarray(law.energy(devices.leaf(), span + i * step, rise)) for i in (-2, -1, 0, 1, 2)]
    state = law.respond(devices.leaf(), span, rise)
    np.testing.assert_allclose(state.energy, u[2], rtol=1e-14)
    np.testing.assert_allclose(state.force, (u[0] - 8 * u[1] + 8 * u[3] - u[4]) / (12 * step), rtol=1e-6)
    np.testing.assert_allclose(
        state.stiffness, (-u[0] + 16 * u[1] - 30 * u[2] + 16 * u[3] - u[4]) / (12 * step**2), rtol=1e-5
    )
    curve = law.centreline(devices.leaf(), 0.06, 0.03)
    np.testing.assert_allclose(curve[[0, -1]], [[0.0, 0.0], [0.06, 0.03]], atol=1e-15)


def test_linear_beam_is_the_limit_of_flat_leaves() -> None:
    for other in ("guided", "sliding"):
        flat, linear = (devices.states(name, 0.0, 4.2).stiffness for name in (other, "linear"))
        assert float(flat / linear) == pytest.approx(1.0, abs=0.25)
    spring = devices.device(devices.law("guided"))
    low = dataclasses.replace(spring, clamp_height=1e-4)
    straight = dataclasses.replace(devices.device(LinearBeam()), clamp_height=1e-4)
    flat, linear = (float(evaluate(one, 0.0, 0.1).stiffness) for one in (low, straight))
    assert flat == pytest.approx(linear, rel=1e-5)  # square of the slope, 1e-3


def _flipped(name: str) -> Callable[..., Points]:
    def wrong(*arguments: Any) -> Points:
        found = evaluate(*arguments)
        return dataclasses.replace(found, **{name: -getattr(found, name)})

    return wrong


@pytest.mark.parametrize("name", ["energy", "load", "stiffness", "adjusting_load"])
def test_a_wrong_sign_turns_claims_red(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    stiffness.elastic_variation.cache_clear()
    monkeypatch.setattr(devices, "evaluate", _flipped(name))
    verdicts = [find("chacon_2011", claim).verdict for claim in load_claims("chacon_2011")]
    stiffness.elastic_variation.cache_clear()
    assert Verdict.UNEXPECTED in verdicts
