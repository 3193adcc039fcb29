"""A brushed or brushless motor with its gear, fed by a four-quadrant drive."""

from __future__ import annotations

import math

import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.drives.drive import Drive, DriveFlows, Temperatures
from varistiff.dynamics.drives.limits import check_above_zero, check_efficiency, check_finite, check_not_below_zero
from varistiff.dynamics.drives.loss_share import loss_share
from varistiff.dynamics.drives.two_node_heating import TwoNodeHeating

Scalar = Float[Array, ""]
_BOUNDLESS = 1e12  # [V]: a finite stand-in for no voltage limit, because 0 times infinity spoils a gradient


class Motor(Drive):
    """Permanent-magnet motor as a direct-current machine, u = R i + k w, and a gear with losses.

    The rotor turns at w = n * output_rate. The drive sets the current i = command/(n k): it knows the gear's ratio, not
    its losses. The current limit acts first, |i| <= i_max, then the voltage, |R i + k w| <= min(voltage_limit,
    bus_voltage), and the voltage has the last word. Above the no-load speed it therefore forces a current that brakes
    and charges the bus, i = (u - k w)/R, even beyond the current limit: no bridge can block the back-EMF of a motor
    that turns faster than the bus allows. Both limits are continuous.

    With the friction F = T_c tanh(w/w_0) + c w of the rotor and T = k i - F, the gear keeps the share 1 - eta of T w
    where it drives and 1/eta - 1 where the load drives it back:

        torque = n [T - T tanh(T/T_0) tanh(w/w_0) share],    share by the sense tanh(T/T_0) tanh(w/w_0)

    Parameters
    ----------
    torque_constant : k [N m/A], also of the back-EMF [V s/rad]
    resistance : R of the winding [ohm], at ambient temperature; of a brushless motor between two phases
    rotor_inertia : [kg m^2]
    gear_ratio : n, rotor angle per output coordinate [rad/rad], or [rad/m] for a belt or a screw
    gear_efficiency : eta, above 0 and up to 1
    gear_inertia : of the gear, seen at the rotor [kg m^2]
    current_limit : i_max [A]; infinite without one
    voltage_limit : of the drive [V]; infinite where only the bus limits
    friction_torque : T_c at the rotor [N m]: bearings, brushes, iron
    viscous_friction : c at the rotor [N m s/rad]
    resistance_coefficient : rise of R with the winding's temperature [1/K], 0.00393 for copper; 0 keeps R as given
    thermal : heating; None where it is not known
    smoothing_rate : w_0 of the rotor [rad/s]; slower than it, friction and gear loss fade to zero
    smoothing_torque : T_0 at the rotor [N m], likewise for the gear loss

    Raises
    ------
    InputError : a number that no motor has; names the field

    Notes
    -----
    Validity: the inductance is neglected, so its time constant L/R (about 1 ms or less in the table) must be short
    against the motion; constant flux; no cogging, no loss in the drive's electronics (the storage's converter has it).
    The rotor does not stick: against a small load it creeps at up to w_0. A gear that locks itself (eta below about
    0.5) is driven back here with its losses, not blocked. Friction and gear loss make the fastest rate in the model,
    about (T_c + |T| (1 - eta^2)/(2 eta))/(w_0 J): a time step must resolve it.

    >>> motor = Motor(torque_constant=0.0302, resistance=0.299, rotor_inertia=1.42e-5, gear_ratio=100.0)
    >>> flows = motor.flows(jnp.asarray(9.06), jnp.asarray(2.0), jnp.asarray(24.0))
    >>> [round(float(x), 4) for x in (flows.torque, flows.current, flows.voltage, flows.copper_power)]
    [9.06, 3.0, 6.937, 2.691]
    """

    torque_constant: float
    resistance: float
    rotor_inertia: float
    gear_ratio: float = 1.0
    gear_efficiency: float = 1.0
    gear_inertia: float = 0.0
    current_limit: float = math.inf
    voltage_limit: float = math.inf
    friction_torque: float = 0.0
    viscous_friction: float = 0.0
    resistance_coefficient: float = 0.0
    thermal: TwoNodeHeating | None = None
    smoothing_rate: float = 10.0
    smoothing_torque: float = 1e-3

    def __check_init__(self) -> None:
        positive = {
            "torque_constant": self.torque_constant,
            "resistance": self.resistance,
            "rotor_inertia": self.rotor_inertia,
            "gear_ratio": self.gear_ratio,
            "smoothing_rate": self.smoothing_rate,
            "smoothing_torque": self.smoothing_torque,
        }
        friction = {
            "gear_inertia": self.gear_inertia,
            "friction_torque": self.friction_torque,
            "viscous_friction": self.viscous_friction,
            "resistance_coefficient": self.resistance_coefficient,
        }
        check_above_zero(**positive, current_limit=self.current_limit, voltage_limit=self.voltage_limit)
        check_not_below_zero(**friction)
        check_finite(**positive, **friction)
        check_efficiency(gear_efficiency=self.gear_efficiency)

    @property
    def reflected_inertia(self) -> float:
        """n^2 (rotor + gear) [kg m^2], or [kg] at a linear output."""
        return self.gear_ratio**2 * (self.rotor_inertia + self.gear_inertia)

    @property
    def torque_limit(self) -> float:
        """Command at the current limit, n k i_max [N m] or [N]; the losses come off it."""
        return self.gear_ratio * self.torque_constant * self.current_limit

    @property
    def temperature_limit(self) -> float:
        """Rise of the winding that is allowed [K]."""
        return math.inf if self.thermal is None else self.thermal.rise_limit

    def flows(
        self, command: Scalar, output_rate: Scalar, bus_voltage: Scalar, winding_rise: Scalar | float = 0.0
    ) -> DriveFlows:
        """See ``Drive.flows``; the resistance is R (1 + resistance_coefficient * winding_rise)."""
        n, k, w = self.gear_ratio, self.torque_constant, self.gear_ratio * output_rate
        resistance = self.resistance * (1.0 + self.resistance_coefficient * winding_rise)
        current = self._current(command, w, bus_voltage, resistance)
        turning = jnp.tanh(w / self.smoothing_rate)
        friction = self.friction_torque * turning + self.viscous_friction * w
        rotor = k * current - friction
        pulling = jnp.tanh(rotor / self.smoothing_torque)
        eta = self.gear_efficiency
        share = loss_share(pulling * turning, forward=1.0 - eta, backward=1.0 / eta - 1.0)
        drag = rotor * pulling * turning * share
        voltage = resistance * current + k * w
        return DriveFlows(
            torque=n * (rotor - drag),
            current=current,
            voltage=voltage,
            electrical_power=voltage * current,
            copper_power=resistance * current**2,
            gear_power=(friction + drag) * w,
        )

    def _current(self, command: Scalar, rate: Scalar, bus_voltage: Scalar, resistance: Scalar | float) -> Scalar:
        """Current [A] at a rate of the rotor [rad/s]: limited by current, then by voltage."""
        wanted = command / (self.gear_ratio * self.torque_constant)
        allowed = jnp.clip(wanted, -self.current_limit, self.current_limit)
        # an empty storage, at 0 V or just below it, shorts the motor
        available = jnp.clip(jnp.minimum(bus_voltage, self.voltage_limit), 0.0, _BOUNDLESS)
        back = self.torque_constant * rate
        return jnp.clip(allowed, (-available - back) / resistance, (available - back) / resistance)

    def heat_rates(self, temperatures: Temperatures, copper_power: Scalar) -> Temperatures:
        """See ``Drive.heat_rates``."""
        if self.thermal is None:
            return Temperatures(jnp.zeros_like(temperatures.winding), jnp.zeros_like(temperatures.housing))
        return self.thermal.rates(temperatures, copper_power)
