"""Mirror images, dimensions and proportionality, on every kind that has them."""

from __future__ import annotations

import numpy as np
import pytest

from varistiff.actuators import FixedPair, RollerBeam, Rollers, SingleLower, SingleUpper, SwivellingPair

from .catalogue import CATALOGUE, Case, Scale
from .evaluation import respond

every_case = pytest.mark.parametrize("case", CATALOGUE, ids=lambda case: case.name)
CLOSE = 1e-11  # rounding of a nearby point, times a condition number of at most some hundreds


@pytest.mark.parametrize("case", [case for case in CATALOGUE if case.symmetric], ids=lambda case: case.name)
def test_mirror_symmetric_devices(case: Case) -> None:
    """V, stiffness, adjusting load and stress are even in the deflection, the load is odd, bit for bit nearly."""
    deflection, setting = case.sample(3)
    there, back = respond(case.actuator, deflection, setting), respond(case.actuator, -deflection, setting)
    for name in ("energy", "stiffness", "adjusting_load", "stress"):
        np.testing.assert_allclose(back[name], there[name], rtol=CLOSE, err_msg=name)
    scale = float(np.max(np.abs(there["load"])))
    np.testing.assert_allclose(back["load"], -there["load"], rtol=CLOSE, atol=CLOSE * scale)
    assert np.ptp(there["load"]) > 0


def _mirrored(device: RollerBeam) -> RollerBeam:
    """Change the sign of the mounting angle, of both offsets across, and swap the rollers."""
    rollers = device.rollers
    other: Rollers
    if isinstance(rollers, SingleLower):
        other = SingleUpper(offset=-rollers.offset, radius=rollers.radius)
    elif isinstance(rollers, SingleUpper):
        other = SingleLower(offset=-rollers.offset, radius=rollers.radius)
    elif isinstance(rollers, FixedPair):
        other = FixedPair(offset=-rollers.offset, radius=rollers.radius, clearance=rollers.clearance)
    else:
        assert isinstance(rollers, SwivellingPair)
        other = SwivellingPair(offset=-rollers.offset, clearance=rollers.clearance)
    return RollerBeam(
        beam=device.beam,
        rollers=other,
        mounting_angle=-device.mounting_angle,
        clamp_offset_along=device.clamp_offset_along,
        clamp_offset_across=-device.clamp_offset_across,
    )


@pytest.mark.parametrize(
    "case", [case for case in CATALOGUE if case.name.startswith("roller")], ids=lambda case: case.name
)
def test_mirror_image_of_a_roller_beam(case: Case) -> None:
    """theta -> -theta with everything mirrored: what is a length, a force or an energy stays, angles turn."""
    device = case.actuator
    assert isinstance(device, RollerBeam)
    deflection, setting = case.sample(4)
    there, back = respond(device, deflection, setting), respond(_mirrored(device), -deflection, setting)
    kept = ("energy", "stiffness", "adjusting_load", "stress", "contact_force", "active_length")
    for name in kept:
        np.testing.assert_allclose(back[name], there[name], rtol=CLOSE, atol=1e-9, err_msg=name)
    for name in ("load", "contact_slope", "root_moment"):
        np.testing.assert_allclose(back[name], -there[name], rtol=CLOSE, err_msg=name)
    assert (np.sign(there["contact_slope"]) == np.sign(deflection)).all()


@every_case
def test_dimensions(case: Case) -> None:
    """All lengths times L with E fixed: energy and torque L^3, force L^2, stress unchanged; E only multiplies."""
    size, modulus = 2.5, 3.0
    deflection, setting = case.sample(5)
    here = respond(case.actuator, deflection, setting)
    length_setting = case.actuator.setting_unit == "m"
    grown = respond(
        case.build(Scale(length=size, modulus=modulus)),
        deflection * (size if case.linear else 1.0),
        setting * (size if length_setting else 1.0),
    )
    powers = {
        "energy": 3,
        "load": 2 if case.linear else 3,
        "stiffness": 1 if case.linear else 3,
        "adjusting_load": 2 if length_setting else 3,
        "stress": 0,
    }
    assert (grown["status"] == here["status"]).all()
    for name, power in powers.items():
        wanted = here[name] * modulus * size**power
        scale = float(np.nanmax(np.abs(wanted), initial=0.0))
        np.testing.assert_allclose(grown[name], wanted, rtol=1e-9, atol=1e-11 * scale, err_msg=name)


@pytest.mark.parametrize("case", [case for case in CATALOGUE if case.has_width], ids=lambda case: case.name)
def test_proportional_to_width(case: Case) -> None:
    """Twice the width is two leaves side by side: energy and loads double, the stress stays."""
    deflection, setting = case.sample(6)
    one = respond(case.actuator, deflection, setting)
    two = respond(case.build(Scale(width=2.0)), deflection, setting)
    for name in ("energy", "load", "stiffness", "adjusting_load"):
        scale = float(np.max(np.abs(one[name])))
        np.testing.assert_allclose(two[name], 2 * one[name], rtol=CLOSE, atol=CLOSE * scale, err_msg=name)
    np.testing.assert_allclose(two["stress"], one["stress"], rtol=CLOSE)


@every_case
def test_points_do_not_mix(case: Case) -> None:
    """A point's numbers do not depend on its neighbours or its place in the batch."""
    deflection, setting = case.sample(7)
    forward = respond(case.actuator, deflection, setting)
    backward = respond(case.actuator, deflection[::-1].copy(), setting[::-1].copy())
    alone = respond(case.actuator, np.full_like(deflection, deflection[5]), np.full_like(setting, setting[5]))
    for name, values in forward.items():
        np.testing.assert_allclose(backward[name][::-1], values, rtol=1e-13, err_msg=name)
        np.testing.assert_allclose(alone[name], values[5], rtol=1e-13, err_msg=name)


@every_case
def test_energy_grows_with_the_load(case: Case) -> None:
    """A step in the direction of the load stores energy, a step against it gives energy back."""
    deflection, setting = case.sample(8)
    here = respond(case.actuator, deflection, setting)
    step = 1e-4 * case.reach[0] * np.sign(here["load"])
    clear = np.abs(here["load"]) > 0.02 * np.max(np.abs(here["load"]))
    assert clear.sum() >= 12
    more = respond(case.actuator, deflection + step, setting)["energy"]
    less = respond(case.actuator, deflection - step, setting)["energy"]
    assert (more > here["energy"])[clear].all()
    assert (less < here["energy"])[clear].all()
