"""Heating of a motor: winding and housing, each one temperature."""

from __future__ import annotations

import equinox as eqx
from jaxtyping import Array, Float

from varistiff.dynamics.drives.drive import Temperatures
from varistiff.dynamics.drives.limits import check_above_zero

Scalar = Float[Array, ""]


class TwoNodeHeating(eqx.Module):
    """Winding and housing as two heat capacities in a row; temperatures T_w, T_h are above ambient.

        C_w T_w' = P - (T_w - T_h)/R_wh,    C_w = tau_w/R_wh
        C_h T_h' = (T_w - T_h)/R_wh - T_h/R_ha,    C_h = tau_m/R_ha

    Parameters
    ----------
    winding_resistance : R_wh, thermal, from winding to housing [K/W]
    housing_resistance : R_ha, thermal, from housing to ambient [K/W]; data sheets give it in free air, without a flange
    winding_time : tau_w, thermal time constant of the winding at a fixed temperature of the housing [s]
    motor_time : tau_m, thermal time constant of the motor [s]
    rise_limit : of the winding above ambient that is allowed [K]

    Raises
    ------
    InputError : a number that is not above zero

    Notes
    -----
    The four numbers of a data sheet. Its time constants are read as those of each node alone; the pair's own two are
    a little apart from them. The only heat is the copper loss P: iron, brushes and bearings are left out, at rated
    speed a tenth to a half of the heat, so the model runs cool.
    """

    winding_resistance: float
    housing_resistance: float
    winding_time: float
    motor_time: float
    rise_limit: float

    def __check_init__(self) -> None:
        check_above_zero(
            winding_resistance=self.winding_resistance,
            housing_resistance=self.housing_resistance,
            winding_time=self.winding_time,
            motor_time=self.motor_time,
            rise_limit=self.rise_limit,
        )

    def rates(self, temperatures: Temperatures, copper_power: Scalar) -> Temperatures:
        """T_w', T_h' [K/s] under a copper loss [W]."""
        inward = (temperatures.winding - temperatures.housing) / self.winding_resistance
        outward = temperatures.housing / self.housing_resistance
        return Temperatures(
            winding=(copper_power - inward) * self.winding_resistance / self.winding_time,
            housing=(inward - outward) * self.housing_resistance / self.motor_time,
        )
