"""A simulation made by hand: two masses and a spring, integrated with SciPy, in the clothes of any kind.

The motion and its energies are those of a linear spring with the stiffness at rest; only the spring is simple, the
balance closes. Stiffness, stress and status come from the design at the points that the motion passes.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import xarray as xr
from scipy.integrate import solve_ivp

from varistiff.characteristic.provenance import provenance
from varistiff.design.design import Design
from varistiff.dynamics.audit import Audit
from varistiff.dynamics.ledger import LONG_NAMES, LOSSES
from varistiff.dynamics.outcome import Event, Metric, Outcome

Array = np.ndarray
FREQUENCY = 2.5  # of the link on its spring [Hz]


@dataclass(frozen=True)
class Made:
    """Everything that the report asks for."""

    name: str
    design: Design
    data: xr.Dataset
    audit: Audit
    outcome: Outcome = Outcome.DONE
    failed_at: float | None = None
    events: tuple[Event, ...] = ()
    metrics: dict[str, Metric] = field(default_factory=dict)


def make(design: Design, *, duration: float = 2.0, samples: int = 801, gravity: bool = False, **other: Any) -> Made:
    """A drive that steps to a new place with a link behind it; a joint without a drive swings freely."""
    reach = 0.6 * min(abs(end) for end in design.deflection_range)
    span = design.setting_range
    rest = None if span is None else 0.5 * (span[0] + span[1])
    stiffness = float(design.evaluate(reach, rest).load / reach)
    inertia = stiffness / (2.0 * np.pi * FREQUENCY) ** 2
    driven = design.kind != "roller_beam"
    time = np.linspace(0.0, duration, samples)
    part = np.clip(time / (0.7 * duration), 0.0, 1.0)
    setting = (
        None
        if span is None
        else span[0] + (span[1] - span[0]) * (0.35 + 0.3 * part**3 * (10 - 15 * part + 6 * part**2))
    )
    wanted = np.where(time < 0.1 * duration, 0.0, 5.0 * reach) if driven else np.full(samples, np.nan)
    states = _integrate(time, stiffness, inertia, reach, driven, duration)
    data, audit = _dataset(design, time, states, (stiffness, inertia), setting, wanted, driven)
    if gravity:
        data.attrs["gravity_rest"] = 0.0
    return Made("Step of a synthetic joint", design, data, audit, **{"metrics": METRICS, "events": EVENTS, **other})


def _integrate(time: Array, stiffness: float, inertia: float, reach: float, driven: bool, duration: float) -> Array:
    """Link, its rate, drive, its rate, friction loss of the link, and the work and friction of the drive."""
    damping = 0.1 * np.sqrt(stiffness * inertia)
    gain, rate_gain = 4.0 * stiffness, 2.0 * np.sqrt(4.0 * stiffness * inertia)

    def rates(t: float, y: Array) -> list[float]:
        link, link_rate, drive, drive_rate = y[:4]
        load = stiffness * ((drive - link) if driven else -link)
        goal = 5.0 * reach if t >= 0.1 * duration else 0.0
        torque = gain * (goal - drive) - rate_gain * drive_rate if driven else 0.0
        push = (torque - load) / inertia if driven else 0.0
        return [
            link_rate,
            (load - damping * link_rate) / inertia,
            drive_rate,
            push,
            damping * link_rate**2,
            torque * drive_rate,
        ]

    start = [0.0 if driven else 1.5 * reach, 0.0, 0.0, 0.0, 0.0, 0.0]
    found = solve_ivp(rates, (0.0, duration), start, t_eval=time, rtol=1e-11, atol=1e-13, max_step=0.01 * duration)
    assert found.success
    return np.asarray(found.y)


def _dataset(
    design: Design,
    time: Array,
    states: Array,
    law: tuple[float, float],
    setting: Array | None,
    wanted: Array,
    driven: bool,
) -> tuple[xr.Dataset, Audit]:
    stiffness, inertia = law
    link, link_rate, drive, drive_rate, lost, work = states
    deflection = drive - link if driven else link
    answer = design.evaluate(deflection, setting)
    position, load = ("rad", "N*m") if design.deflection_unit == "rad" else ("m", "N")
    terms = {name: np.zeros_like(time) for name in (*LONG_NAMES,) if name not in ("residual",)}
    terms["kinetic"] = 0.5 * inertia * (link_rate**2 + (drive_rate**2 if driven else 0.0))
    terms["elastic"] = 0.5 * stiffness * deflection**2
    terms["friction_link"], terms["supplied"] = lost, work
    for name in ("kinetic", "elastic"):
        terms[name] = terms[name] - terms[name][0]
    losses = sum(terms[name] for name in LOSSES)
    residual = terms["kinetic"] + terms["elastic"] + losses - work
    turnover = np.cumsum(np.abs(np.gradient(terms["kinetic"]))) + lost
    audit = Audit(terms=terms, residual=residual, turnover=turnover, allowance=1e-6)
    columns: dict[str, tuple[Array, str]] = {
        "link": (link, position),
        "drive": (drive, position),
        "deflection": (deflection, position),
        "wanted_position": (wanted, position),
        "load": (np.asarray(answer.load), load),
        "stiffness": (np.asarray(answer.stiffness), f"{load}/{position}"),
        "wanted_stiffness": (np.asarray(answer.stiffness) * 1.05, f"{load}/{position}"),
        "stress": (np.asarray(answer.stress), "Pa"),
        "external_torque": (np.where(time > 0.8 * time[-1], 0.1 * stiffness * deflection.max(), 0.0), load),
        "drive_torque": (inertia * np.gradient(drive_rate, time) + stiffness * deflection, load),
        "drive_current": (2.0 * inertia * np.gradient(drive_rate, time), "A"),
        "drive_power": (np.gradient(work, time), "W"),
        "drive_temperature": (3.0 * np.linspace(0.0, 1.0, time.size) ** 0.5, "K"),
        "storage_energy": (100.0 - work, "J"),
        "storage_voltage": (np.sqrt(2.0 * (100.0 - work) / 0.5), "V"),
        **{name: (values, "J") for name, values in terms.items()},
        "residual": (residual, "J"),
    }
    if not driven:
        columns = {name: each for name, each in columns.items() if not name.startswith(("drive", "storage"))}
    if setting is not None:
        columns["setting"] = (setting, str(design.setting_unit))
        columns["setting_torque"] = (np.gradient(np.gradient(setting, time), time), "N*m")
    variables = {
        name: xr.Variable("time", values, {"units": unit, "long_name": LONG_NAMES.get(name, name.replace("_", " "))})
        for name, (values, unit) in columns.items()
    }
    variables["status"] = xr.Variable("time", np.asarray(answer.status, np.int8), {"long_name": "status"})
    data = xr.Dataset(
        variables,
        {"time": xr.Variable("time", time, {"units": "s", "long_name": "time"})},
        {**provenance(design.actuator), **design.attributes},
    )
    if driven:
        top = 0.6 * float(np.abs(data.drive_torque).max())
        data.drive_torque.attrs["limits"] = (-top, top)
    return data, audit


METRICS = {
    "position_settling_time": Metric(0.34, "s", "settling time", "to within 2 % of the step"),
    "position_overshoot": Metric(12.4, "%", "overshoot"),
    "position_rise_time": Metric(0.08, "s", "rise time", "from 10 % to 90 % of the step"),
    "position_bandwidth": Metric(None, "Hz", "bandwidth", "no chirp in this run"),
    "position_error_max": Metric(0.05, "rad", "largest position error"),
}
EVENTS = (
    Event(0.2, "step", "The wanted position steps."),
    Event(0.23, "drive saturated", "The drive is at its limit: 3.2 asked, 2.1 given."),
    Event(1.6, "load", "The external load sets in."),
)
