"""Bode diagram of a slider leaf joint, from the drive's torque to its position."""

from __future__ import annotations

import numpy as np
from joint_resonance import joint
from matplotlib.figure import Figure

from varistiff.dynamics.linear import frequency_response, linearise, rest
from varistiff.report.simulation_linear import draw_bode


def draw() -> Figure:
    """Draw it at an active length of 20 mm."""
    case = joint()
    system = linearise(case.plant, rest(case, motion=0.02))
    return draw_bode(
        frequency_response(system, "drive_command", "drive", np.geomspace(1.0, 100.0, 600), units="rad/(N*m)")
    ).figure
