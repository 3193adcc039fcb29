"""From a validated scenario and its design to what a run is computed from."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from varistiff.core.errors import InputError
from varistiff.core.quantity import Kind
from varistiff.design.build_scenario_control import WHOLE, Built, build_loop
from varistiff.design.build_scenario_plant import build_plant
from varistiff.design.build_scenario_signals import Place, build_signal
from varistiff.design.build_scenario_start import build_start
from varistiff.design.design import Design
from varistiff.design.scenario_control_spec import (
    AnyDriveControlSpec,
    AnySettingControlSpec,
    ControlSpec,
    PositionPidSpec,
    StiffnessPidSpec,
    TorqueControlSpec,
    VirtualSpringDamperSpec,
)
from varistiff.design.scenario_fields import ROTARY
from varistiff.design.scenario_joint import Joint
from varistiff.design.scenario_signal_spec import AnySignalSpec
from varistiff.design.scenario_spec import LoadSpec, ReferenceSpec, ScenarioSpec
from varistiff.dynamics.control_loop import Inputs
from varistiff.dynamics.program import Case
from varistiff.dynamics.signals import Constant, Signal

DEFAULT_PERIOD = 1e-3  # s
SAMPLES_LIMIT = 500_000  # rows of a run: about half a gigabyte
STEPS_LIMIT = 100_000_000


def build_case(spec: ScenarioSpec, design: Design, directory: Path) -> Case:
    """Return the case that a scenario states.

    Parameters
    ----------
    directory : that the files of its trajectories are relative to

    Raises
    ------
    InputError : parts that do not fit each other or the design's kind; says the field
    """
    try:
        return _case(spec, design, directory)
    except InputError:
        raise
    except (ArithmeticError, ValueError, np.linalg.LinAlgError) as error:  # numbers too far apart for a design of gains
        raise InputError(f"no joint or control can be made of these numbers: {' '.join(str(error).split())}") from error


def _case(spec: ScenarioSpec, design: Design, directory: Path) -> Case:
    joint = Joint(design)
    period = DEFAULT_PERIOD if spec.control is None else spec.control.period
    _check_times(spec, period)
    plant, setting = build_plant(spec.plant, joint)
    inputs = _inputs(spec, joint, directory)
    motion = build_start(spec.start, joint, plant, inputs)
    loop = build_loop(spec.control, Built(joint, plant, setting, motion, period, directory))
    _check_followed(spec.reference, spec.control)
    return Case(plant, loop, inputs, motion, period)


def _check_times(spec: ScenarioSpec, period: float) -> None:
    """Refuse times that do not fit each other, and more samples than memory should hold."""
    samples = spec.duration / period
    if abs(samples - round(samples)) > WHOLE * max(samples, 1.0) or round(samples) < 1:
        low, high = math.floor(samples) * period, math.ceil(samples) * period
        near = f"{high:.9g} s" if low == 0.0 else f"{low:.9g} s or {high:.9g} s"
        raise InputError(
            f"is {spec.duration:.9g} s, no whole number of periods of {period:.9g} s; allowed is for example {near}",
            field="duration",
        )
    if samples > SAMPLES_LIMIT:
        raise InputError(
            f"makes {samples:.6g} samples of {period:.9g} s; allowed are at most {SAMPLES_LIMIT}", field="duration"
        )
    if spec.step is None:
        return
    parts = period / spec.step
    if abs(parts - round(parts)) > WHOLE * max(parts, 1.0) or round(parts) < 1:
        allowed = f"allowed is for example {period / max(1, math.ceil(parts)):.9g} s"
        raise InputError(
            f"is {spec.step:.9g} s and does not divide the period of {period:.9g} s; {allowed}",
            field="step",
        )
    if samples * parts > STEPS_LIMIT:
        raise InputError(
            f"makes {samples * parts:.3g} steps of {spec.step:.9g} s; allowed are at most {STEPS_LIMIT}",
            field="step",
        )


def _inputs(spec: ScenarioSpec, joint: Joint, directory: Path) -> Inputs:
    measures = joint.link
    reference = spec.reference or ReferenceSpec()
    load = spec.load or LoadSpec()

    def signal(given: AnySignalSpec | None, kind: Kind, field: str) -> Signal:
        return Constant(0.0) if given is None else build_signal(given, Place(kind, field, directory))

    if reference.stiffness is not None:
        joint.check_setting(reference.stiffness, "reference.stiffness")
    link = spec.plant.link.signal
    torque, torque_field = _load_of(reference, joint, "reference")
    outside, outside_field = _load_of(load, joint, "load")
    return Inputs(
        position=signal(reference.position, measures.position, "reference.position"),
        stiffness=signal(reference.stiffness, measures.stiffness, "reference.stiffness"),
        torque=signal(torque, measures.load, torque_field),
        load=signal(outside, measures.load, outside_field),
        link=None if link is None else signal(link, measures.position, "plant.link.signal"),
    )


def _load_of(spec: ReferenceSpec | LoadSpec, joint: Joint, field: str) -> tuple[AnySignalSpec | None, str]:
    """The torque of a joint, or the force of a linear device, with its field."""
    own, other = ("torque", "force") if joint.link is ROTARY else ("force", "torque")
    if getattr(spec, other) is not None:
        raise InputError(f"is given, but {joint.name} {joint.link.word}; give {own} instead", field=f"{field}.{other}")
    return getattr(spec, own), f"{field}.{own}"


def _check_followed(reference: ReferenceSpec | None, control: ControlSpec | None) -> None:
    """Refuse a reference that no controller follows, and a controller whose reference is missing."""
    needed, followed = _references(
        None if control is None else control.drive, None if control is None else control.setting
    )
    given = reference or ReferenceSpec()
    for name in ("position", "stiffness", "torque", "force"):
        signal = getattr(given, name)
        what = "torque" if name == "force" else name
        if signal is not None and what not in followed:
            raise InputError("no controller follows it; leave it out, or add one to control", field=f"reference.{name}")
    for name, by in needed.items():
        names = (name, "force") if name == "torque" else (name,)
        if all(getattr(given, each) is None for each in names):
            raise InputError(f"is missing; {by} follows it", field=f"reference.{name}")


def _references(
    drive: AnyDriveControlSpec | None, setting: AnySettingControlSpec | None
) -> tuple[dict[str, str], set[str]]:
    """References that are needed, with the field of the controller, and those that are followed."""
    needed: dict[str, str] = {}
    followed: set[str] = set()
    if isinstance(drive, TorqueControlSpec):
        needed["torque"] = "control.drive"
    elif drive is not None:
        needed["position"] = "control.drive"
        followed |= set() if isinstance(drive, PositionPidSpec) else {"torque"}
    if isinstance(setting, StiffnessPidSpec):
        needed["stiffness"] = "control.setting"
    elif isinstance(setting, VirtualSpringDamperSpec):
        followed |= {"torque"}
        if setting.stiffness is not None or setting.damping is not None:
            needed["position"] = "control.setting"
        else:
            needed["torque"] = "control.setting"
    return needed, followed | set(needed)
