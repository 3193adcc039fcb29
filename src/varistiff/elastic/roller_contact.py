"""A cantilever that slides over a frictionless roller: the elastica under a normal tip force, exact.

Frame: the beam is clamped at the origin along +x; a roller of radius r (to the beam's centreline) bears from below
at the centre C and pushes the beam towards +y. The contact force F is normal to the beam, so the slope t at the
contact fixes everything. With X = C.t^ (the distance of the contact along its own tangent) and the ratios of
``lemniscate``,

    (C x t^) - r = X offset_ratio(t)                                the contact condition
    F = 2 E I sin t/X^2,   L = X length_ratio,   V = 2 E I sin t offset_ratio/X,   M_root = 2 E I sin t/X

which hold through t = 90 degrees up to the fold, where the beam slips off. Derived from Eqs. (1)-(12) of dos Santos
and Richter (2019), doi 10.3390/act8010012, whose tan(t) form is singular at 90 degrees. A negative r describes a
pair of rollers that turns with the beam: the contact lies beyond the pivot by the clearance.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import lax
from jaxtyping import Array, Bool, Float

from varistiff.elastic.lemniscate import COEFFICIENTS, SlopeTerms, slope_terms
from varistiff.elastic.polynomial import estrin

CONTACT_TOLERANCE = 1e-12  # a gap or an overlap [m] below this is no contact
_CONVERGED = 1e-6  # a cubic step this small leaves an error below 1e-15
_FIRST_CHANGE = 1e-6  # the same for the second step from the fitted guess, which in practice is a thousandth of that
_STEPS_AT_MOST = 60

Field = Float[Array, "..."]
_Carry = tuple[Array, Array, Array, Array, Array]


class RollerContact(NamedTuple):
    """State of the beam at one roller position; all fields share one shape, SI units."""

    touching: Bool[Array, "..."]  # the undeformed beam would overlap the roller
    exists: Bool[Array, "..."]  # a stable solution exists: not beyond the fold
    slope: Field  # t, at the contact [rad]
    sine: Field  # sin t
    cosine: Field  # cos t
    force: Field  # F, normal to the beam [N]
    arc_length: Field  # L, from the clamp to the contact [m]
    root_moment: Field  # at the clamp [N m]
    curvature_max: Field  # the largest along the beam [1/m]
    energy: Field  # V [J]
    stiffness_nn: Field  # d2V/dC2 along the contact normal [N/m]
    stiffness_tn: Field  # mixed [N/m]
    stiffness_tt: Field  # along the contact tangent [N/m]


def roller_contact(centre_x: Field, centre_y: Field, radius: Field, flexural_rigidity: Field) -> RollerContact:
    """Solve the contact for roller centres (centre_x, centre_y) [m], arrays of one shape.

    Parameters
    ----------
    centre_x, centre_y : roller centre C in the clamp's frame [m]
    radius : distance of the centre from the beam's centreline [m]: roller radius plus half the thickness
    flexural_rigidity : E I [N m^2]

    Returns
    -------
    RollerContact; where ``touching`` or ``exists`` is false the numbers are those of a harmless stand-in and
    must not be used. The gradient of dV/dC is F (-sin t, cos t).

    Notes
    -----
    Valid for slender inextensible beams, 0 <= t up to the fold (171 degrees at r = 0). Relative error about 1e-14
    except within 1e-3 rad of first contact and near the fold, where the problem itself is ill-conditioned.

    >>> state = roller_contact(*map(jnp.asarray, (0.5, 0.01, 0.0, 13.0)))
    >>> round(float(state.force * 0.5**3 / (3 * 13.0 * 0.01)), 3)  # P L^3/(3 E I b) -> 1
    0.999
    """
    touching = centre_y + radius > CONTACT_TOLERANCE
    usable = touching & (radius * radius < centre_x * centre_x + centre_y * centre_y)
    x = jnp.where(usable, centre_x, 1.0)
    y = jnp.where(usable, centre_y, 0.1)
    r = jnp.where(usable, radius, 0.0)
    exists = usable & _before_fold(*_unit(x, y, r))
    slope = contact_slope(x, y, r)
    terms = _materialised(slope_terms(slope))
    reach = x * terms.cosine + y * terms.sine
    return RollerContact(touching, exists, slope, *_state(terms, reach, r, slope, flexural_rigidity))


def _state(terms: SlopeTerms, reach: Field, radius: Field, slope: Field, flexural_rigidity: Field) -> tuple[Field, ...]:
    """Fields of RollerContact after the slope; ``reach`` is X = C.t^."""
    s, c, h, h_over_s, length = terms
    inverse = 1.0 / reach
    root_moment = 2.0 * flexural_rigidity * s * inverse
    force = root_moment * inverse
    # beyond 90 degrees the moment peaks inside the beam, where the tangent is normal to the contact's
    peak = jnp.where(slope > 0.5 * math.pi, lax.rsqrt(jnp.where(slope > 0.5 * math.pi, s, 1.0)), 1.0)
    curvature = 2.0 * s * inverse * peak
    lever = 0.5 * reach * c + s * (reach * h + radius)  # B sin t of the derivation
    fold = reach + 2.0 * h_over_s * lever  # D/sqrt(sin t): zero at the fold
    inverse_fold = 1.0 / fold
    normal = 8.0 * flexural_rigidity * lever * inverse * inverse * inverse * inverse_fold
    mixed = -4.0 * flexural_rigidity * s * inverse * inverse * inverse_fold
    tangential = -2.0 * force * h * inverse_fold
    return s, c, force, reach * length, root_moment, curvature, root_moment * h, normal, mixed, tangential


def _materialised(terms: SlopeTerms) -> SlopeTerms:
    """Keep the compiler from evaluating the polynomials again for every output that uses them."""
    return SlopeTerms(*lax.optimization_barrier(tuple(terms)))


def _unit(x: Field, y: Field, r: Field) -> tuple[Field, Field, Field]:
    inverse = lax.rsqrt(x * x + y * y)
    return x * inverse, y * inverse, r * inverse


def _mismatch(terms: SlopeTerms, x: Field, y: Field, r: Field) -> Field:
    """Contact condition; negative at t = 0 in contact, increasing in t up to the root."""
    along, across = x * terms.cosine + y * terms.sine, x * terms.sine - y * terms.cosine
    return across - r - along * terms.offset_ratio


def _fold_slope(epsilon: Field) -> Field:
    return estrin(COEFFICIENTS["fold_slope"], epsilon)


def _before_fold(x1: Field, y1: Field, epsilon: Field) -> Bool[Array, "..."]:
    """Whether the centre's polar angle is below the largest that any slope reaches, a function of r/rho alone.

    The fold's slope comes from a polynomial; the angle is stationary there, so its error enters squared.
    """
    return _mismatch(slope_terms(_fold_slope(epsilon)), x1, y1, epsilon) >= 0.0


def _first_guess(x1: Field, y1: Field, epsilon: Field, fold_slope: Field) -> Field:
    """Contact slope to about 1 %, from tan(beta/2) and r/rho, with the fold's square root taken out."""
    half_tangent = y1 / (1.0 + x1)
    at_contact = -epsilon / (1.0 + jnp.sqrt(1.0 - epsilon * epsilon))
    at_fold = estrin(COEFFICIENTS["fold_half_tangent"], epsilon)
    u = jnp.sqrt(jnp.clip((at_fold - half_tangent) / (at_fold - at_contact), 0.0, 1.0))
    row = [estrin(coefficients, epsilon) for coefficients in COEFFICIENTS["start"]]
    ratio = row[-1]
    for coefficient in reversed(row[:-1]):
        ratio = ratio * u + coefficient
    return jnp.clip(ratio * (1.0 - u), 0.0, fold_slope)


