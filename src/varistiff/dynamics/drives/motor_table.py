"""Real motors, from their makers' data sheets."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cache
from importlib import resources
from typing import Any, Literal

from varistiff.core.errors import InputError
from varistiff.core.suggest import quoted, unknown
from varistiff.core.textfile import parse_yaml
from varistiff.dynamics.drives.permanent_magnet_motor import Motor
from varistiff.dynamics.drives.two_node_heating import TwoNodeHeating

COPPER = 0.00393  # rise of copper's resistance [1/K] from 25 degC: IEC 60028, 0.00393 from 20 degC

_RPM = math.pi / 30.0
# SI value = printed value * factor; Celsius stays as it is, only differences of it are used
_FACTORS = {
    "nominal_voltage": 1.0,
    "no_load_speed": _RPM,
    "no_load_current": 1.0,
    "nominal_torque": 1e-3,
    "nominal_current": 1.0,
    "stall_torque": 1e-3,
    "resistance": 1.0,
    "inductance": 1e-3,
    "torque_constant": 1e-3,
    "rotor_inertia": 1e-7,
    "mechanical_time": 1e-3,
    "thermal_winding_housing": 1.0,
    "thermal_housing_ambient": 1.0,
    "winding_time": 1.0,
    "motor_time": 1.0,
    "ambient_temperature": 1.0,
    "winding_temperature": 1.0,
    "speed_max": _RPM,
    "mass": 1e-3,
}
_TEXTS = ("maker", "type", "order_number", "commutation", "source")


@dataclass(frozen=True, slots=True)
class MotorData:
    """A motor as its data sheet has it, in SI units (temperatures in degrees Celsius); None is not in the source.

    Parameters
    ----------
    key, maker, type, order_number : which motor
    commutation : ``brushed`` or ``brushless``
    source : what was read
    nominal_voltage : [V]
    no_load_speed : at nominal voltage [rad/s]
    no_load_current : [A]
    nominal_torque, nominal_current : the largest that the motor bears continuously [N m], [A]
    stall_torque : at nominal voltage [N m]
    resistance : of the winding at ambient temperature [ohm]
    inductance : [H]
    torque_constant : [N m/A]
    rotor_inertia : [kg m^2]
    mechanical_time : time constant J R/k^2 [s]
    thermal_winding_housing, thermal_housing_ambient : thermal resistances [K/W]
    winding_time, motor_time : thermal time constants [s]
    ambient_temperature, winding_temperature : at which the values hold, and the largest allowed [degC]
    speed_max : [rad/s]
    mass : [kg]
    """

    key: str
    maker: str
    type: str
    order_number: str
    commutation: Literal["brushed", "brushless"]
    source: str
    nominal_voltage: float
    no_load_speed: float
    no_load_current: float
    stall_torque: float
    resistance: float
    torque_constant: float
    rotor_inertia: float
    ambient_temperature: float
    nominal_torque: float | None = None
    nominal_current: float | None = None
    inductance: float | None = None
    mechanical_time: float | None = None
    thermal_winding_housing: float | None = None
    thermal_housing_ambient: float | None = None
    winding_time: float | None = None
    motor_time: float | None = None
    winding_temperature: float | None = None
    speed_max: float | None = None
    mass: float | None = None

    @property
    def continuous_current(self) -> float:
        """The current that the motor bears continuously [A]; from the torque where no current is printed.

        Infinite where neither is.
        """
        if self.nominal_current is not None:
            return self.nominal_current
        if self.nominal_torque is not None:
            return self.nominal_torque / self.torque_constant + self.no_load_current
        return math.inf

    @property
    def heating(self) -> TwoNodeHeating | None:
        """Heating of winding and housing; None where the source lacks one of its numbers."""
        winding, housing = self.thermal_winding_housing, self.thermal_housing_ambient
        if winding is None or housing is None or self.winding_time is None or self.motor_time is None:
            return None
        if self.winding_temperature is None:
            return None
        return TwoNodeHeating(
            winding_resistance=winding,
            housing_resistance=housing,
            winding_time=self.winding_time,
            motor_time=self.motor_time,
            rise_limit=self.winding_temperature - self.ambient_temperature,
        )


@cache
def motor_table() -> Mapping[str, MotorData]:
    """Return the motors by key."""
    text = resources.files("varistiff.dynamics.drives").joinpath("motors.yaml").read_text(encoding="utf-8")
    (document,) = parse_yaml(text)
    return {key: _data(key, entry) for key, entry in document.items()}


def motor_data(name: str) -> MotorData:
    """Return one motor's data sheet.

    Raises
    ------
    InputError : no motor has this name; says the nearest one

    >>> motor_data("maxon_re_40_150w_24v").order_number
    '148867'
    """
    table = motor_table()
    if name not in table:
        raise InputError(unknown("motor", name, table))
    return table[name]


def motor(
    name: str,
    *,
    gear_ratio: float = 1.0,
    gear_efficiency: float = 1.0,
    gear_inertia: float = 0.0,
    current_limit: float | None = None,
    voltage_limit: float | None = None,
) -> Motor:
    """Return a motor of the table with a gear.

    Parameters
    ----------
    name : key of the table
    gear_ratio : rotor angle per output coordinate [rad/rad] or [rad/m]
    gear_efficiency : above 0 and up to 1
    gear_inertia : of the gear, seen at the rotor [kg m^2]
    current_limit : of the drive's electronics [A]; without one the current that the motor bears continuously
    voltage_limit : of the drive's electronics [V]; without one the nominal voltage

    Raises
    ------
    InputError : no such motor, or a wrong number

    Notes
    -----
    The friction is the torque of the no-load current, k I_0, at all speeds; data sheets that print only I_0 leave open
    how much of it is iron and grows with speed. The winding's resistance rises as copper does.

    >>> round(motor("maxon_re_40_150w_24v", gear_ratio=100.0).torque_limit, 2)
    18.12
    """
    data = motor_data(name)
    return Motor(
        torque_constant=data.torque_constant,
        resistance=data.resistance,
        rotor_inertia=data.rotor_inertia,
        gear_ratio=gear_ratio,
        gear_efficiency=gear_efficiency,
        gear_inertia=gear_inertia,
        current_limit=data.continuous_current if current_limit is None else current_limit,
        voltage_limit=data.nominal_voltage if voltage_limit is None else voltage_limit,
        friction_torque=data.torque_constant * data.no_load_current,
        resistance_coefficient=COPPER,
        thermal=data.heating,
    )


def _data(key: str, entry: Mapping[str, Any]) -> MotorData:
    for field in entry:
        if field not in _FACTORS and field not in _TEXTS:
            raise InputError(unknown("field", field, (*_TEXTS, *_FACTORS)), field=key)
    values: dict[str, Any] = {field: entry.get(field) for field in _TEXTS}
    for field, factor in _FACTORS.items():
        printed = entry.get(field)
        if printed is not None and not (isinstance(printed, int | float) and printed > 0):
            raise InputError(f"is {quoted(printed)}; allowed is a number above zero", field=f"{key}.{field}")
        values[field] = None if printed is None else printed * factor
    return MotorData(key=key, **values)


# the loader fills the dataclass by name: the two lists of fields must be one
if {field.name for field in fields(MotorData)} != {"key", *_TEXTS, *_FACTORS}:
    raise AssertionError("MotorData and the fields of motors.yaml differ")
