"""A signal that does not change."""

from __future__ import annotations

import jax.numpy as jnp

from varistiff.dynamics.signals.signal import Field, Sample, Signal


class Constant(Signal):
    """One value for all time.

    Parameters
    ----------
    value : the value
    """

    value: float

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        zero = jnp.zeros_like(time, dtype=float)
        return Sample(zero + self.value, zero, zero)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()
