"""A supply: a constant voltage from outside."""

from __future__ import annotations

import math

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.drives.limits import check_above_zero, check_efficiency, check_finite, check_not_below_zero
from varistiff.dynamics.storage.storage import Storage, StorageFlows
from varistiff.dynamics.storage.terminals import terminal_flows

Scalar = Float[Array, ""]


class Supply(Storage):
    """Constant voltage V behind a resistance: it stores nothing, and what it gives enters the joint from outside.

        supplied power = V i,    P + converter loss = V i - R i^2

    Parameters
    ----------
    voltage : V [V]
    series_resistance : R, with the cable [ohm]
    converter_efficiency : above 0 and up to 1
    regenerative : whether returned power goes back to the supply, which then counts it as below zero; False burns it
        in a brake resistor

    Raises
    ------
    InputError : a number that no supply has; names the field

    Notes
    -----
    Its charge counts what flowed out, below zero, from 0 at the start.

    >>> flows = Supply(voltage=48.0, regenerative=False).flows(jnp.asarray(0.0), jnp.asarray(-10.0))
    >>> float(flows.converter_power), abs(float(flows.supplied_power))
    (10.0, 0.0)
    """

    voltage: float = 48.0
    series_resistance: float = 0.0
    converter_efficiency: float = 1.0
    regenerative: bool = eqx.field(static=True, default=True)

    def __check_init__(self) -> None:
        check_above_zero(voltage=self.voltage)
        check_not_below_zero(series_resistance=self.series_resistance)
        check_finite(voltage=self.voltage, series_resistance=self.series_resistance)
        check_efficiency(converter_efficiency=self.converter_efficiency)

    @property
    def charge0(self) -> float:
        """0 [C]."""
        return 0.0

    def open_voltage(self, charge: Scalar) -> Scalar:
        """V [V], whatever flowed."""
        return self.voltage + jnp.zeros_like(charge)

    def energy(self, charge: Scalar) -> Scalar:
        """0 [J]: a supply is no store."""
        return jnp.zeros_like(charge)

    def flows(self, charge: Scalar, power: Scalar) -> StorageFlows:
        """See ``Storage.flows``."""
        voltage = self.open_voltage(charge)
        flows = terminal_flows(
            power,
            voltage=voltage,
            series_resistance=self.series_resistance,
            leakage_resistance=math.inf,
            converter_efficiency=self.converter_efficiency,
            regenerative=self.regenerative,
        )
        return StorageFlows(
            charge_rate=-flows.current,
            stored_power=jnp.zeros_like(flows.current),
            series_power=flows.series_power,
            leakage_power=flows.leakage_power,
            converter_power=flows.converter_power,
            supplied_power=voltage * flows.current,
            shortfall=flows.shortfall,
        )
