"""What every model of a leaf between a clamp and a guiding roller answers."""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import numpy.typing as npt
from jaxtyping import Array, Bool, Float

from varistiff.core.errors import InputError
from varistiff.elastic.leaf import Leaf

Field = Float[Array, "..."]
Mask = Bool[Array, "..."]
Curve = npt.NDArray[np.float64]


class LeafState(NamedTuple):
    """Answer of a leaf law, per point; numbers are NaN where ``exists`` is false.

    ``energy`` U [J], ``force`` dU/d(span) [N], ``stiffness`` d2U/d(span)2 [N/m] (tangent), all at a fixed
    rise; ``curvature_max`` the largest curvature of the leaf [1/m]; ``arc_length`` from clamp to roller [m];
    ``exists`` whether a stable shape exists with this span imposed; ``valid`` whether the law's own
    assumptions hold.
    """

    energy: Field
    force: Field
    stiffness: Field
    curvature_max: Field
    arc_length: Field
    exists: Mask
    valid: Mask


class LeafLaw(eqx.Module):
    """A leaf that leaves a roller horizontally and ends horizontally in a clamp.

    ``span`` is the horizontal and ``rise`` the vertical distance from roller to clamp [m], ``rise`` > 0.
    The leaf's length between them is free. With EI the flexural rigidity, U rise/EI depends on span/rise
    (and on lengths of the law over rise) alone.
    """

    references: ClassVar[tuple[str, ...]]  # keys of varistiff.core.citations

    @abstractmethod
    def energy(self, leaf: Leaf, span: Field, rise: Field) -> Field:
        """Bending energy U [J]; differentiable, NaN where no stable shape exists."""

    @abstractmethod
    def respond(self, leaf: Leaf, span: Field, rise: Field) -> LeafState:
        """Energy, its first two derivatives in closed form, largest curvature and length."""

    @abstractmethod
    def centreline(self, leaf: Leaf, span: float, rise: float, points: int = 101) -> Curve:
        """Points (N, 2) [m] of the deformed leaf from the roller (0, 0) to the clamp (span, rise).

        x runs along the roller line towards the clamp, y from the roller line to the clamp.
        Raises ``InputError`` where no stable shape exists.
        """


def masked(exists: Mask, value: Field) -> Field:
    """The value where a shape exists, NaN elsewhere."""
    return jnp.where(exists, value, jnp.nan)


def require_shape(exists: bool, span: float, rise: float) -> None:
    """Refuse to draw a leaf that has no stable shape."""
    if not exists:
        problem = f"no stable leaf at span {span:g} m and rise {rise:g} m; choose a larger span"
        raise InputError(problem, field="span")
