"""The exact leaf: it slides without friction through the roller, a free elastica."""

from __future__ import annotations

import math
from typing import ClassVar, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import numpy.typing as npt

from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import Curve, Field, LeafLaw, LeafState, masked, require_shape
from varistiff.elastic.lemniscate import SlopeTerms, offset_ratio, slope_terms
from varistiff.elastic.polynomial import estrin

_NEWTON_STEPS = 2  # the start is good to 4e-5: 1e-9, then rounding
_START = (1.5, 1.863563e-2, -6.9831e-4, 6.36758e-3, -3.36399e-3, 8.212e-4)  # slope/chord over chord^2


class FreeShape(NamedTuple):
    """Half a free elastica, from its middle (slope ``slope``, no moment) to its horizontal end.

    ``distance`` is that of its end points [m], ``flatness`` sqrt(1 + offset_ratio^2), so that the length
    scale is k = distance/(4 sqrt(sin t) flatness) for the whole leaf.
    """

    slope: Field
    terms: SlopeTerms
    distance: Field
    flatness: Field


def _chord_rate(terms: SlopeTerms) -> Field:
    """d(chord angle)/d(slope) > 0 up to the fold at a slope of 170.9 degrees."""
    o = terms.offset_ratio
    return 1.0 - 0.5 * (1.0 - terms.cosine * terms.offset_over_sine) / (1.0 + o * o)


@jax.custom_jvp
def _middle_slope(chord: Field) -> Field:
    """Slope t in the middle with t - atan(offset_ratio(t)) = chord, the angle of the line of the ends."""
    start = chord * estrin(_START, chord * chord)

    def improve(_: int, t: Field) -> Field:
        terms = slope_terms(t)
        return t - (t - jnp.arctan(terms.offset_ratio) - chord) / _chord_rate(terms)

    solution: Field = jax.lax.fori_loop(0, _NEWTON_STEPS, improve, start)
    return solution


@_middle_slope.defjvp
def _middle_slope_jvp(primals: tuple[Field], tangents: tuple[Field]) -> tuple[Field, Field]:
    t = _middle_slope(primals[0])
    return t, tangents[0] / _chord_rate(slope_terms(t))


def free_shape(span: Field, rise: Field) -> FreeShape:
    """Free elastica between horizontal ends, for span >= 0 and rise > 0 [m]."""
    t = _middle_slope(jnp.arctan2(rise, span))
    terms = slope_terms(t)
    distance = jnp.sqrt(span * span + rise * rise)
    return FreeShape(t, terms, distance, jnp.sqrt(1.0 + terms.offset_ratio**2))


_drawn_shape = jax.jit(free_shape)
_drawn_offset = jax.jit(offset_ratio)


def free_energy(shape: FreeShape, rigidity: float | Field) -> Field:
    """U = EI I2/k [J]."""
    return 8.0 * rigidity * shape.terms.sine * shape.terms.offset_ratio * shape.flatness / shape.distance


def free_force(shape: FreeShape, rigidity: float | Field) -> Field:
    """dU/d(span) = -EI kappa^2/2 [N], kappa the end curvature: the configurational force, -F sin t."""
    return -0.5 * rigidity * end_curvature(shape) ** 2


def free_stiffness(shape: FreeShape, rigidity: float | Field, span: Field, rise: Field) -> Field:
    """d2U/d(span)2 [N/m], negative below span/rise = 0.2552."""
    s, c, o = shape.terms.sine, shape.terms.cosine, shape.terms.offset_ratio
    o_rate = 0.5 * (1.0 - c * shape.terms.offset_over_sine)
    half_rate = s * (c * shape.flatness**2 + s * o * o_rate)  # d(s^2 flatness^2)/dt/2
    inner = span * (s * shape.flatness) ** 2 / shape.distance**2 + rise * half_rate / (
        shape.distance**2 * _chord_rate(shape.terms)
    )
    return 16.0 * rigidity * inner / shape.distance**2


def end_curvature(shape: FreeShape) -> Field:
    """Curvature at both horizontal ends sqrt(sin t)/k [1/m]."""
    return 4.0 * shape.terms.sine * shape.flatness / shape.distance


def largest_curvature(shape: FreeShape) -> Field:
    """That of the ends, or 1/k inside the leaf (square to its middle) once the slope passes 90 degrees."""
    s = shape.terms.sine
    level = jnp.where(shape.terms.cosine < 0.0, jnp.sqrt(s), s)
    return 4.0 * level * shape.flatness / shape.distance


