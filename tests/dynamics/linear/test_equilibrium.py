"""Rest of a joint against balances solved by hand."""

from __future__ import annotations

import math

import jax
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from varistiff.actuators import Groove, RollerBeam, SliderLeafJoint, SwivellingPair
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.linear import Equilibrium, equilibrium
from varistiff.dynamics.path import Affine, GroovePath
from varistiff.dynamics.plant import Gravity, Member, Plant
from varistiff.dynamics.state import Motion
from varistiff.dynamics.stop import Stop
from varistiff.elastic.leaf import Leaf

from .joints import DRIVE, LINK, SCREW, SPRING_RATE, STIFFNESS, maccepa, moving, two_mass

WEIGHT = 30.0  # m g l [N m]
CLOSE = 1e-9  # the iteration stops at 1e-11 of the forces or 1e-12 rad; forces here are up to 100 N m

angles = st.floats(-1.2, 1.2)
torques = st.floats(-40.0, 40.0)


@settings(max_examples=40, deadline=None)
@given(link=angles, torque=torques)
def test_drive_that_holds_a_pendulum_under_a_load(link: float, torque: float) -> None:
    rest = equilibrium(two_mass(weight=WEIGHT), link=link, external_torque=torque)
    carried = WEIGHT * math.sin(link) + torque
    assert float(rest.motion.drive) == pytest.approx(link + carried / STIFFNESS, abs=CLOSE)
    assert rest.drive_torque == pytest.approx(carried, abs=100 * CLOSE)
    assert rest.residual <= CLOSE


@settings(max_examples=40, deadline=None)
@given(drive=angles, torque=torques)
def test_link_that_hangs_on_a_held_drive(drive: float, torque: float) -> None:
    rest = equilibrium(two_mass(weight=WEIGHT), drive=drive, external_torque=torque)
    # the stiffness exceeds the weight: one root
    link = brentq(lambda q: STIFFNESS * (drive - q) - WEIGHT * math.sin(q) - torque, -3.0, 3.0, xtol=1e-14)
    assert float(rest.motion.link) == pytest.approx(link, abs=CLOSE)
    assert rest.drive_torque == pytest.approx(STIFFNESS * (drive - link), abs=100 * CLOSE)
    assert rest.stability == "stable"


@settings(max_examples=40, deadline=None)
@given(drive_torque=st.floats(-20.0, 20.0), torque=st.floats(-9.0, 9.0))
def test_both_bodies_under_given_torques(drive_torque: float, torque: float) -> None:
    rest = equilibrium(two_mass(weight=WEIGHT), drive_torque=drive_torque, external_torque=torque)
    link = math.asin((drive_torque - torque) / WEIGHT)
    assert float(rest.motion.link) == pytest.approx(link, abs=1e-8)  # near the top of the sine the root is flatter
    assert float(rest.motion.drive) == pytest.approx(link + drive_torque / STIFFNESS, abs=1e-8)
    assert rest.free == ("link", "drive")
    assert rest.stability == "stable"


def test_positions_alone_give_the_torques() -> None:
    rest = equilibrium(two_mass(weight=WEIGHT), link=0.2, drive=0.5)
    assert rest.drive_torque == pytest.approx(0.3 * STIFFNESS, rel=1e-14)
    assert rest.external_torque == pytest.approx(0.3 * STIFFNESS - WEIGHT * math.sin(0.2), rel=1e-14)
    assert rest.free == ()
    assert rest.stability == "stable"


def test_setting_drive_holds_the_spring_through_its_screw() -> None:
    rest = equilibrium(maccepa(), link=0.3, drive=0.3, motion=4.0)
    assert rest.setting_torque == pytest.approx(SPRING_RATE * (0.002 + SCREW * 4.0) * SCREW, rel=1e-12)


