"""What a link needs from its spring, and the deflection that gives it."""

from __future__ import annotations

from collections.abc import Callable

import equinox as eqx
import jax.numpy as jnp

from varistiff.actuators.actuator import Response
from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Number, Scalar, Wanted, as_scalar


class LinkModel(eqx.Module):
    """The link as a controller knows it: J q'' + D q' + gravity(q) = load.

    Parameters
    ----------
    inertia : J [kg m^2 or kg], above 0
    damping : D [N m s/rad or N s/m], at least 0
    gravity : torque [N m] against +q at a position [rad]; None for none

    Raises
    ------
    InputError : a number is out of range
    """

    inertia: Number
    damping: Number = 0.0
    gravity: Callable[[Scalar], Scalar] | None = None

    def __check_init__(self) -> None:
        check_number("inertia", self.inertia, above=0.0)
        check_number("damping", self.damping, least=0.0)

    def load(self, wanted: Wanted) -> Scalar:
        """Load [N m or N] that the wanted motion needs, with the wanted torque."""
        needed = self.inertia * wanted.position_acceleration + self.damping * wanted.position_rate + wanted.torque
        if self.gravity is None:
            return as_scalar(needed)
        return needed + self.gravity(as_scalar(wanted.position))


class GravityTorque(eqx.Module):
    """Gravity of a pendulum: m g l sin(q - q_0), the torque against +q.

    Parameters
    ----------
    moment : m g l [N m]
    rest : q_0 [rad], where it hangs
    """

    moment: Number
    rest: Number = 0.0

    def __call__(self, position: Scalar) -> Scalar:
        """Torque [N m] at a link position [rad]."""
        return self.moment * jnp.sin(position - self.rest)


def wanted_deflection(response: Response, deflection: Scalar, load: Number, *, stiffness_min: Number) -> Scalar:
    """Deflection [rad or m] at which the spring would give ``load``, by the tangent at the measured point.

        d_w = d + (load - load(d, s))/stiffness(d, s)

    Exact for a linear spring; for any other the next sample goes on from where this one led.

    Parameters
    ----------
    response : of the map at the measured point
    deflection : d [rad or m] there
    load : wanted [N m or N]
    stiffness_min : the tangent is taken to be at least this steep [N m/rad or N/m], above 0: a slack spring would ask
        for any deflection
    """
    return deflection + (load - response.load) / jnp.maximum(response.stiffness, stiffness_min)
