"""The smoothest way from rest to rest: Flash and Hogan's minimum-jerk motion."""

from __future__ import annotations

import jax.numpy as jnp

from varistiff.dynamics.signals.limits import check_positive
from varistiff.dynamics.signals.signal import Field, Sample, Signal


class MinimumJerk(Signal):
    """Motion from one value to another in a given time that makes the mean square jerk least.

        x = before + (after - before) (10 s^3 - 15 s^4 + 6 s^5),  s = (t - start)/duration within 0 and 1

    Value, rate and acceleration are continuous; the motion rests at both ends. The largest rate is 15/8 of the mean.

    Parameters
    ----------
    start : when it begins [s]
    duration : how long it lasts [s], above zero
    before, after : the two values

    Notes
    -----
    T. Flash and N. Hogan (1985), in one coordinate, doi 10.1523/JNEUROSCI.05-07-01688.1985.
    """

    start: float
    duration: float
    before: float
    after: float

    def __check_init__(self) -> None:
        check_positive("duration", self.duration, "s")

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        s = jnp.clip((time - self.start) / self.duration, 0.0, 1.0)
        travel = self.after - self.before
        value = self.before + travel * s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
        rate = travel / self.duration * 30.0 * s**2 * (1.0 - s) ** 2
        acceleration = travel / self.duration**2 * 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s)
        return Sample(value, rate, acceleration)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None: even the acceleration is continuous."""
        return ()
