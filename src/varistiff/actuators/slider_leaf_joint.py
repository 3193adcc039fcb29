"""The reconfigurable joint of Wang et al. (2024): leaf springs, sliders and a groove disc."""

from __future__ import annotations

import math
from typing import ClassVar

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from varistiff.actuators.actuator import Actuator, Field, Mask, Quantity, Response, blank, first_status
from varistiff.actuators.compiled import details_at
from varistiff.actuators.groove import Groove
from varistiff.actuators.leaf_joint_theory import LargeDeflection, LeafJointState, LeafJointTheory, SmallDeflection
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.roller_contact import centreline


class SliderLeafJoint(Actuator):
    """N leaves clamped radially on the output disc, each held at its active length by a slider on the input disc.

    Deflection is the angle phi [rad] of the input against the output, setting the active length l_1 [m] or, driven
    through the groove, the angle of the stiffness disc [rad] with 0 at the clamp. The adjusting load is dV/dl_1, a
    force on all sliders together, or dV/d(disc angle) = dV/dl_1 dl_1/da, a torque on the disc. It is negative: the
    sliders want to move outward. Eq. (12) of the paper gives its magnitude and calls it a torque.

    Parameters
    ----------
    leaf : one leaf
    count : number N of engaged leaves
    clamp_radius : r_2 [m]
    theory : SmallDeflection (the paper's) or LargeDeflection (exact elastica)
    groove : optional groove of the stiffness disc
    driven_by : "length", or "disc" where the setting is the disc's angle

    Notes
    -----
    Statuses: ``no_solution`` for l_1 <= 0, settings off the groove, or beyond the fold (exact);
    ``element_too_short``; ``outside_validity`` beyond 10 degrees of leaf rotation (small deflection); ``yielded``. The
    fork has no play, so phi = 0 is ``ok``. doi 10.3390/app14072685.
    """

    kind: ClassVar[str] = "slider_leaf_joint"
    deflection_unit: ClassVar[str] = "rad"
    references: ClassVar[tuple[str, ...]] = ("wang_2024",)
    broken_assumption: ClassVar[str] = "the leaf turns by more than 10 deg, the limit of the small-deflection theory"
    details: ClassVar[dict[str, Quantity]] = {
        "leaf_rotation": Quantity("slope of a leaf at its slider", "rad"),
        "contact_force": Quantity("force of one slider on its leaf", "N"),
        "active_arc_length": Quantity("arc length of a leaf up to its slider", "m"),
        "active_length": Quantity("active length l_1", "m"),
        "disc_angle": Quantity("angle of the stiffness disc", "rad"),
    }

    leaf: Leaf
    count: int
    clamp_radius: float
    theory: LeafJointTheory = SmallDeflection()
    groove: Groove | None = None
    driven_by: str = eqx.field(static=True, default="length")

    @property
    def setting_unit(self) -> str | None:
        """A length, or the angle of the stiffness disc."""
        return "rad" if self.driven_by == "disc" else "m"

    @property
    def strength(self) -> float:
        """Tensile yield strength of the leaf [Pa]."""
        return self.leaf.yield_strength

    def active_length(self, setting: Field) -> Field:
        """l_1 [m] of a setting."""
        if self.driven_by == "disc":
            assert self.groove is not None
            return self.groove.active_length(setting)
        return setting

    def _reached(self, setting: Field, length: Field) -> Mask:
        """Whether the mechanism has this setting."""
        if self.groove is None:
            return length > 0.0
        if self.driven_by == "disc":
            return self.groove.reaches(setting) & (length > 0.0)
        travel = self.groove.outer_radius - self.groove.inner_radius
        return (length > 0.0) & (length <= travel * (1.0 + 1e-12))

    def _solve(self, deflection: Field, length: Field) -> LeafJointState:
        return self.theory.solve(self.leaf, self.count, self.clamp_radius, deflection, length)

    def energy(self, deflection: Field, setting: Field) -> Field:
        """V [J] of all leaves; NaN where no solution exists."""
        length = self.active_length(setting) + 0.0 * deflection
        reached = self._reached(setting, length)
        state = self._solve(deflection, jnp.where(reached, length, self.clamp_radius))
        return jnp.where(reached & state.exists, state.energy, jnp.nan)

    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Closed forms of the theory, translated to the setting; see ``Actuator.respond``."""
        length = self.active_length(setting) + 0.0 * deflection
        reached = self._reached(setting, length)
        # settings that no mechanism has are solved at a harmless length and blanked
        usable = jnp.where(reached, length, self.clamp_radius)
        state = self._solve(deflection, usable)
        stress = self.leaf.bending_stress(state.curvature)
        status = first_status(
            no_solution=jnp.logical_not(reached) | ~state.exists,
            element_too_short=state.arc_length > self.leaf.length,
            no_contact=jnp.zeros_like(reached),
            outside_validity=~state.valid,
            yielded=stress > self.leaf.yield_strength,
        )
        adjusting = state.thrust
        details = {
            "leaf_rotation": state.rotation,
            "contact_force": state.force,
            "active_arc_length": state.arc_length,
        }
        if self.groove is not None:
            details["active_length"] = usable
            details["disc_angle"] = self.groove.angle(usable)
            if self.driven_by == "disc":
                adjusting = adjusting * self.groove.active_length_rate(setting)
        numbers = (state.energy, state.load, state.stiffness, adjusting, stress)
        response = Response(status, *(blank(status, value) for value in numbers))
        return response, {name: blank(status, value) for name, value in details.items()}

    def element_shapes(self, deflection: float, setting: float) -> list[np.ndarray]:
        """Centrelines of the N leaves in the output disc's frame (axis at the origin), each (N, 2) [m].

        Leaf 0 is clamped at (clamp_radius, 0) and points along +x, the others follow by turns of 2 pi/N. Drawn by
        the exact elastica for either theory, a fifth of the active length beyond the slider where no length is given.
        """
        exact = eqx.tree_at(lambda joint: joint.theory, self, LargeDeflection())
        state = details_at(exact, deflection, setting)
        length = float(setting) if self.groove is None or state is None else state["active_length"]
        drawn = self.leaf.length if math.isfinite(self.leaf.length) else 1.2 * length
        if state is None:
            line = centreline(0.0, drawn)
        else:
            arc = state["active_arc_length"]
            line = centreline(abs(state["leaf_rotation"]), arc, tail=max(drawn - arc, 0.0))
        line = line * np.array([1.0, math.copysign(1.0, deflection)]) + np.array([self.clamp_radius, 0.0])
        turns = [2.0 * math.pi * index / self.count for index in range(self.count)]
        return [line @ np.array([[math.cos(a), math.sin(a)], [-math.sin(a), math.cos(a)]]) for a in turns]
