"""Where a case rests at the start, by who gives way."""

from __future__ import annotations

import dataclasses

import pytest

from varistiff.dynamics.control_loop import Inputs
from varistiff.dynamics.linear import rest
from varistiff.dynamics.plant import Member
from varistiff.dynamics.signals import Constant, Step

from .joints import DRIVE, LINK, SCREW, STIFFNESS, case, maccepa, maccepa_stiffness, moving, two_mass

LOAD = 4.0  # N m


def test_the_drive_takes_the_load_where_it_is_free() -> None:
    at = rest(case(two_mass(), moving(link=0.2, drive=0.7, rates=(3.0, -2.0, 0.0)), load=LOAD))
    assert float(at.motion.link) == 0.2
    assert float(at.motion.drive) == pytest.approx(0.2 + LOAD / STIFFNESS, abs=1e-12)
    assert at.drive_torque == pytest.approx(LOAD, rel=1e-9)
    assert float(at.motion.link_rate) == float(at.motion.drive_rate) == 0.0


def test_the_link_gives_way_to_a_locked_drive() -> None:
    at = rest(case(two_mass(drive=Member(DRIVE, mode="locked")), moving(link=0.2, drive=0.7), load=LOAD))
    assert float(at.motion.drive) == 0.7
    assert float(at.motion.link) == pytest.approx(0.7 - LOAD / STIFFNESS, abs=1e-12)


def test_a_prescribed_link_is_where_its_signal_begins() -> None:
    joint = case(two_mass(link=Member(LINK, mode="prescribed")), moving(link=9.0, drive=0.4))
    at = rest(dataclasses.replace(joint, inputs=Inputs(link=Constant(0.3))))
    assert float(at.motion.link) == 0.3
    assert at.external_torque == pytest.approx(0.1 * STIFFNESS, rel=1e-12)  # what holds the link there


def test_a_load_that_comes_later_does_not_count() -> None:
    joint = dataclasses.replace(case(two_mass(), moving(link=0.2)), inputs=Inputs(load=Step(0.5, 0.0, LOAD)))
    assert float(rest(joint).motion.drive) == pytest.approx(0.2, abs=1e-12)


def test_another_setting_than_that_of_the_start() -> None:
    joint = case(maccepa(), moving(motion=1.0), load=1e-3)
    stiffness = maccepa_stiffness(0.002 + SCREW * 5.0)
    at = rest(joint, motion=5.0)
    assert float(at.motion.motion) == 5.0
    assert float(at.motion.drive) == pytest.approx(1e-3 / stiffness, rel=1e-4)  # small deflection: cubic terms
    assert float(rest(joint).motion.drive) > 2.0 * float(at.motion.drive)
