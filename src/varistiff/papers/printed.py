"""Printed digits: their value, and how far a number that rounds to them may lie off."""

from __future__ import annotations

import re

_DIGITS = re.compile(r"[+-]?(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d+))?")


def value_of(text: str) -> float:
    """Value of printed digits such as ``71.56`` or ``1.2e-3``.

    >>> value_of("71.56")
    71.56
    """
    if _DIGITS.fullmatch(text) is None:
        raise ValueError(f"{text!r} is no printed number such as 71.56 or 1.2e-3")
    return float(text)


def half_digit(text: str) -> float:
    """Half a unit of the last printed digit.

    >>> half_digit("71.56"), half_digit("128"), half_digit("1.2e3")
    (0.005, 0.5, 50.0)
    """
    match = _DIGITS.fullmatch(text)
    if match is None:
        raise ValueError(f"{text!r} is no printed number such as 71.56 or 1.2e-3")
    return 0.5 * float(f"1e{int(match[3] or 0) - len(match[2] or '')}")
