"""What a drive is: a command becomes torque, and every watt on the way has a name."""

from __future__ import annotations

from abc import abstractmethod
from typing import NamedTuple

import equinox as eqx
from jaxtyping import Array, Float

Scalar = Float[Array, ""]


class DriveFlows(NamedTuple):
    """Torque, current and powers of a drive at an instant; all scalars.

    ``torque`` [N m] or force [N] at the output, after the losses; ``current`` [A], ``voltage`` [V] at the motor's
    terminals; ``electrical_power`` [W] drawn from the bus, below zero where it is returned; ``copper_power`` [W] lost
    in the winding; ``gear_power`` [W] lost in gear and bearings.

        electrical_power = copper_power + gear_power + torque * output_rate
    """

    torque: Scalar
    current: Scalar
    voltage: Scalar
    electrical_power: Scalar
    copper_power: Scalar
    gear_power: Scalar


class Temperatures(NamedTuple):
    """Temperatures of winding and housing above ambient [K], or their rates [K/s]."""

    winding: Scalar
    housing: Scalar


class Drive(eqx.Module):
    """Turns a commanded torque into a torque at the output.

    Rates and torques are those of the output: rad/s and N m of a rotary one, m/s and N of a linear one. The inertia of
    the rotor is no part of the torque: the plant adds ``reflected_inertia`` to what it accelerates.
    """

    @property
    @abstractmethod
    def reflected_inertia(self) -> float:
        """Inertia of the rotor, seen at the output [kg m^2] or mass [kg]."""

    @property
    @abstractmethod
    def torque_limit(self) -> float:
        """Largest command that the current limit lets through [N m] or [N]; infinite without one."""

    @property
    @abstractmethod
    def temperature_limit(self) -> float:
        """Rise of the winding above ambient that is allowed [K]; infinite where it is not known."""

    @abstractmethod
    def flows(
        self, command: Scalar, output_rate: Scalar, bus_voltage: Scalar, winding_rise: Scalar | float = 0.0
    ) -> DriveFlows:
        """Torque, current and powers at an instant.

        Parameters
        ----------
        command : wanted torque at the output [N m] or [N]
        output_rate : of the output [rad/s] or [m/s]
        bus_voltage : what the storage offers [V]
        winding_rise : temperature of the winding above ambient [K], for a resistance that rises with it
        """

    @abstractmethod
    def heat_rates(self, temperatures: Temperatures, copper_power: Scalar) -> Temperatures:
        """Rates of the temperatures [K/s] under a copper loss [W]; zero where nothing is known of heat."""
