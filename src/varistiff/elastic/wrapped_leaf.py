"""The sliding leaf that wraps on protection cylinders at both ends."""

from __future__ import annotations

import math
from typing import ClassVar, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import Curve, Field, LeafLaw, LeafState, Mask, masked, require_shape
from varistiff.elastic.lemniscate import SlopeTerms, slope_terms
from varistiff.elastic.polynomial import estrin
from varistiff.elastic.sliding_leaf import (
    FreeShape,
    SlidingLeaf,
    end_curvature,
    free_energy,
    free_force,
    free_length,
    free_shape,
    free_stiffness,
    half_curve,
    largest_curvature,
)

_NEWTON_STEPS = 2  # the start is good to 2e-6: 1e-12, then rounding
_START = (1.03762, -1.33473e-2, -6.7301e-4, -3.9168e-5)  # turning/a over a^2
_REACH_LIMIT = 1.4355400220922596  # (pi/c)^2, c the lemniscate constant: the reach at 90 degrees of turning


def _reach(terms: SlopeTerms) -> tuple[Field, Field]:
    """m = Q (Q + 2 cos psi) and dm/dpsi, with Q = sqrt(sin psi) I2(psi)."""
    q = 2.0 * terms.sine * terms.offset_ratio
    q_rate = terms.sine + terms.cosine * terms.offset_ratio
    return q * (q + 2.0 * terms.cosine), 2.0 * (q_rate * (q + terms.cosine) - q * terms.sine)


@jax.custom_jvp
def _free_turning(reach: Field) -> Field:
    """psi in (0, pi/2) that the leaf turns between lift-off and middle, from m in (0, (pi/c)^2)."""
    a = jnp.arcsin(jnp.sqrt(reach / _REACH_LIMIT))
    start = a * estrin(_START, a * a)

    def improve(_: int, psi: Field) -> Field:
        value, rate = _reach(slope_terms(psi))
        return psi - (value - reach) / jnp.maximum(rate, 1e-12)  # the rate vanishes at 90 degrees

    solution: Field = jax.lax.fori_loop(0, _NEWTON_STEPS, improve, start)
    return solution


@_free_turning.defjvp
def _free_turning_jvp(primals: tuple[Field], tangents: tuple[Field]) -> tuple[Field, Field]:
    psi = _free_turning(primals[0])
    return psi, tangents[0] / jnp.maximum(_reach(slope_terms(psi))[1], 1e-12)


class _WrappedShape(NamedTuple):
    """Half a wrapped leaf: an arc of angle ``arc``, then a free part that turns back by psi to the middle."""

    terms: SlopeTerms  # at psi
    arc: Field
    slope: Field  # in the middle, arc + psi
    slope_rate: Field  # d(slope)/d(span/2R)
    turning_rate: Field  # d(psi)/d(span/2R)


class _Cases(NamedTuple):
    """Which shape a point has, and both shapes (each at a harmless place where it does not apply)."""

    wrapped: Mask
    exists: Mask
    valid: Mask
    free: FreeShape
    bent: _WrappedShape


def _wrapped_shape(xi: Field, eta: Field, reach: Field) -> _WrappedShape:
    psi = _free_turning(reach)
    terms = slope_terms(psi)
    s, c = terms.sine, terms.cosine
    q = 2.0 * s * terms.offset_ratio
    lag = jnp.arctan2(s, c + q)
    slope = jnp.arctan2(xi, 1.0 - eta) - lag
    turning_rate = 2.0 * xi / jnp.maximum(_reach(terms)[1], 1e-12)
    lag_rate = (1.0 + q * c - s * (s + c * terms.offset_ratio)) / (1.0 + reach)
    slope_rate = (1.0 - eta) / (1.0 + reach) - lag_rate * turning_rate
    return _WrappedShape(terms, slope - psi, slope, slope_rate, turning_rate)