def free_length(shape: FreeShape) -> Field:
    """Arc length 2 k I1 [m]."""
    return shape.distance * shape.terms.length_ratio / shape.flatness


def half_curve(slope: float, scale: float, turning: npt.NDArray[np.float64]) -> Curve:
    """Points (N, 2) [m] from the inflection of slope ``slope``, where the leaf has turned by ``turning``.

    ``scale`` is k; negative turnings give the other half, the point reflection.
    """
    psi = np.abs(turning)
    root = np.sqrt(np.sin(psi))
    along = np.sign(turning) * 2.0 * scale * root
    across = -along * np.asarray(_drawn_offset(jnp.asarray(psi)))
    c, s = math.cos(slope), math.sin(slope)
    return np.stack([along * c - across * s, along * s + across * c], axis=1)


class SlidingLeaf(LeafLaw):
    """The leaf slides freely through the roller: minimiser of the bending energy over shape and length.

    A free elastica kappa'' + kappa^3/2 = 0, point-symmetric about its middle, where the slope is t and the
    moment zero; each half is a beam under a normal tip force (`varistiff.elastic.roller_contact` with zero
    radius)::

        t - atan(I2/(2 sqrt(sin t))) = atan2(rise, span),    k = distance/(2 sqrt(4 sin t + I2^2))
        U = EI I2/k,    dU/d(span) = -F sin t,   F = EI/(2 k^2),    length = 2 k I1

    F sin t is the force at the roller: the configurational force M^2/(2 EI) of a sliding sleeve.

    Stability. With the span imposed the leaf is a strict local minimum for every span > 0: its first
    conjugate point passes the clamp only where the chord angle turns back, at t = 170.9 degrees and
    span/rise = -0.169. It overhangs (t > 90 degrees) below span/rise = 0.599. Its tangent stiffness vanishes
    at span/rise = 0.2552 (t = 117.0 degrees) and is negative below: under a dead load it would snap there,
    with an imposed span it does not, so the numbers are given. Spans <= 0 have no mechanism.

    Source: Chacon et al. (2011) for the device; Bigoni et al. (2013) for the force of a sliding sleeve.

    >>> import jax.numpy as jnp
    >>> leaf = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
    >>> round(float(SlidingLeaf().energy(leaf, jnp.asarray(0.081), jnp.asarray(0.0405))), 4)
    1.5181
    """

    references: ClassVar[tuple[str, ...]] = ("chacon_2011", "bigoni_2013")

    def energy(self, leaf: Leaf, span: Field, rise: Field) -> Field:
        """Bending energy [J]; NaN for span <= 0."""
        exists = span > 0.0
        shape = free_shape(jnp.where(exists, span, 1.0), rise)
        return masked(exists, free_energy(shape, leaf.flexural_rigidity))

    def respond(self, leaf: Leaf, span: Field, rise: Field) -> LeafState:
        """State at (span, rise) [m]; no shape for span <= 0."""
        exists, ei = span > 0.0, leaf.flexural_rigidity
        x = jnp.where(exists, span, 1.0)
        shape = free_shape(x, rise)
        return LeafState(
            energy=masked(exists, free_energy(shape, ei)),
            force=masked(exists, free_force(shape, ei)),
            stiffness=masked(exists, free_stiffness(shape, ei, x, rise)),
            curvature_max=masked(exists, largest_curvature(shape)),
            arc_length=masked(exists, free_length(shape)),
            exists=exists,
            valid=jnp.ones_like(exists),
        )

    def centreline(self, leaf: Leaf, span: float, rise: float, points: int = 101) -> Curve:
        """Points (N, 2) [m] from the roller (0, 0) to the clamp (span, rise), denser towards the middle."""
        require_shape(span > 0.0, span, rise)
        shape = _drawn_shape(jnp.asarray(span), jnp.asarray(rise))
        slope = float(shape.slope)
        scale = 0.25 * float(shape.distance / shape.flatness) / math.sqrt(math.sin(slope))
        step = np.linspace(-1.0, 1.0, points)  # turning grows with the square of the arc length
        return np.array([0.5 * span, 0.5 * rise]) + half_curve(slope, scale, slope * step * np.abs(step))
