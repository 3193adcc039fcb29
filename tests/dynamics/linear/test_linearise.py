"""The linear plant against frequencies, damping ratios and transfers in closed form."""

from __future__ import annotations

import dataclasses
import math

import control
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.linalg import eigh

from varistiff.actuators import Groove, RollerBeam, SliderLeafJoint, SwivellingPair
from varistiff.core.errors import InputError
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.drives import Motor, TorqueSource
from varistiff.dynamics.equations import rates
from varistiff.dynamics.friction import DryFriction, Friction
from varistiff.dynamics.linear import antiresonances, equilibrium, frequency_response, linearise, modes
from varistiff.dynamics.linear.state_at import numbers_of, pushed, state_at
from varistiff.dynamics.path import Affine, GroovePath
from varistiff.dynamics.plant import Gravity, Member, Plant
from varistiff.dynamics.state import Command, Motion
from varistiff.elastic.leaf import Leaf

from .joints import DRIVE, LINK, STIFFNESS, maccepa, maccepa_stiffness, moving, two_mass

EXACT = 1e-12  # derivatives are exact; what is left is the eigenvalue solver's rounding


def two_mass_frequency(stiffness: float, link: float, drive: float) -> float:
    return math.sqrt(stiffness * (1.0 / link + 1.0 / drive))


def test_two_masses_swing_against_each_other_and_turn_together() -> None:
    plant = two_mass()
    found = modes(linearise(plant, equilibrium(plant, link=0.0, external_torque=0.0)))
    assert [mode.natural_frequency for mode in found[:2]] == [0.0, 0.0]
    assert all(math.isnan(mode.damping_ratio) for mode in found[:2])
    assert found[2].natural_frequency == pytest.approx(two_mass_frequency(STIFFNESS, LINK, DRIVE), rel=EXACT)
    assert found[2].frequency == pytest.approx(found[2].natural_frequency / (2.0 * math.pi), rel=1e-15)
    assert found[2].damping_ratio == pytest.approx(0.0, abs=EXACT)


def test_the_rotor_counts_with_the_square_of_its_gear() -> None:
    motor = Motor(torque_constant=0.03, resistance=0.3, rotor_inertia=1.4e-6, gear_ratio=100.0, gear_inertia=6e-7)
    plant = two_mass(drive_motor=motor)
    found = modes(linearise(plant, equilibrium(plant, link=0.0, external_torque=0.0)))
    drive = DRIVE + 100.0**2 * 2.0e-6
    assert found[-1].natural_frequency == pytest.approx(two_mass_frequency(STIFFNESS, LINK, drive), rel=EXACT)


def test_a_link_on_a_held_drive_swings_at_the_antiresonance() -> None:
    plant = two_mass()
    at = equilibrium(plant, link=0.0, external_torque=0.0)
    expected = math.sqrt(STIFFNESS / LINK)
    held = modes(linearise(plant, at, hold=("drive",)))
    assert [mode.natural_frequency for mode in held] == [pytest.approx(expected, rel=EXACT)]
    zeros = antiresonances(linearise(plant, at), "drive_command", "drive")
    assert [mode.natural_frequency for mode in zeros] == [pytest.approx(expected, rel=1e-9)]  # generalised eigenvalues
    assert antiresonances(linearise(plant, at), "drive_command", "link") == ()


@pytest.mark.parametrize("damping", [0.4, 3.2, 12.0])
def test_damping_ratio(damping: float) -> None:
    plant = two_mass(link_damping=damping)
    found = modes(linearise(plant, equilibrium(plant, drive=0.0, external_torque=0.0), hold=("drive",)))
    ratio = damping / (2.0 * math.sqrt(STIFFNESS * LINK))
    if ratio < 1.0:
        assert found[0].damping_ratio == pytest.approx(ratio, rel=EXACT)
        assert found[0].natural_frequency == pytest.approx(math.sqrt(STIFFNESS / LINK), rel=EXACT)
    else:
        root = math.sqrt(ratio**2 - 1.0)
        rates = [math.sqrt(STIFFNESS / LINK) * (ratio - root), math.sqrt(STIFFNESS / LINK) * (ratio + root)]
        assert [-mode.root.real for mode in found] == [pytest.approx(rate, rel=1e-10) for rate in rates]
        assert not any(mode.oscillates for mode in found)


