"""Signals added to one another."""

from __future__ import annotations

import jax.numpy as jnp

from varistiff.dynamics.signals.signal import Field, Sample, Signal


class Sum(Signal):
    """The sum of signals; zero without any.

    Parameters
    ----------
    parts : the signals
    """

    parts: tuple[Signal, ...]

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        zero = jnp.zeros_like(time, dtype=float)
        total = Sample(zero, zero, zero)
        for part in self.parts:
            total = Sample(*(one + other for one, other in zip(total, part.at(time), strict=True)))
        return total

    @property
    def breaks(self) -> tuple[float, ...]:
        """Those of the parts, each once; parts that cancel each other are not found out."""
        return tuple(sorted({instant for part in self.parts for instant in part.breaks}))
