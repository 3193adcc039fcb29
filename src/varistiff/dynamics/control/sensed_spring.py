"""What the encoders tell of the spring, by way of the actuator's map."""

from __future__ import annotations

import math

import equinox as eqx
import jax.numpy as jnp

from varistiff.actuators.actuator import Actuator, Response
from varistiff.dynamics.control.checks import check_range
from varistiff.dynamics.control.controller import Measured, Number, Scalar, as_scalar
from varistiff.dynamics.path import Affine, Path


class SensedSpring(eqx.Module):
    """Deflection, setting, load and stiffness of the spring from three measured positions.

    Parameters
    ----------
    actuator : the map that the controller has; it need not be the one that the plant has
    path : setting over the setting drive's coordinate
    setting_min, setting_max : readings are held in this range [m or rad] before the map is asked
    driven : False for a semi-active joint, whose deflection is the link's position itself

    Notes
    -----
    Where the map has no answer the numbers are NaN, and so is the command that is made of them.
    """

    actuator: Actuator
    path: Path = Affine()
    setting_min: Number = -math.inf
    setting_max: Number = math.inf
    driven: bool = eqx.field(static=True, default=True)

    def __check_init__(self) -> None:
        check_range("setting", self.setting_min, self.setting_max)

    def deflection(self, measured: Measured) -> Scalar:
        """Drive minus link, from two encoders and the common zero [rad or m]."""
        return as_scalar(measured.drive - measured.link if self.driven else measured.link)

    def setting(self, measured: Measured) -> Scalar:
        """Setting [m or rad] at the measured coordinate of the setting drive."""
        setting = self.path.at(as_scalar(measured.motion)).value
        # unlike that of jnp.clip the derivative is whole at an end, where a run may start
        raised = jnp.where(setting < self.setting_min, self.setting_min, setting)
        return jnp.where(raised > self.setting_max, self.setting_max, raised)

    def response(self, measured: Measured) -> Response:
        """The map's answer at the measured deflection and setting."""
        return self.actuator.respond(self.deflection(measured), self.setting(measured))[0]

    def link_load(self, measured: Measured) -> Scalar:
        """Torque [N m] or force [N] of the spring on the link in its positive direction."""
        load = self.response(measured).load
        return load if self.driven else -load

    def adjusting_torque(self, measured: Measured) -> Scalar:
        """What the setting drive has to hold at its own coordinate: dV/ds ds/dz [N m or N]."""
        return self.response(measured).adjusting_load * self.path.at(as_scalar(measured.motion)).slope