@pytest.mark.parametrize("lean", [0.0, 0.7, math.pi])
def test_pendulum_with_a_spring(lean: float) -> None:
    weight = 30.0
    plant = two_mass(weight=weight)
    at = equilibrium(plant, link=lean, external_torque=0.0)
    found = modes(linearise(plant, at, hold=("drive",)))
    expected = math.sqrt((STIFFNESS + weight * math.cos(lean)) / LINK)
    assert found[0].natural_frequency == pytest.approx(expected, rel=1e-10)


def test_an_inverted_pendulum_that_is_too_heavy_falls() -> None:
    plant = two_mass(weight=2.0 * STIFFNESS)
    at = equilibrium(plant, guess=moving(link=math.pi), drive=math.pi, external_torque=0.0)
    found = modes(linearise(plant, at, hold=("drive",)))
    growth = math.sqrt(STIFFNESS / LINK)
    assert sorted(mode.root.real for mode in found) == [pytest.approx(-growth), pytest.approx(growth)]
    assert max(found, key=lambda mode: mode.root.real).damping_ratio == -1.0


RIGIDITY = 194e9 * 0.025 * 0.003**3 / 12.0
SHUTTLE, SHANK, PLACE = 0.7, 0.4, 0.3  # kg, kg m^2, m


def knee(weight: float, gravity: float) -> Plant:
    beam = Leaf(youngs_modulus=194e9, width=0.025, thickness=0.003, length=0.9)
    return Plant(
        RollerBeam(beam, SwivellingPair(0.0, 0.0)),
        link=Member(SHANK),
        setting=Member(0.05),
        carried=CarriedMass(SHUTTLE, Affine(), "link"),
        gravity=Gravity(weight, acceleration=gravity),
        driven=False,
    )


def test_a_shuttle_on_the_link_slows_it() -> None:
    plant = knee(0.0, 0.0)
    at = equilibrium(plant, guess=moving(link=1e-3), motion=PLACE, external_torque=-1e-3 * 3.0 * RIGIDITY / PLACE)
    found = modes(linearise(plant, at, hold=("motion",)))
    # slender cantilever under a small angle theta: torque 3 E I theta/x, wrong by theta^2 = 1e-6 of it
    expected = math.sqrt(3.0 * RIGIDITY / PLACE / (SHANK + SHUTTLE * PLACE**2))
    assert found[0].natural_frequency == pytest.approx(expected, rel=1e-5)


def test_a_shuttle_that_is_free_swings_with_the_link() -> None:
    plant, angle = knee(20.0, 9.8), 2e-3
    at = equilibrium(plant, link=angle, motion=PLACE)
    found = modes(linearise(plant, at))
    # V = 3 E I theta^2/(2 x) - (20 + m g x) cos theta, at rest without gyroscopic terms
    weight = SHUTTLE * 9.8
    stiffness = np.array(
        [
            [3.0 * RIGIDITY / PLACE + 20.0 + weight * PLACE, -3.0 * RIGIDITY * angle / PLACE**2 + weight * angle],
            [0.0, 3.0 * RIGIDITY * angle**2 / PLACE**3],
        ]
    )
    stiffness[1, 0] = stiffness[0, 1]
    squares = eigh(stiffness, np.diag([SHANK + SHUTTLE * PLACE**2, 0.05 + SHUTTLE]), eigvals_only=True)
    slow, fast = np.sqrt(squares)
    found = [mode for mode in found if mode.root != 0.0]
    assert [mode.natural_frequency for mode in found] == [
        pytest.approx(slow, rel=1e-3),  # a small difference of terms that are right to theta^2
        pytest.approx(fast, rel=1e-5),
    ]


