"""From a wanted stiffness or load to the setting of any actuator."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from varistiff.actuators.actuator import Actuator
from varistiff.actuators.compiled import respond_block
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.dynamics.control.checks import check_choice, check_number, check_range
from varistiff.dynamics.control.controller import Number, Scalar, as_scalar
from varistiff.dynamics.control.monotone_inverse import monotone_inverse

_CHECKED = 257  # settings at which monotonicity is checked; 15 deflections fit a block


class SettingInverse(eqx.Module):
    """Setting at which an actuator has a wanted stiffness, or load, at a given deflection.

    ``setting_inverse`` makes one and checks that the answer is unique.

    Parameters
    ----------
    actuator : from whose response it is found
    setting_min, setting_max : range of the settings [m or rad]; beyond it the nearer end is the answer
    rising : whether the magnitude of the quantity rises with the setting
    quantity : ``stiffness`` (tangent) or ``load``
    """

    actuator: Actuator
    setting_min: Number
    setting_max: Number
    rising: bool = eqx.field(static=True)
    quantity: Literal["stiffness", "load"] = eqx.field(static=True, default="stiffness")

    def at(self, target: Number, deflection: Number = 0.0) -> Scalar:
        """Setting [m or rad] for a stiffness [N m/rad or N/m] or load [N m or N] at a deflection [rad or m].

        A load of the other sign than the deflection gives counts as too small: the softest setting is the answer.
        """
        deflection = as_scalar(deflection)
        # the magnitude of a load falls or rises with the setting alike on both sides of rest
        side = jnp.where(deflection < 0.0, -1.0, 1.0) if self.quantity == "load" else 1.0

        def magnitude(setting: Scalar) -> Scalar:
            response, _ = self.actuator.respond(deflection, setting)
            return side * (response.load if self.quantity == "load" else response.stiffness)

        return monotone_inverse(magnitude, side * target, self.setting_min, self.setting_max, rising=self.rising)


def setting_inverse(
    actuator: Actuator,
    *,
    setting_min: float,
    setting_max: float,
    quantity: Literal["stiffness", "load"] = "stiffness",
    deflections: Sequence[float] = (0.0,),
) -> SettingInverse:
    """Make a ``SettingInverse`` after checking that the quantity is strictly monotone over the settings.

    Parameters
    ----------
    actuator : with plain numbers for parameters
    setting_min, setting_max : range of the settings [m or rad]
    quantity : what is to be found again
    deflections : up to 15, at which it is checked, all in the same sense [rad or m]; a load needs some beside 0

    Raises
    ------
    InputError : no setting, an empty range, or a quantity that does not exist or turns back in it; says where
    """
    check_choice("quantity", quantity, ("stiffness", "load"))
    for name, value in (("setting_min", setting_min), ("setting_max", setting_max)):
        check_number(name, value)
    check_range("setting", setting_min, setting_max)
    if actuator.setting_unit is None:
        raise InputError(f"a {actuator.kind} has no setting that could be found from its {quantity}", field="actuator")
    settings = np.linspace(setting_min, setting_max, _CHECKED)
    senses = [_sense(actuator, settings, float(deflection), quantity) for deflection in deflections]
    if len(set(senses)) != 1:
        raise InputError(f"the {quantity} rises with the setting at some deflections and falls at others")
    return SettingInverse(actuator, setting_min, setting_max, senses[0], quantity)


def _sense(actuator: Actuator, settings: np.ndarray, deflection: float, quantity: str) -> bool:
    """Whether the magnitude rises over the settings."""
    response, _ = respond_block(actuator, np.full(settings.size, deflection), settings)
    side = -1.0 if quantity == "load" and deflection < 0.0 else 1.0
    values = side * np.asarray(response.load if quantity == "load" else response.stiffness)
    unit, angle = actuator.setting_unit, actuator.deflection_unit
    place = f"at a deflection of {deflection:.6g} {angle}"
    if np.isnan(values).any():
        index = int(np.argmax(np.isnan(values)))
        status = Status(int(response.status[index])).label
        where = f"{place} and a setting of {settings[index]:.6g} {unit}"
        raise InputError(f"the actuator has no {quantity} {where}: {status}")
    steps = np.diff(values)
    rising = bool(values[-1] > values[0])
    wrong = ~(steps > 0.0) if rising else ~(steps < 0.0)
    if wrong.any():
        turn = settings[int(np.argmax(wrong))]
        raise InputError(
            f"the {quantity} {place} must rise or fall all the way from {settings[0]:.6g} to {settings[-1]:.6g} {unit},"
            f" but turns back or rests at {turn:.6g} {unit}"
        )
    return rising