def _room(slope: Field) -> Field:
    """Distance to the nearer singularity, 0 or pi: what the size of a step is judged by."""
    return jnp.minimum(slope, math.pi - slope)


def _step(slope: Field, x1: Field, y1: Field, epsilon: Field) -> tuple[Field, Field]:
    """Mismatch and the root of its second-order Taylor polynomial: cubic, and exact in kind at the fold."""
    terms = slope_terms(slope)
    s, c, h, h_over_s, _ = terms
    along, across = x1 * c + y1 * s, x1 * s - y1 * c
    g = across - epsilon - along * h
    h1 = 0.5 - 0.5 * h_over_s * c
    h2 = 0.5 * (h_over_s - h1 * c) / jnp.maximum(s, 1e-12)
    g1 = along + across * h - along * h1
    g2 = -across + along * h + 2.0 * across * h1 - along * h2
    root = jnp.sqrt(jnp.maximum(g1 * g1 - 2.0 * g * g2, 0.0))
    return g, -2.0 * g / jnp.maximum(jnp.maximum(g1, 0.0) + root, 1e-300)


@jax.custom_jvp
def contact_slope(x: Field, y: Field, r: Field) -> Field:
    """Slope t of the beam at the contact [rad]; needs contact, and a centre before the fold.

    Two cubic steps from the fitted guess serve the whole practical range; the rare points that need more
    (|r| close to the centre's distance) are bracketed and finished in a loop.
    """
    x1, y1, epsilon = _unit(x, y, r)
    fold_slope = _fold_slope(epsilon)
    slope = _first_guess(x1, y1, epsilon, fold_slope)
    slope = jnp.clip(slope + _step(slope, x1, y1, epsilon)[1], 0.0, fold_slope)
    change = _step(slope, x1, y1, epsilon)[1]
    open_ = (jnp.abs(change) > _FIRST_CHANGE * _room(slope)) & _before_fold(x1, y1, epsilon)
    slope = jnp.clip(slope + change, 0.0, fold_slope)
    finished: Field = lax.cond(jnp.any(open_), _finish, lambda *operands: operands[0], slope, open_, x, y, r)
    return finished


