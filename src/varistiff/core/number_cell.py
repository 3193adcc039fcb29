"""A finite number in a cell of a table."""

from __future__ import annotations

import math
import re

from varistiff.core.errors import InputError
from varistiff.core.suggest import quoted

NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?", re.ASCII)
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)", re.IGNORECASE)


def parse_cell(cell: str, *, where: str, unit: str = "in SI units") -> float:
    """Return the number in a cell.

    Parameters
    ----------
    where : row and column, for the message
    unit : what to say of the unit, after "a finite number"

    Raises
    ------
    InputError : blank, no number, or not finite

    >>> parse_cell(" 1.5e-3 ", where="row 1, column x")
    0.0015
    """
    text = cell.strip()
    if not text:
        raise InputError(f"is blank; allowed is a finite number {unit}", field=where)
    if _NOT_FINITE.fullmatch(text):
        raise InputError(f"{quoted(text)} is not finite; allowed is a finite number {unit}", field=where)
    if len(text) > 400 or not NUMBER.fullmatch(text):
        raise InputError(f"{quoted(text)} is not a number; allowed is a finite number {unit}", field=where)
    value = float(text)
    if not math.isfinite(value):
        raise InputError(f"{quoted(text)} is too large; allowed is a finite number {unit}", field=where)
    return value
