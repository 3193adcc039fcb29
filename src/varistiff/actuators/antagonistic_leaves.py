"""The adjustable-stiffness spring of Chacon et al. (2011): two pairs of leaves against each other."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp
import numpy as np

from varistiff.actuators.actuator import Actuator, Field, Quantity, Response, blank, first_status
from varistiff.core.errors import InputError
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import Curve, LeafLaw

# a leaf that just lies on its protecting cylinder has the yield stress itself, up to rounding: not yielded
_YIELD_MARGIN = 1.0 + 1e-12


class AntagonisticLeaves(Actuator):
    """Four leaves, clamped on two nuts of bar 1 and guided by four rollers of bar 2; a linear spring.

    Deflection is the displacement d [m] of bar 2 against bar 1 along the screw, setting the distance delta
    [m] of the nuts, which a right- and left-handed screw changes symmetrically. With U the energy of one
    leaf (`LeafLaw`)::

        x_0 = (D - delta)/2,   V = 2 [U(x_0 - d) + U(x_0 + d)],   load = dV/dd,   adjusting load = dV/d(delta)

    The adjusting load is positive: the leaves press the nuts together, the screw must hold them apart. Loads
    and stiffness are in closed form from those of the leaf.

    Parameters
    ----------
    leaf : one leaf; its length limits the arc from clamp to roller
    law : GuidedLeaf (the paper's model), SlidingLeaf (exact) or WrappedLeaf (exact, with protection
    cylinders)
    roller_distance : D [m] along the screw
    clamp_height : y_f [m] of the clamps over the rollers
    screw_lead : axial travel of one nut per turn [m], or None

    Notes
    -----
    Statuses: ``no_solution`` for delta <= 0, |d| >= x_0, and where a leaf has no stable shape with this span
    imposed (beyond the hard stop of the cylinders); ``element_too_short``; ``outside_validity`` where
    cylinders are too small to hold the leaf (`WrappedLeaf`); ``yielded`` where the largest bending stress of
    any leaf exceeds the yield strength. A negative tangent stiffness is no status: the deflection is
    imposed. The leaves are always preloaded, so ``no_contact`` never occurs.

    Source: Chacon et al. (2011), Eqs. (1)-(4) and section 3. Between the aspect ratios 3.5 and 2 at rest the
    stiffness is multiplied by 10.4 (guided), 10.3 (sliding) and 10.8 (wrapped at R = 35 mm), by 15 first at
    1.81, 1.80 and 1.92. For its "1500 %" the paper names no range and no displacement; wrapped leaves pass it at
    the aspect ratio 2 and a displacement of 7.1 mm.

    >>> leaf = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005, yield_strength=1.5e9)
    >>> from varistiff.elastic.sliding_leaf import SlidingLeaf
    >>> spring = AntagonisticLeaves(leaf=leaf, law=SlidingLeaf(), roller_distance=0.345, clamp_height=0.0405)
    >>> response, _ = spring.respond(jnp.asarray(0.0), jnp.asarray(0.183))
    >>> round(float(response.stiffness), 1)
    7212.7
    """

    kind: ClassVar[str] = "antagonistic_leaves"
    deflection_unit: ClassVar[str] = "m"
    references: ClassVar[tuple[str, ...]] = ("chacon_2011", "bigoni_2013")
    broken_assumption: ClassVar[str] = "the leaf bends tighter than the protection cylinders where they cannot hold it"
    details: ClassVar[dict[str, Quantity]] = {
        "leaf_length_needed": Quantity("arc length from clamp to roller of the longest leaf", "m"),
        "screw_turns": Quantity("turns of the screw from nuts that touch", "1"),
    }

    leaf: Leaf
    law: LeafLaw
    roller_distance: float
    clamp_height: float
    screw_lead: float | None = None

    @property
    def setting_unit(self) -> str | None:
        """The nut distance is a length."""
        return "m"

    @property
    def strength(self) -> float:
        """Tensile yield strength of the leaf [Pa]."""
        return self.leaf.yield_strength

    def spans(self, deflection: Field, setting: Field) -> Field:
        """Spans [m] of left and right leaves, on a new first axis; NaN for a nut distance <= 0."""
        rest = jnp.where(jnp.asarray(setting) > 0.0, 0.5 * (self.roller_distance - setting), jnp.nan)
        return jnp.stack([rest - deflection, rest + deflection])

    def energy(self, deflection: Field, setting: Field) -> Field:
        """V [J] of the four leaves; NaN where a leaf has no stable shape."""
        rise = jnp.asarray(self.clamp_height)
        return 2.0 * jnp.sum(self.law.energy(self.leaf, self.spans(deflection, setting), rise), axis=0)

    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Closed forms of the leaf law, left against right; see ``Actuator.respond``."""
        state = self.law.respond(self.leaf, self.spans(deflection, setting), jnp.asarray(self.clamp_height))
        left, right = state.force
        length = jnp.max(state.arc_length, axis=0)
        stress = self.leaf.bending_stress(jnp.max(state.curvature_max, axis=0))
        status = first_status(
            no_solution=~jnp.all(state.exists, axis=0),
            element_too_short=length > self.leaf.length,
            no_contact=jnp.zeros_like(length, dtype=bool),
            outside_validity=~jnp.all(state.valid, axis=0),
            yielded=stress > _YIELD_MARGIN * self.leaf.yield_strength,
        )
        numbers = (
            2.0 * jnp.sum(state.energy, axis=0),
            2.0 * (right - left),
            2.0 * jnp.sum(state.stiffness, axis=0),
            -(left + right),
            stress,
        )
        response = Response(status, *(blank(status, value) for value in numbers))
        details = {"leaf_length_needed": blank(status, length)}
        if self.screw_lead is not None:
            details["screw_turns"] = blank(status, setting / (2.0 * self.screw_lead) + 0.0 * length)
        return response, details

    def element_shapes(self, deflection: float, setting: float) -> list[Curve]:
        """Centrelines (N, 2) [m] of the four leaves, each from its roller to its clamp, for drawings.

        Frame: origin in the middle of bar 1 on the screw's axis, x along the axis in the positive direction
        of the deflection of bar 2, y across it. The clamps are drawn on the axis at x = -/+ delta/2 and the
        rollers at x = d -/+ D/2, y = +/- y_f; order left upper, left lower, right upper, right lower. The
        published device sets the clamps off the axis by an unpublished distance, which changes nothing but
        the picture.
        """
        if setting <= 0.0:
            raise InputError(f"nut distance {setting:g} m; it must be positive", field="setting")
        rest, middle = 0.5 * (self.roller_distance - setting), 0.5 * self.roller_distance
        shapes = []
        for side in (-1.0, 1.0):
            curve = self.law.centreline(self.leaf, rest + side * deflection, self.clamp_height)
            x = deflection + side * (middle - curve[:, 0])
            y = self.clamp_height - curve[:, 1]
            shapes += [np.stack([x, y], axis=1), np.stack([x, -y], axis=1)]
        return shapes


