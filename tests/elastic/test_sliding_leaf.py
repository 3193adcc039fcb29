"""The exact sliding leaf against a boundary value problem and a discrete rod, and its stability."""

from __future__ import annotations

import math
from functools import cache

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_bvp
from scipy.linalg import null_space
from scipy.optimize import brentq

from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafState
from varistiff.elastic.sliding_leaf import SlidingLeaf, half_curve

LEAF = Leaf(youngs_modulus=70e9, width=0.03, thickness=0.0008)
RISE = 0.06
EI = 70e9 * 0.03 * 0.0008**3 / 12.0


def state_at(aspect: float) -> LeafState:
    return compiled(jnp.asarray(aspect * RISE))


@jax.jit
def compiled(span: jax.Array) -> LeafState:
    return SlidingLeaf().respond(LEAF, span, jnp.asarray(RISE))


@cache
def rods() -> dict[float, tuple[float, float, float, float]]:
    """Energy, dU/dspan, largest curvature and length of rods of unknown length by aspect ratio (EI = rise = 1).

    Unknown besides the shape: length and both components of the internal force; the length is free, so the
    Hamiltonian kappa^2/2 + Fx cos(theta) + Fy sin(theta) vanishes, and dU/dspan = Fx. The span is reduced in
    steps from a shallow leaf, so that no other elastica is found.
    """
    s = np.linspace(0.0, 1.0, 41)
    slope = 1.5 / 3.5
    guess = np.stack([3.5 * s, s, slope * 4.0 * s * (1.0 - s), slope * (4.0 - 8.0 * s) / 3.5, s])
    parameters = np.array([3.6, -0.1, 0.3])
    found = {}
    for aspect in (3.5, 2.0, 1.4, 1.0, 0.8, 0.65, 0.55, 0.45):

        def rates(_: np.ndarray, z: np.ndarray, p: np.ndarray) -> np.ndarray:
            bend = p[1] * np.sin(z[2]) - p[2] * np.cos(z[2])
            return p[0] * np.stack([np.cos(z[2]), np.sin(z[2]), z[3], bend, 0.5 * z[3] ** 2])

        def ends(a: np.ndarray, b: np.ndarray, p: np.ndarray, span: float = aspect) -> np.ndarray:
            return np.array([*a[:3], a[4], b[0] - span, b[1] - 1.0, b[2], 0.5 * a[3] ** 2 + p[1]])

        solution = solve_bvp(rates, ends, s, guess, parameters, tol=1e-8, max_nodes=5000)
        assert solution.success
        guess, parameters = solution.sol(s), solution.p
        curvature = np.abs(solution.sol(np.linspace(0.0, 1.0, 4001))[3]).max()
        found[aspect] = float(solution.y[4, -1]), float(solution.p[1]), float(curvature), float(solution.p[0])
    return found


@pytest.mark.parametrize("aspect", [3.5, 1.0, 0.45])
def test_rod_of_unknown_length(aspect: float) -> None:
    energy, force, curvature, length = rods()[aspect]
    state = state_at(aspect)
    assert float(state.energy) == pytest.approx(energy * EI / RISE, rel=1e-7)  # tolerance of solve_bvp
    assert float(state.force) == pytest.approx(force * EI / RISE**2, rel=1e-7)
    assert float(state.curvature_max) == pytest.approx(curvature / RISE, rel=1e-6)  # 4001 samples
    assert float(state.arc_length) == pytest.approx(length * RISE, rel=1e-7)


class DiscreteRod:
    """Equal segments of unknown length h with both end slopes held: E = sum (change of slope)^2/(2 h)."""

    def __init__(self, curve: np.ndarray) -> None:
        step = np.diff(curve, axis=0)
        self.slopes = np.unwrap(np.arctan2(step[:, 1], step[:, 0]))
        self.segment = float(np.hypot(*step.T).mean())
        self.end = curve[-1] - curve[0]

    def equilibrium(self) -> tuple[float, float]:
        """Energy and smallest eigenvalue of the second variation on the constraints, after Newton's method.

        Unknown: inner slopes, segment length and the two forces that hold the end (trapezoidal rule).
        """
        theta, h = 0.5 * (self.slopes[1:] + self.slopes[:-1]), self.segment
        m = len(theta)
        k = 2.0 * np.eye(m) - np.eye(m, k=1) - np.eye(m, k=-1)
        force = np.zeros(2)
        for step in range(15):
            c, s = np.cos(theta), np.sin(theta)
            bend = k @ theta
            jacobian = np.stack([np.append(-h * s, 1.0 + c.sum()), np.append(h * c, s.sum())])
            gradient = np.append(bend / h, -0.5 * theta @ bend / h**2)
            if step == 0:
                force = np.linalg.lstsq(jacobian.T, gradient)[0]
            mixed = -bend / h**2 + force[0] * s - force[1] * c
            hessian = np.zeros((m + 1, m + 1))
            hessian[:m, :m] = k / h + np.diag(h * (force[0] * c + force[1] * s))
            hessian[:m, m] = hessian[m, :m] = mixed
            hessian[m, m] = theta @ bend / h**3
            closure = h * np.array([1.0 + c.sum(), s.sum()]) - self.end
            residual = np.append(gradient - jacobian.T @ force, -closure)
            change = np.linalg.solve(np.block([[hessian, -jacobian.T], [-jacobian, np.zeros((2, 2))]]), -residual)
            theta, h, force = theta + change[:m], h + change[m], force + change[m + 1 :]
        assert np.abs(residual).max() < 1e-9
        free = null_space(jacobian)
        return 0.5 * theta @ k @ theta / h, float(np.linalg.eigvalsh(free.T @ hessian @ free)[0])


