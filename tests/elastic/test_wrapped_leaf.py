"""The leaf on its protection cylinders against closure by quadrature and a curvature-limited discrete rod."""

from __future__ import annotations

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq, fsolve, minimize

from varistiff.core.errors import InputError
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafState
from varistiff.elastic.sliding_leaf import SlidingLeaf
from varistiff.elastic.wrapped_leaf import WrappedLeaf

LEAF = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
EI = 210e9 * 0.05 * 0.0005**3 / 12.0
RISE, RADIUS = 0.0405, 0.035
LAW = WrappedLeaf(RADIUS)
STOP = math.sqrt(RISE * (4.0 * RADIUS - RISE))


@jax.jit
def compiled(law: WrappedLeaf | SlidingLeaf, span: jax.Array) -> LeafState:
    return law.respond(LEAF, span, jnp.asarray(RISE))


def respond(law: WrappedLeaf | SlidingLeaf, span: object) -> LeafState:
    """State at any spans, in one batch of a fixed size: compiled once a law."""
    x = np.asarray(span, float)
    batch = np.full(512, RISE)
    batch[: x.size] = x.ravel()
    return LeafState(*(np.asarray(v)[: x.size].reshape(x.shape) for v in compiled(law, jnp.asarray(batch))))


def closure(span: float, radius: float) -> tuple[float, float, float]:
    """Energy, length and arc angle: one arc and one free quarter by quadrature over the slope, two unknowns.

    The free part has kappa^2 = (1/R^2) sin(t - theta)/sin(psi); theta = t - v^2 removes its end singularity.
    """

    def integral(f: object, psi: float) -> float:
        return quad(lambda v: 2.0 * v * f(v * v) if v > 0.0 else 0.0, 0.0, math.sqrt(psi), epsabs=1e-13)[0]

    def residual(unknown: np.ndarray) -> list[float]:
        psi, arc = unknown
        scale = radius * math.sqrt(math.sin(psi))
        x = integral(lambda g: scale * math.cos(arc + psi - g) / math.sqrt(math.sin(g)), psi)
        y = integral(lambda g: scale * math.sin(arc + psi - g) / math.sqrt(math.sin(g)), psi)
        return [
            (radius * math.sin(arc) + x) / span - 0.5,
            (radius * (1.0 - math.cos(arc)) + y) / RISE - 0.5,
        ]

    (psi, arc), _, flag, _ = fsolve(residual, [0.6, 0.4], xtol=1e-12, full_output=True)
    assert flag == 1
    scale = radius * math.sqrt(math.sin(psi))
    bending = integral(lambda g: math.sqrt(math.sin(g)) / scale, psi)
    length = integral(lambda g: scale / math.sqrt(math.sin(g)), psi)
    return EI * (arc / radius + bending), 2.0 * (radius * arc + length), arc


@pytest.mark.parametrize("span", [0.066, 0.07, 0.078])
def test_arcs_and_free_part_close(span: float) -> None:
    energy, length, arc = closure(span, RADIUS)
    state = respond(LAW, span)
    assert arc > 0.05
    assert float(state.energy) == pytest.approx(energy, rel=1e-10)
    assert float(state.arc_length) == pytest.approx(length, rel=1e-10)
    assert float(state.curvature_max) == pytest.approx(1.0 / RADIUS, rel=1e-15)
    step = 1e-4 * span
    force = (closure(span + step, RADIUS)[0] - closure(span - step, RADIUS)[0]) / (2.0 * step)
    assert float(state.force) == pytest.approx(force, rel=1e-4)  # differences near the hard stop


