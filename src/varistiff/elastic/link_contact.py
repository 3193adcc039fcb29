"""A roller on a pivoting link that bends a cantilever: the law shared by the roller beam and the slider leaf joint."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
from jax import lax
from jaxtyping import Array, Float

from varistiff.elastic.lemniscate import circular
from varistiff.elastic.roller_contact import RollerContact, roller_contact

Field = Float[Array, "..."]


class LinkContact(NamedTuple):
    """Contact in joint coordinates; SI units, one shape."""

    contact: RollerContact
    centre: tuple[Field, Field]  # roller centre in the clamp's frame [m]
    moment: Field  # dV/d(link angle) [N m]
    thrust: Field  # dV/d(position), force along the link that holds the roller's carriage [N]
    stiffness: Field  # d2V/d(link angle)2 [N m/rad]


def link_contact(
    angle: Field,
    position: Field,
    *,
    offset: Field,
    joint: tuple[Field, Field],
    radius: Field,
    flexural_rigidity: Field,
) -> LinkContact:
    """Lower roller at (position, offset) on a link turned by ``angle`` about ``joint``.

    With C = joint + Rot(angle) (position, offset) and zeta = angle - t the angle between link and beam at the contact,

        moment = F (position cos zeta - offset sin zeta),    thrust = F sin zeta

    and the stiffness is the Hessian of V(C) along the roller's circle less the turning of the force.

    Parameters
    ----------
    angle : of the link against the undeformed beam [rad]
    position, offset : of the roller's centre along and across the link [m]
    joint : pivot of the link in the clamp's frame (x, y) [m]
    radius : of the roller to the beam's centreline [m]
    flexural_rigidity : E I [N m^2]

    Notes
    -----
    For an upper roller mirror the inputs (angle, offset, joint y) and the moment. Source: dos Santos and Richter
    (2019), doi 10.3390/act8010012, Eqs. (6)-(11); moment, thrust and stiffness are announced there but not printed.
    """
    sine, cosine = lax.optimization_barrier(circular(angle))
    x = joint[0] + position * cosine - offset * sine
    y = joint[1] + position * sine + offset * cosine
    state = roller_contact(x, y, radius, flexural_rigidity)
    cos_zeta = cosine * state.cosine + sine * state.sine
    sin_zeta = sine * state.cosine - cosine * state.sine
    across = position * cos_zeta - offset * sin_zeta
    along = position * sin_zeta + offset * cos_zeta
    stiffness = (
        state.stiffness_tt * along * along
        - 2.0 * state.stiffness_tn * along * across
        + state.stiffness_nn * across * across
        - state.force * along
    )
    return LinkContact(state, (x, y), state.force * across, state.force * sin_zeta, stiffness)


def mirrored(side: Field, value: Field) -> Field:
    """``value`` seen in the mirror where ``side`` is negative."""
    return jnp.where(side < 0.0, -value, value)
