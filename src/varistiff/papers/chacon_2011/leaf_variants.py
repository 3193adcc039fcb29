"""Springs that the paper compares with, in the place of the leaves of its device."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp
import numpy as np

from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import Curve, Field, LeafLaw, LeafState, masked, require_shape
from varistiff.elastic.linear_cantilever import linear_cantilever


class LinearBeam(LeafLaw):
    """The leaf with the linearised curvature y'' that the paper rules out: two cantilevers tip to tip.

    Each cantilever is half as long as the span and takes half the rise, so with P their tip force::

        P = 12 EI rise/span^3,   U = P rise/2,   dU/d(span) = -3 U/span,   d2U/d(span)2 = 12 U/span^2

    Valid for rise much smaller than span. Curvature and length are those of the cubic, linearised too.

    >>> leaf = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
    >>> round(float(LinearBeam().energy(leaf, jnp.asarray(0.081), jnp.asarray(0.0405))), 6)
    2.025463
    """

    references: ClassVar[tuple[str, ...]] = ("chacon_2011",)

    def energy(self, leaf: Leaf, span: Field, rise: Field) -> Field:
        """Bending energy [J]; NaN for span <= 0."""
        half = linear_cantilever(0.5 * rise, 0.5 * span, jnp.asarray(leaf.flexural_rigidity))
        return masked(span > 0.0, 0.5 * half.force * rise)

    def respond(self, leaf: Leaf, span: Field, rise: Field) -> LeafState:
        """State at (span, rise) [m]; no shape for span <= 0."""
        exists = span > 0.0
        half = linear_cantilever(0.5 * rise, 0.5 * span, jnp.asarray(leaf.flexural_rigidity))
        energy = self.energy(leaf, span, rise)
        return LeafState(
            energy=energy,
            force=-3.0 * energy / span,
            stiffness=12.0 * energy / span**2,
            curvature_max=masked(exists, half.root_curvature),
            arc_length=masked(exists, span),
            exists=exists,
            valid=jnp.ones_like(exists),
        )

    def centreline(self, leaf: Leaf, span: float, rise: float, points: int = 101) -> Curve:
        """Points (N, 2) [m] of the cubic from the roller (0, 0) to the clamp (span, rise)."""
        require_shape(span > 0.0, span, rise)
        part = np.linspace(0.0, 1.0, points)
        return np.stack([span * part, rise * part**2 * (3.0 - 2.0 * part)], axis=1)


class PowerSpring(LeafLaw):
    """A compression spring between nut and roller with the force rate (free_span - span)^(exponent - 1).

    Exponent 2 is a linear spring, exponent 3 one with the quadratic characteristic of the rolamites that the
    paper cites. The rise plays no part.

    Parameters
    ----------
    rate : force per compression^(exponent - 1), SI units
    exponent : of the energy, above 1
    free_span : span without force [m]; the spring stays compressed in every use here
    """

    references: ClassVar[tuple[str, ...]] = ("chacon_2011",)

    rate: float
    exponent: float
    free_span: float

    def energy(self, leaf: Leaf, span: Field, rise: Field) -> Field:
        """Energy [J]; NaN for a span that is not compressed."""
        squeeze = self.free_span - span
        return masked(squeeze > 0.0, self.rate / self.exponent * squeeze**self.exponent)

    def respond(self, leaf: Leaf, span: Field, rise: Field) -> LeafState:
        """State at a span [m]; none where the spring is not compressed."""
        squeeze, exponent = self.free_span - span, self.exponent
        exists = squeeze > 0.0
        return LeafState(
            energy=self.energy(leaf, span, rise),
            force=masked(exists, -self.rate * squeeze ** (exponent - 1.0)),
            stiffness=masked(exists, self.rate * (exponent - 1.0) * squeeze ** (exponent - 2.0)),
            curvature_max=jnp.zeros_like(span),
            arc_length=masked(exists, span),
            exists=exists,
            valid=jnp.ones_like(exists),
        )

    def centreline(self, leaf: Leaf, span: float, rise: float, points: int = 101) -> Curve:
        """Points (N, 2) [m] of its straight axis."""
        part = np.linspace(0.0, 1.0, points)
        return np.stack([span * part, rise * part], axis=1)
