"""Roller beam against a boundary-value rod and an energy minimisation that share no formula with it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.actuators import FixedPair, Rollers, SingleLower, SingleUpper, SwivellingPair
from varistiff.characteristic.evaluate import evaluate

from .devices import BEAM, CLEARANCE, RADIUS, device, placed
from .references.discrete_rod import extrapolated, obstacle
from .references.rod_bvp import roller_contact

ARRANGEMENTS: dict[str, tuple[Rollers, bool]] = {
    "lower": (SingleLower(offset=-0.011, radius=RADIUS), True),
    "upper": (SingleUpper(offset=0.008, radius=RADIUS), False),
    "fixed pair, lower": (FixedPair(offset=0.002, radius=0.004, clearance=0.05), True),
    "fixed pair, upper": (FixedPair(offset=0.002, radius=0.004, clearance=0.05), False),
    "swivelling, lower": (SwivellingPair(offset=0.004, clearance=CLEARANCE), True),
    "swivelling, upper": (SwivellingPair(offset=0.004, clearance=CLEARANCE), False),
    "point": (SingleLower(offset=0.0, radius=-BEAM.thickness / 2), True),
}
CONVERGED = 1e-8  # the rod is converged to 1e-9
EI = BEAM.flexural_rigidity


@pytest.mark.parametrize("name", ARRANGEMENTS)
@pytest.mark.parametrize("degrees", [14.0, 31.0, 58.0, 83.0, 89.0])
def test_against_the_rod(name: str, degrees: float) -> None:
    """Slope, force, length, moments, energy, torque and thrust, from small slopes to beyond the right angle."""
    rollers, lower = ARRANGEMENTS[name]
    deflection, setting = math.radians(degrees if lower else -degrees), 0.36
    where = placed(rollers, deflection, setting, lower=lower)
    rod = roller_contact(where.mirrored(), radius=where.radius, flexural_rigidity=EI)
    if rod.length > BEAM.length:
        pytest.fail("the catalogue of this test asks for a longer beam")
    here = evaluate(device(rollers), [deflection], [setting])
    side = 1.0 if lower else -1.0
    assert here.status[0] == 0
    assert here.details["contact_slope"][0] == pytest.approx(side * rod.end_slope, rel=CONVERGED)
    assert here.details["contact_force"][0] == pytest.approx(rod.force, rel=CONVERGED)
    assert here.details["active_length"][0] == pytest.approx(rod.length, rel=CONVERGED)
    assert here.details["root_moment"][0] == pytest.approx(side * rod.root_moment, rel=CONVERGED)
    assert here.energy[0] == pytest.approx(rod.energy, rel=CONVERGED)
    # the nodes of the rod straddle the largest moment: the parabola through three of them is good to 1e-6
    outer = rod.moment_max / EI * BEAM.youngs_modulus * BEAM.thickness / 2
    assert here.stress[0] == pytest.approx(outer, rel=1e-6)
    # what turns the link and moves the shuttle: the contact force, with its arm about the joint
    force = (rod.force_x, side * rod.force_y)
    arm = (float(rod.x[-1]) - where.joint[0], side * float(rod.y[-1]) - where.joint[1])
    torque = arm[0] * force[1] - arm[1] * force[0]
    assert here.load[0] == pytest.approx(torque, rel=CONVERGED, abs=CONVERGED * rod.force * setting)
    thrust = force[0] * where.along_link[0] + force[1] * where.along_link[1]
    assert here.adjusting_load[0] == pytest.approx(thrust, rel=CONVERGED, abs=CONVERGED * rod.force)


def test_slopes_cover_the_range() -> None:
    """Polar angles from 4 to 99 degrees of a point contact give slopes from 6 to 166 degrees."""
    seen = []
    plain = device(SingleLower(offset=0.0, radius=-BEAM.thickness / 2))
    plain = type(plain)(beam=plain.beam, rollers=plain.rollers)
    for degrees in (4, 30, 60, 80, 90, 96, 99):
        turn = math.radians(degrees)
        rod = roller_contact((0.3 * math.cos(turn), 0.3 * math.sin(turn)), radius=0.0, flexural_rigidity=EI)
        here = evaluate(plain, [turn], [0.3])
        assert here.details["contact_slope"][0] == pytest.approx(rod.end_slope, rel=1e-7)
        assert here.load[0] / rod.force / 0.3 == pytest.approx(math.cos(turn - rod.end_slope), abs=1e-7)
        seen.append(math.degrees(rod.end_slope))
    assert seen == sorted(seen)
    assert seen[0] < 7
    assert seen[-1] > 160


@pytest.mark.parametrize("name", ["lower", "upper", "swivelling, lower", "point"])
@pytest.mark.parametrize("degrees", [20.0, 60.0, 85.0])
def test_against_the_least_energy(name: str, degrees: float) -> None:
    """The minimiser holds the whole beam, tail included, off the roller; differences of 1e-5 and 1e-4 were seen."""
    rollers, lower = ARRANGEMENTS[name]
    deflection, setting = math.radians(degrees if lower else -degrees), 0.4
    where = placed(rollers, deflection, setting, lower=lower)
    found = [
        obstacle(where.mirrored(), radius=where.radius, flexural_rigidity=EI, length=BEAM.length, elements=n)
        for n in (32, 64)
    ]
    here = evaluate(device(rollers), [deflection], [setting])
    assert here.energy[0] == pytest.approx(extrapolated(found[0].energy, found[1].energy), rel=1e-4)
    assert here.details["contact_force"][0] == pytest.approx(extrapolated(found[0].force, found[1].force), rel=1e-3)
    assert here.details["active_length"][0] == pytest.approx(found[1].active_length, rel=1e-3)
    assert abs(here.details["contact_slope"][0]) == pytest.approx(found[1].slope, rel=2e-3)


@pytest.mark.parametrize("name", [name for name in ARRANGEMENTS if "swivelling" not in name])
def test_drawn_beam_touches_the_roller(name: str) -> None:
    """The drawn centreline has the beam's length, the rod's shape, and stays one radius off the roller's centre."""
    rollers, lower = ARRANGEMENTS[name]
    deflection, setting = math.radians(62.0 if lower else -62.0), 0.33
    where = placed(rollers, deflection, setting, lower=lower)
    (line,) = device(rollers).element_shapes(deflection, setting)
    pieces = np.hypot(*np.diff(line, axis=0).T)
    assert pieces.sum() == pytest.approx(BEAM.length, rel=1e-4)
    fine = np.linspace(0, 1, 20001)
    along = np.concatenate([[0.0], np.cumsum(pieces)]) / pieces.sum()
    x, y = np.interp(fine, along, line[:, 0]), np.interp(fine, along, line[:, 1])
    distance = np.hypot(x - where.centre[0], y - where.centre[1])
    assert distance.min() == pytest.approx(where.radius, abs=5e-5)  # half a piece of the drawn line, squared
    side = 1.0 if lower else -1.0
    rod = roller_contact(where.mirrored(), radius=where.radius, flexural_rigidity=EI)
    at = np.searchsorted(fine * BEAM.length, rod.s[::50])
    np.testing.assert_allclose(x[at], rod.x[::50], atol=2e-4)
    np.testing.assert_allclose(y[at], side * rod.y[::50], atol=2e-4)


def test_tail_length_does_not_matter() -> None:
    """Beyond the contact the beam is free and straight: a longer one changes nothing."""
    longer = type(BEAM)(BEAM.youngs_modulus, BEAM.width, BEAM.thickness, 1.7)
    rollers = SingleLower(offset=-0.011, radius=RADIUS)
    short, long = (evaluate(device(rollers, beam), [0.9], [0.4]) for beam in (BEAM, longer))
    assert short.load[0] == long.load[0]
    assert short.energy[0] == long.energy[0]