def test_static_gains() -> None:
    plant = two_mass(weight=30.0)
    at = equilibrium(plant, link=0.0, external_torque=0.0)
    system = linearise(plant, at)
    gains = -system.C @ np.linalg.solve(system.A, system.B)
    told = {
        (row, column): gains[i, j]
        for i, row in enumerate(system.output_labels)
        for j, column in enumerate(system.input_labels)
    }
    # the weight holds the link: u = m g l q + tau_ext, and u = K (q_1 - q)
    assert told["link", "drive_command"] == pytest.approx(1.0 / 30.0)
    assert told["link", "external_torque"] == pytest.approx(-1.0 / 30.0)
    assert told["drive", "drive_command"] == pytest.approx(1.0 / 30.0 + 1.0 / STIFFNESS)
    assert told["deflection", "drive_command"] == pytest.approx(1.0 / STIFFNESS)
    assert told["load", "drive_command"] == pytest.approx(1.0)
    assert told["load", "external_torque"] == pytest.approx(0.0, abs=1e-12)


def test_names_follow_what_is_free() -> None:
    plant = maccepa()
    at = equilibrium(plant, link=0.0, external_torque=0.0, motion=2.0)
    system = linearise(plant, at)
    assert system.state_labels == ["link", "link_rate", "drive", "drive_rate", "motion", "motion_rate"]
    assert system.input_labels == ["drive_command", "setting_command", "external_torque"]
    assert system.output_labels == ["link", "drive", "motion", "deflection", "load"]
    locked = dataclasses.replace(plant, link=Member(LINK, mode="locked"))
    held = linearise(locked, at, hold=("motion",))
    assert held.state_labels == ["drive", "drive_rate"]
    assert held.input_labels == ["drive_command"]
    with pytest.raises(InputError, match="nothing is free"):
        linearise(locked, at, hold=("motion", "drive"))


def test_dry_friction_counts_where_it_is_asked_for() -> None:
    rub = DryFriction(coulomb=1.5, breakaway=2.0, smoothing_rate=0.02)
    plant = two_mass(drive=Member(DRIVE, Friction(0.3, rub)))
    at = equilibrium(plant, link=0.0, external_torque=0.0)
    sliding, sticking = linearise(plant, at), linearise(plant, at, dry_friction=True)
    assert sliding.A[3, 3] == pytest.approx(-0.3 / DRIVE, rel=EXACT)
    assert sticking.A[3, 3] == pytest.approx(-(0.3 + 2.0 / 0.02) / DRIVE, rel=EXACT)


def test_a_torque_beyond_the_drive_is_refused() -> None:
    plant = two_mass(drive_motor=TorqueSource(limit=5.0))
    with pytest.raises(InputError, match=r"drive_motor: .* needs 8 .* limit 5"):
        linearise(plant, equilibrium(plant, link=0.0, external_torque=8.0))


