"""A supercapacitor with series resistance and leakage."""

from __future__ import annotations

import math

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.drives.limits import check_above_zero, check_efficiency, check_finite, check_not_below_zero
from varistiff.dynamics.storage.storage import Storage, StorageFlows
from varistiff.dynamics.storage.terminals import smooth_step, terminal_flows

Scalar = Float[Array, ""]
_BAND = 0.01  # share of voltage_max below it in which the brake resistor takes over


class Supercapacitor(Storage):
    """A capacitance with a resistance in series and one across.

        V = q/C,    E = q^2/(2 C)
        q' = -i - V/R_leak,    P + converter loss = V i - R i^2,    E' = V q'

    Parameters
    ----------
    capacitance : C [F]
    voltage : at the start [V]
    series_resistance : R, the ESR [ohm]
    leakage_resistance : R_leak [ohm], the voltage over the data sheet's leakage current; infinite without one
    voltage_max : from 1 % below which the brake resistor takes over what is returned [V]; None without one
    converter_efficiency : above 0 and up to 1
    regenerative : False burns all returned power in a brake resistor

    Raises
    ------
    InputError : a number that no capacitor has; names the field

    Notes
    -----
    Constant C; no redistribution of charge within the electrodes, which looks like a faster leakage in the first
    hours. It gives at most V^2/(4 R), so an empty one gives nothing.

    >>> capacitor = Supercapacitor(capacitance=165.0, voltage=48.0, series_resistance=6.3e-3)
    >>> float(capacitor.energy(jnp.asarray(capacitor.charge0)))  # 53 Wh
    190080.0
    """

    capacitance: float
    voltage: float
    series_resistance: float = 0.0
    leakage_resistance: float = math.inf
    voltage_max: float | None = None
    converter_efficiency: float = 1.0
    regenerative: bool = eqx.field(static=True, default=True)

    def __check_init__(self) -> None:
        check_above_zero(
            capacitance=self.capacitance, leakage_resistance=self.leakage_resistance, voltage_max=self.voltage_max
        )
        check_not_below_zero(voltage=self.voltage, series_resistance=self.series_resistance)
        check_finite(
            capacitance=self.capacitance,
            voltage=self.voltage,
            series_resistance=self.series_resistance,
            voltage_max=self.voltage_max,
        )
        check_efficiency(converter_efficiency=self.converter_efficiency)

    @property
    def charge0(self) -> float:
        """C V at the start [C]."""
        return self.capacitance * self.voltage

    def open_voltage(self, charge: Scalar) -> Scalar:
        """q/C [V]."""
        return charge / self.capacitance

    def energy(self, charge: Scalar) -> Scalar:
        """q^2/(2 C) [J]."""
        return 0.5 * charge**2 / self.capacitance

    def flows(self, charge: Scalar, power: Scalar) -> StorageFlows:
        """See ``Storage.flows``."""
        voltage = self.open_voltage(charge)
        limit = self.voltage_max
        takes = 1.0 if limit is None else smooth_step(limit - voltage, _BAND * limit)
        flows = terminal_flows(
            power,
            voltage=voltage,
            series_resistance=self.series_resistance,
            leakage_resistance=self.leakage_resistance,
            converter_efficiency=self.converter_efficiency,
            regenerative=self.regenerative,
            takes=takes,
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
