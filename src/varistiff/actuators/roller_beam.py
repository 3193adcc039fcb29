"""The roller beam of dos Santos and Richter (2019): a cantilever under a moving roller, large deflection."""

from __future__ import annotations

import math
from typing import ClassVar

import jax.numpy as jnp
import numpy as np

from varistiff.actuators.actuator import Actuator, Field, Mask, Quantity, Response, blank, first_status
from varistiff.actuators.compiled import details_at
from varistiff.actuators.rollers import Bearing, Rollers
from varistiff.elastic.beam_clearance import beam_clearance
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.lemniscate import circular
from varistiff.elastic.link_contact import LinkContact, link_contact, mirrored
from varistiff.elastic.roller_contact import centreline


class RollerBeam(Actuator):
    """Cantilever on link 1 bent by a roller that a shuttle moves along link 2 (the shank).

    Deflection is the joint angle theta_j [rad], setting the roller position x_r [m]. The moment that the actuator
    puts on link 2 in the direction of +theta_j is minus the load; the adjusting force is what holds the shuttle,
    positive away from the joint (the paper's thrust on the roller is its opposite).

    Parameters
    ----------
    beam : the leaf; its length limits the arc length to the contact
    rollers : arrangement of the rollers on the shuttle
    mounting_angle : alpha_w [rad]
    clamp_offset_along, clamp_offset_across : d_1, d_0, from the joint to the clamp [m]

    Notes
    -----
    Inextensible Euler-Bernoulli beam without friction, valid for slender beams (length over thickness above 5.4) and
    any slope up to the fold. Statuses: ``no_solution`` beyond the fold, for x_r <= 0 and for links turned by more
    than half a turn; ``element_too_short`` where the contact lies beyond the beam's end; ``no_contact``;
    ``outside_validity`` (NaN) where both rollers of a fixed pair would bear; ``yielded``. doi 10.3390/act8010012.
    """

    kind: ClassVar[str] = "roller_beam"
    deflection_unit: ClassVar[str] = "rad"
    references: ClassVar[tuple[str, ...]] = ("dos_santos_2019",)
    broken_assumption: ClassVar[str] = "both rollers of the fixed pair would bear on the beam"
    loses_contact: ClassVar[bool] = True
    details: ClassVar[dict[str, Quantity]] = {
        "contact_slope": Quantity("slope of the beam at the contact", "rad"),
        "contact_force": Quantity("contact force normal to the beam", "N"),
        "active_length": Quantity("arc length from the clamp to the contact", "m"),
        "root_moment": Quantity("bending moment at the clamp", "N*m"),
    }

    beam: Leaf
    rollers: Rollers
    mounting_angle: float = 0.0
    clamp_offset_along: float = 0.0
    clamp_offset_across: float = 0.0

    @property
    def setting_unit(self) -> str | None:
        """The setting is the roller's position, a length."""
        return "m"

    @property
    def strength(self) -> float:
        """Tensile yield strength of the leaf [Pa]."""
        return self.beam.yield_strength

    def joint(self) -> tuple[Field, Field]:
        """Joint in the clamp's frame: Rot(alpha_w) (-d_1, -d_0) [m]."""
        sine, cosine = jnp.sin(self.mounting_angle), jnp.cos(self.mounting_angle)
        along, across = self.clamp_offset_along, self.clamp_offset_across
        return -along * cosine + across * sine, -along * sine - across * cosine

    def centre(self, deflection: Field, setting: Field, offset: Field) -> tuple[Field, Field]:
        """Point of the shuttle at ``offset`` from the link's axis, in the clamp's frame [m]."""
        sine, cosine = circular(self.mounting_angle + deflection)
        x, y = self.joint()
        return x + setting * cosine - offset * sine, y + setting * sine + offset * cosine

    def _bearing(self, deflection: Field, setting: Field) -> Bearing:
        return self.rollers.acting(lambda offset: self.centre(deflection, setting, offset), self.beam.thickness)

    def _contact(self, deflection: Field, setting: Field, bearing: Bearing) -> LinkContact:
        x, y = self.joint()
        side = bearing.side
        return link_contact(
            side * (self.mounting_angle + deflection),
            setting,
            offset=side * bearing.offset,
            joint=(x, side * y),
            radius=bearing.radius,
            flexural_rigidity=jnp.asarray(self.beam.flexural_rigidity),
        )

    def _blocked(self, deflection: Field, setting: Field, bearing: Bearing, solved: LinkContact) -> Mask:
        """Whether the other roller of a fixed pair would bear on the deformed beam too."""
        partner = self.rollers.partner(bearing, self.beam.thickness)
        if partner is None:
            return jnp.zeros_like(solved.contact.touching)
        x, y = self.centre(deflection, setting, partner)
        state, (centre_x, centre_y) = solved.contact, solved.centre
        dx, dy = x - centre_x, bearing.side * y - centre_y
        along = dx * state.cosine + dy * state.sine
        across = dy * state.cosine - dx * state.sine - bearing.radius
        reach = centre_x * state.cosine + centre_y * state.sine
        length = jnp.asarray(self.beam.length)
        return beam_clearance(state, reach, along, across, length) < bearing.radius

    def energy(self, deflection: Field, setting: Field) -> Field:
        """V [J]: 2 E I sin t offset_ratio(t)/X; 0 without contact, NaN where no solution exists."""
        state = self._contact(deflection, setting, self._bearing(deflection, setting)).contact
        value = jnp.where(state.touching, jnp.where(state.exists, state.energy, jnp.nan), 0.0)
        return jnp.where(self._reached(deflection, setting), value, jnp.nan)

    def _reached(self, deflection: Field, setting: Field) -> Mask:
        """Whether the shuttle and the joint can stand there."""
        return (setting > 0.0) & (jnp.abs(self.mounting_angle + deflection) <= math.pi)

    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Closed forms of the contact, translated to the joint; see ``Actuator.respond``."""
        bearing = self._bearing(deflection, setting)
        solved = self._contact(deflection, setting, bearing)
        state, side = solved.contact, bearing.side
        stress = self.beam.bending_stress(state.curvature_max)
        blocked = self._blocked(deflection, setting, bearing, solved)
        status = first_status(
            no_solution=(state.touching & ~state.exists) | ~self._reached(deflection, setting),
            element_too_short=state.touching & (state.arc_length > self.beam.length),
            no_contact=~state.touching,
            outside_validity=blocked,
            yielded=stress > self.beam.yield_strength,
        )
        blocked = blocked & state.touching

        def held(value: Field) -> Field:
            return blank(status, value, extra_nan=blocked)

        response = Response(
            status=status,
            energy=held(state.energy),
            load=held(mirrored(side, solved.moment)),
            stiffness=held(solved.stiffness),
            adjusting_load=held(solved.thrust),
            stress=held(stress),
        )
        details = {
            "contact_slope": held(mirrored(side, state.slope)),
            "contact_force": held(state.force),
            "active_length": held(state.arc_length),
            "root_moment": held(mirrored(side, state.root_moment)),
        }
        return response, details

    def element_shapes(self, deflection: float, setting: float) -> list[np.ndarray]:
        """Deformed centreline of the whole beam in the clamp's frame, shape (N, 2) [m]; straight without contact."""
        drawn = self.beam.length if math.isfinite(self.beam.length) else 1.2 * float(setting)
        state = details_at(self, deflection, setting)
        if state is None or state["contact_slope"] == 0.0:
            return [centreline(0.0, drawn)]
        slope, length = state["contact_slope"], state["active_length"]
        line = centreline(abs(slope), length, tail=max(drawn - length, 0.0))
        return [line * np.array([1.0, math.copysign(1.0, slope)])]
