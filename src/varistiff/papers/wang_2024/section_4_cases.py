"""The joint of Wang et al. (2024) in the simulations of their Section 4.

Printed are the equations of motion (17), a PID on each drive (Fig. 15), the stiffness of 200 N m/rad, and the sines.
Inertias, friction, gains, limits, the load and the strokes are not: the constants below are what a joint of 4 kg and
140 mm could have, the two sets hold what ``section_4_search`` finds.
"""

from __future__ import annotations

from typing import NamedTuple

import jax
import jax.numpy as jnp

from varistiff.actuators import SliderLeafJoint
from varistiff.actuators.groove import Groove
from varistiff.actuators.leaf_joint_theory import LeafJointTheory, SmallDeflection
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.control import (
    Pid,
    PositionPid,
    StiffnessChain,
    StiffnessPid,
    active_length_from_stiffness,
    wang_chain,
)
from varistiff.dynamics.control_loop import Channel, ControlLoop, Inputs
from varistiff.dynamics.drives import TorqueSource
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.path import GroovePath
from varistiff.dynamics.plant import Member, Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.signals import Constant, Sine, Step, Sum
from varistiff.dynamics.state import Motion
from varistiff.elastic.leaf import Leaf
from varistiff.papers.wang_2024 import paper_values as paper

STIFFNESS = paper.TEST_STIFFNESS
AMPLITUDE = paper.POSITION_AMPLITUDE
SWING = paper.STIFFNESS_AMPLITUDE
FREQUENCY = paper.FREQUENCY
CLAMP_RADIUS = paper.CLAMP_RADIUS
LENGTH_MIN, LENGTH_MAX = paper.LENGTH_MIN, paper.LENGTH_MAX

# assumed
PERIOD = 1e-3  # s, of control
STEP_TIME = 0.1  # s
FILTER_TIME = 5e-3  # s, of the derivatives
LINK = 0.004  # kg m^2: output disc, leaf seats and a light link
LINK_FRICTION, DISC_FRICTION = 0.01, 0.01  # N m s/rad
DISC = 7.5e-4  # kg m^2: stiffness disc, and a rotor of 10.8 g cm^2 behind a reducer of 24
DISC_LIMIT = 0.6  # N m, what that motor bears continuously
SLIDERS = 0.06  # kg
ARC_RADIUS = 0.0368  # m: the groove closest to the straight line of Eq. (16)
CENTRE = 450.0  # N m/rad: a swing of 200 has to stay above the 206 N m/rad of 25 mm
USED_MAX = 0.0255  # m: 200 N m/rad lie at 25.37 mm


class PositionSet(NamedTuple):
    """What the position tests need beside the constants, in SI units.

    Parameters
    ----------
    load_inertia, load_torque : the load [kg m^2], [N m]; the torque acts on the link throughout a run
    drive_inertia, drive_friction : of the input side, with the rotor behind its gear [kg m^2], [N m s/rad]
    proportional, integral, derivative : gains from the link's position to the drive's torque [N m/rad], ...
    limit : of the drive's torque [N m]
    small, large : strokes of the two steps [rad]
    """

    load_inertia: float
    drive_inertia: float
    drive_friction: float
    proportional: float
    integral: float
    derivative: float
    limit: float
    small: float
    large: float
    load_torque: float = 0.0


class SettingSet(NamedTuple):
    """What the stiffness tests need beside the constants and the loop of a ``PositionSet``, in SI units.

    Parameters
    ----------
    proportional, integral, derivative : gains from the disc's angle to its torque [N m/rad], ...
    load_inertia, load_torque : the load of these tests [kg m^2], [N m]
    """

    proportional: float
    integral: float
    derivative: float
    load_inertia: float
    load_torque: float


def joint(theory: LeafJointTheory | None = None) -> SliderLeafJoint:
    """Joint of Table 2 (b = 25 mm, h = 1 mm, N = 1), its groove with the radius that is closest to Eq. (16).

    Parameters
    ----------
    theory : of the leaf, where it is not the paper's
    """
    return SliderLeafJoint(
        leaf=Leaf(youngs_modulus=paper.YOUNGS_MODULUS, width=paper.WIDTH, thickness=paper.THICKNESS),
        count=paper.COUNT,
        clamp_radius=CLAMP_RADIUS,
        theory=SmallDeflection() if theory is None else theory,
        groove=groove(),
    )


def groove() -> Groove:
    """Groove of Table 2; its arc radius is not published."""
    return Groove(
        inner_radius=CLAMP_RADIUS, outer_radius=paper.OUTER_RADIUS, outer_angle=paper.OUTER_ANGLE, arc_radius=ARC_RADIUS
    )