def _finish(slope: Field, open_: Bool[Array, "..."], x: Field, y: Field, r: Field) -> Field:
    """Bracketed cubic steps until every open point has converged."""
    x1, y1, epsilon = _unit(x, y, r)
    fold_slope = _fold_slope(epsilon)

    def body(carry: _Carry) -> _Carry:
        count, t, low, high, pending = carry
        g, change = _step(t, x1, y1, epsilon)
        low, high = jnp.where(g < 0.0, t, low), jnp.where(g < 0.0, high, t)
        close = jnp.abs(change) <= _CONVERGED * _room(t)
        proposal = jnp.clip(t + change, 0.0, fold_slope)
        # a step too small to leave the bracket's end is the last one, not a reason to bisect
        inside = close | (proposal > low) & (proposal < high)
        proposal = jnp.where(inside, proposal, 0.5 * (low + high))
        settled = close | (high - low <= 4e-16 * high)
        return count + 1, jnp.where(pending, proposal, t), low, high, pending & ~settled

    def more(carry: _Carry) -> Array:
        return (carry[0] < _STEPS_AT_MOST) & jnp.any(carry[4])

    start = (jnp.asarray(0), slope, jnp.zeros_like(slope), fold_slope + jnp.zeros_like(slope), open_)
    result: Field = lax.while_loop(more, body, start)[1]
    return result


@contact_slope.defjvp
def _contact_slope_jvp(
    primals: tuple[Field, Field, Field], tangents: tuple[Field, Field, Field]
) -> tuple[Field, Field]:
    """Implicit differentiation of the contact condition."""
    x, y, r = primals
    slope = contact_slope(x, y, r)
    s, c, h, h_over_s, _ = slope_terms(slope)
    along, across = x * c + y * s, x * s - y * c
    rate = along + across * h - along * (0.5 - 0.5 * h_over_s * c)
    dx, dy, dr = tangents
    return slope, -((s - c * h) * dx - (c + s * h) * dy - dr) / rate


def centreline(slope: float, arc_length: float, points: int = 101, tail: float = 0.0) -> np.ndarray:
    """Deformed centreline from the clamp to the contact, then ``tail`` metres straight on; shape (points, 2) [m].

    Parameters
    ----------
    slope, arc_length : t >= 0 and L of the solved contact
    points : on the bent part, evenly spaced in the square root of the angle still to turn
    tail : length of the free end [m]; adds one point
    """
    if slope <= 0.0:
        ends = np.linspace(0.0, arc_length + tail, points)
        return np.stack([ends, np.zeros_like(ends)], axis=1)
    # ds = k dpsi/sqrt(sin psi) with psi = root^2 the angle still to turn
    nodes, weights = np.polynomial.legendre.leggauss(12)
    root = np.linspace(math.sqrt(slope), 0.0, points)
    half = 0.5 * (root[:-1] - root[1:])
    inner = 0.5 * (root[:-1] + root[1:])[:, None] + half[:, None] * nodes
    density = 2.0 * inner / np.sqrt(np.sin(inner**2)) * weights * half[:, None]
    density *= arc_length / density.sum()
    angle = slope - inner**2
    steps = np.stack([(density * np.cos(angle)).sum(axis=1), (density * np.sin(angle)).sum(axis=1)], axis=1)
    line = np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
    if tail > 0.0:
        line = np.concatenate([line, line[-1:] + tail * np.array([[math.cos(slope), math.sin(slope)]])])
    return line
