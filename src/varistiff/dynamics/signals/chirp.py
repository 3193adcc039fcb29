"""A sine whose frequency sweeps."""

from __future__ import annotations

import math
from typing import Literal

import equinox as eqx
import jax.numpy as jnp

from varistiff.dynamics.signals.limits import check_positive
from varistiff.dynamics.signals.signal import Field, Sample, Signal


class Chirp(Signal):
    """offset + amplitude sin(phase), the phase growing from 0 at the start at a frequency that sweeps.

        linear       f = f_0 + (f_1 - f_0) s        s = (t - start)/duration within 0 and 1
        logarithmic  f = f_0 (f_1/f_0)^s            equal time for every octave

    Before the start the signal rests at its offset; after the sweep it goes on at f_1. The value is continuous, and its
    rate but at the start.

    Parameters
    ----------
    start : when the sweep begins [s]
    duration : how long it lasts [s], above zero
    offset : mean value
    amplitude : half of peak to peak
    first_frequency, last_frequency : f_0, f_1 [Hz], above zero
    sweep : "linear" or "logarithmic"
    """

    start: float
    duration: float
    offset: float
    amplitude: float
    first_frequency: float
    last_frequency: float
    sweep: Literal["linear", "logarithmic"] = eqx.field(static=True, default="linear")

    def __check_init__(self) -> None:
        check_positive("duration", self.duration, "s")
        check_positive("first_frequency", self.first_frequency, "Hz")
        check_positive("last_frequency", self.last_frequency, "Hz")

    def _phase(self, swept: Field) -> Sample:
        """Phase [rad] within the sweep, its rate, and the rate of that."""
        first, last = 2.0 * math.pi * self.first_frequency, 2.0 * math.pi * self.last_frequency
        if self.sweep == "linear":
            slope = (last - first) / self.duration
            return Sample(swept * (first + 0.5 * slope * swept), first + slope * swept, slope + 0.0 * swept)
        octaves = jnp.log(last / first)
        growth = octaves / self.duration
        steady = jnp.abs(octaves) < 1e-8  # there the quotient below is 0/0, and a series exact to rounding
        quotient = jnp.expm1(growth * swept) / jnp.where(steady, 1.0, growth)
        pulsation = first * jnp.exp(growth * swept)
        angle = first * jnp.where(steady, swept * (1.0 + 0.5 * growth * swept), quotient)
        return Sample(angle, pulsation, growth * pulsation)

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        shift = time - self.start
        swept = jnp.clip(shift, 0.0, self.duration)
        angle, pulsation, growth = self._phase(swept)
        angle = angle + pulsation * jnp.maximum(shift - self.duration, 0.0)
        begun = shift >= 0.0
        pulsation = jnp.where(begun, pulsation, 0.0)
        growth = jnp.where(begun & (shift <= self.duration), growth, 0.0)
        sine, cosine = self.amplitude * jnp.sin(angle), self.amplitude * jnp.cos(angle)
        return Sample(self.offset + sine, pulsation * cosine, growth * cosine - pulsation**2 * sine)

    @property
    def breaks(self) -> tuple[float, ...]:
        """The start."""
        return (float(self.start),)
