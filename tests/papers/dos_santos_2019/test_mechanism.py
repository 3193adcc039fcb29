"""Sections 2 and 3: with its clamp at the joint the mechanism has one length, x_r, and its laws are powers of it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from varistiff.papers.dos_santos_2019 import drive, mechanism


def test_one_length_makes_powers():
    # V, M and stiffness go with E I/x_r at one joint angle
    assert mechanism.stiffness_falls() == pytest.approx(1.0 - 0.71 / 0.75)
    assert mechanism.moment_falls() == pytest.approx(1.0 - 0.71 / 0.75)
    assert mechanism.release_by_thrust() == pytest.approx(1.0 - 0.43 / 0.75, rel=1e-10)  # 12 Gauss points on 1/x^2
    assert mechanism.adjusting_work_share() == pytest.approx(0.1 - (1.0 - 0.43 / 0.75))


def test_thrust_at_small_angles_is_half_the_angle():
    # the beam leans 3/2 of the joint angle at the contact, the thrust is the half that is left over
    assert mechanism.backdriven() == pytest.approx(0.5 * np.radians(2.0), rel=1e-3)  # corrections are quadratic


def test_idle_roller_keeps_twice_the_play():
    assert mechanism.one_roller_at_a_time() == pytest.approx(2e-4, rel=1e-6)


def test_a_roller_that_overlaps_is_seen(monkeypatch):
    # with the contact a clearance above the pivot, and not below, the idle roller touches
    whole = mechanism.joint
    monkeypatch.setattr(mechanism, "joint", lambda *, clearance: whole(clearance=-clearance))
    assert mechanism.one_roller_at_a_time() < 1e-9  # 0 without the rounding of a drawn line


def test_beam_stands_out_by_its_tail():
    line = mechanism.joint().element_shapes(math.radians(18.0), 0.43)[0]
    tail = mechanism.leaf("spring_steel").length - 0.43
    # it leaves link 2 at half the joint angle; corrections are quadratic in 0.3, and the arc is longer than x_r
    assert mechanism.beam_beside_link() + 0.05 == pytest.approx(tail * math.sin(math.radians(9.0)), rel=0.05)
    assert np.hypot(*np.diff(line, axis=0).T).sum() == pytest.approx(tail + 0.43, rel=1e-6)  # chords of a polyline


def test_printed_frames_are_the_devices():
    for geometry in mechanism.GEOMETRIES:
        mounting, d_1, d_0, d_r, _, x_r, theta_j = geometry

        def turn(angle: float) -> np.ndarray:
            return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])

        slope = 0.3
        zeta = mounting + theta_j - slope
        radius = geometry[4] + 0.5 * 3.16e-3
        on_roller = radius * np.array([np.sin(zeta), np.cos(zeta)])
        wanted = turn(mounting) @ (np.array([-d_1, -d_0]) + turn(theta_j) @ (np.array([x_r, d_r]) + on_roller))
        assert mechanism.printed_contact(geometry, slope) == pytest.approx(wanted)


def test_yield_of_a_short_rotation_is_linear():
    # root curvature 3 phi/x_r: 235 MPa, E = 169.2 GPa, h = 4.69 mm
    wanted = 235e6 / (0.5 * 169.2e9 * 4.69e-3) * 0.43 / 3.0
    assert mechanism.rotation_at_yield("low_carbon_steel", setting=0.43) == pytest.approx(wanted, rel=0.01)  # 5 deg


def test_a_turned_sign_of_the_device_is_seen(monkeypatch):
    whole = mechanism.evaluate
    for name, seen in (
        ("stiffness", (mechanism.moment_and_thrust,)),
        ("load", (mechanism.moment_balance, mechanism.moment_and_thrust, mechanism.stored_energy_returns)),
        ("adjusting_load", (mechanism.moment_and_thrust, mechanism.stored_energy_returns, mechanism.release_by_thrust)),
    ):

        def turned(*arguments, name=name):
            points = whole(*arguments)
            return replace(points, **{name: -getattr(points, name)})

        monkeypatch.setattr(mechanism, "evaluate", turned)
        assert all(margin() < 0.0 for margin in seen)


def test_drive_changes_sign_where_the_law_says():
    # dE/dt = tau w - R tau^2/a^2 with R = a = tau = 1
    assert drive.negative_work_returned() == (0.5 - 1.0, 2.0 - 1.0)
    assert drive.power_of_holding() == -1.0
    assert drive.joule_loss() == 1.0
    assert drive.damping_by_control() == pytest.approx(0.99 - 0.99**2)
