"""Numbers that judge a run."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from varistiff.dynamics.outcome import Metric
from varistiff.dynamics.response_metrics import bandwidth, step_metrics
from varistiff.dynamics.simulate import Run
from varistiff.dynamics.stiffness_variation import stiffness_variations, variation_metrics

_SETTLED = "tracking after the first tenth of the run"


def metrics(run: Run) -> dict[str, Metric]:
    """Tracking, step response, stiffness variation, bandwidth, peaks and energies of a run, by name.

    Of a run that is no result only what its rows hold, up to where they end. Where a number does not exist (a
    settling time without a step, a bandwidth without a chirp) its value is None and the note says why.
    """
    unit = "rad" if run.case.plant.actuator.deflection_unit == "rad" else "m"
    return {**_tracking(run, unit), **_stiffness(run, unit), **_peaks(run, unit), **_energies(run)}


def _tracking(run: Run, unit: str) -> dict[str, Metric]:
    if run.case.loop.drive is None:
        return {}
    time, wanted = run.time, np.asarray(run.rows.wanted_position)
    position = np.asarray(run.rows.state.motion.link)
    error = position - wanted
    late = time >= 0.1 * time[-1]
    return {
        "position_error_max": Metric(_most(error), unit, "largest position error"),
        "position_error_rms": Metric(_rms(error), unit, "root mean square position error"),
        "position_error_late": Metric(_most(error[late]), unit, "largest position error later", _SETTLED),
        **step_metrics(time, wanted, position, unit, "position"),
        "bandwidth": bandwidth(time, wanted, position),
    }


def _stiffness(run: Run, unit: str) -> dict[str, Metric]:
    if run.case.loop.setting is None:
        return {}
    per = "N*m/rad" if unit == "rad" else "N/m"
    time, wanted = run.time, np.asarray(run.rows.wanted_stiffness)
    stiffness = np.asarray(run.rows.flows.response.stiffness)
    error = stiffness - wanted
    late = time >= 0.1 * time[-1]
    load_unit = "N*m" if unit == "rad" else "N"
    variations = stiffness_variations(time, wanted, stiffness, np.asarray(run.rows.flows.response.load))
    return {
        "stiffness_error_max": Metric(_most(error), per, "largest stiffness error"),
        "stiffness_error_rms": Metric(_rms(error), per, "root mean square stiffness error"),
        "stiffness_error_late": Metric(_most(error[late]), per, "largest stiffness error later", _SETTLED),
        **step_metrics(time, wanted, stiffness, per, "stiffness"),
        **variation_metrics(variations, load_unit),
    }


def _peaks(run: Run, unit: str) -> dict[str, Metric]:
    load_unit = "N*m" if unit == "rad" else "N"
    flows, plant = run.rows.flows, run.case.plant
    peaks = {
        "deflection_max": Metric(_most(run.rows.deflection), unit, "largest deflection"),
        "load_max": Metric(_most(flows.response.load), load_unit, "largest load of the elastic element"),
    }
    drives = [("setting", "setting drive", flows.setting, plant.setting.mode)]
    if plant.driven:
        drives.insert(0, ("drive", "drive", flows.drive, plant.drive.mode))
    for name, title, own, mode in drives:
        if mode == "locked":
            continue
        torque = load_unit if name == "drive" else ("N*m" if plant.motion_unit == "rad" else "N")
        peaks[f"{name}_torque_max"] = Metric(_most(own.torque), torque, f"largest torque of the {title}")
        peaks[f"{name}_current_max"] = Metric(_most(own.current), "A", f"largest current of the {title}")
        peaks[f"{name}_power_max"] = Metric(_most(own.electrical_power), "W", f"largest power of the {title}")
    return peaks


def _energies(run: Run) -> dict[str, Metric]:
    terms, time = run.audit.terms, run.time
    power = np.asarray(run.rows.flows.drive.electrical_power) + np.asarray(run.rows.flows.setting.electrical_power)
    drawn = float(np.trapezoid(np.maximum(power, 0.0), time))
    returned = float(np.trapezoid(np.maximum(-power, 0.0), time))
    losses = ("copper_drive", "copper_setting", "gear_drive", "gear_setting", "friction_link", "friction_drive")
    lost = sum(float(terms[name][-1]) for name in (*losses, "friction_setting", "stop_loss"))
    return {
        "energy_drawn": Metric(drawn, "J", "energy drawn by the drives", "trapezoids of the rows' power above zero"),
        "energy_returned": Metric(returned, "J", "energy returned by the drives", "trapezoids of the rows' power"),
        "energy_lost": Metric(lost, "J", "copper, gears, friction and stops"),
        "energy_turned_over": Metric(float(run.audit.turnover[-1]), "J", "energy turned over"),
        "energy_residual": Metric(run.audit.relative, "", "energy residual over energy turned over"),
    }


def _most(values: ArrayLike) -> float:
    return float(np.max(np.abs(np.asarray(values))))


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
