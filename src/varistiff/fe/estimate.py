"""How much memory and time a three-dimensional solution will take, before it begins."""

from __future__ import annotations

import os
from dataclasses import dataclass

_SECONDS = 1.2  # for one factorisation of 26 000 unknowns, on one slow core of 2024
_POWER = 1.85
_BYTES = 2.5e8  # of a factorisation of 26 000 unknowns
_BYTES_POWER = 1.3
_REFERENCE = 26_000.0


@dataclass(frozen=True)
class Estimate:
    """What a solution is expected to take; within a factor of about two.

    Parameters
    ----------
    unknowns : of one matrix
    memory : [bytes]
    seconds : wall time
    """

    unknowns: int
    memory: float
    seconds: float


def direct_solver(unknowns: int, *, matrices: int = 1) -> Estimate:
    """Estimate for sparse Cholesky factorisations on elements of order 3, calibrated on extruded solids.

    seconds ~ 1.2 (n/26000)^1.85,   memory ~ 0.25 GB (n/26000)^1.3   per matrix
    """
    ratio = max(unknowns, 1000) / _REFERENCE
    return Estimate(unknowns, matrices * _BYTES * ratio**_BYTES_POWER, 2.0 * matrices * _SECONDS * ratio**_POWER)


def available_memory() -> float:
    """Memory that a computation may take: nine tenths of what is free [bytes]; infinite where nobody says."""
    try:
        return 0.9 * os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return float("inf")
