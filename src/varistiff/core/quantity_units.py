"""Units that the edge understands, exact, each with what it measures.

A unit is a factor to SI and a signature over *measures* (length, angle, force, pressure, energy ...).
The measures are deliberately finer than the SI base: an angle is not a pure number and ``J`` is not ``N*m``,
so that a torque, an energy and a rotational stiffness stay three different things.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from varistiff.core.errors import InputError
from varistiff.core.suggest import nearest, quoted

Signature = tuple[tuple[str, int], ...]

# pi to 60 digits: conversions round once, to the nearest double
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494")

_MICRO = "u\u00b5\u03bc"
_PREFIXES = {
    "n": Fraction(1, 10**9),
    "u": Fraction(1, 10**6),
    "\u00b5": Fraction(1, 10**6),  # the micro sign
    "\u03bc": Fraction(1, 10**6),  # the Greek letter, which looks the same
    "m": Fraction(1, 10**3),
    "c": Fraction(1, 10**2),
    "d": Fraction(1, 10),
    "h": Fraction(10**2),
    "k": Fraction(10**3),
    "M": Fraction(10**6),
    "G": Fraction(10**9),
    "T": Fraction(10**12),
}

_POUND = Fraction("0.45359237")
_INCH = Fraction("0.0254")
_GRAVITY = Fraction("9.80665")
_POUND_FORCE = _POUND * _GRAVITY


class Unit(NamedTuple):
    """A unit expression: SI value = number * factor; the signature says what it measures."""

    factor: Fraction
    signature: Signature


def _atom(factor: Fraction | int, **measures: int) -> Unit:
    return Unit(Fraction(factor), tuple(sorted(measures.items())))


# symbol: (unit, prefixes that engineers use with it; others are more likely a slip, such as mPa for MPa)
_PREFIXABLE: dict[str, tuple[Unit, str]] = {
    "m": (_atom(1, length=1), "n" + _MICRO + "mcdk"),
    "g": (_atom(Fraction(1, 1000), mass=1), _MICRO + "mk"),
    "s": (_atom(1, time=1), "n" + _MICRO + "m"),
    "rad": (_atom(1, angle=1), _MICRO + "m"),
    "N": (_atom(1, force=1), _MICRO + "mckM"),
    "Nm": (_atom(1, force=1, length=1), _MICRO + "mckM"),
    "Pa": (_atom(1, pressure=1), "hkMGT"),
    "J": (_atom(1, energy=1), "n" + _MICRO + "mkM"),
    "Hz": (_atom(1, frequency=1), "mkM"),
}

_PLAIN: dict[str, Unit] = {
    "metre": _atom(1, length=1),
    "meter": _atom(1, length=1),
    "in": _atom(_INCH, length=1),
    "inch": _atom(_INCH, length=1),
    "ft": _atom(12 * _INCH, length=1),
    "deg": _atom(PI / 180, angle=1),
    "degree": _atom(PI / 180, angle=1),
    "degrees": _atom(PI / 180, angle=1),
    "°": _atom(PI / 180, angle=1),
    "radian": _atom(1, angle=1),
    "arcmin": _atom(PI / 10800, angle=1),
    "arcsec": _atom(PI / 648000, angle=1),
    "turn": _atom(2 * PI, angle=1),
    "rev": _atom(2 * PI, angle=1),
    "Nmm": _atom(Fraction(1, 1000), force=1, length=1),
    "lbf": _atom(_POUND_FORCE, force=1),
    "kgf": _atom(_GRAVITY, force=1),
    "bar": _atom(10**5, pressure=1),
    "psi": _atom(_POUND_FORCE / _INCH**2, pressure=1),
    "ksi": _atom(1000 * _POUND_FORCE / _INCH**2, pressure=1),
    "lb": _atom(_POUND, mass=1),
    "t": _atom(1000, mass=1),
    "min": _atom(60, time=1),
    "h": _atom(3600, time=1),
    "rpm": _atom(2 * PI / 60, angle=1, time=-1),
    "Wh": _atom(3600, energy=1),
    "l": _atom(Fraction(1, 1000), length=3),
    "L": _atom(Fraction(1, 1000), length=3),
}

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_FACTOR = re.compile(r"([A-Za-z\u00b5\u03bc\u00b0]+)(?:(?:\^|\*\*)?([+-]?[0-9]+))?", re.ASCII)
_OPERATOR = re.compile(r"\s*([*·⋅/])(?!\*)\s*|\s+")
_LARGEST_POWER = 4


@cache
def atoms() -> dict[str, Unit]:
    """Return every unit symbol, prefixed ones included."""
    table = dict(_PLAIN)
    for symbol, (unit, prefixes) in _PREFIXABLE.items():
        table[symbol] = unit
        for prefix in prefixes:
            table[prefix + symbol] = Unit(unit.factor * _PREFIXES[prefix], unit.signature)
    return table


def parse_unit(text: str) -> Unit:
    """Return the unit that an expression such as ``N*m/rad`` or ``kg/m^3`` names.

    Factors are joined by ``*``, a space, a middle dot or ``/``, which divides by the next factor only; a
    power follows its factor. Nothing is evaluated and there are no brackets.

    Raises
    ------
    InputError : on anything that is not such an expression of known symbols

    >>> parse_unit("N*m/deg").signature
    (('angle', -1), ('force', 1), ('length', 1))
    """
    expression = text.translate(_SUPERSCRIPTS).strip()
    factor, powers, position, sign = Fraction(1), dict[str, int](), 0, 1
    while True:
        match = _FACTOR.match(expression, position)
        if match is None:
            raise InputError(f"cannot read the unit {quoted(text)}; write it like mm, N*m/rad or kg/m^3")
        atom, power = _symbol(match[1]), sign * _power(match[2], text)
        factor *= atom.factor**power
        for measure, exponent in atom.signature:
            powers[measure] = powers.get(measure, 0) + power * exponent
        position = match.end()
        if position == len(expression):
            break
        operator = _OPERATOR.match(expression, position)
        if operator is None:
            raise InputError(f"cannot read the unit {quoted(text)}; write it like mm, N*m/rad or kg/m^3")
        sign = -1 if operator[1] == "/" else 1
        position = operator.end()
    return Unit(factor, tuple(sorted((name, power) for name, power in powers.items() if power)))


def _power(text: str | None, unit: str) -> int:
    power = 1 if text is None else int(text[:4])
    if abs(power) > _LARGEST_POWER or (text is not None and len(text) > 3):
        raise InputError(f"the unit {quoted(unit)} has a power beyond {_LARGEST_POWER}")
    return power


def _symbol(symbol: str) -> Unit:
    known = atoms()
    if symbol in known:
        return known[symbol]
    match = nearest(symbol, known)
    hint = f' (did you mean "{match}"?)' if match else ""
    raise InputError(f"unknown unit {quoted(symbol)}{hint}")
