"""The leaf of Chacon et al. (2011): guided at the roller, without axial force."""

from __future__ import annotations

from functools import cache
from typing import ClassVar, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import numpy.typing as npt
from numpy.polynomial import chebyshev, legendre

from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import Curve, Field, LeafLaw, LeafState, masked, require_shape
from varistiff.elastic.polynomial import estrin

Numbers = npt.NDArray[np.float64]

_SPLIT = 0.65  # p above which the integrals are taken as A(1 - p) z + B(1 - p)
_NEWTON_STEPS = 3  # the start is good to 0.4 % and the equation nearly linear: the third step only rounds
_START = (2.951, 1.5286, 1.2723)  # rational start of z(rise/span), fitted between its two exact limits


class _Series(NamedTuple):
    """Coefficients, lowest first, of polynomials in a variable scaled to [-1, 1]; J0 and J2 each."""

    low: tuple[list[float], list[float]]  # J over p^2
    factor: tuple[list[float], list[float]]  # A of J0 = A z + B and A/e of J2, over e = 1 - p
    rest: tuple[list[float], list[float]]  # B


def _carlson(p: Numbers, e: Numbers) -> tuple[Numbers, Numbers]:
    """J0, J2 by Carlson's symmetric integrals."""
    from scipy.special import elliprd, elliprf  # which the other laws of a leaf do without

    s = e * (1.0 + p)
    return elliprf(s, 1.0 + p, e), s / 3.0 * elliprd(1.0 + p, e, s)


def _log_factors(e: Numbers) -> tuple[Numbers, Numbers]:
    """A of J0 = A log(1/e) + B and A/e of J2: integrals around the pinched branch points, midpoint rule."""
    p = 1.0 - e
    sine2 = np.sin((np.arange(32)[:, None] + 0.5) * np.pi / 32.0) ** 2
    root = np.sqrt(1.0 + p + e * sine2)
    return 0.5 * np.mean(1.0 / root, axis=0) / np.sqrt(p), -0.5 * np.mean(sine2 / root, axis=0) / p**1.5


@cache
def _series() -> _Series:
    """Interpolate the smooth parts at Chebyshev points: singularities are far, so 16 digits."""

    def fit(values: Numbers, nodes: Numbers) -> list[float]:
        return list(chebyshev.cheb2poly(chebyshev.chebfit(nodes, values, len(nodes) - 1)))

    u, v = chebyshev.chebpts1(20), chebyshev.chebpts1(18)
    p = _SPLIT * np.sqrt(0.5 * (1.0 + u))
    e = 0.5 * (1.0 - _SPLIT) * (1.0 + v)
    low, high, factor = _carlson(p, 1.0 - p), _carlson(1.0 - e, e), _log_factors(e)
    rest = high[0] + factor[0] * np.log(e), high[1] + factor[1] * e * np.log(e)
    return _Series(
        low=(fit(low[0], u), fit(low[1], u)),
        factor=(fit(factor[0], v), fit(factor[1], v)),
        rest=(fit(rest[0], v), fit(rest[1], v)),
    )


def _integrals(z: Field) -> tuple[Field, Field]:
    """J0 = int_0^1 dv/D and J2 = int_0^1 v^2 dv/D, D^2 = 1 - p^2 (1 - v^2)^2, at p = 1 - exp(-z), z >= 0."""
    series, p, e = _series(), -jnp.expm1(-z), jnp.exp(-z)
    u = 2.0 * p * p / _SPLIT**2 - 1.0
    v = 2.0 * e / (1.0 - _SPLIT) - 1.0

    def either(i: int, logarithm: Field) -> Field:
        near_vertical = estrin(series.factor[i], v) * logarithm + estrin(series.rest[i], v)
        return jnp.where(p < _SPLIT, estrin(series.low[i], u), near_vertical)

    return either(0, z), either(1, e * z)


def _rise_over_span(z: Field) -> tuple[Field, Field]:
    """G = p (J0 - J2) and dG/dz = (1 + J2)/(2 (1 + p))."""
    p = -jnp.expm1(-z)
    j0, j2 = _integrals(z)
    return p * (j0 - j2), 0.5 * (1.0 + j2) / (1.0 + p)


@jax.custom_jvp
def _slope_parameter(ratio: Field) -> Field:
    """z > 0 with G(z) = ratio = rise/span.

    Solved for z, not p = 1 - exp(-z): G is nearly linear in z, also where 1 - p underflows.
    """
    a, b, c = _START
    start = ratio * (1.5 + ratio * (a + ratio * np.sqrt(8.0) * b)) / (1.0 + ratio * (c + ratio * b))

    def improve(_: int, z: Field) -> Field:
        value, derivative = _rise_over_span(z)
        return z - (value - ratio) / derivative

    solution: Field = jax.lax.fori_loop(0, _NEWTON_STEPS, improve, start)
    return solution


@_slope_parameter.defjvp
def _slope_parameter_jvp(primals: tuple[Field], tangents: tuple[Field]) -> tuple[Field, Field]:
    z = _slope_parameter(primals[0])
    return z, tangents[0] / _rise_over_span(z)[1]


_drawn_parameter = jax.jit(_slope_parameter)