def length_of(stiffness: float) -> float:
    """Active length [m] at which the joint has a stiffness [N m/rad] at rest, by Eq. (9)."""
    bending = 3.0 * joint().leaf.flexural_rigidity
    with jax.ensure_compile_time_eval():  # a number, wherever a compiled search asks for it
        return float(active_length_from_stiffness(stiffness, bending=bending, clamp_radius=CLAMP_RADIUS))


def stiffness_at(length: float) -> float:
    """Stiffness at rest [N m/rad] at an active length [m], by Eq. (9)."""
    with jax.ensure_compile_time_eval():
        return float(joint().respond(jnp.asarray(0.0), jnp.asarray(length))[0].stiffness)


def angle_of(length: float) -> float:
    """Disc angle [rad] at an active length [m]."""
    with jax.ensure_compile_time_eval():
        return float(groove().angle(jnp.asarray(length)))


def published_chain() -> StiffnessChain:
    """Eq. (9), then the straight line of Eq. (16) fitted to the whole range."""
    with jax.ensure_compile_time_eval():
        return wang_chain(joint(), setting_min=LENGTH_MIN, setting_max=USED_MAX)


def position_case(own: PositionSet, *, loaded: float, step: float = 0.0, sine: float = 0.0) -> Case:
    """Position test at 200 N m/rad with the disc held.

    Parameters
    ----------
    loaded : 1 with the load, 0 without
    step, sine : height of the step and amplitude of the sine that are wanted [rad]
    """
    start = Motion(*[jnp.asarray(0.0)] * 6)._replace(motion=jnp.asarray(angle_of(length_of(STIFFNESS))))
    plant = Plant(
        joint(),
        link=Member(LINK + loaded * own.load_inertia, Friction(LINK_FRICTION)),
        drive=Member(own.drive_inertia, Friction(own.drive_friction)),
        setting_path=GroovePath(groove()),
        drive_motor=TorqueSource(limit=own.limit),
    )
    inputs = Inputs(position=_position(step, sine), load=Constant(loaded * own.load_torque))
    return Case(plant, ControlLoop(drive=_position_loop(own)), inputs, start, PERIOD)


def stiffness_case(
    own: PositionSet,
    setting: SettingSet,
    *,
    loaded: float,
    sine: float,
    theory: LeafJointTheory | None = None,
    chain: StiffnessChain | None = None,
) -> Case:
    """Stiffness test, while the position does its large step or its sine.

    Parameters
    ----------
    own : of the position loop; its load is not used
    setting : of the stiffness loop, and the load
    loaded : 1 with the load, 0 without
    sine : 1 for 450 + 200 sin N m/rad with the sine of the position, 0 for a step from 25 to 6 mm with its large step
    theory : of the plant's leaf, where it is not the paper's
    chain : of the controller, where it is not the paper's
    """
    plant = Plant(
        joint(theory),
        link=Member(LINK + loaded * setting.load_inertia, Friction(LINK_FRICTION)),
        drive=Member(own.drive_inertia, Friction(own.drive_friction)),
        setting=Member(DISC, Friction(DISC_FRICTION)),
        setting_path=GroovePath(groove()),
        carried=CarriedMass(SLIDERS, GroovePath(groove(), CLAMP_RADIUS), "drive"),
        drive_motor=TorqueSource(limit=own.limit),
        setting_motor=TorqueSource(limit=DISC_LIMIT),
    )
    pid = Pid(*setting[:3], filter_time=FILTER_TIME, limit=DISC_LIMIT, derivative_on="error")
    controller = StiffnessPid(pid, published_chain() if chain is None else chain)
    step = 1.0 - sine  # numbers, so that one compiled function serves both
    levels = (sine * CENTRE + step * stiffness_at(length) for length in (LENGTH_MAX, LENGTH_MIN))
    inputs = Inputs(
        position=_position(step * own.large, sine * AMPLITUDE),
        stiffness=Sum((Step(STEP_TIME, *levels), Sine(0.0, sine * SWING, FREQUENCY))),
        load=Constant(loaded * setting.load_torque),
    )
    angle = sine * angle_of(length_of(CENTRE)) + step * angle_of(LENGTH_MAX)
    start = Motion(*[jnp.asarray(0.0)] * 6)._replace(motion=jnp.asarray(angle))
    return Case(plant, ControlLoop(_position_loop(own), Channel(controller)), inputs, start, PERIOD)


def _position(step: float, sine: float) -> Sum:
    return Sum((Step(STEP_TIME, 0.0, step), Sine(0.0, sine, FREQUENCY)))


def _position_loop(own: PositionSet) -> Channel:
    pid = Pid(
        own.proportional,
        own.integral,
        own.derivative,
        filter_time=FILTER_TIME,
        limit=own.limit,
        derivative_on="error",
    )
    return Channel(PositionPid(pid))
