"""The device of four leaves: signs, symmetry, statuses, the paper's numbers."""

from __future__ import annotations

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq

from varistiff.actuators.actuator import Response
from varistiff.actuators.antagonistic_leaves import (
    AntagonisticLeaves,
    aspect_ratio,
    protecting_radius,
    screw_turns,
)
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafLaw
from varistiff.elastic.sliding_leaf import SlidingLeaf
from varistiff.elastic.wrapped_leaf import WrappedLeaf

LEAF = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005, yield_strength=1.5e9)
DISTANCE, HEIGHT = 0.345, 0.0405
LAWS = [GuidedLeaf(), SlidingLeaf(), WrappedLeaf(protecting_radius(LEAF))]
EACH_LAW = pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)


def spring(law: LeafLaw, leaf: Leaf = LEAF, scale: float = 1.0) -> AntagonisticLeaves:
    return AntagonisticLeaves(leaf=leaf, law=law, roller_distance=DISTANCE * scale, clamp_height=HEIGHT * scale)


@jax.jit
def compiled(device: AntagonisticLeaves, d: jax.Array, s: jax.Array) -> tuple[Response, dict[str, jax.Array]]:
    return device.respond(d, s)


def respond(device: AntagonisticLeaves, deflection: object, setting: object) -> tuple[Response, np.ndarray]:
    """Response and leaf length needed, in one batch of a fixed size: compiled once a law."""
    d, s = np.broadcast_arrays(np.asarray(deflection, float), np.asarray(setting, float))
    batch = np.zeros((2, 256)) + np.array([[0.0], [0.1]])
    batch[:, : d.size] = d.ravel(), s.ravel()
    response, details = compiled(device, *jnp.asarray(batch))
    short = [np.asarray(v)[: d.size].reshape(d.shape) for v in (*response, details["leaf_length_needed"])]
    return Response(*short[:-1]), short[-1]


def status_of(device: AntagonisticLeaves, deflection: float, setting: float) -> Status:
    return Status(int(respond(device, deflection, setting)[0].status))


def test_turns_of_the_screw_are_reported_with_its_lead() -> None:
    device = AntagonisticLeaves(
        leaf=LEAF, law=SlidingLeaf(), roller_distance=DISTANCE, clamp_height=HEIGHT, screw_lead=0.002
    )
    turns = device.respond(jnp.asarray(0.001), jnp.asarray(0.1))[1]["screw_turns"]
    assert float(turns) == pytest.approx(25.0)  # each turn moves both nuts by the lead: 0.1/(2 * 0.002)
    assert "screw_turns" not in spring(SlidingLeaf()).respond(jnp.asarray(0.001), jnp.asarray(0.1))[1]


@EACH_LAW
def test_loads_are_derivatives_of_the_energy(law: LeafLaw) -> None:
    device = spring(law)
    d, s = np.array([0.0, 0.004, -0.011, 0.0135]), np.array([0.17, 0.1203, 0.0777, 0.15])
    h = 2e-4  # fourth-order differences: relative error about 1e-7
    weights = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / (12.0 * h)
    curve = np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) / (12.0 * h**2)
    offsets = h * np.arange(-2, 3)[:, None]
    by_deflection = respond(device, d + offsets, s)[0].energy
    by_setting = respond(device, d, s + offsets)[0].energy
    response, _ = respond(device, d, s)
    np.testing.assert_allclose(response.load, weights @ by_deflection, rtol=2e-5, atol=1e-8)
    np.testing.assert_allclose(response.adjusting_load, weights @ by_setting, rtol=2e-5)
    np.testing.assert_allclose(response.stiffness, curve @ by_deflection, rtol=2e-4)
    energy = jax.jit(device.energy)(jnp.asarray(d), jnp.asarray(s))
    np.testing.assert_allclose(response.energy, energy, rtol=1e-14)
    assert np.all(np.asarray(response.load[1:]) * d[1:] > 0.0)
    assert np.all(np.asarray(response.adjusting_load) > 0.0)  # the leaves press the nuts together


@EACH_LAW
def test_left_and_right_are_mirror_images(law: LeafLaw) -> None:
    d, s = np.array([0.003, 0.009, 0.014]), np.array([0.065, 0.11, 0.165])
    there, back = respond(spring(law), d, s)[0], respond(spring(law), -d, s)[0]
    for name in ("energy", "stiffness", "adjusting_load", "stress"):
        np.testing.assert_array_equal(getattr(there, name), getattr(back, name))
    np.testing.assert_array_equal(there.load, -np.asarray(back.load))


