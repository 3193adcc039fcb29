"""A harmonic signal."""

from __future__ import annotations

import math

import jax.numpy as jnp

from varistiff.dynamics.signals.signal import Field, Sample, Signal
from varistiff.elastic.lemniscate import circular


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
        turns = self.frequency * time
        # whole turns off first: the angle stays moderate, and exact, however late it is
        sine, cosine = circular(2.0 * math.pi * (turns - jnp.floor(turns)) + self.phase)
        swing = self.amplitude * sine
        rate = pulsation * self.amplitude * cosine
        return Sample(self.offset + swing, rate, -(pulsation**2) * swing)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()
