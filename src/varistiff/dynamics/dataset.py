"""A run as a labelled dataset."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr

from varistiff.characteristic.provenance import provenance
from varistiff.core.status import Status
from varistiff.dynamics.drives import Motor
from varistiff.dynamics.ledger import LONG_NAMES
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.simulate import Run


def run_dataset(run: Run) -> xr.Dataset:
    """Return what a run computed against time [s], SI units, with long names and units at every variable.

    The energy account is cumulated from 0. Attributes say kind, signs, versions, papers, step, outcome and residual.
    """
    columns = {**_motion(run), **_actuator(run), **_drives(run), **_ledger(run)}
    variables = {
        name: xr.Variable("time", np.asarray(values), {"units": unit, "long_name": text})
        for name, (values, unit, text) in columns.items()
    }
    variables["status"] = xr.Variable(
        "time",
        np.asarray(run.rows.flows.response.status, dtype=np.int8),
        {
            "long_name": "status of the map at this point",
            "flag_values": np.array([int(status) for status in Status], dtype=np.int8),
            "flag_meanings": " ".join(status.label for status in Status),
        },
    )
    for name, limits in _limits(run.case.plant).items():
        if name in variables:
            variables[name].attrs["limits"] = limits
    time = xr.Variable("time", run.time, {"units": "s", "long_name": "time"})
    attributes: dict[str, Any] = {
        **provenance(run.case.plant.actuator),
        "outcome": run.outcome.value,
        "step": run.step,
        "energy_residual": run.audit.relative,
        "energy_residual_allowed": run.audit.allowance,
        "dissipation_convention": "losses are cumulated and never negative; external_work and supplied flow in",
    }
    if run.failed_at is not None:
        attributes["failed_at"] = run.failed_at
    return xr.Dataset(variables, coords={"time": time}, attrs=attributes)


_Column = tuple[Any, str, str]


def _units(run: Run) -> tuple[str, str]:
    """Units of position and load."""
    return ("rad", "N*m") if run.case.plant.actuator.deflection_unit == "rad" else ("m", "N")


def _motion(run: Run) -> dict[str, _Column]:
    rows, (unit, load) = run.rows, _units(run)
    motion, own = rows.state.motion, run.case.plant.motion_unit
    columns: dict[str, _Column] = {
        "link": (motion.link, unit, "link position"),
        "link_rate": (motion.link_rate, f"{unit}/s", "link rate"),
        "wanted_position": (rows.wanted_position, unit, "wanted link position"),
        "external_torque": (rows.flows.external_torque, load, "load from outside against the link"),
        "motion": (motion.motion, own, "coordinate of the setting drive"),
        "motion_rate": (motion.motion_rate, f"{own}/s", "rate of the setting drive"),
        "switchings": (rows.switchings, "1", "switchings located in the period before"),
    }
    if run.case.plant.driven:
        columns["drive"] = (motion.drive, unit, "drive position")
        columns["drive_rate"] = (motion.drive_rate, f"{unit}/s", "drive rate")
    return columns


def _actuator(run: Run) -> dict[str, _Column]:
    rows, (unit, load), response = run.rows, _units(run), run.rows.flows.response
    actuator = run.case.plant.actuator
    columns: dict[str, _Column] = {
        "deflection": (rows.deflection, unit, "deflection"),
        "stretch": (_stretch(run), unit, "deflection of the elastic element, without the backlash"),
        "load": (response.load, load, "load"),
        "stiffness": (response.stiffness, f"{load}/{unit}", "tangent stiffness"),
        "stress": (response.stress, "Pa", "largest stress in the elastic element"),
        "wanted_stiffness": (rows.wanted_stiffness, f"{load}/{unit}", "wanted stiffness"),
    }
    if actuator.setting_unit is not None:
        adjusting = "N*m" if actuator.setting_unit == "rad" else "N"
        columns["setting"] = (rows.setting, actuator.setting_unit, "setting")
        columns["adjusting_load"] = (response.adjusting_load, adjusting, "adjusting load")
    return columns


def _stretch(run: Run) -> np.ndarray:
    return np.asarray(run.case.plant.stretch(run.rows.state.motion))


def _limits(plant: Plant) -> dict[str, tuple[float, float]]:
    """Lowest and highest value that a variable may have; infinite where there is no limit."""
    limits: dict[str, tuple[float, float]] = {}
    for name, stop in (("link", plant.link.stop), ("drive", plant.drive.stop), ("deflection", plant.deflection_stop)):
        if stop is not None:
            limits[name] = (float(stop.lower), float(stop.upper))
    for name, motor in (("drive", plant.drive_motor), ("setting", plant.setting_motor)):
        limits[f"{name}_torque"] = (-float(motor.torque_limit), float(motor.torque_limit))
        limits[f"{name}_temperature"] = (-math.inf, float(motor.temperature_limit))
        if isinstance(motor, Motor):
            limits[f"{name}_current"] = (-float(motor.current_limit), float(motor.current_limit))
            limits[f"{name}_voltage"] = (-float(motor.voltage_limit), float(motor.voltage_limit))
    return limits


def _drives(run: Run) -> dict[str, _Column]:
    rows, plant = run.rows, run.case.plant
    columns: dict[str, _Column] = {}
    setting_torque = "N*m" if plant.motion_unit == "rad" else "N"
    for name, title, torque, flows, command, heat in (
        ("drive", "drive", _units(run)[1], rows.flows.drive, rows.command.drive, rows.state.drive_heat),
        ("setting", "setting drive", setting_torque, rows.flows.setting, rows.command.setting, rows.state.setting_heat),
    ):
        columns |= {
            f"{name}_command": (command, torque, f"torque asked of the {title}"),
            f"{name}_torque": (flows.torque, torque, f"torque of the {title}"),
            f"{name}_current": (flows.current, "A", f"current of the {title}"),
            f"{name}_voltage": (flows.voltage, "V", f"voltage at the {title}'s motor"),
            f"{name}_power": (flows.electrical_power, "W", f"electrical power drawn by the {title}"),
            f"{name}_temperature": (heat.winding, "K", f"winding of the {title} above ambient"),
        }
    columns["storage_voltage"] = (plant.storage.open_voltage(rows.state.charge), "V", "open voltage of the storage")
    columns["storage_energy"] = (rows.stores.stored, "J", "energy in the storage")
    return columns


def _ledger(run: Run) -> dict[str, _Column]:
    columns: dict[str, _Column] = {name: (values, "J", LONG_NAMES[name]) for name, values in run.audit.terms.items()}
    columns["residual"] = (run.audit.residual, "J", LONG_NAMES["residual"])
    columns["turnover"] = (run.audit.turnover, "J", "energy turned over")
    return columns