class GuidedLeaf(LeafLaw):
    """The leaf as Chacon et al. (2011) model it: moment linear in x, no axial force, for every span > 0.

    With v = 1 - 2 x/span from 0 (middle) to 1 (end) the printed closed form reads sin(theta) = p (1 - v^2),
    p = 1 - exp(-z) in (0, 1) the sine of the steepest slope (their a = -4 p/span^2), and::

        rise/span = G(p) = p (J0 - J2),    J0, J2 = int_0^1 {1, v^2} dv/sqrt(1 - p^2 (1 - v^2)^2)
        U = EI W/span,   W = 8 p^2 J2,     length = span J0,    curvature = 4 p v/span, largest at both ends
        dG/dp = (1 + J2)/(2 (1 - p^2)),    dW/dp = W/p + 4 G

    The last line (integration by parts) gives force and stiffness by the chain rule without further
    integrals. J0 and J2 are smooth in p^2, and smooth times z plus smooth near the vertical: both as
    polynomials, relative error 1e-14 of every output for span/rise from 1e-6 to 1e6.

    The shape is not the minimiser of the bending energy at this span (`SlidingLeaf` is), so U is slightly
    larger: 0.02 % at span/rise = 3.5, 0.2 % at 2, 2 % at 1. The Cartesian equation printed in the paper has
    the sign of the arc-length form; its closed form, used here, is right for the corrected one.

    Source: Chacon et al. (2011), section 3.

    >>> import jax.numpy as jnp
    >>> leaf = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
    >>> round(float(GuidedLeaf().energy(leaf, jnp.asarray(0.081), jnp.asarray(0.0405))), 4)
    1.5211
    """

    references: ClassVar[tuple[str, ...]] = ("chacon_2011",)

    def energy(self, leaf: Leaf, span: Field, rise: Field) -> Field:
        """Bending energy [J]; NaN for span <= 0."""
        exists = span > 0.0
        x = jnp.where(exists, span, 1.0)
        z = _slope_parameter(rise / x)
        p, (_, j2) = -jnp.expm1(-z), _integrals(z)
        return masked(exists, 8.0 * leaf.flexural_rigidity * p * p * j2 / x)

    def respond(self, leaf: Leaf, span: Field, rise: Field) -> LeafState:
        """State at (span, rise) [m]; no shape for span <= 0."""
        exists = span > 0.0
        x = jnp.where(exists, span, 1.0)
        ei, ratio = leaf.flexural_rigidity, rise / x
        z = _slope_parameter(ratio)
        p, (j0, j2) = -jnp.expm1(-z), _integrals(z)
        h = j0 - j2
        s = jnp.exp(-z) * (1.0 + p)  # 1 - p^2 with its digits
        r = 2.0 / (1.0 + j2)
        n = p * (8.0 * j2 + 4.0 * h)  # dW/dp
        j2_slope = (0.5 * h - j2) / p
        w = 8.0 * p * p * j2
        w1 = s * r * n  # dW/dG
        s_n_slope = s * (8.0 * (j2 + p * j2_slope)) + 4.0 / r  # (1 - p^2) d2W/dp2
        w2 = s * r * r * (s_n_slope - 2.0 * p * n - 0.5 * s * r * n * j2_slope)  # d2W/dG2
        return LeafState(
            energy=masked(exists, ei * w / x),
            force=masked(exists, -ei * (w + ratio * w1) / x**2),
            stiffness=masked(exists, ei * (2.0 * w + ratio * (4.0 * w1 + ratio * w2)) / x**3),
            curvature_max=masked(exists, 4.0 * p / x),
            arc_length=masked(exists, x * j0),
            exists=exists,
            valid=jnp.ones_like(exists),
        )

    def centreline(self, leaf: Leaf, span: float, rise: float, points: int = 101) -> Curve:
        """Points (N, 2) [m] from the roller (0, 0) to the clamp (span, rise), nearly even along the leaf."""
        require_shape(span > 0.0, span, rise)
        z = float(_drawn_parameter(jnp.asarray(rise / span)))
        p = -np.expm1(-z)
        # v = sqrt((1 - p)/p) sinh(w) spreads the nearly vertical middle; top = w(1) from logarithms
        top = 0.5 * z + np.log(np.sqrt(p) + np.sqrt(p + np.exp(-z)))
        w = np.linspace(-top, top, points)
        nodes, weights = legendre.leggauss(8)
        half = top / (points - 1)
        inner = 0.5 * (w[1:] + w[:-1])[:, None] + half * nodes
        v2 = (_sinh_ratio(inner, top)) ** 2
        steps = half * np.sum(weights * np.sqrt(p) * (1.0 - v2) / np.sqrt(1.0 + p - p * v2), axis=1)
        height = np.concatenate([[0.0], np.cumsum(steps)])
        x = 0.5 * (1.0 + _sinh_ratio(w, top))
        return np.stack([span * x, rise * height / height[-1]], axis=1)


def _sinh_ratio(w: Numbers, top: float) -> Numbers:
    """sinh(w)/sinh(top) without overflow."""
    size = np.abs(w)
    return np.asarray(np.sign(w) * np.exp(size - top) * np.expm1(-2.0 * size) / np.expm1(-2.0 * top))
