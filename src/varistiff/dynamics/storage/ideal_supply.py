"""An ideal supply: any power at a constant voltage, without a loss."""

from __future__ import annotations

import math

import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.drives.limits import check_above_zero
from varistiff.dynamics.storage.storage import Storage, StorageFlows

Scalar = Float[Array, ""]


class IdealSupply(Storage):
    """Gives and takes back what the drives ask for: supplied power = P.

    Parameters
    ----------
    voltage : of the bus [V]; infinite for drives that no voltage limits

    Raises
    ------
    InputError : the voltage is not above zero

    >>> float(IdealSupply().flows(jnp.asarray(0.0), jnp.asarray(-10.0)).supplied_power)
    -10.0
    """

    voltage: float = math.inf

    def __check_init__(self) -> None:
        check_above_zero(voltage=self.voltage)

    @property
    def charge0(self) -> float:
        """0 [C]: it has no charge to lose."""
        return 0.0

    def open_voltage(self, charge: Scalar) -> Scalar:
        """See ``Storage.open_voltage``."""
        return jnp.asarray(self.voltage) + 0.0 * charge

    def energy(self, charge: Scalar) -> Scalar:
        """0 [J]: it stores nothing."""
        return 0.0 * charge

    def flows(self, charge: Scalar, power: Scalar) -> StorageFlows:
        """See ``Storage.flows``."""
        del charge
        nothing = jnp.zeros_like(power)
        return StorageFlows(nothing, nothing, nothing, nothing, nothing, power, nothing)
