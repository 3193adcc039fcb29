"""From the start of a scenario file to the state at the time 0."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np

from varistiff.characteristic.evaluate import Points, evaluate
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.design.scenario_joint import Joint, si, within
from varistiff.design.scenario_spec import StartSpec
from varistiff.dynamics.control import motion_of_setting, setting_inverse
from varistiff.dynamics.control_loop import Inputs
from varistiff.dynamics.linear import equilibrium
from varistiff.dynamics.linear.state_at import motion_of
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.state import Motion

_POINTS, _ROUNDS = 129, 8  # a bracket is narrowed 128 times in each round: to rounding


def build_start(spec: StartSpec | None, joint: Joint, plant: Plant, inputs: Inputs) -> Motion:
    """Return positions and rates at the time 0.

    What is not given: the link at zero, or where its signal puts it; the drive where the spring carries what acts on
    the link at the start, or at the link where that is held itself; all rates zero.

    Raises
    ------
    InputError : a quantity of another kind, a setting that is missing or that no mechanism has, or a load that the
        spring cannot carry
    """
    given = spec if spec is not None else StartSpec()
    link, link_rate = _link(given, joint, plant, inputs)
    motion, motion_rate = _motion(given, joint, plant)
    for name in ("drive", "drive_rate"):
        joint.check_driven(getattr(given, name), f"start.{name}")
    drive_rate = si(given.drive_rate, joint.link.rate, "start.drive_rate")
    if drive_rate != 0.0 and plant.drive.mode == "locked":
        raise InputError("is given, but the drive does not move; leave it out", field="start.drive_rate")
    found = motion_of((link, link_rate, link if joint.driven else 0.0, drive_rate, motion, motion_rate))
    if joint.driven:
        found = found._replace(drive=jnp.asarray(_drive(given, joint, plant, inputs, found)))
    _check(plant, found)
    return found


def _link(given: StartSpec, joint: Joint, plant: Plant, inputs: Inputs) -> tuple[float, float]:
    if plant.link.mode == "prescribed":
        for name in ("link", "link_rate"):
            if getattr(given, name) is not None:
                raise InputError("is given, but the link follows its signal; leave it out", field=f"start.{name}")
        sample = inputs.link_sample(jnp.asarray(0.0))
        return float(sample.value), float(sample.rate)
    link = si(given.link, joint.link.position, "start.link")
    rate = si(given.link_rate, joint.link.rate, "start.link_rate")
    if rate != 0.0 and plant.link.mode == "locked":
        raise InputError("is given, but the link is locked; leave it out", field="start.link_rate")
    return link, rate


def _motion(given: StartSpec, joint: Joint, plant: Plant) -> tuple[float, float]:
    """Coordinate of the setting drive and its rate."""
    measures = joint.setting
    for name in ("setting", "stiffness", "setting_rate"):
        joint.check_setting(getattr(given, name), f"start.{name}")
    if measures is None:
        return 0.0, 0.0
    if given.setting is None and given.stiffness is None:
        raise InputError(
            f"is missing; {joint.name} needs it, or start.stiffness; {measures.position.allowed()}",
            field="start.setting",
        )
    if given.setting is None:
        field, setting = "start.stiffness", _setting_of_stiffness(given, joint, plant)
    else:
        field, setting = "start.setting", given.setting.of(measures.position, "start.setting")
    motion = float(motion_of_setting(plant.setting_path, setting))
    if not math.isfinite(motion):
        raise InputError(f"the groove has no setting of {setting:.6g} {joint.design.setting_unit}", field=field)
    rate = si(given.setting_rate, measures.rate, "start.setting_rate")
    if rate != 0.0 and plant.setting.mode == "locked":
        raise InputError("is given, but the setting does not move; leave it out", field="start.setting_rate")
    return motion, rate / float(plant.setting_path.at(jnp.asarray(motion)).slope)


def _setting_of_stiffness(given: StartSpec, joint: Joint, plant: Plant) -> float:
    """Setting within the design's range with a tangent stiffness at rest, by narrowing a bracket to rounding."""
    bounds = joint.design.setting_range
    assert given.stiffness is not None
    assert bounds is not None
    wanted = given.stiffness.of(joint.link.stiffness, "start.stiffness")
    with within("start.stiffness"):
        rising = setting_inverse(plant.actuator, setting_min=bounds[0], setting_max=bounds[1]).rising
    low, high = bounds
    for _ in range(_ROUNDS):
        settings = np.linspace(low, high, _POINTS)
        stiffness = evaluate(plant.actuator, 0.0, settings).stiffness
        ordered = stiffness if rising else stiffness[::-1]
        if not ordered[0] <= wanted <= ordered[-1]:
            allowed = f"allowed is from {ordered[0]:.6g} to {ordered[-1]:.6g} {joint.link.stiffness.unit}"
            raise InputError(f"is outside the design's range of settings; {allowed}", field="start.stiffness")
        above = int(np.clip(np.searchsorted(ordered, wanted), 1, _POINTS - 1))
        low, high = settings[above - 1 : above + 1] if rising else settings[_POINTS - 1 - above : _POINTS + 1 - above]
    return float(0.5 * (low + high))


def _drive(given: StartSpec, joint: Joint, plant: Plant, inputs: Inputs, found: Motion) -> float:
    if given.drive is not None:
        return given.drive.of(joint.link.position, "start.drive")
    if plant.link.mode != "free":
        return float(found.link)
    load = float(inputs.load.at(jnp.asarray(0.0)).value)
    if load == 0.0 and _rests_relaxed(plant, found):
        return float(found.link)
    setting = None if joint.setting is None else float(found.motion)
    try:
        rest = equilibrium(plant, guess=found, link=float(found.link), motion=setting, external_torque=load)
    except InputError as error:
        raise InputError(f"give it: {error.problem}", field="start.drive") from None
    return float(rest.motion.drive)


def _rests_relaxed(plant: Plant, found: Motion) -> bool:
    """Whether nothing acts on the link where the drive stands with it, so that no equilibrium has to be sought."""
    stops = [(plant.link.stop, float(found.link)), (plant.deflection_stop, 0.0)]
    inside = all(stop is None or stop.lower <= place <= stop.upper for stop, place in stops)
    return plant.gravity is None and inside and float(_response(plant, 0.0, found).load) == 0.0


def _response(plant: Plant, deflection: float, at: Motion) -> Points:
    setting = float(plant.setting_path.at(at.motion).value)
    return evaluate(plant.actuator, deflection, setting)


def _check(plant: Plant, motion: Motion) -> None:
    """Refuse a start for which the actuator has no solution."""
    deflection = float(plant.stretch(motion))
    found = _response(plant, deflection, motion)
    status = Status(int(found.status))
    if status in (Status.NO_SOLUTION, Status.ELEMENT_TOO_SHORT):
        raise InputError(
            f"the actuator has no solution at a deflection of {deflection:.6g} and a setting of "
            f"{float(found.setting):.6g} (SI): {status.label}. {status.remedy}",
            field="start",
        )