def screw_turns(setting_from: float, setting_to: float, *, lead: float) -> float:
    """Turns of the right- and left-handed screw between two nut distances [m]; positive moves the nuts apart.

    One turn moves each nut by the lead [m per turn], so the distance changes by twice that.

    >>> round(screw_turns(0.0615, 0.183, lead=0.002), 6)
    30.375
    """
    if not lead > 0.0:
        raise InputError(f"{lead:g} m; the lead of a screw must be positive", field="screw_lead")
    return (setting_to - setting_from) / (2.0 * lead)


def protecting_radius(leaf: Leaf) -> float:
    """Smallest radius R = E t/(2 sigma_y) [m] to which a leaf bends without yielding; Eq. (3) of the paper.

    Zero for a leaf without a yield strength.

    >>> round(
    ...     protecting_radius(Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005, yield_strength=1.5e9)),
    ...     6,
    ... )
    0.035
    """
    return leaf.youngs_modulus * leaf.thickness / (2.0 * leaf.yield_strength)


def aspect_ratio(setting: float, *, roller_distance: float, clamp_height: float) -> float:
    """Span over rise of the leaves at rest, alpha = (D - delta)/(2 y_f) [-]; Eq. (4) of the paper.

    >>> round(aspect_ratio(0.0615, roller_distance=0.345, clamp_height=0.0405), 6)
    3.5
    """
    return (roller_distance - setting) / (2.0 * clamp_height)
