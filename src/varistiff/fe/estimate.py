"""How much memory and time a three-dimensional solution will take, before it begins."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass

_SECONDS = 1.2  # for one factorisation of 26 000 unknowns, on one slow core of 2024
_POWER = 1.85
_BYTES = 2.5e8  # of a factorisation of 26 000 unknowns
_BYTES_POWER = 1.3
_REFERENCE = 26_000.0

ALL_KEPT = "every result is kept from an earlier run"


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

    @staticmethod
    def one_after_the_other(parts: Iterable[Estimate]) -> Estimate:
        """Of several solutions: the most unknowns and memory of any, the time of all."""
        kept = list(parts)
        return Estimate(
            max((part.unknowns for part in kept), default=0),
            max((part.memory for part in kept), default=0.0),
            sum(part.seconds for part in kept),
        )

    @property
    def time(self) -> str:
        """Wall time as people say it."""
        for seconds, unit in ((3600.0, "h"), (60.0, "min")):
            if self.seconds >= 2.0 * seconds:
                return f"{self.seconds / seconds:.2g} {unit}"
        return f"{max(self.seconds, 1.0):.0f} s"

    @property
    def room(self) -> str:
        """Memory as people say it."""
        return f"{max(self.memory / 2**30, 0.1):.2g} GiB"


def direct_solver(unknowns: int, *, matrices: int = 1) -> Estimate:
    """Estimate for sparse Cholesky factorisations on elements of order 3, calibrated on extruded solids.

    seconds ~ 1.2 (n/26000)^1.85,   memory ~ 0.25 GB (n/26000)^1.3   per matrix
    """
    ratio = max(unknowns, 1000) / _REFERENCE
    return Estimate(unknowns, matrices * _BYTES * ratio**_BYTES_POWER, 2.0 * matrices * _SECONDS * ratio**_POWER)


def counted(new: int, count: int, name: str) -> str:
    """How many things are to be computed, and how many are kept from an earlier run."""
    text = f"{new} {name}{'' if new == 1 else 's'}"
    return text if new == count else f"{text} ({count - new} more kept from an earlier run)"


def available_memory() -> float:
    """Memory that a computation may take: nine tenths of what is free [bytes]; infinite where nobody says."""
    try:
        return 0.9 * os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return float("inf")
