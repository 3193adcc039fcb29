"""Rate of a sampled position: differences through a first-order filter."""

from __future__ import annotations

from typing import NamedTuple

from varistiff.dynamics.control.controller import Number, Scalar, as_scalar


class RateMemory(NamedTuple):
    """The last position and the filtered rate there."""

    position: Scalar
    rate: Scalar


def start_rate(position: Number) -> RateMemory:
    """Memory of something at rest."""
    return RateMemory(as_scalar(position), as_scalar(0.0))


def filtered_rate(memory: RateMemory, position: Number, period: Number, filter_time: Number) -> RateMemory:
    """One sample of s/(T_f s + 1) by backward differences, stable for every period T.

        r_k = (T_f r_(k-1) + x_k - x_(k-1))/(T_f + T)

    Parameters
    ----------
    memory : of the sample before
    position : x_k [rad or m, or any other signal]
    period : T [s], above 0
    filter_time : T_f [s], at least 0; 0 gives the plain difference quotient

    Notes
    -----
    Astrom and Hagglund (1995), PID Controllers, section 3.6.

    >>> memory = filtered_rate(start_rate(0.0), 0.5, period=0.1, filter_time=0.4)
    >>> float(memory.rate)
    1.0
    """
    x = as_scalar(position)
    rate = (filter_time * memory.rate + (x - memory.position)) / (filter_time + period)
    return RateMemory(x, rate)