@EACH_LAW
def test_similar_devices_have_similar_answers(law: LeafLaw) -> None:
    scale, stiffer, wider = 1.7, 0.31, 2.3
    big_leaf = Leaf(youngs_modulus=210e9 * stiffer, width=0.05 * wider * scale, thickness=0.0005 * scale)
    big_law = WrappedLeaf(0.035 * scale) if isinstance(law, WrappedLeaf) else law
    d, s = np.array([0.0035, -0.012]), np.array([0.1, 0.16])
    small, big = respond(spring(law), d, s), respond(spring(big_law, big_leaf, scale), d * scale, s * scale)
    factor = stiffer * wider * scale**3
    np.testing.assert_allclose(big[0].energy, factor * np.asarray(small[0].energy), rtol=1e-12)
    np.testing.assert_allclose(big[0].load, factor / scale * np.asarray(small[0].load), rtol=1e-12)
    np.testing.assert_allclose(big[0].stiffness, factor / scale**2 * np.asarray(small[0].stiffness), rtol=1e-12)
    np.testing.assert_allclose(big[0].stress, stiffer * np.asarray(small[0].stress), rtol=1e-12)
    np.testing.assert_allclose(big[1], scale * small[1], rtol=1e-12)


@pytest.mark.parametrize(
    ("law", "ratio", "fifteenfold"),
    [(LAWS[0], 10.39, 1.808), (LAWS[1], 10.28, 1.800), (LAWS[2], 10.78, 1.919)],
    ids=["guided", "sliding", "wrapped"],
)
def test_printed_stiffness_variation_is_not_reached_at_rest(law: LeafLaw, ratio: float, fifteenfold: float) -> None:
    def stiffness(alpha: float) -> float:
        return float(respond(spring(law), 0.0, DISTANCE - 2.0 * HEIGHT * alpha)[0].stiffness)

    assert stiffness(2.0) / stiffness(3.5) == pytest.approx(ratio, abs=0.01)
    at = brentq(lambda alpha: stiffness(alpha) - 15.0 * stiffness(3.5), 1.7, 2.0)
    assert at == pytest.approx(fifteenfold, abs=1e-3)
    linear = (3.5 / 2.0) ** 5  # stiffness 4 * 72 EI y^2/x^5 of linear beams
    assert linear == pytest.approx(16.4, abs=0.05)
    assert ratio < linear


def test_printed_geometry_and_radius() -> None:
    assert aspect_ratio(0.0615, roller_distance=DISTANCE, clamp_height=HEIGHT) == pytest.approx(3.5, rel=1e-12)
    assert aspect_ratio(0.183, roller_distance=DISTANCE, clamp_height=HEIGHT) == pytest.approx(2.0, rel=1e-12)
    assert protecting_radius(LEAF) == pytest.approx(0.035, rel=1e-14)
    assert protecting_radius(Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)) == 0.0
    assert screw_turns(0.1, 0.112, lead=0.003) == pytest.approx(2.0)
    assert screw_turns(0.112, 0.1, lead=0.003) == pytest.approx(-2.0)
    with pytest.raises(InputError, match="positive"):
        screw_turns(0.1, 0.2, lead=0.0)


@pytest.mark.parametrize(("law", "alpha"), [(LAWS[0], 2.1075), (LAWS[1], 2.0258)], ids=["guided", "sliding"])
def test_leaf_yields_before_the_stiffest_published_setting(law: LeafLaw, alpha: float) -> None:
    def setting(a: float) -> float:
        return DISTANCE - 2.0 * HEIGHT * a

    assert status_of(spring(law), 0.0, setting(alpha + 1e-3)) is Status.OK
    assert status_of(spring(law), 0.0, setting(alpha - 1e-3)) is Status.YIELDED
    # a displacement tightens one pair
    assert status_of(spring(law), 0.001, setting(alpha + 1e-3)) is Status.YIELDED
    endless = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
    assert status_of(spring(law, endless), 0.0, setting(alpha - 1e-3)) is Status.OK


@pytest.mark.parametrize("yield_strength", [1.5e9, 1.37e9, 1.1e9 / 3.0, 987654321.0])
def test_protecting_cylinder_keeps_the_leaf_from_yielding(yield_strength: float) -> None:
    leaf = Leaf(youngs_modulus=205e9, width=0.05, thickness=0.00047, yield_strength=yield_strength)
    radius = protecting_radius(leaf)
    hard_stop = 0.5 * math.sqrt(HEIGHT * (4.0 * radius - HEIGHT))
    s = DISTANCE - 4.0 * hard_stop * np.linspace(1.001, 1.4, 30)
    s = s[s > 0.0]
    response, _ = respond(spring(WrappedLeaf(radius), leaf), 0.0, s)
    assert np.max(response.stress) == pytest.approx(yield_strength, rel=1e-13)
    assert set(np.asarray(response.status).tolist()) == {int(Status.OK)}
    tighter, _ = respond(spring(WrappedLeaf(0.999 * radius), leaf), 0.0, s[:1])
    assert int(tighter.status[0]) == Status.YIELDED


