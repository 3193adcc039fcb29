"""From the control of a scenario file to encoders and controllers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.design.build_scenario_signals import Place, build_signal
from varistiff.design.scenario_control_spec import (
    AnyDriveControlSpec,
    AnySettingControlSpec,
    ControlSpec,
    DecouplingSpec,
    EncoderSpec,
    ImpedanceSpec,
    LqrSpec,
    PositionPidSpec,
    ServoSpec,
    SettingHoldSpec,
    SettingScheduleSpec,
    StiffnessPidSpec,
    TorqueLoopSpec,
)
from varistiff.design.scenario_fields import ROTARY, Amount, Measures
from varistiff.design.scenario_joint import Joint, si, within
from varistiff.dynamics.control import (
    Controller,
    Encoder,
    GravityTorque,
    ImpedanceControl,
    LinkModel,
    LqrWeights,
    MapChain,
    Pid,
    PositionPid,
    SensedSpring,
    SettingHold,
    StiffnessChain,
    StiffnessDecoupling,
    StiffnessPid,
    TorqueControl,
    TwoMass,
    exact_chain,
    motion_of_setting,
    rotary_encoder,
    scheduled_lqr,
    setting_inverse,
    virtual_spring_damper,
    wang_chain,
)
from varistiff.dynamics.control.setting_schedule import SettingSchedule
from varistiff.dynamics.control_loop import Channel, ControlLoop
from varistiff.dynamics.path import Affine, GroovePath
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.state import Motion

WHOLE = 1e-6  # of a period: what counts as a whole number of them


@dataclass(frozen=True, slots=True)
class Built:
    """What controllers are built from.

    Parameters
    ----------
    joint, plant : what they control
    setting : what the setting drive's own coordinate measures; None for a kind without a setting
    motion : the start
    period : of the loop [s]
    directory : that the files of trajectories are relative to
    """

    joint: Joint
    plant: Plant
    setting: Measures | None
    motion: Motion
    period: float
    directory: Path

    @property
    def spring(self) -> SensedSpring:
        """The design's map, as the controllers ask it."""
        low, high = self.joint.design.setting_range or (-math.inf, math.inf)
        return SensedSpring(self.plant.actuator, self.plant.setting_path, low, high, self.plant.driven)


def build_loop(spec: ControlSpec | None, built: Built) -> ControlLoop:
    """Return the sampled control that a spec states.

    Raises
    ------
    InputError : a controller of a drive that is not there or does not move, or numbers that make none
    """
    if spec is None:
        return ControlLoop()
    joint, plant = built.joint, built.plant
    joint.check_driven(spec.drive, "control.drive")
    joint.check_setting(spec.setting, "control.setting")
    for name, given, member in (("drive", spec.drive, plant.drive), ("setting", spec.setting, plant.setting)):
        if given is not None and member.mode != "free":
            part = "plant.drive" if name == "drive" else "plant.setting_drive"
            raise InputError(f"is given, but {part} does not move; give it, or free it", field=f"control.{name}")
    drive, setting = spec.drive, spec.setting
    with within("control.drive"):
        drive_channel = None if drive is None else Channel(_drive_controller(drive, built), drive.every)
    with within("control.setting"):
        setting_channel = None if setting is None else Channel(_setting_controller(setting, built), setting.every)
    return ControlLoop(
        drive=drive_channel,
        setting=setting_channel,
        encoders=_encoders(spec, built),
        delay=_delay(spec),
    )


def _delay(spec: ControlSpec) -> int:
    if isinstance(spec.delay, int):
        return spec.delay
    periods = spec.delay / spec.period
    if abs(periods - round(periods)) > WHOLE * max(1.0, periods) or periods > 100.0:
        raise InputError(
            f"is {spec.delay:.9g} s; allowed is a whole number of periods of {spec.period:.9g} s, at most 100",
            field="control.delay",
        )
    return round(periods)


def _encoders(spec: ControlSpec, built: Built) -> tuple[Encoder, Encoder, Encoder]:
    given = spec.encoders
    if given is None:
        return Encoder(), Encoder(), Encoder()
    built.joint.check_driven(given.drive, "control.encoders.drive")
    built.joint.check_setting(given.setting, "control.encoders.setting")
    link = built.joint.link
    return (
        _encoder(given.link, link, "control.encoders.link"),
        _encoder(given.drive, link, "control.encoders.drive"),
        _encoder(given.setting, built.setting or link, "control.encoders.setting"),
    )


