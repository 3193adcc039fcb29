"""An ideal drive: the papers' u_1 and u_2."""

from __future__ import annotations

import math

import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.drives.drive import Drive, DriveFlows, Temperatures
from varistiff.dynamics.drives.limits import check_above_zero

Scalar = Float[Array, ""]


class TorqueSource(Drive):
    """Gives the commanded torque without losses, rotor or heat; its power is torque * rate, drawn or returned.

    Current and voltage have no meaning and are 0.

    Parameters
    ----------
    limit : largest torque [N m] or force [N]; infinite without one

    Raises
    ------
    InputError : a limit that is not above zero

    >>> source = TorqueSource(limit=2.0)
    >>> flows = source.flows(jnp.asarray(5.0), jnp.asarray(-3.0), jnp.asarray(24.0))
    >>> float(flows.torque), float(flows.electrical_power)
    (2.0, -6.0)
    """

    limit: float = math.inf

    def __check_init__(self) -> None:
        check_above_zero(limit=self.limit)

    @property
    def reflected_inertia(self) -> float:
        """None: 0."""
        return 0.0

    @property
    def torque_limit(self) -> float:
        """The limit itself [N m] or [N]."""
        return self.limit

    @property
    def temperature_limit(self) -> float:
        """Infinite: nothing heats up."""
        return math.inf

    def flows(
        self, command: Scalar, output_rate: Scalar, bus_voltage: Scalar, winding_rise: Scalar | float = 0.0
    ) -> DriveFlows:
        """See ``Drive.flows``; neither voltage nor temperature matters."""
        del bus_voltage, winding_rise
        torque = jnp.clip(command, -self.limit, self.limit)
        nothing = jnp.zeros_like(torque)
        return DriveFlows(torque, nothing, nothing, torque * output_rate, nothing, nothing)

    def heat_rates(self, temperatures: Temperatures, copper_power: Scalar) -> Temperatures:
        """Zero."""
        del copper_power
        return Temperatures(jnp.zeros_like(temperatures.winding), jnp.zeros_like(temperatures.housing))