@EACH_LAW
def test_no_solution_by_geometry(law: LeafLaw) -> None:
    # spans (D - delta)/2 -/+ d of both pairs, nut distance, and for cylinders the span where their arcs meet
    d, s = np.meshgrid(np.linspace(-0.17, 0.17, 35), np.array([-0.02, 0.0, 0.01, 0.1, 0.3, 0.345, 0.4]))
    shortest = 0.5 * (DISTANCE - s) - np.abs(d)
    radius = law.protection_radius if isinstance(law, WrappedLeaf) else HEIGHT / 4.0
    expected = (s <= 0.0) | (shortest <= 1e-12) | (shortest < math.sqrt(HEIGHT * (4.0 * radius - HEIGHT)))
    response, length = respond(spring(law), d, s)
    np.testing.assert_array_equal(np.asarray(response.status) == Status.NO_SOLUTION, expected)
    for value in (*response[1:], length):
        np.testing.assert_array_equal(np.isnan(value), expected)


def test_element_too_short_by_the_longest_leaf() -> None:
    long, d, s = spring(SlidingLeaf()), 0.012, 0.1
    needed = float(respond(long, d, s)[1])
    curve = max((np.hypot(*np.diff(c, axis=0).T).sum() for c in long.element_shapes(d, s)), default=0.0)
    assert needed == pytest.approx(curve, rel=1e-4)
    for length, status in ((needed * (1.0 + 1e-9), Status.OK), (needed * (1.0 - 1e-9), Status.ELEMENT_TOO_SHORT)):
        leaf = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005, length=length)
        response, detail = respond(spring(SlidingLeaf(), leaf), d, s)
        assert int(response.status) == status
        assert np.isnan(detail) == (status is Status.ELEMENT_TOO_SHORT)


def test_cylinders_too_small_are_outside_validity() -> None:
    # below R = y_f/4 nothing holds the overhanging leaf: decided by the sliding leaf's own largest curvature
    radius = 0.21 * HEIGHT
    s = DISTANCE - 2.0 * HEIGHT * np.array([0.1, 0.2, 0.9, 2.1])
    endless = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
    free, _ = respond(spring(SlidingLeaf(), endless), 0.0, s)
    small, _ = respond(spring(WrappedLeaf(radius), endless), 0.0, s)
    tight = np.asarray(free.stress) > 0.5 * 210e9 * 0.0005 / radius
    assert tight.tolist() == [True, True, False, False]
    np.testing.assert_array_equal(np.asarray(small.status) == Status.OUTSIDE_VALIDITY, tight)
    np.testing.assert_allclose(small.stiffness, free.stiffness, rtol=1e-13)


def test_negative_stiffness_is_reported_with_its_numbers() -> None:
    endless = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
    response, _ = respond(spring(SlidingLeaf(), endless), 0.0, DISTANCE - 2.0 * HEIGHT * 0.2)
    assert int(response.status) == Status.OK
    assert float(response.stiffness) < 0.0


@EACH_LAW
def test_drawn_leaves_hang_between_rollers_and_nuts(law: LeafLaw) -> None:
    d, s = 0.007, 0.11
    shapes = spring(law).element_shapes(d, s)
    rollers = [curve[0].tolist() for curve in shapes]
    clamps = [curve[-1].tolist() for curve in shapes]
    left, right = d - DISTANCE / 2.0, d + DISTANCE / 2.0
    expected = [[left, HEIGHT], [left, -HEIGHT], [right, HEIGHT], [right, -HEIGHT]]
    np.testing.assert_allclose(rollers, expected, atol=1e-15)
    nuts = [[-s / 2.0, 0.0], [-s / 2.0, 0.0], [s / 2.0, 0.0], [s / 2.0, 0.0]]
    np.testing.assert_allclose(clamps, nuts, atol=1e-15)
    spans = [abs(c[-1, 0] - c[0, 0]) for c in shapes]
    assert spans[0] == pytest.approx(0.5 * (DISTANCE - s) - d)  # d > 0 shortens the left pair
    with pytest.raises(InputError, match="nut distance"):
        spring(law).element_shapes(d, -0.1)
