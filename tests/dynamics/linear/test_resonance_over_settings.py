"""Resonance over the settings against the closed form of a joint whose stiffness is known."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from varistiff.actuators import SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.linear import resonance_over_settings
from varistiff.dynamics.plant import Member, Plant
from varistiff.elastic.leaf import Leaf

from .joints import DRIVE, LINK, case, maccepa, maccepa_stiffness, moving, two_mass

PRETENSIONS = np.array([0.004, 0.009, 0.02])


def test_resonance_and_antiresonance_rise_with_the_pretension() -> None:
    found = resonance_over_settings(case(maccepa()), PRETENSIONS)
    stiffness = np.array([maccepa_stiffness(pretension) for pretension in PRETENSIONS])
    tight = 1e-10  # exact derivatives, rounding of eigenvalues
    np.testing.assert_allclose(found.stiffness, stiffness, rtol=tight)
    np.testing.assert_allclose(found.resonance, np.sqrt(stiffness * (1 / LINK + 1 / DRIVE)) / (2 * np.pi), rtol=tight)
    np.testing.assert_allclose(found.antiresonance, np.sqrt(stiffness / LINK) / (2 * np.pi), rtol=tight)
    np.testing.assert_allclose(found.resonance_damping, 0.0, atol=1e-12)
    assert (found.status == Status.OK).all()
    assert {name: found[name].attrs["units"] for name in found.data_vars} == {
        "deflection": "rad",
        "stiffness": "N*m/rad",
        "resonance": "Hz",
        "resonance_damping": "1",
        "antiresonance": "Hz",
        "antiresonance_damping": "1",
        "status": "1",
    }
    assert found.setting.attrs["units"] == "m"
    assert found.attrs["kind"] == "maccepa"


def test_viscous_friction_damps_both() -> None:
    plant = maccepa(link=Member(LINK, Friction(0.02)))
    found = resonance_over_settings(case(plant), PRETENSIONS)
    stiffness = np.array([maccepa_stiffness(pretension) for pretension in PRETENSIONS])
    np.testing.assert_allclose(found.antiresonance_damping, 0.02 / (2.0 * np.sqrt(stiffness * LINK)), rtol=1e-9)


def test_a_loaded_joint_rests_deflected() -> None:
    found = resonance_over_settings(case(maccepa(), load=0.3), [0.009])
    # load k e A' at the deflection, with A^2 = B^2 + C^2 - 2 B C cos d
    b, c, d = 0.036, 0.135, float(found.deflection[0])
    a = math.sqrt(b * b + c * c - 2.0 * b * c * math.cos(d))
    assert 394.0 * (a + 0.009 - (c - b)) * b * c * math.sin(d) / a == pytest.approx(0.3, rel=1e-9)
    assert d > 0.0


def test_a_slack_cable_has_no_resonance() -> None:
    found = resonance_over_settings(case(maccepa()), [-0.001, 0.009])
    assert found.status.values.tolist() == [Status.NO_CONTACT, Status.OK]
    assert np.isnan(found.resonance.values).tolist() == [True, False]


def test_a_load_that_no_setting_carries() -> None:
    found = resonance_over_settings(case(maccepa(), load=50.0), [0.009])
    assert math.isnan(float(found.resonance[0]))
    assert int(found.status[0]) == Status.NO_SOLUTION


def test_an_element_that_is_too_short_says_so() -> None:
    leaf = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001, length=0.02)
    device = SliderLeafJoint(leaf=leaf, count=1, clamp_radius=0.025)
    plant = Plant(device, link=Member(LINK), drive=Member(DRIVE))
    found = resonance_over_settings(case(plant, moving(motion=0.018)), [0.018, 0.022])
    assert found.status.values.tolist() == [Status.OK, Status.ELEMENT_TOO_SHORT]
    assert np.isfinite(found.resonance.values).tolist() == [True, False]


def test_a_locked_drive_leaves_the_link_alone() -> None:
    plant = dataclasses.replace(maccepa(), drive=Member(DRIVE, mode="locked"))
    found = resonance_over_settings(case(plant, moving(link=0.1, drive=0.1)), [0.009])
    expected = math.sqrt(maccepa_stiffness(0.009) / LINK) / (2.0 * math.pi)
    assert float(found.resonance[0]) == pytest.approx(expected, rel=1e-9)
    assert math.isnan(float(found.antiresonance[0]))


def test_a_joint_without_a_setting_is_refused() -> None:
    with pytest.raises(InputError, match="settings: a series_elastic has no setting"):
        resonance_over_settings(case(two_mass()), [0.1])