def test_setting_found_from_the_force_of_its_drive() -> None:
    rest = equilibrium(maccepa(), guess=moving(motion=1.0), link=0.3, drive=0.3, setting_torque=0.01)
    assert float(rest.motion.motion) == pytest.approx((0.01 / SPRING_RATE / SCREW - 0.002) / SCREW, rel=1e-9)
    assert rest.stability == "stable"  # the spring pulls the screw back: V_PP = k


def test_weight_of_a_shuttle_on_the_link() -> None:
    plant = maccepa(
        gravity=Gravity(WEIGHT, rest=0.1), carried=CarriedMass(mass=0.7, radius=Affine(0.2, 0.05), body="link")
    )
    rest = equilibrium(plant, link=0.4, drive=0.4, motion=4.0)
    spring = SPRING_RATE * (0.002 + SCREW * 4.0) * SCREW
    assert rest.setting_torque == pytest.approx(spring - 0.7 * 9.80665 * 0.05 * math.cos(0.3), rel=1e-12)
    moment = WEIGHT + 0.7 * 9.80665 * (0.2 + 0.05 * 4.0)
    assert rest.external_torque == pytest.approx(-moment * math.sin(0.3), rel=1e-12)


@pytest.mark.parametrize(("share", "stability"), [(0.9, "stable"), (1.1, "unstable")])
def test_inverted_pendulum_falls_when_it_is_heavier_than_stiff(share: float, stability: str) -> None:
    plant = two_mass(weight=share * STIFFNESS)
    rest = equilibrium(plant, guess=moving(link=math.pi), drive=math.pi, external_torque=0.0)
    assert float(rest.motion.link) == pytest.approx(math.pi, abs=1e-9)
    assert rest.hessian[0, 0] == pytest.approx((1.0 - share) * STIFFNESS, rel=1e-9)
    assert rest.stability == stability


def test_a_joint_that_nothing_holds_is_neutral() -> None:
    assert equilibrium(two_mass(), drive_torque=0.0, external_torque=0.0).stability == "neutral"


@pytest.mark.parametrize("torque", [-7.0, 7.0])
def test_a_load_is_found_across_the_play(torque: float) -> None:
    play = 0.04
    rest = equilibrium(two_mass(backlash=play), drive=0.1, guess=moving(link=0.1), external_torque=torque)
    side = math.copysign(0.5 * play, torque)
    assert float(rest.motion.link) == pytest.approx(0.1 - torque / STIFFNESS - side, abs=1e-11)


def test_link_pressed_into_its_stop() -> None:
    stop = Stop(upper=0.2, stiffness=5000.0)
    rest = equilibrium(two_mass(link=Member(LINK, stop=stop)), drive=0.5, external_torque=-12.0)
    # K (q_1 - q) + 12 = k (q - 0.2)
    assert float(rest.motion.link) == pytest.approx((STIFFNESS * 0.5 + 12.0 + 5000.0 * 0.2) / (STIFFNESS + 5000.0))


def test_a_semi_active_joint_has_no_drive() -> None:
    beam = RollerBeam(Leaf(youngs_modulus=194e9, width=0.025, thickness=0.003, length=0.9), SwivellingPair(0.0, 0.0))
    plant = Plant(beam, link=Member(0.4), setting=Member(1.0), driven=False)
    rest = equilibrium(plant, guess=moving(link=0.01, motion=0.4), motion=0.4, external_torque=-2.0)
    # slender beam, small angle: torque 3 E I theta/x, relative error of the order of theta^2
    rigidity = 194e9 * 0.025 * 0.003**3 / 12.0
    assert float(rest.motion.link) == pytest.approx(2.0 * 0.4 / (3.0 * rigidity), rel=1e-3)
    assert rest.setting_torque == pytest.approx(-0.5 * 2.0 * float(rest.motion.link) / 0.4, rel=1e-3)  # dV/dx = -V/x
    assert rest.drive_torque == 0.0
    with pytest.raises(InputError, match=r"drive: this joint has no such coordinate"):
        equilibrium(plant, link=0.1, motion=0.4, drive=0.0)


