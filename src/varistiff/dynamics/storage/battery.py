"""A battery with a voltage that falls with its charge."""

from __future__ import annotations

import math

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.drives.limits import (
    check_above_zero,
    check_at_most,
    check_efficiency,
    check_finite,
    check_not_below_zero,
)
from varistiff.dynamics.storage.storage import Storage, StorageFlows
from varistiff.dynamics.storage.terminals import smooth_step, terminal_flows

Scalar = Float[Array, ""]
_BAND = 0.01  # share of the capacity at either end in which giving and taking fade out


class Battery(Storage):
    """An open-circuit voltage that is linear in the charge, behind a resistance.

        V = V_0 + (V_1 - V_0) q/Q,    E = V_0 q + (V_1 - V_0) q^2/(2 Q)
        q' = -i - V/R_leak,    P + converter loss = V i - R i^2,    E' = V q'

    Parameters
    ----------
    capacity : Q [C]; 1 A h is 3600 C
    voltage_full, voltage_empty : V_1 and V_0 [V], V_1 not below V_0
    series_resistance : R [ohm]
    leakage_resistance : R_leak, for self-discharge [ohm]; infinite without it
    charge_share : q/Q at the start, from 0 to 1
    converter_efficiency : above 0 and up to 1
    regenerative : False burns all returned power in a brake resistor

    Raises
    ------
    InputError : a number that no battery has; names the field

    Notes
    -----
    One resistance: no diffusion, no temperature, no ageing. In the last 1 % of the capacity it fades out: an empty one
    gives nothing (a shortfall), a full one sends what is returned to the brake resistor.

    >>> battery = Battery(capacity=3600.0, voltage_full=25.2, voltage_empty=18.0)
    >>> round(float(battery.open_voltage(jnp.asarray(battery.charge0))), 9)  # at 80 %
    23.76
    """

    capacity: float
    voltage_full: float
    voltage_empty: float
    series_resistance: float = 0.0
    leakage_resistance: float = math.inf
    charge_share: float = 0.8
    converter_efficiency: float = 1.0
    regenerative: bool = eqx.field(static=True, default=True)

    def __check_init__(self) -> None:
        positive = {
            "capacity": self.capacity,
            "voltage_full": self.voltage_full,
            "voltage_empty": self.voltage_empty,
        }
        check_above_zero(**positive, leakage_resistance=self.leakage_resistance)
        check_not_below_zero(series_resistance=self.series_resistance, charge_share=self.charge_share)
        check_finite(**positive, series_resistance=self.series_resistance)
        check_efficiency(converter_efficiency=self.converter_efficiency)
        check_at_most(1.0, charge_share=self.charge_share)
        check_at_most(self.voltage_full, voltage_empty=self.voltage_empty)

    @property
    def charge0(self) -> float:
        """Charge at the start [C]."""
        return self.charge_share * self.capacity

    def open_voltage(self, charge: Scalar) -> Scalar:
        """V_0 + (V_1 - V_0) q/Q [V]."""
        return self.voltage_empty + (self.voltage_full - self.voltage_empty) * charge / self.capacity

    def energy(self, charge: Scalar) -> Scalar:
        """V_0 q + (V_1 - V_0) q^2/(2 Q) [J]."""
        slope = (self.voltage_full - self.voltage_empty) / self.capacity
        return (self.voltage_empty + 0.5 * slope * charge) * charge

    def flows(self, charge: Scalar, power: Scalar) -> StorageFlows:
        """See ``Storage.flows``."""
        voltage, band = self.open_voltage(charge), _BAND * self.capacity
        flows = terminal_flows(
            power,
            voltage=voltage,
            series_resistance=self.series_resistance,
            leakage_resistance=self.leakage_resistance,
            converter_efficiency=self.converter_efficiency,
            regenerative=self.regenerative,
            takes=smooth_step(self.capacity - charge, band),
            gives=smooth_step(charge, band),
        )
        rate = -flows.current - flows.leakage_current
        return StorageFlows(
            charge_rate=rate,
            stored_power=voltage * rate,
            series_power=flows.series_power,
            leakage_power=flows.leakage_power,
            converter_power=flows.converter_power,
            supplied_power=jnp.zeros_like(rate),
            shortfall=flows.shortfall,
        )