def _encoder(spec: EncoderSpec | None, measures: Measures, field: str) -> Encoder:
    if spec is None:
        return Encoder()
    if spec.resolution is not None:
        return Encoder(spec.resolution.of(measures.position, f"{field}.resolution"))
    if measures is not ROTARY:
        raise InputError("is given, but this coordinate slides; give resolution", field=f"{field}.counts")
    with within(field):
        return rotary_encoder(_present(spec.counts), 1.0 if spec.ratio is None else spec.ratio)


def _present(value: float | None) -> float:
    """A number that validation has seen to be there."""
    assert value is not None
    return value


def _servo(spec: ServoSpec, measures: Measures, limit: float) -> Pid:
    return Pid(
        proportional=spec.proportional.of(measures.stiffness, "proportional"),
        integral=si(spec.integral, measures.stiffness_rate, "integral"),
        derivative=si(spec.derivative, measures.damping, "derivative"),
        filter_time=spec.filter_time,
        windup_time=math.inf if spec.windup_time is None else spec.windup_time,
        limit=si(spec.limit, measures.load, "limit", default=limit),
        derivative_on=spec.derivative_on,
    )


def _torque_loop(spec: TorqueLoopSpec, built: Built) -> TorqueControl:
    limit = float(built.plant.drive_motor.torque_limit)
    pid = Pid(
        proportional=spec.proportional,
        integral=spec.integral,
        derivative=spec.derivative,
        filter_time=spec.filter_time,
        windup_time=math.inf if spec.windup_time is None else spec.windup_time,
        limit=si(spec.limit, built.joint.link.load, "limit", default=limit),
        derivative_on=spec.derivative_on,
    )
    return TorqueControl(pid, built.spring)


def _drive_controller(spec: AnyDriveControlSpec, built: Built) -> Controller:
    measures, plant = built.joint.link, built.plant
    limit = float(plant.drive_motor.torque_limit)
    if isinstance(spec, LqrSpec):
        return _lqr(spec, built)
    if isinstance(spec, ImpedanceSpec):
        return ImpedanceControl(
            _torque_loop(spec, built),
            stiffness=spec.stiffness.of(measures.stiffness, "stiffness"),
            damping=si(spec.damping, measures.damping, "damping"),
            inertia=float(plant.inertias(built.motion).link) if spec.inertia_feedforward else 0.0,
            filter_time=spec.rate_filter_time,
        )
    if isinstance(spec, TorqueLoopSpec):
        return _torque_loop(spec, built)
    servo = _servo(spec, measures, limit)
    if isinstance(spec, PositionPidSpec):
        return PositionPid(servo, spec.feedback)
    assert isinstance(spec, DecouplingSpec)
    inertia = plant.inertias(built.motion)
    return StiffnessDecoupling(
        built.spring,
        servo,
        LinkModel(float(inertia.link), plant.link.friction.viscous, _gravity(plant)),
        stiffness=spec.stiffness.of(measures.stiffness, "stiffness"),
        damping=si(spec.damping, measures.damping, "damping"),
        drive_inertia=float(inertia.drive),
        drive_damping=plant.drive.friction.viscous,
        filter_time=spec.rate_filter_time,
    )


def _gravity(plant: Plant) -> GravityTorque | None:
    return None if plant.gravity is None else GravityTorque(plant.gravity.moment, plant.gravity.rest)


def _lqr(spec: LqrSpec, built: Built) -> Controller:
    plant, measures = built.plant, built.joint.link
    inertia, gravity = plant.inertias(built.motion), plant.gravity
    hanging = 0.0 if gravity is None else gravity.moment * math.cos(float(built.motion.link) - gravity.rest)
    model = TwoMass(
        link_inertia=float(inertia.link),
        drive_inertia=float(inertia.drive),
        link_damping=plant.link.friction.viscous,
        drive_damping=plant.drive.friction.viscous,
        link_stiffness=hanging,
    )
    error = spec.link_error.of(measures.position, "link_error")
    weights = LqrWeights(
        link=error**-2,
        torque=spec.command.of(measures.load, "command") ** -2,
        link_rate=_weight(spec.link_rate, measures, "link_rate"),
        drive=_weight(spec.drive_error, measures, "drive_error"),
        drive_rate=_weight(spec.drive_rate, measures, "drive_rate"),
        integral=0.0 if spec.integral_time is None else (error * spec.integral_time) ** -2,
    )
    return scheduled_lqr(
        built.spring,
        model,
        weights,
        nodes=spec.nodes,
        period=built.period * spec.every if spec.design == "sampled" else None,
        gravity=_gravity(plant),
        limit=si(spec.limit, measures.load, "limit", default=float(plant.drive_motor.torque_limit)),
        filter_time=spec.rate_filter_time,
    )


