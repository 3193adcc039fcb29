"""Joints that the tests of motion share."""

from __future__ import annotations

import math

from varistiff.actuators import RollerBeam, SeriesElastic, SliderLeafJoint, SwivellingPair
from varistiff.actuators.leaf_joint_theory import LargeDeflection, SmallDeflection
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.control.pid import Pid
from varistiff.dynamics.control.position_pid import PositionPid
from varistiff.dynamics.control.setting_hold import SettingHold
from varistiff.dynamics.control_loop import Channel, ControlLoop, Inputs
from varistiff.dynamics.drives import Motor, TorqueSource
from varistiff.dynamics.friction import DryFriction, Friction
from varistiff.dynamics.path import Affine
from varistiff.dynamics.plant import Gravity, Member, Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.signals import Constant, Sine
from varistiff.dynamics.state import Motion
from varistiff.dynamics.stop import Stop
from varistiff.dynamics.storage import Supercapacitor
from varistiff.elastic.leaf import Leaf

REST = Motion(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
LEAF = Leaf(youngs_modulus=206e9, width=0.025, thickness=1e-3, yield_strength=1.4e9)
BEAM = Leaf(youngs_modulus=194e9, width=25.45e-3, thickness=3.16e-3, length=0.9, yield_strength=500e6)


def two_masses(*, stiffness: float = 160.0, link: float = 0.2, drive: float = 0.5) -> Case:
    """Two inertias and a spring, nothing else, the link turned by 0.1 rad at the start."""
    plant = Plant(SeriesElastic(stiffness), link=Member(link), drive=Member(drive))
    return Case(plant, ControlLoop(), Inputs(), REST._replace(link=0.1), 1e-3)


def leaf_joint(*, exact: bool = False, gain: float = 1.0) -> Case:
    """The slider leaf joint under a position PID and an open setting drive, smooth."""
    theory = LargeDeflection() if exact else SmallDeflection()
    actuator = SliderLeafJoint(leaf=LEAF, count=1, clamp_radius=0.025, theory=theory)
    plant = Plant(
        actuator,
        link=Member(0.05, Friction(0.4)),
        drive=Member(0.1, Friction(0.5)),
        setting=Member(0.02, Friction(0.1)),
        setting_path=Affine(0.025, 0.01),
        carried=CarriedMass(0.2, Affine(0.050, 0.01), "drive"),
        drive_motor=TorqueSource(limit=30.0),
    )
    pid = Pid(25.0 * gain, 10.0, 2.0, filter_time=0.005, limit=30.0)
    loop = ControlLoop(drive=Channel(PositionPid(pid, "drive")))
    return Case(plant, loop, Inputs(position=Sine(0.0, 0.1, 1.0)), REST, 1e-3)


def knee() -> Case:
    """A semi-active roller beam that swings with its shuttle, with gravity, motor, storage and every smooth loss."""
    actuator = RollerBeam(beam=BEAM, rollers=SwivellingPair(offset=0.0, clearance=0.0))
    plant = Plant(
        actuator,
        link=Member(0.4, Friction(0.3)),
        setting=Member(0.02, Friction(0.5)),
        setting_path=Affine(0.35, 0.02),
        carried=CarriedMass(0.8, Affine(0.35, 0.02), "link"),
        setting_motor=Motor(
            torque_constant=0.03, resistance=0.3, rotor_inertia=1.4e-5, gear_ratio=20.0, gear_efficiency=0.85
        ),
        storage=Supercapacitor(
            capacitance=20.0, voltage=24.0, series_resistance=0.05, leakage_resistance=2e3, converter_efficiency=0.9
        ),
        gravity=Gravity(moment=6.0),
        driven=False,
    )
    loop = ControlLoop(setting=Channel(SettingHold(Pid(0.8, 0.0, 0.08, filter_time=0.01), motion=1.5)))
    return Case(plant, loop, Inputs(load=Sine(0.0, 8.0, 0.7)), REST._replace(link=0.15), 1e-3)


def wall() -> Case:
    """A series elastic joint pulled against a wall, its motor holding, with backlash and dry friction."""
    plant = Plant(
        SeriesElastic(160.0),
        link=Member(0.05, Friction(0.05), Stop(lower=-math.inf, upper=0.3, stiffness=2e4, damping=0.4)),
        drive=Member(0.1, Friction(0.2, DryFriction(coulomb=0.5, breakaway=0.8, smoothing_rate=0.05))),
        drive_motor=Motor(
            torque_constant=0.03, resistance=0.3, rotor_inertia=1.4e-5, gear_ratio=30.0, viscous_friction=1e-4
        ),
        backlash=0.01,
    )
    loop = ControlLoop(drive=Channel(PositionPid(Pid(20.0, 0.0, 1.0, filter_time=0.005), "drive")))
    return Case(plant, loop, Inputs(load=Constant(-9.0)), REST, 1e-3)