def limited_rod(span: float, segments: int) -> tuple[float, float]:
    """Least bending energy and length of a rod of free length whose joints bend by at most h/R (SLSQP)."""
    n = segments - 1
    end = np.array([span, RISE]) / RISE
    curve = LAW.centreline(LEAF, span, RISE, 401) / RISE
    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(curve, axis=0).T))])
    middle = np.interp(np.arange(1, segments) / segments * s[-1], 0.5 * (s[1:] + s[:-1]), slopes(curve))
    rng = np.random.default_rng(3)
    start = np.append(middle * 0.9 + 0.02 * rng.standard_normal(n), 1.05 * s[-1] / segments)
    pad = np.zeros(1)

    def energy(v: np.ndarray) -> tuple[float, np.ndarray]:
        bend = np.diff(np.concatenate([pad, v[:-1], pad]))
        gradient = np.append((bend[:-1] - bend[1:]) / v[-1], -0.5 * (bend**2).sum() / v[-1] ** 2)
        return 0.5 * (bend**2).sum() / v[-1], gradient

    def close(v: np.ndarray) -> np.ndarray:
        return v[-1] * np.array([1.0 + np.cos(v[:-1]).sum(), np.sin(v[:-1]).sum()]) - end

    def close_rate(v: np.ndarray) -> np.ndarray:
        c, s = np.cos(v[:-1]), np.sin(v[:-1])
        return np.stack([np.append(-v[-1] * s, 1.0 + c.sum()), np.append(v[-1] * c, s.sum())])

    turn = np.eye(segments, n) - np.eye(segments, n, k=-1)
    limit = np.full((segments, 1), RISE / RADIUS)
    bound = np.block([[-turn, limit], [turn, limit]])
    result = minimize(
        energy,
        start,
        jac=True,
        method="SLSQP",
        constraints=[
            {"type": "eq", "fun": close, "jac": close_rate},
            {"type": "ineq", "fun": lambda v: bound @ v, "jac": lambda _: bound},
        ],
        options={"maxiter": 300, "ftol": 1e-12},
    )
    assert result.success
    return float(result.fun) * EI / RISE, float(result.x[-1]) * segments * RISE


def slopes(curve: np.ndarray) -> np.ndarray:
    step = np.diff(curve, axis=0)
    return np.unwrap(np.arctan2(step[:, 1], step[:, 0]))


@pytest.mark.parametrize("span", [0.067, 0.074])
def test_least_energy_under_the_curvature_limit(span: float) -> None:
    state = respond(LAW, span)
    energy, length = limited_rod(span, 32)
    # 32 chords: h^2 is 1e-3
    assert float(state.energy) == pytest.approx(energy, rel=3e-3)
    assert float(state.arc_length) == pytest.approx(length, rel=3e-3)


def test_wrapping_starts_smoothly_and_stores_more_than_the_free_leaf() -> None:
    onset = brentq(lambda x: float(respond(SlidingLeaf(), x).curvature_max) - 1.0 / RADIUS, 0.06, 0.1)
    assert onset / RISE == pytest.approx(2.026, abs=5e-4)
    span = np.linspace(1.6, 2.4, 81) * RISE
    wrapped, free = respond(LAW, span), respond(SlidingLeaf(), span)
    on = np.asarray(free.curvature_max) > 1.0 / RADIUS
    excess = np.asarray(wrapped.energy - free.energy)
    assert np.all(excess[on] > 0.0)
    np.testing.assert_allclose(excess[~on], 0.0, atol=1e-15)
    np.testing.assert_array_less(np.asarray(wrapped.curvature_max) * RADIUS, 1.0 + 1e-12)
    just_below = onset * (1.0 - 1e-5)
    below, above = respond(LAW, just_below), respond(SlidingLeaf(), just_below)
    # energy to third, force to second, stiffness to first order in the distance to the onset
    np.testing.assert_allclose(below.force, above.force, rtol=1e-8)
    np.testing.assert_allclose(below.stiffness, above.stiffness, rtol=1e-3)


