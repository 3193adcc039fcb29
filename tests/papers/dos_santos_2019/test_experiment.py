"""Section 4: the states of the rig, the errors, and what the experiment can tell."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from varistiff.papers.dos_santos_2019 import experiment
from varistiff.papers.dos_santos_2019.beams import leaf
from varistiff.papers.dos_santos_2019.paper_values import ACTIVE_LENGTHS, BEAMS, FORCES

ERRORS = (1.1525, 2.9869, 0.92602, 1.8255)


def marched(rigidity: float, length: float, force: float) -> tuple[float, float, float]:
    """Slope, a and b of a cantilever with a tip force normal to it, by shooting from the contact."""

    def end(slope: float) -> np.ndarray:
        ratio = math.tan(slope)

        def rates(_: float, state: np.ndarray) -> list[float]:
            theta = state[0]
            bending = force / rigidity * (math.cos(theta) + ratio * math.sin(theta))
            return [-state[1], bending, math.cos(theta), math.sin(theta)]

        return solve_ivp(rates, (0.0, length), [slope, 0.0, 0.0, 0.0], rtol=1e-10, atol=1e-12).y[:, -1]

    slope = brentq(lambda slope: end(slope)[0], 1e-4, 0.8, xtol=1e-12)
    return slope, *end(slope)[2:]


@pytest.mark.parametrize("beam", BEAMS)
@pytest.mark.parametrize("length", ACTIVE_LENGTHS.values())
def test_state_of_the_device_is_that_of_the_integrated_beam(beam, length):
    state = experiment.contact(beam, length, FORCES[1])
    assert state.across_force == pytest.approx(FORCES[1], rel=1e-9)  # two closed forms
    assert state.active_length == pytest.approx(length, rel=1e-9)
    wanted = marched(leaf(beam).flexural_rigidity, length, FORCES[1])
    assert (state.slope, state.along, state.across) == pytest.approx(wanted, rel=1e-7)  # the marching's own error


def test_linear_theories_lie_on_both_sides_of_the_errors():
    # the softest beam at its longer length, where every theory is furthest off
    rigidity, worst = leaf("spring_steel").flexural_rigidity, dict.fromkeys(experiment.linear_errors(), 0.0)
    for force in range(2, 21):
        slope, a, b = marched(rigidity, 0.75, float(force))
        chord = math.hypot(a, b)
        forces = {
            "chord_normal": 3.0 * rigidity * b / chord**3 * math.cos(1.5 * b / chord),
            "arc_normal": 3.0 * rigidity * b / 0.75**3 * math.cos(1.5 * b / 0.75),
            "arc_across": 3.0 * rigidity * b / 0.75**3,
            "slope": 2.0 * rigidity * slope / 0.75**2,
            "span_across": 3.0 * rigidity * b / a**3,
        }
        worst = {theory: max(worst[theory], abs(value - force)) for theory, value in forces.items()}
    assert experiment.linear_errors() == pytest.approx(worst, rel=1e-5)  # the marching's own error, in a difference
    assert worst["chord_normal"] < 0.03
    assert worst["arc_normal"] < 0.6 < min(ERRORS)
    assert min(ERRORS) < 1.75 < worst["arc_across"] < worst["slope"] < worst["span_across"]
    least, largest = experiment.experiment_tells_theories_apart()
    assert (least, largest) == pytest.approx((worst["chord_normal"] - 0.92602, worst["span_across"] - 0.92602))


def test_slopes_stay_below_28_degrees():
    softest, stiffest = leaf("spring_steel").flexural_rigidity, leaf("low_carbon_steel").flexural_rigidity
    assert experiment.largest_slope() == pytest.approx(marched(softest, 0.75, 20.0)[0], rel=1e-7)  # as above
    assert experiment.largest_slope() < math.radians(28.0)
    least = min(state.slope for state in experiment.states())
    assert least == pytest.approx(marched(stiffest, 0.43, 2.0)[0], rel=1e-6)  # as above, of a small number


def test_errors_of_equal_and_of_unequal_groups():
    assert experiment.pooled_error(14, 14, 14, 14) == pytest.approx(math.sqrt(sum(e**2 for e in ERRORS) / 4.0))
    assert experiment.pooled_error(14, 14, 14, 14) == pytest.approx(1.900, abs=5e-4)  # 1.956 is printed
    assert experiment.pooled_error(16, 16, 12, 12) == pytest.approx(1.956, abs=5e-4)
    least, largest = experiment.overall_error()
    assert min(ERRORS) < least < 1.956 < largest < max(ERRORS)


def test_active_length_grows_as_the_beam_slides():
    gain = experiment.growth_of_active_length("spring_steel", 0.75)
    # cubic shape: the arc is longer than the chord by 3 b^2/5 - b^2/2 over it, b/L about 0.32
    assert gain == pytest.approx(0.75 * 0.1 * math.tan(0.3335) ** 2, rel=0.1)  # a tenth: the next order


def test_a_turned_sign_of_the_device_is_seen(monkeypatch):
    whole = experiment.evaluate

    def turned(*arguments):
        points = whole(*arguments)
        return replace(points, adjusting_load=-points.adjusting_load)

    monkeypatch.setattr(experiment, "evaluate", turned)
    caches = (experiment.contact, experiment.states)
    for cached in caches:
        cached.cache_clear()
    try:
        assert experiment.zero_lambda() < 0.0
        assert experiment.normal_force() < 0.0
        assert experiment.defined_force_agrees() < 0.0
    finally:
        for cached in caches:
            cached.cache_clear()


@pytest.mark.parametrize("wrong", ["root_moment", "stress"])
def test_a_doubled_moment_or_stress_is_seen(monkeypatch, wrong):
    states = [state._replace(**{wrong: 2.0 * getattr(state, wrong)}) for state in experiment.states()]
    monkeypatch.setattr(experiment, "states", lambda: states)
    assert experiment.moment_at_clamp() < -0.4
