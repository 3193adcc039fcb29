"""A jump from one value to another."""

from __future__ import annotations

import jax.numpy as jnp

from varistiff.dynamics.signals.signal import Field, Sample, Signal


class Step(Signal):
    """One value before an instant, another from that instant on; the derivatives are zero on both sides.

    Parameters
    ----------
    time : instant of the jump [s]
    before, after : the two values
    """

    time: float
    before: float
    after: float

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        zero = jnp.zeros_like(time, dtype=float)
        return Sample(zero + jnp.where(time < self.time, self.before, self.after), zero, zero)

    @property
    def breaks(self) -> tuple[float, ...]:
        """The instant of the jump."""
        return (float(self.time),)