def test_gradients_agree_with_the_closed_forms() -> None:
    span = jnp.linspace(STOP * 1.0005, 0.16, 300)
    one = jnp.ones_like(span)

    def energy(x: jax.Array) -> jax.Array:
        return LAW.energy(LEAF, x, jnp.asarray(RISE))

    def force(x: jax.Array) -> jax.Array:
        return jax.jvp(energy, (x,), (one,))[1]

    state = respond(LAW, span)
    first, second = jax.jit(lambda x: jax.jvp(force, (x,), (one,)))(span)
    np.testing.assert_allclose(first, state.force, rtol=1e-12)
    np.testing.assert_allclose(second, state.stiffness, rtol=1e-10)
    assert np.all(np.asarray(state.stiffness) > 0.0)


def test_hard_stop_where_the_arcs_meet() -> None:
    # two arcs of angle phi: rise = 2 R (1 - cos phi), span = 2 R sin phi
    phi = math.acos(1.0 - RISE / (2.0 * RADIUS))
    stop = 2.0 * RADIUS * math.sin(phi)
    state = respond(LAW, np.array([stop * (1.0 - 1e-9), stop * (1.0 + 1e-9), 0.9 * stop, -0.01]))
    assert np.asarray(state.exists).tolist() == [False, True, False, False]
    assert np.isnan(np.asarray(state.energy)).tolist() == [True, False, True, True]
    assert float(state.energy[1]) == pytest.approx(EI * phi / RADIUS, rel=1e-4)  # square root of the distance
    assert float(state.arc_length[1]) == pytest.approx(2.0 * RADIUS * phi, rel=1e-4)
    assert float(state.force[1]) < 1e3 * float(respond(LAW, 0.08).force)
    with pytest.raises(InputError, match="larger span"):
        LAW.centreline(LEAF, 0.99 * stop, RISE)


def test_cylinders_too_small_to_hold_an_overhanging_leaf() -> None:
    # R < rise/4: free leaf; its tightest bend is 5.0 to 5.15 over the rise once it overhangs
    span = np.array([0.01, 0.3, 1.0, 4.0]) * RISE
    law = WrappedLeaf(0.22 * RISE)
    state, free = respond(law, span), respond(SlidingLeaf(), span)
    np.testing.assert_allclose(state.energy, free.energy, rtol=1e-15)
    expected = (np.asarray(free.curvature_max) * 0.22 * RISE <= 1.0).tolist()
    assert np.asarray(state.valid).tolist() == expected == [False, False, True, True]
    assert np.all(state.exists)
    assert np.all(respond(WrappedLeaf(0.19 * RISE), span).valid)


@pytest.mark.parametrize("radius_ratio", [0.25, 0.26, 0.4, 0.9, 30.0])
def test_every_existing_point_is_finite(radius_ratio: float) -> None:
    span = RISE * np.concatenate([np.linspace(-0.5, 1.0, 301), np.linspace(1.01, 20.0, 200)])
    state = respond(WrappedLeaf(radius_ratio * RISE), span)
    exists = np.asarray(state.exists)
    np.testing.assert_array_equal(exists, (span > 0.0) & (span**2 > RISE**2 * (4.0 * radius_ratio - 1.0)))
    for value in state[:5]:
        np.testing.assert_array_equal(np.isfinite(np.asarray(value)), exists)
    assert np.all(np.diff(np.asarray(state.energy)[exists]) < 0.0)


@pytest.mark.parametrize("span", [0.068, 0.12])
def test_drawn_shape_stays_off_the_cylinders(span: float) -> None:
    curve = LAW.centreline(LEAF, span, RISE, 301)
    np.testing.assert_allclose(curve[[0, -1]], [[0.0, 0.0], [span, RISE]], atol=1e-15)
    at_roller = np.hypot(curve[:, 0], curve[:, 1] - RADIUS)
    at_clamp = np.hypot(curve[:, 0] - span, curve[:, 1] - RISE + RADIUS)
    assert min(at_roller.min(), at_clamp.min()) > RADIUS * (1.0 - 1e-12)
    length = np.hypot(*np.diff(curve, axis=0).T).sum()
    assert length == pytest.approx(float(respond(LAW, span).arc_length), rel=1e-4)
