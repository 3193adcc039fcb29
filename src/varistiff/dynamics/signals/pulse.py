"""A blow: a signal that is there for a short time."""

from __future__ import annotations

import math
from typing import Literal

import equinox as eqx
import jax.numpy as jnp

from varistiff.dynamics.signals.limits import check_positive
from varistiff.dynamics.signals.signal import Field, Sample, Signal


class Pulse(Signal):
    """Zero but for a rectangle or half a sine wave of a given height.

    Parameters
    ----------
    start : when it begins [s]
    duration : how long it lasts [s], above zero
    height : its largest value
    shape : "rectangle" or "half_sine"
    """

    start: float
    duration: float
    height: float
    shape: Literal["rectangle", "half_sine"] = eqx.field(static=True, default="half_sine")

    def __check_init__(self) -> None:
        check_positive("duration", self.duration, "s")

    @property
    def impulse(self) -> float:
        """Integral over time: height times duration, for half a sine 2/pi of that."""
        return self.height * self.duration * (1.0 if self.shape == "rectangle" else 2.0 / math.pi)

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        shift = time - self.start
        inside = (shift >= 0.0) & (shift < self.duration)
        height = jnp.where(inside, self.height, 0.0)
        if self.shape == "rectangle":
            return Sample(height, jnp.zeros_like(height), jnp.zeros_like(height))
        pulsation = math.pi / self.duration
        sine, cosine = jnp.sin(pulsation * shift), jnp.cos(pulsation * shift)
        return Sample(height * sine, pulsation * height * cosine, -(pulsation**2) * height * sine)

    @property
    def breaks(self) -> tuple[float, ...]:
        """Both ends."""
        return float(self.start), float(self.start + self.duration)
