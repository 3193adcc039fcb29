"""A harmonic signal."""

from __future__ import annotations

import math

import jax.numpy as jnp

from varistiff.dynamics.signals.signal import Field, Sample, Signal


class Sine(Signal):
    """offset + amplitude sin(2 pi frequency t + phase), for all time.

    Parameters
    ----------
    offset : mean value
    amplitude : half of peak to peak
    frequency : [Hz]
    phase : at t = 0 [rad]
    """

    offset: float
    amplitude: float
    frequency: float
    phase: float = 0.0

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        pulsation = 2.0 * math.pi * self.frequency
        angle = pulsation * time + self.phase
        swing = self.amplitude * jnp.sin(angle)
        rate = pulsation * self.amplitude * jnp.cos(angle)
        return Sample(self.offset + swing, rate, -(pulsation**2) * swing)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()
