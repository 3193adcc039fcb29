"""Equilibrium and linear analysis of a joint: poles, resonance, Bode, and the poles of a sampled loop."""

from varistiff.core import precision
from varistiff.dynamics.linear.closed_loop import ClosedLoop, closed_loop, closed_loop_poles
from varistiff.dynamics.linear.equilibrium import Equilibrium, equilibrium
from varistiff.dynamics.linear.fastest_rate import fastest_rate
from varistiff.dynamics.linear.frequency_response import frequency_response
from varistiff.dynamics.linear.linearise import linearise
from varistiff.dynamics.linear.modes import Mode, antiresonances, modes
from varistiff.dynamics.linear.resonance_over_settings import resonance_over_settings
from varistiff.dynamics.linear.rest import rest
from varistiff.dynamics.linear.without_dry_friction import without_dry_friction

precision.enable()

__all__ = [
    "ClosedLoop",
    "Equilibrium",
    "Mode",
    "antiresonances",
    "closed_loop",
    "closed_loop_poles",
    "equilibrium",
    "fastest_rate",
    "frequency_response",
    "linearise",
    "modes",
    "resonance_over_settings",
    "rest",
    "without_dry_friction",
]
