"""Checks of a controller's numbers where it is made."""

from __future__ import annotations

import jax
import numpy as np

from varistiff.core.errors import InputError


def is_traced(value: object) -> bool:
    """Whether a number is only known when the compiled program runs."""
    return isinstance(value, jax.core.Tracer)


def check_number(
    field: str, value: object, *, above: float | None = None, least: float | None = None, infinite: bool = False
) -> None:
    """Refuse a number (or a batch of them) that is NaN, infinite (unless allowed), or too small.

    Numbers that a transformation traces are not known yet and pass.

    Raises
    ------
    InputError : names the field, the number and what is allowed
    """
    if is_traced(value):
        return
    numbers = np.asarray(value, dtype=float)
    if np.isnan(numbers).any() or (not infinite and np.isinf(numbers).any()):
        raise InputError(f"must be a finite number, not {_shown(numbers)}", field=field)
    if above is not None and not (numbers > above).all():
        raise InputError(f"must be above {above:g}, not {_shown(numbers)}", field=field)
    if least is not None and not (numbers >= least).all():
        raise InputError(f"must be at least {least:g}, not {_shown(numbers)}", field=field)


def check_choice(field: str, value: str, allowed: tuple[str, ...]) -> None:
    """Refuse a word that is none of the allowed ones.

    Raises
    ------
    InputError : names the field, the word and what is allowed
    """
    if value not in allowed:
        raise InputError(f"must be one of {', '.join(allowed)}, not {value!r}", field=field)


def check_range(field: str, low: object, high: object) -> None:
    """Refuse a range whose lower end does not lie below its upper end; infinite ends are allowed.

    Raises
    ------
    InputError : names the field and the ends
    """
    if is_traced(low) or is_traced(high):
        return
    lows, highs = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
    if not (lows < highs).all():
        raise InputError(f"the lower end {_shown(lows)} must lie below the upper end {_shown(highs)}", field=field)


def _shown(numbers: np.ndarray) -> str:
    return f"{numbers.flat[0]:.6g}" if numbers.size == 1 else f"a batch from {numbers.min():.6g} to {numbers.max():.6g}"