def test_derivatives_are_those_of_the_equations() -> None:
    """Central differences of the rates, at a deflected rest of a joint in which everything couples."""
    groove = Groove(
        inner_radius=0.025, outer_radius=0.054, outer_angle=math.radians(47), arc_radius=0.0368, centre="near"
    )
    leaf = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001, length=0.04)
    plant = Plant(
        SliderLeafJoint(leaf=leaf, count=3, clamp_radius=0.025, groove=groove),
        link=Member(LINK, Friction(0.2)),
        drive=Member(DRIVE, Friction(0.1)),
        setting=Member(1e-3, Friction(0.01)),
        setting_path=GroovePath(groove),
        carried=CarriedMass(0.06, GroovePath(groove, start=0.025), "drive"),
        gravity=Gravity(12.0),
    )
    at = equilibrium(plant, link=0.3, drive=0.37, motion=0.5)
    system = linearise(plant, at)
    commands = np.array([at.drive_torque, at.setting_torque, at.external_torque])

    @jax.jit
    def slopes(values: jax.Array) -> jax.Array:
        state = state_at(plant, Motion(*values[:6]))
        return jnp.stack(rates(plant, state, Command(values[6], values[7]), pushed(values[8])).motion)

    point = np.concatenate([numbers_of(at.motion), commands])
    assert np.abs(slopes(point)).max() < 1e-7  # nothing moves at rest; accelerations here are up to 1e4
    step = 1e-6
    expected = np.array([(slopes(point + e) - slopes(point - e)) / (2.0 * step) for e in step * np.eye(9)]).T
    # differences of second order: step^2 of the third derivatives, and rounding over the step
    size = np.abs(expected).max()
    np.testing.assert_allclose(system.A, expected[:, :6], rtol=1e-5, atol=1e-9 * size)
    np.testing.assert_allclose(system.B, expected[:, 6:], rtol=1e-5, atol=1e-9 * size)


def test_frequency_response_of_two_damped_masses() -> None:
    d, d_1 = 0.8, 0.5
    plant = two_mass(link_damping=d, drive_damping=d_1)
    system = linearise(plant, equilibrium(plant, link=0.0, external_torque=0.0))
    f = np.geomspace(0.3, 60.0, 200)
    s = 2.0j * np.pi * f
    link, drive = LINK * s**2 + d * s, DRIVE * s**2 + d_1 * s
    common = link * drive + STIFFNESS * (link + drive)
    for output, expected in (("drive", (link + STIFFNESS) / common), ("link", STIFFNESS / common)):
        found = frequency_response(system, "drive_command", output, f, units="rad/(N*m)")
        np.testing.assert_allclose(found.magnitude, np.abs(expected), rtol=1e-9)
        np.testing.assert_allclose(np.exp(1j * found.phase), expected / np.abs(expected), rtol=0.0, atol=1e-9)
        assert np.abs(np.diff(found.phase)).max() < 1.0
        assert found.frequency.attrs["units"] == "Hz"
        assert found.magnitude.attrs["units"] == "rad/(N*m)"
    assert float(found.phase[-1]) < -1.4 * np.pi  # the link falls behind by up to one and a half turns, unwrapped


@pytest.mark.parametrize("frequencies", [[0.0, 1.0], [2.0, 1.0], [1.0, math.inf]])
def test_frequencies_out_of_order(frequencies: list[float]) -> None:
    plant = two_mass()
    system = linearise(plant, equilibrium(plant, link=0.0, external_torque=0.0))
    with pytest.raises(InputError, match="frequencies: must be finite, above 0 and rising"):
        frequency_response(system, "drive_command", "link", frequencies)
    with pytest.raises(InputError, match="output: must be one of link, drive, deflection, load, not 'lnk'"):
        frequency_response(system, "drive_command", "lnk", [1.0])


def test_the_setting_drive_winds_the_spring() -> None:
    plant = maccepa(setting=Member(2e-4, Friction(1e-4)))
    at = equilibrium(plant, link=0.0, external_torque=0.0, motion=2.0)
    # at rest nothing couples: V_dP = 0; the screw feels the spring as k r^2
    wound = linearise(plant, at, hold=("link", "drive"))
    screw, spring = 0.003, 394.0
    (mode,) = modes(wound)
    assert mode.natural_frequency == pytest.approx(math.sqrt(spring * screw**2 / 2e-4), rel=1e-10)
    assert mode.damping_ratio == pytest.approx(1e-4 / (2.0 * math.sqrt(spring * screw**2 * 2e-4)), rel=1e-10)
    both = linearise(plant, at, hold=("motion",))
    expected = two_mass_frequency(maccepa_stiffness(0.002 + screw * 2.0), LINK, DRIVE)
    assert modes(both)[-1].natural_frequency == pytest.approx(expected, rel=1e-10)
    assert isinstance(both, control.StateSpace)
