"""Units that the edge understands: pint parses and converts them, exactly, by the definitions in ``units.txt``.

In front of pint stands a strict grammar: what reaches it is a short product of known symbols with small whole
powers. pint by itself takes any prefix and a plural s, and evaluates arithmetic.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache
from importlib import resources
from typing import TYPE_CHECKING, NamedTuple

from varistiff.core.errors import InputError
from varistiff.core.suggest import nearest, quoted

if TYPE_CHECKING:
    from pint import UnitRegistry

Signature = tuple[tuple[str, int], ...]  # pint's dimensionality, sorted: hashable, and known without pint


class Unit(NamedTuple):
    """A unit expression: SI value = number * factor; the signature says what it measures."""

    factor: Fraction
    signature: Signature


_MICRO = "u\u00b5\u03bc"
# prefixes that engineers use with a symbol; others are more likely a slip, such as mPa for MPa
_PREFIXES = {
    "m": "n" + _MICRO + "mcdk",
    "g": _MICRO + "m",
    "s": "n" + _MICRO + "m",
    "rad": _MICRO + "m",
    "N": _MICRO + "mckM",
    "Nm": _MICRO + "mckM",
    "Pa": "hkMGT",
    "J": "n" + _MICRO + "mkM",
    "Hz": "mkM",
    "V": _MICRO + "mk",
    "A": _MICRO + "m",
    "ohm": _MICRO + "mk",
    "\u03a9": _MICRO + "mk",
    "\u2126": _MICRO + "mk",
    "F": "n" + _MICRO + "m",
    "C": _MICRO + "m",
    "Ah": "m",
    "W": "mk",
    "K": "m",
}

_PLAIN_SIGNS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻·⋅", "0123456789-**")
_FACTOR = re.compile(r"([A-Za-z\u00b5\u03bc\u00b0\u03a9\u2126]+)(?:(?:\^|\*\*)?([+-]?[0-9]+))?")
_EXPRESSION = re.compile(rf"{_FACTOR.pattern}(?:(?: ?[*/] ?| ){_FACTOR.pattern})*")
_LARGEST_POWER = 4


@cache
def _registry() -> UnitRegistry[Fraction]:
    from pint import UnitRegistry  # with numpy most of a second: not for a command without quantities

    definitions = resources.files("varistiff.core").joinpath("units.txt").read_text(encoding="utf-8")
    return UnitRegistry(definitions.splitlines(), non_int_type=Fraction, on_redefinition="raise")


@cache
def _symbols() -> frozenset[str]:
    prefixed = {prefix + symbol for symbol, prefixes in _PREFIXES.items() for prefix in prefixes}
    return frozenset(prefixed.union(_registry()))


@cache
def atoms() -> dict[str, Unit]:
    """Return every unit symbol, prefixed ones included."""
    return {symbol: _measured(symbol) for symbol in sorted(_symbols())}


def parse_unit(text: str) -> Unit:
    """Return the unit that an expression such as ``N*m/rad`` or ``kg/m^3`` names.

    Factors are joined by ``*``, a space, a middle dot or ``/``, which divides by the next factor only; a
    power follows its factor. There are no brackets and no numbers other than powers.

    Raises
    ------
    InputError : on anything that is not such an expression of known symbols

    >>> parse_unit("N*m/deg").signature
    (('angle', -1), ('force', 1), ('length', 1))
    """
    expression = " ".join(text.translate(_PLAIN_SIGNS).split())
    if _EXPRESSION.fullmatch(expression) is None:
        raise InputError(f"cannot read the unit {quoted(text)}; write it like mm, N*m/rad or kg/m^3")

    def for_pint(factor: re.Match[str]) -> str:
        symbol, power = _symbol(factor[1]), _power(factor[2], text)
        return f"{symbol}**{power}" if power else "dimensionless"  # pint trips over a power of zero

    return _measured(_FACTOR.sub(for_pint, expression))


def _measured(expression: str) -> Unit:
    unit = _registry().parse_units(expression)
    factor, _ = _registry().get_root_units(unit)
    measures = ((name.strip("[]"), int(_exact(power))) for name, power in unit.dimensionality.items())
    return Unit(_exact(factor), tuple(sorted(measures)))


def _exact(number: object) -> Fraction:
    if not isinstance(number, int | Fraction):  # a slip in units.txt or in a later pint
        raise TypeError(f"pint gave {type(number).__name__} {number}, not an exact fraction")
    return Fraction(number)


def _power(text: str | None, unit: str) -> int:
    power = 1 if text is None else int(text[:4])
    if abs(power) > _LARGEST_POWER or (text is not None and len(text) > 3):
        raise InputError(f"the unit {quoted(unit)} has a power beyond {_LARGEST_POWER}")
    return power


def _symbol(symbol: str) -> str:
    if symbol in _symbols():
        return symbol
    match = nearest(symbol, sorted(_symbols()))
    hint = f' (did you mean "{match}"?)' if match else ""
    raise InputError(f"unknown unit {quoted(symbol)}{hint}")
