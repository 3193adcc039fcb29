"""Quantities at the edge: text with a unit, checked by kind, to an SI float.

The dimension alone is not enough: to the SI a joule is a newton metre and a radian is nothing, so
``1 J`` would pass for a torque and ``1 N*m`` for a rotational stiffness. Each kind therefore lists what its
units may measure.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from fractions import Fraction

from varistiff.core.errors import InputError
from varistiff.core.quantity_units import Signature, parse_unit
from varistiff.core.suggest import quoted

_LONGEST = 100
_LARGEST_EXPONENT = 400
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?", re.ASCII)
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)\b", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of quantity.

    Parameters
    ----------
    name : with its article, as messages say it
    example : text that passes
    unit : SI unit of the parsed value
    signatures : what its units may measure: the dimensionality that pint gives them by ``units.txt``
    """

    name: str
    example: str
    unit: str
    signatures: tuple[Signature, ...]

    def allowed(self, limit: str = "") -> str:
        """What is allowed, with an example; ``limit`` says more about the value, such as "above zero"."""
        return f"allowed is {self.name}{' ' if limit else ''}{limit}, for example {self.example}"


def _measures(**powers: int) -> Signature:
    return tuple(sorted(powers.items()))


LENGTH = Kind("a length", "25.4 mm", "m", (_measures(length=1),))
ANGLE = Kind("an angle", "10 deg", "rad", (_measures(angle=1),))
FORCE = Kind("a force", "120 N", "N", (_measures(force=1), _measures(mass=1, length=1, time=-2)))
TORQUE = Kind("a torque", "1.5 N*m", "N*m", (_measures(force=1, length=1), _measures(energy=1, angle=-1)))
ENERGY = Kind("an energy", "2.5 J", "J", (_measures(energy=1),))
STRESS = Kind("a stress or modulus", "194 GPa", "Pa", (_measures(pressure=1), _measures(force=1, length=-2)))
LINEAR_STIFFNESS = Kind("a linear stiffness", "394 N/m", "N/m", (_measures(force=1, length=-1),))
ROTATIONAL_STIFFNESS = Kind(
    "a rotational stiffness",
    "160 N*m/rad",
    "N*m/rad",
    (_measures(force=1, length=1, angle=-1), _measures(energy=1, angle=-2)),
)
DENSITY = Kind("a density", "7850 kg/m^3", "kg/m^3", (_measures(mass=1, length=-3),))
MASS = Kind("a mass", "0.5 kg", "kg", (_measures(mass=1),))
TIME = Kind("a time", "20 ms", "s", (_measures(time=1),))
FREQUENCY = Kind("a frequency", "5 Hz", "Hz", (_measures(frequency=1),))
ANGULAR_RATE = Kind("an angular rate", "30 rad/s", "rad/s", (_measures(angle=1, time=-1),))
# of a gain; unlike a frequency or an angular rate it counts nothing
PER_TIME = Kind("a number per time", "20 s^-1", "1/s", (_measures(time=-1),))
VELOCITY = Kind("a velocity", "0.2 m/s", "m/s", (_measures(length=1, time=-1),))
MOMENT_OF_INERTIA = Kind("a moment of inertia", "0.05 kg*m^2", "kg*m^2", (_measures(mass=1, length=2),))
LINEAR_DAMPING = Kind("a linear damping", "20 N*s/m", "N*s/m", (_measures(force=1, length=-1, time=1),))
ROTATIONAL_DAMPING = Kind(
    "a rotational damping",
    "0.1 N*m*s/rad",
    "N*m*s/rad",
    (_measures(force=1, length=1, angle=-1, time=1), _measures(energy=1, angle=-2, time=1)),
)
# gains of an integral
LINEAR_STIFFNESS_RATE = Kind(
    "a linear stiffness per time", "200 N/m/s", "N/m/s", (_measures(force=1, length=-1, time=-1),)
)
ROTATIONAL_STIFFNESS_RATE = Kind(
    "a rotational stiffness per time",
    "40 N*m/rad/s",
    "N*m/rad/s",
    (_measures(force=1, length=1, angle=-1, time=-1), _measures(energy=1, angle=-2, time=-1)),
)
# damping of a stop over its stiffness
TIME_PER_ANGLE = Kind("a time per angle", "0.4 s/rad", "s/rad", (_measures(time=1, angle=-1),))
TIME_PER_LENGTH = Kind("a time per length", "0.4 s/m", "s/m", (_measures(time=1, length=-1),))
LENGTH_PER_ANGLE = Kind("a length per angle", "0.5 mm/deg", "m/rad", (_measures(length=1, angle=-1),))
VOLTAGE = Kind("a voltage", "24 V", "V", (_measures(voltage=1),))
CURRENT = Kind("a current", "5 A", "A", (_measures(current=1),))
RESISTANCE = Kind("a resistance", "0.3 ohm", "ohm", (_measures(resistance=1), _measures(voltage=1, current=-1)))
CAPACITANCE = Kind("a capacitance", "100 F", "F", (_measures(capacitance=1),))
CHARGE = Kind("a charge", "2 Ah", "C", (_measures(charge=1), _measures(current=1, time=1)))
POWER = Kind("a power", "70 W", "W", (_measures(power=1), _measures(energy=1, time=-1)))
TORQUE_CONSTANT = Kind("a torque constant", "30.2 mNm/A", "N*m/A", (_measures(force=1, length=1, current=-1),))
TEMPERATURE_DIFFERENCE = Kind("a temperature difference", "100 K", "K", (_measures(temperature=1),))
PER_TEMPERATURE = Kind("a number per temperature", "0.00393 K^-1", "1/K", (_measures(temperature=-1),))
THERMAL_RESISTANCE = Kind("a thermal resistance", "4.5 K/W", "K/W", (_measures(temperature=1, power=-1),))

