"""Signals over time, each with its exact rate and acceleration, for references, loads and prescribed motions."""

from varistiff.core import precision
from varistiff.dynamics.signals.chirp import Chirp
from varistiff.dynamics.signals.constant import Constant
from varistiff.dynamics.signals.minimum_jerk import MinimumJerk
from varistiff.dynamics.signals.pulse import Pulse
from varistiff.dynamics.signals.samples import Samples
from varistiff.dynamics.signals.scaled import Scaled
from varistiff.dynamics.signals.signal import Sample, Signal
from varistiff.dynamics.signals.sine import Sine
from varistiff.dynamics.signals.step import Step
from varistiff.dynamics.signals.sum import Sum

precision.enable()  # the modules above trace nothing when they are imported

__all__ = [
    "Chirp",
    "Constant",
    "MinimumJerk",
    "Pulse",
    "Sample",
    "Samples",
    "Scaled",
    "Signal",
    "Sine",
    "Step",
    "Sum",
]
