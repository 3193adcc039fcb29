"""What a storage is: it serves the drives' power, and every watt on the way has a name."""

from __future__ import annotations

from abc import abstractmethod
from typing import NamedTuple

import equinox as eqx
from jaxtyping import Array, Float

Scalar = Float[Array, ""]


class StorageFlows(NamedTuple):
    """Powers of a storage at an instant [W]; all scalars.

    ``charge_rate`` [A]; ``stored_power`` is dE/dt by its own law, energy'(charge) * charge_rate; ``series_power``,
    ``leakage_power``, ``converter_power`` are losses, the last with the brake resistor; ``supplied_power`` enters from
    outside the joint; ``shortfall`` is what was asked and could not be given (below zero: could not be taken), 0 in a
    joint that works.

        power + series + leakage + converter + stored = supplied + shortfall
    """

    charge_rate: Scalar
    stored_power: Scalar
    series_power: Scalar
    leakage_power: Scalar
    converter_power: Scalar
    supplied_power: Scalar
    shortfall: Scalar


class Storage(eqx.Module):
    """What both drives draw from and return to, through one converter.

    The bus has the open-circuit voltage: the sag in the series resistance is a loss here, but does not lower the
    voltage that limits the motors.
    """

    @property
    @abstractmethod
    def charge0(self) -> float:
        """Charge at the start [C]."""

    @abstractmethod
    def open_voltage(self, charge: Scalar) -> Scalar:
        """Voltage without a current [V]."""

    @abstractmethod
    def energy(self, charge: Scalar) -> Scalar:
        """Stored energy [J]; its derivative is the open-circuit voltage."""

    @abstractmethod
    def flows(self, charge: Scalar, power: Scalar) -> StorageFlows:
        """Powers at a charge [C] under a power [W] that the drives draw; below zero where they return it."""