def test_hessian_is_that_of_the_energies() -> None:
    groove = Groove(
        inner_radius=0.025, outer_radius=0.054, outer_angle=math.radians(47), arc_radius=0.0368, centre="near"
    )
    leaf = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001, length=0.04)
    plant = Plant(
        SliderLeafJoint(leaf=leaf, count=3, clamp_radius=0.025, groove=groove),
        link=Member(LINK),
        drive=Member(DRIVE),
        setting=Member(1e-4),
        setting_path=GroovePath(groove),
        carried=CarriedMass(0.06, GroovePath(groove, start=0.025), "link"),
        gravity=Gravity(WEIGHT),
    )
    at = equilibrium(plant, link=0.3, drive=0.36, motion=0.5)
    forces = {"external_torque": at.external_torque, "drive_torque": at.drive_torque}
    free = equilibrium(plant, guess=at.motion, **forces, setting_torque=at.setting_torque)
    assert float(free.motion.drive) == pytest.approx(0.36, abs=1e-9)

    @jax.jit
    @jax.hessian
    def hessian(positions: jax.Array) -> jax.Array:
        motion = Motion(positions[0], 0.0, positions[1], 0.0, positions[2], 0.0)
        stores = plant.stores(motion, 0.0)
        return stores.elastic + stores.gravity

    expected = np.asarray(hessian(np.array([0.3, 0.36, 0.5])))
    # closed forms against derivatives of the energy, both to about 1e-12 of the largest
    np.testing.assert_allclose(free.hessian, expected, rtol=1e-8, atol=1e-9 * np.abs(expected).max())


def test_no_torque_holds_more_than_the_weight() -> None:
    with pytest.raises(InputError, match=r"no equilibrium of the link and the drive .* stays unbalanced"):
        equilibrium(two_mass(weight=WEIGHT), drive_torque=1.2 * WEIGHT, external_torque=0.0)


def test_no_spring_carries_more_than_its_largest_torque() -> None:
    # the cable's pull is at most k (2 B + P), its lever at most B
    beyond = SPRING_RATE * (2 * 0.036 + 0.02) * 0.036
    with pytest.raises(InputError, match="no equilibrium of the link"):
        equilibrium(maccepa(), drive=0.0, motion=6.0, external_torque=beyond)


def test_a_point_off_the_map_is_refused() -> None:
    beam = RollerBeam(Leaf(youngs_modulus=194e9, width=0.025, thickness=0.003, length=0.9), SwivellingPair(0.0, 0.0))
    with pytest.raises(InputError, match=Status.NO_SOLUTION.label):
        equilibrium(Plant(beam, link=Member(0.4), driven=False), link=0.1, motion=-0.4)


@pytest.mark.parametrize(
    "given",
    [
        {},
        {"link": 0.1},
        {"link": 0.1, "drive": 0.2, "external_torque": 1.0},
        {"drive_torque": 1.0, "drive": 0.1, "link": 0.1},
    ],
)
def test_too_few_or_too_many_numbers(given: dict[str, float]) -> None:
    with pytest.raises(InputError, match="an equilibrium needs 2 of link, drive, external_torque, drive_torque"):
        equilibrium(two_mass(), **given)


def test_numbers_that_do_not_determine_the_rest() -> None:
    # link known and its force too, drive's force unknown: the drive follows; the other way round nothing does
    assert isinstance(equilibrium(two_mass(), link=0.1, external_torque=1.0), Equilibrium)
    with pytest.raises(InputError, match="no equilibrium"):
        equilibrium(two_mass(), drive_torque=2.0, external_torque=1.0)


def test_a_number_that_is_none_is_named() -> None:
    with pytest.raises(InputError, match="link: must be a finite number"):
        equilibrium(two_mass(), link=math.nan, external_torque=0.0)