class WrappedLeaf(LeafLaw):
    """A sliding leaf that wraps on cylinders of radius R at clamp and roller instead of bending tighter.

    While the free elastica's end curvature is at most 1/R this is `SlidingLeaf`. Beyond, each end follows its
    cylinder over an angle phi and a free elastica with curvature 1/R at lift-off joins them: with psi the
    turning from lift-off to the middle (slope t = phi + psi), xi = span/(2 R), eta = rise/(2 R) and
    Q = sqrt(sin psi) I2(psi)::

        Q (Q + 2 cos psi) = xi^2 - eta (2 - eta),    t = atan2(xi, 1 - eta) - atan2(sin psi, cos psi + Q)
        U = EI (phi + I2/sqrt(sin psi))/R,    dU/d(span) = -F sin t,   F = EI/(2 R^2 sin psi)

    It is the minimiser of the bending energy under the curvature limit 1/R. Over the arc angle alone,
    dU/d(phi) = EI R (kappa - 1/R)^2 with kappa the curvature after lift-off: moment and configurational force
    M^2/(2 EI) are continuous there, no force acts at lift-off, and stiffness has a kink but no jump where
    wrapping begins. The force grows without bound towards the hard stop, where the arcs meet and the law
    ends: span = sqrt(rise (4 R - rise)). Strictly, a frictionless cylinder cannot hold the compressed arc
    down: the leaf would bridge it by a hair and touch at one point, bending tighter than 1/R by about
    phi^2/48 of it.

    Cylinders with R < rise/4 have no hard stop: the leaf overhangs before it could wrap and is tightest
    inside, where no cylinder protects it. The free leaf is reported then, ``valid`` while it bends nowhere
    tighter than 1/R.

    Parameters
    ----------
    protection_radius : R [m]; the leaf's thickness is neglected against it, as in the paper's Eq. (3)

    Source: Chacon et al. (2011), section 2 and Eq. (3), for the device.

    >>> import jax.numpy as jnp
    >>> leaf = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
    >>> state = WrappedLeaf(0.035).respond(leaf, jnp.asarray(0.07), jnp.asarray(0.0405))
    >>> round(float(1.0 / state.curvature_max), 6)
    0.035
    """

    protection_radius: float

    references: ClassVar[tuple[str, ...]] = ("chacon_2011", "bigoni_2013")

    def _cases(self, span: Field, rise: Field) -> _Cases:
        radius = self.protection_radius
        some = span > 0.0
        x = jnp.where(some, span, rise)
        free = free_shape(x, rise)
        xi, eta = 0.5 * x / radius, 0.5 * rise / radius
        holding = eta <= 2.0
        # past 90 degrees the ends of the free leaf unbend again, but by then it lies on the cylinders
        wrapped = holding & ((end_curvature(free) * radius > 1.0) | (free.terms.cosine < 0.0))
        reach = xi * xi - eta * (2.0 - eta)
        exists = some & (~wrapped | (reach > 0.0))
        safe = jnp.where(wrapped & exists, jnp.minimum(reach, _REACH_LIMIT), 0.5 * _REACH_LIMIT)
        valid = holding | (largest_curvature(free) * radius <= 1.0)
        return _Cases(wrapped, exists, valid, free, _wrapped_shape(xi, eta, safe))

    def energy(self, leaf: Leaf, span: Field, rise: Field) -> Field:
        """Bending energy [J], arcs included; NaN beyond the hard stop."""
        case, ei = self._cases(span, rise), leaf.flexural_rigidity
        bent = ei * (case.bent.arc + 2.0 * case.bent.terms.offset_ratio) / self.protection_radius
        return masked(case.exists, jnp.where(case.wrapped, bent, free_energy(case.free, ei)))

    def respond(self, leaf: Leaf, span: Field, rise: Field) -> LeafState:
        """State at (span, rise) [m]; no shape beyond the hard stop."""
        case, ei, radius = self._cases(span, rise), leaf.flexural_rigidity, self.protection_radius
        bent = case.bent
        s, c, turn = bent.terms.sine, bent.terms.cosine, jnp.sin(bent.slope)
        force = -0.5 * ei * turn / (radius**2 * s)
        bend_rate = c * turn / s * bent.turning_rate - jnp.cos(bent.slope) * bent.slope_rate
        stiffness = 0.25 * ei * bend_rate / (s * radius**3)
        length = 2.0 * radius * (bent.arc + 2.0 * s * bent.terms.length_ratio)

        def choose(on_cylinder: Field, off: Field) -> Field:
            return masked(case.exists, jnp.where(case.wrapped, on_cylinder, off))

        return LeafState(
            energy=self.energy(leaf, span, rise),
            force=choose(force, free_force(case.free, ei)),
            stiffness=choose(stiffness, free_stiffness(case.free, ei, span, rise)),
            curvature_max=choose(jnp.full_like(s, 1.0 / radius), largest_curvature(case.free)),
            arc_length=choose(length, free_length(case.free)),
            exists=case.exists,
            valid=case.valid,
        )

    def centreline(self, leaf: Leaf, span: float, rise: float, points: int = 101) -> Curve:
        """Points (N, 2) [m] from the roller (0, 0) to the clamp (span, rise); N about ``points``."""
        case = jax.jit(WrappedLeaf._cases)(self, jnp.asarray(span), jnp.asarray(rise))
        require_shape(bool(case.exists), span, rise)
        if not bool(case.wrapped):
            return SlidingLeaf().centreline(leaf, span, rise, points)
        radius, arc, slope = self.protection_radius, float(case.bent.arc), float(case.bent.slope)
        psi = slope - arc
        on_arc = max(2, round(points * arc / (2.0 * arc + 4.0 * psi)))
        angle = np.linspace(0.0, arc, on_arc)
        lower = radius * np.stack([np.sin(angle), 1.0 - np.cos(angle)], axis=1)
        step = np.linspace(-1.0, 1.0, max(points - 2 * on_arc + 2, 3))
        middle = 0.5 * np.array([span, rise])
        free = middle + half_curve(slope, radius * math.sqrt(math.sin(psi)), psi * step * np.abs(step))
        return np.concatenate([lower, free[1:-1], 2.0 * middle - lower[::-1]])