def even(curve: np.ndarray, n: int) -> np.ndarray:
    """The same curve at n + 1 points of equal spacing."""
    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(curve, axis=0).T))])
    at = np.linspace(0.0, s[-1], n + 1)
    return np.stack([np.interp(at, s, curve[:, i]) for i in (0, 1)], axis=1)


@pytest.mark.parametrize("aspect", [2.0, 0.45, 0.1])
def test_discrete_rod_finds_the_same_stable_leaf(aspect: float) -> None:
    curve = SlidingLeaf().centreline(LEAF, aspect * RISE, RISE, 2001) / RISE
    coarse, fine = (DiscreteRod(even(curve, n)).equilibrium() for n in (40, 80))
    energy = (4.0 * fine[0] - coarse[0]) / 3.0  # second order: Richardson leaves h^4
    assert float(state_at(aspect).energy) == pytest.approx(energy * EI / RISE, rel=2e-5)
    assert coarse[1] > 0.0
    assert fine[1] > 0.0


@pytest.mark.parametrize(("slope_degrees", "stable"), [(143.0, True), (168.0, True), (174.0, False)])
def test_imposed_span_holds_the_leaf_until_the_chord_turns_back(slope_degrees: float, stable: bool) -> None:
    # beyond every span > 0 (143 degrees is span 0): the loss of stability is at 170.9 degrees, span/rise -0.169
    slope = math.radians(slope_degrees)
    step = np.linspace(-1.0, 1.0, 4001)
    curve = half_curve(slope, 1.0, slope * step * np.abs(step))
    curve = (curve - curve[0]) / (curve[-1, 1] - curve[0, 1])
    assert (DiscreteRod(even(curve, 120)).equilibrium()[1] > 0.0) is stable


def test_tangent_stiffness_vanishes_at_a_quarter_but_the_leaf_goes_on() -> None:
    def stiffness(aspect: float) -> float:
        return float(state_at(aspect).stiffness)

    zero = brentq(stiffness, 0.2, 0.3)
    assert zero == pytest.approx(0.2552, abs=5e-5)
    state = state_at(0.05)
    assert bool(state.exists)
    assert float(state.stiffness) < 0.0
    # there the end moment, and with it the configurational force, is largest
    assert float(state_at(zero).force) < float(state_at(zero + 0.05).force)
    assert float(state_at(zero).force) < float(state_at(zero - 0.05).force)


def test_force_is_the_configurational_force_of_the_end_moment() -> None:
    # below 90 degrees of slope the largest curvature is the ends'
    span = RISE * np.linspace(0.61, 9.0, 60)
    state = SlidingLeaf().respond(LEAF, jnp.asarray(span), jnp.asarray(RISE))
    np.testing.assert_allclose(state.force, -0.5 * EI * np.asarray(state.curvature_max) ** 2, rtol=1e-13)


def test_gradients_agree_with_the_closed_forms() -> None:
    span = jnp.asarray(RISE * np.concatenate([np.linspace(0.01, 0.25, 25), np.logspace(-0.58, 6, 200)]))
    law = SlidingLeaf()

    def energy(x: jax.Array) -> jax.Array:
        return law.energy(LEAF, x, jnp.asarray(RISE))

    one = jnp.ones_like(span)

    def force(x: jax.Array) -> jax.Array:
        return jax.jvp(energy, (x,), (one,))[1]

    state = jax.jit(lambda x: law.respond(LEAF, x, jnp.asarray(RISE)))(span)
    first, second = jax.jit(lambda x: jax.jvp(force, (x,), (one,)))(span)
    np.testing.assert_allclose(first, state.force, rtol=1e-12)
    # against U/x^2, because the stiffness passes zero
    scale = np.asarray(state.energy / span**2)
    np.testing.assert_allclose(second / scale, state.stiffness / scale, atol=1e-9)


def test_shallow_leaf_is_the_linear_beam() -> None:
    span = 1e5 * RISE
    state = state_at(1e5)
    assert float(state.energy) == pytest.approx(6.0 * EI * RISE**2 / span**3, rel=1e-9)
    assert float(state.stiffness) == pytest.approx(72.0 * EI * RISE**2 / span**5, rel=1e-9)
    assert float(state.curvature_max) == pytest.approx(6.0 * RISE / span**2, rel=1e-9)


@pytest.mark.parametrize(("aspect", "percent"), [(3.5, 0.02), (2.0, 0.2), (1.0, 2.0)])
def test_guided_leaf_stores_slightly_more(aspect: float, percent: float) -> None:
    guided = GuidedLeaf().energy(LEAF, jnp.asarray(aspect * RISE), jnp.asarray(RISE))
    excess = 100.0 * (float(guided) / float(state_at(aspect).energy) - 1.0)
    assert excess == pytest.approx(percent, rel=0.25)  # quoted to one digit


def test_no_leaf_without_a_positive_span() -> None:
    span = jnp.asarray([-0.005, 0.0, 1e-6, 0.1])
    state = SlidingLeaf().respond(LEAF, span, jnp.asarray(RISE))
    assert np.asarray(state.exists).tolist() == [False, False, True, True]
    for value in state[:5]:
        assert np.isfinite(np.asarray(value)).tolist() == [False, False, True, True]