KINDS = (
    LENGTH,
    ANGLE,
    FORCE,
    TORQUE,
    ENERGY,
    STRESS,
    LINEAR_STIFFNESS,
    ROTATIONAL_STIFFNESS,
    DENSITY,
    MASS,
    TIME,
    FREQUENCY,
    ANGULAR_RATE,
    PER_TIME,
    VELOCITY,
    MOMENT_OF_INERTIA,
    LINEAR_DAMPING,
    ROTATIONAL_DAMPING,
    LINEAR_STIFFNESS_RATE,
    ROTATIONAL_STIFFNESS_RATE,
    TIME_PER_ANGLE,
    TIME_PER_LENGTH,
    LENGTH_PER_ANGLE,
    VOLTAGE,
    CURRENT,
    RESISTANCE,
    CAPACITANCE,
    CHARGE,
    POWER,
    TORQUE_CONSTANT,
    TEMPERATURE_DIFFERENCE,
    PER_TEMPERATURE,
    THERMAL_RESISTANCE,
)


def parse_quantity(value: object, kind: Kind) -> float:
    """Return the SI value of text such as ``"25.4 mm"``, correctly rounded.

    Parameters
    ----------
    value : what the file says; only text with a number and a unit passes
    kind : the kind of quantity that the field holds

    Raises
    ------
    InputError : not text, no unit, not finite, unknown unit, or a unit of another kind; says what is allowed

    >>> parse_quantity("2 N*m/deg", ROTATIONAL_STIFFNESS)
    114.59155902616465
    >>> parse_quantity("1 J", TORQUE)
    Traceback (most recent call last):
    ...
    varistiff.core.errors.InputError: "1 J" is an energy; allowed is a torque, for example 1.5 N*m
    """
    number, unit_text = _split(value, kind)
    try:
        unit = parse_unit(unit_text)
    except InputError as error:
        raise InputError(f"{error.problem}; {kind.allowed()}") from None
    if unit.signature not in kind.signatures:
        raise InputError(f"{quoted(value)} is {_name(unit.signature)}; {kind.allowed()}")
    exact = Fraction(number) * unit.factor
    try:
        result = float(exact)
    except OverflowError:
        raise InputError(f"{quoted(value)} is not finite; {kind.allowed()}") from None
    return result + 0.0  # "-0 mm" is 0


def kind_of(value: object, kinds: tuple[Kind, ...]) -> Kind | None:
    """Return which of the kinds the unit in ``value`` is of, None for none of them or unreadable text."""
    for kind in kinds:
        try:
            parse_quantity(value, kind)
        except InputError:
            continue
        return kind
    return None


def _split(value: object, kind: Kind) -> tuple[str, str]:
    """Return the number and the unit of a text, both still text."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        reason = "has no unit" if math.isfinite(value) else "is not a finite number"
        raise InputError(f"{quoted(value)} {reason}; {kind.allowed()}")
    if not isinstance(value, str):
        raise InputError(f"is {quoted(value)}; {kind.allowed()}")
    text = value.strip().replace("\u2212", "-")  # the typographic minus sign
    if len(text) > _LONGEST:
        raise InputError(f"{quoted(value)} is longer than {_LONGEST} characters; {kind.allowed()}")
    if not text:
        raise InputError(f"is empty; {kind.allowed()}")
    if _NOT_FINITE.match(text):
        raise InputError(f"{quoted(value)} is not a finite number; {kind.allowed()}")
    match = _NUMBER.match(text)
    if match is None:
        raise InputError(f"{quoted(value)} does not begin with a number; {kind.allowed()}")
    unit = text[match.end() :].strip()
    if not unit:
        raise InputError(f"{quoted(value)} has no unit; {kind.allowed()}")
    if unit[0] == ",":
        raise InputError(f"{quoted(value)} has a decimal comma, write a point; {kind.allowed()}")
    _check_range(match[0], value, kind)
    return match[0], unit


def _check_range(number: str, value: object, kind: Kind) -> None:
    # an exact power of ten is only formed for exponents that a double can hold
    exponent = number.lower().partition("e")[2]
    if exponent and (len(exponent) > 6 or abs(int(exponent)) > _LARGEST_EXPONENT):
        raise InputError(f"{quoted(value)} is out of range; {kind.allowed()}")
    if not math.isfinite(float(number)):
        raise InputError(f"{quoted(value)} is not finite; {kind.allowed()}")


def _name(signature: Signature) -> str:
    for kind in KINDS:
        if signature in kind.signatures:
            return kind.name
    if not signature:
        return "a pure number"
    return "of another kind"
