"""A multiple of a signal."""

from __future__ import annotations

from varistiff.dynamics.signals.signal import Field, Sample, Signal


class Scaled(Signal):
    """A multiple of a signal: a sign, a body mass, a gear.

    Parameters
    ----------
    signal : the signal
    factor : what multiplies its value and its derivatives
    """

    signal: Signal
    factor: float

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        return Sample(*(self.factor * part for part in self.signal.at(time)))

    @property
    def breaks(self) -> tuple[float, ...]:
        """Those of the signal."""
        return self.signal.breaks
