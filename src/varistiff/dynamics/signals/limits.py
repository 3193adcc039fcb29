"""Checks of a signal's parameters where it is made."""

from __future__ import annotations

import math

from varistiff.core.errors import InputError
from varistiff.core.suggest import quoted


def check_positive(name: str, value: object, unit: str) -> None:
    """Refuse a number that is not finite and above zero; traced numbers pass unseen.

    Raises
    ------
    InputError : the number is zero, negative or not finite
    """
    if isinstance(value, int | float) and not 0.0 < value < math.inf:
        raise InputError(f"is {quoted(value)}; allowed is a number above zero [{unit}]", field=name)
