"""Which numbers a drive or a storage may have, said with the field's name."""

from __future__ import annotations

import math

from varistiff.core.errors import InputError
from varistiff.core.suggest import quoted


def check_above_zero(**numbers: float | None) -> None:
    """Refuse numbers that are not above zero; infinity passes.

    Only plain numbers are looked at: inside a traced function a parameter has no value yet. None passes.

    Raises
    ------
    InputError : names the first wrong field

    >>> check_above_zero(resistance=0.3, voltage_limit=math.inf)
    """
    for field, number in numbers.items():
        if isinstance(number, int | float) and not number > 0.0:
            raise InputError(f"is {quoted(number)}; allowed is a number above zero", field=field)


def check_not_below_zero(**numbers: float | None) -> None:
    """Refuse negative numbers and NaN.

    Raises
    ------
    InputError : names the first wrong field
    """
    for field, number in numbers.items():
        if isinstance(number, int | float) and not number >= 0.0:
            raise InputError(f"is {quoted(number)}; allowed is zero or a number above it", field=field)


def check_finite(**numbers: float | None) -> None:
    """Refuse infinity and NaN.

    Raises
    ------
    InputError : names the first wrong field
    """
    for field, number in numbers.items():
        if isinstance(number, int | float) and not math.isfinite(number):
            raise InputError(f"is {quoted(number)}; allowed is a finite number", field=field)


def check_efficiency(**numbers: float | None) -> None:
    """Refuse efficiencies outside 0 to 1; 1 passes, 0 does not.

    Raises
    ------
    InputError : names the first wrong field
    """
    for field, number in numbers.items():
        if isinstance(number, int | float) and not 0.0 < number <= 1.0:
            raise InputError(f"is {quoted(number)}; allowed is an efficiency above 0 and up to 1", field=field)


def check_at_most(limit: float | None, **numbers: float | None) -> None:
    """Refuse numbers above a limit, which may pass itself.

    Raises
    ------
    InputError : names the first wrong field
    """
    for field, number in numbers.items():
        if isinstance(number, int | float) and isinstance(limit, int | float) and not number <= limit:
            raise InputError(f"is {quoted(number)}; allowed is at most {quoted(limit)}", field=field)
