"""The paper's guided leaf against its own integrals at 30 digits, and in its limits."""

from __future__ import annotations

from collections.abc import Callable

import jax
import jax.numpy as jnp
import mpmath as mp
import numpy as np
import pytest

from varistiff.core.errors import InputError
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafState

LEAF = Leaf(youngs_modulus=70e9, width=0.03, thickness=0.0008)
RISE = 0.06
EI = 70e9 * 0.03 * 0.0008**3 / 12.0


@jax.jit
def compiled(span: jax.Array) -> LeafState:
    return GuidedLeaf().respond(LEAF, span, jnp.asarray(RISE))


def integrals(q: mp.mpf) -> tuple[mp.mpf, mp.mpf, mp.mpf]:
    """rise/span, U span/EI and length/span of sin(theta) = q (u^2 - u), as printed, by adaptive quadrature."""
    edges = [mp.mpf(0), *(mp.mpf(1) / 2 - mp.mpf(10) ** -k for k in (1, 2, 4, 7, 10)), mp.mpf(1) / 2]

    def half(f: Callable[[mp.mpf], mp.mpf]) -> mp.mpf:
        return 2 * mp.quad(f, edges)

    def cosine(u: mp.mpf) -> mp.mpf:
        return mp.sqrt(1 - (q * (u - u * u)) ** 2)

    return (
        half(lambda u: q * (u - u * u) / cosine(u)),
        half(lambda u: (q * (2 * u - 1)) ** 2 / cosine(u) / 2),
        half(lambda u: 1 / cosine(u)),
    )


def reference(steepness: float) -> tuple[float, ...]:
    """Aspect ratio, energy, force, stiffness, curvature, length (EI = rise = 1) at q = 4 (1 - exp(-steepness)).

    Parametric central differences give dU/dx and d2U/dx2 without solving for q.
    """
    with mp.workdps(25):
        z, h = mp.mpf(steepness), mp.mpf(10) ** -5
        spans, energies = [], []
        for shifted in (z - h, z, z + h):
            ratio, energy, length = integrals(-4 * mp.expm1(-shifted))
            spans.append(1 / ratio)
            energies.append(energy * ratio)
            if shifted == z:
                middle = length
        x1, x2 = (spans[2] - spans[0]) / (2 * h), (spans[2] - 2 * spans[1] + spans[0]) / h**2
        u1, u2 = (energies[2] - energies[0]) / (2 * h), (energies[2] - 2 * energies[1] + energies[0]) / h**2
        x, q = spans[1], -4 * mp.expm1(-z)
        values = (x, energies[1], u1 / x1, (u2 * x1 - u1 * x2) / x1**3, q / x, middle * x)
        return tuple(float(v) for v in values)


# aspect ratios 33, 3.1, 1.5 and 0.15
@pytest.mark.parametrize("steepness", [0.045, 0.55, 1.5, 18.0])
def test_printed_integrals(steepness: float) -> None:
    aspect, energy, force, stiffness, curvature, length = reference(steepness)
    state = compiled(jnp.asarray(aspect * RISE))
    assert float(state.energy) == pytest.approx(energy * EI / RISE, rel=1e-12)
    assert float(state.force) == pytest.approx(force * EI / RISE**2, rel=1e-7)  # differences of step 1e-5
    assert float(state.stiffness) == pytest.approx(stiffness * EI / RISE**3, rel=1e-6)
    assert float(state.curvature_max) == pytest.approx(curvature / RISE, rel=1e-12)
    assert float(state.arc_length) == pytest.approx(length * RISE, rel=1e-12)


def derivatives(energy: Callable[[jax.Array], jax.Array], span: jax.Array) -> tuple[jax.Array, jax.Array]:
    """First two derivatives of a function of each span alone, by automatic differentiation."""
    one = jnp.ones_like(span)

    def first(x: jax.Array) -> jax.Array:
        return jax.jvp(energy, (x,), (one,))[1]

    return jax.jit(lambda x: jax.jvp(first, (x,), (one,)))(span)


def test_shallow_leaf_is_the_linear_beam() -> None:
    span = 1e5 * RISE
    state = compiled(jnp.asarray(span))
    assert float(state.energy) == pytest.approx(6.0 * EI * RISE**2 / span**3, rel=1e-9)
    assert float(state.force) == pytest.approx(-18.0 * EI * RISE**2 / span**4, rel=1e-9)
    assert float(state.stiffness) == pytest.approx(72.0 * EI * RISE**2 / span**5, rel=1e-9)


def test_steep_leaf_keeps_its_digits_where_the_slope_is_vertical() -> None:
    # q -> 4: the bends keep their shape, U span/EI -> 8 (sqrt 2 - 1), and a straight vertical part grows
    span = 1e-4 * RISE
    state = compiled(jnp.asarray(span))
    limit = 8.0 * (np.sqrt(2.0) - 1.0) * EI
    assert float(state.energy) == pytest.approx(limit / span, rel=1e-13)
    assert float(state.force) == pytest.approx(-limit / span**2, rel=1e-13)
    assert float(state.stiffness) == pytest.approx(2.0 * limit / span**3, rel=1e-13)
    assert float(state.curvature_max) == pytest.approx(4.0 / span, rel=1e-13)


def test_gradients_agree_with_the_closed_forms_over_all_aspect_ratios() -> None:
    span = jnp.asarray(RISE * np.logspace(-6, 6, 241))
    law = GuidedLeaf()

    def energy(x: jax.Array) -> jax.Array:
        return law.energy(LEAF, x, jnp.asarray(RISE))

    state = compiled(span)
    force, stiffness = derivatives(energy, span)
    np.testing.assert_allclose(force, state.force, rtol=1e-13)
    np.testing.assert_allclose(stiffness, state.stiffness, rtol=1e-11)  # derivatives of the polynomials
    assert np.all(np.asarray(state.stiffness) > 0.0)


def test_no_leaf_without_a_positive_span() -> None:
    span = jnp.asarray([-0.01, 0.0, np.nan, 0.1])
    state = compiled(span)
    assert np.asarray(state.exists).tolist() == [False, False, False, True]
    assert np.isnan(np.asarray(state.energy)).tolist() == [True, True, True, False]
    with pytest.raises(InputError, match="larger span"):
        GuidedLeaf().centreline(LEAF, -0.01, RISE)


@pytest.mark.parametrize("aspect", [0.03, 0.6, 3.5])
def test_drawn_shape_has_a_moment_linear_in_x(aspect: float) -> None:
    span = aspect * RISE
    curve = GuidedLeaf().centreline(LEAF, span, RISE, 4001)
    np.testing.assert_allclose(curve[[0, -1]], [[0.0, 0.0], [span, RISE]], atol=1e-15)
    step = np.diff(curve, axis=0)
    sine = step[:, 1] / np.hypot(*step.T)
    x = 0.5 * (curve[1:, 0] + curve[:-1, 0]) / span
    shape = x * (1.0 - x)
    q = sine[2000] / shape[2000]
    np.testing.assert_allclose(sine, q * shape, atol=1e-4)  # chords of 4000 pieces, longest at the bends
    length = float(compiled(jnp.asarray(span)).arc_length)
    assert np.hypot(*step.T).sum() == pytest.approx(length, rel=1e-6)
