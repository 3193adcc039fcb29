"""The contact kernel where the battery does not go: extreme radii, the loop for hard points, distances, shapes."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import elliprd, elliprf

from varistiff.elastic import lemniscate
from varistiff.elastic.beam_clearance import beam_clearance
from varistiff.elastic.roller_contact import RollerContact, centreline, roller_contact

LEMNISCATE = 2.6220575542921198


def second_integral(t: np.ndarray) -> np.ndarray:
    bent = np.minimum(t, (math.pi - t) + 1.2246467991473532e-16)
    near = 2.0 / 3.0 * np.sin(bent) ** 1.5 * elliprd(1.0 - np.sin(bent), 1.0 + np.sin(bent), 1.0)
    return np.where(t > bent, 2.0 * math.pi / LEMNISCATE - near, near)


def centre_angle(t: np.ndarray, ratio: float) -> np.ndarray:
    gamma = np.arctan2(second_integral(t), 2.0 * np.sqrt(np.sin(t)))
    return t - gamma - np.arcsin(ratio * np.cos(gamma))


def solve(beta: np.ndarray, ratio: float) -> RollerContact:
    return roller_contact(jnp.cos(beta), jnp.sin(beta), jnp.full_like(beta, ratio), jnp.asarray(1.0))


@pytest.mark.parametrize("ratio", [-0.8, -0.5, -0.01, 0.0, 0.03, 0.4, 0.8, 0.95, 0.999])
def test_slope_inverts_the_closed_form_for_every_radius(ratio: float) -> None:
    t = math.pi * np.linspace(1e-4, 1.0 - 1e-4, 4000)
    beta = centre_angle(t, ratio)
    rising = slice(0, int(beta.argmax()))
    state = solve(jnp.asarray(beta[rising]), ratio)
    assert bool(jnp.all(state.touching & state.exists))
    # judged by the angle: near the fold a rounding of beta moves the slope by its square root
    back = centre_angle(np.asarray(state.slope), ratio)
    assert back == pytest.approx(beta[rising], abs=2e-13)  # roundings, those of SciPy's sine near 180 degrees
    assert (np.diff(np.asarray(state.slope)) > -1e-3).all()  # the same branch all along


@pytest.mark.parametrize("ratio", [-0.7, -0.2, 0.0, 0.2, 0.9])
def test_existence_ends_at_the_largest_angle(ratio: float) -> None:
    t = math.pi * np.linspace(0.5, 1.0 - 1e-9, 2_000_001)
    top = float(centre_angle(t, ratio).max())  # to 1e-12: the maximum is flat
    state = solve(jnp.asarray([top - 1e-9, top + 1e-9]), ratio)
    assert np.asarray(state.exists).tolist() == [True, False]


def test_a_roller_over_the_clamp_is_no_mechanism() -> None:
    state = roller_contact(*(jnp.asarray(v) for v in (0.01, 0.002, 0.0103, 1.0)))
    assert bool(state.touching)
    assert not bool(state.exists)


def test_polynomials_against_carlson() -> None:
    t = np.linspace(1e-6, math.pi - 1e-3, 1001)
    bent = np.minimum(t, (math.pi - t) + 1.2246467991473532e-16)
    first = 2.0 * np.sqrt(np.sin(bent)) * elliprf(1.0 - np.sin(bent), 1.0 + np.sin(bent), 1.0)
    first = np.where(t > bent, 2.0 * LEMNISCATE - first, first)
    terms = lemniscate.slope_terms(jnp.asarray(t))
    root = 2.0 * np.sqrt(np.sin(t))
    # a few roundings of SciPy's own sine near 180 degrees
    assert np.asarray(terms.length_ratio) == pytest.approx(first / root, rel=2e-13)
    assert np.asarray(terms.offset_ratio) == pytest.approx(second_integral(t) / root, rel=2e-13)
    assert np.asarray(terms.sine) == pytest.approx(np.sin(t), abs=4e-16)
    assert np.asarray(terms.cosine) == pytest.approx(np.cos(t), abs=4e-16)


def test_circular_functions_in_every_quadrant() -> None:
    angle = np.linspace(-30.0, 30.0, 20001)
    sine, cosine = lemniscate.circular(jnp.asarray(angle))
    assert np.asarray(sine) == pytest.approx(np.sin(angle), abs=1e-15)
    assert np.asarray(cosine) == pytest.approx(np.cos(angle), abs=1e-15)


@pytest.mark.parametrize(("x", "y", "radius"), [(0.4, 0.05, 0.012), (0.3, 0.35, 0.0), (0.05, 0.4, -0.002)])
def test_drawn_beam_ends_on_the_roller_along_its_tangent(x: float, y: float, radius: float) -> None:
    state = roller_contact(*(jnp.asarray(v) for v in (x, y, radius, 2.0)))
    slope, length = float(state.slope), float(state.arc_length)
    line = centreline(slope, length, points=201)
    contact = np.array([x - radius * math.sin(slope), y + radius * math.cos(slope)])
    assert line[-1] == pytest.approx(contact, abs=1e-12)  # Gauss quadrature with 12 nodes a piece
    assert np.hypot(*np.diff(line, axis=0).T).sum() == pytest.approx(length, rel=1e-5)  # chords of 200 pieces
    tail = centreline(slope, length, points=201, tail=0.1)
    assert np.hypot(*(tail[-1] - tail[-2])) == pytest.approx(0.1)


def test_distance_from_the_deformed_beam() -> None:
    x, y, radius, length = 0.25, 0.2, 0.01, 0.6
    state = roller_contact(*(jnp.asarray(v) for v in (x, y, radius, 2.0)))
    slope = float(state.slope)
    line = centreline(slope, float(state.arc_length), points=40001, tail=length - float(state.arc_length))
    tail = np.linspace(line[-2], line[-1], 20001)
    dense = np.concatenate([line[:-1], tail])
    tangent = np.array([math.cos(slope), math.sin(slope)])
    normal = np.array([-math.sin(slope), math.cos(slope)])
    contact = np.array([x, y]) + radius * normal
    reach = float(np.array([x, y]) @ tangent)
    rng = np.random.default_rng(3)
    for point in rng.uniform([-0.05, -0.1], [0.5, 0.5], (60, 2)):
        along, across = (point - contact) @ tangent, (point - contact) @ normal
        # left of the clamp's normal plane the nearest point is the clamp, and the sign has no meaning
        found = float(beam_clearance(state, *(jnp.asarray(v) for v in (reach, along, across)), jnp.asarray(length)))
        nearest = float(np.hypot(*(dense - point).T).min())
        assert abs(found) == pytest.approx(nearest, abs=2e-5)  # spacing of the samples
        if point[0] > 0.0 and along < length - float(state.arc_length):
            below = float(np.interp(point[0], dense[:, 0], dense[:, 1]))
            assert (found > 0.0) == (point[1] > below)
