"""The pictures show the numbers they are given, in the units on their axes."""

from __future__ import annotations

import numpy as np

from varistiff.dynamics.linear import equilibrium, frequency_response, linearise, resonance_over_settings
from varistiff.report.simulation_linear import draw_bode, draw_resonance

from .joints import case, maccepa, two_mass


def test_bode_diagram() -> None:
    plant = two_mass(link_damping=0.4, drive_damping=0.2)
    system = linearise(plant, equilibrium(plant, link=0.0, external_torque=0.0))
    response = frequency_response(system, "drive_command", "drive", np.geomspace(0.5, 50.0, 300), units="rad/(N*m)")
    drawing = draw_bode(response)
    top, bottom = drawing.figure.axes
    np.testing.assert_array_equal(top.lines[0].get_ydata(), response.magnitude)
    np.testing.assert_allclose(np.radians(bottom.lines[0].get_ydata()), response.phase, rtol=1e-15)
    assert top.get_ylabel() == "Magnitude [rad/(N·m)]"
    assert (bottom.get_xlabel(), bottom.get_ylabel()) == ("Frequency [Hz]", "Phase [deg]")
    assert drawing.svg().startswith("<svg")


def test_resonance_over_setting() -> None:
    found = resonance_over_settings(case(maccepa()), np.linspace(0.004, 0.02, 9))
    axes = draw_resonance(found).figure.axes[0]
    upper, lower = axes.lines
    np.testing.assert_allclose(upper.get_xdata(), 1e3 * found.setting, rtol=1e-15)
    np.testing.assert_array_equal(upper.get_ydata(), found.resonance)
    np.testing.assert_array_equal(lower.get_ydata(), found.antiresonance)
    assert axes.get_xlabel() == "Setting [mm]"