def _weight(welcome: Amount | None, measures: Measures, name: str) -> float:
    """One over the square of the largest value that is welcome; 0 where none is said."""
    kind = measures.rate if name.endswith("rate") else measures.position
    return 0.0 if welcome is None else welcome.of(kind, name) ** -2


def _setting_controller(spec: AnySettingControlSpec, built: Built) -> Controller:
    assert built.setting is not None
    plant, measures, spring = built.plant, built.setting, built.spring
    servo = _servo(spec, measures, float(plant.setting_motor.torque_limit))
    if isinstance(spec, StiffnessPidSpec):
        feedforward = spring if spec.adjusting_feedforward else None
        return StiffnessPid(servo, _chain(spec, built), feedforward, plant.driven)
    if isinstance(spec, SettingHoldSpec):
        return SettingHold(servo, _held(spec, built), spring if spec.adjusting_feedforward else None)
    if isinstance(spec, SettingScheduleSpec):
        return _schedule(spec, servo, built)
    if plant.driven:
        raise InputError(
            f"virtual_spring_damper is for a semi-active joint; {built.joint.name} has a drive; allowed: hold, pid",
            field="kind",
        )
    low, high = built.joint.design.deflection_range
    return virtual_spring_damper(
        spring,
        servo,
        deflection_max=high,
        deflection_min=low,
        stiffness=si(spec.stiffness, built.joint.link.stiffness, "stiffness"),
        damping=si(spec.damping, built.joint.link.damping, "damping"),
        dead_band=spec.dead_band.of(built.joint.link.position, "dead_band"),
        filter_time=spec.rate_filter_time,
    )


def _schedule(spec: SettingScheduleSpec, servo: Pid, built: Built) -> Controller:
    assert built.joint.setting is not None
    if not isinstance(built.plant.setting_path, Affine):
        raise InputError("schedule needs a screw, a belt, a line or a direct drive", field="kind")
    place = Place(built.joint.setting.position, "setting", built.directory)
    inertia = float(built.plant.inertias(built.motion).setting)
    return SettingSchedule(servo, build_signal(spec.setting, place), built.spring, inertia)


def _held(spec: SettingHoldSpec, built: Built) -> float:
    """Coordinate of the setting drive that is held."""
    if spec.setting is None:
        return float(built.motion.motion)
    assert built.joint.setting is not None
    setting = spec.setting.of(built.joint.setting.position, "setting")
    held = float(motion_of_setting(built.plant.setting_path, setting))
    if math.isnan(held):
        raise InputError("is a setting that the groove does not have", field="setting")
    return held


def _chain(spec: StiffnessPidSpec, built: Built) -> StiffnessChain:
    actuator, path = built.plant.actuator, built.plant.setting_path
    low, high = _setting_range(built)
    if spec.chain == "map":
        return MapChain(setting_inverse(actuator, setting_min=low, setting_max=high), path, spec.stiffness_at)
    if spec.stiffness_at == "measured":
        raise InputError("measured is given, but only the chain map asks for it", field="stiffness_at")
    on_disc = isinstance(actuator, SliderLeafJoint) and (
        isinstance(path, GroovePath) or (actuator.driven_by == "disc" and _is_direct(path))
    )
    if not on_disc or not isinstance(actuator, SliderLeafJoint):
        raise InputError(
            f"{spec.chain} ends in the disc angle of a slider_leaf_joint; allowed with transmission groove, or map",
            field="chain",
        )
    make = exact_chain if spec.chain == "exact" else wang_chain
    return make(actuator, setting_min=low, setting_max=high)


def _is_direct(path: object) -> bool:
    return isinstance(path, Affine) and (path.start, path.ratio) == (0.0, 1.0)


def _setting_range(built: Built) -> tuple[float, float]:
    bounds = built.joint.design.setting_range
    assert bounds is not None
    return bounds
