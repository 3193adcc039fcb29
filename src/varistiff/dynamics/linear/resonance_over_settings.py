"""How stiff and how fast a joint is at each setting."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from varistiff.characteristic.evaluate import evaluate
from varistiff.characteristic.provenance import provenance
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.dynamics.control import motion_of_setting
from varistiff.dynamics.linear.matrices import Coordinate, free_coordinates, plant_matrices
from varistiff.dynamics.linear.modes import Mode, modes_of
from varistiff.dynamics.linear.rest import rest
from varistiff.dynamics.linear.state_at import start_of
from varistiff.dynamics.linear.without_dry_friction import without_dry_friction
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.program import Case

if TYPE_CHECKING:
    import xarray as xr

_NUMBERS = ("deflection", "stiffness", "resonance", "resonance_damping", "antiresonance", "antiresonance_damping")


def resonance_over_settings(case: Case, settings: ArrayLike) -> xr.Dataset:
    """Stiffness, resonance and antiresonance of small motions about rest, over the setting.

    The setting stands still, held by its drive. ``resonance`` is the fastest oscillation of link and drive, for two
    inertias and a spring sqrt(K (1/J + 1/J_1)); ``antiresonance`` that of the link on a drive that stands still,
    sqrt(K/J). Dry friction is left out, viscous is not. Both are natural frequencies |pole|/(2 pi).

    Parameters
    ----------
    settings : (n,) [m] or [rad]

    Returns
    -------
    Dataset over ``setting``: ``deflection``, tangent ``stiffness``, ``resonance`` and ``antiresonance`` [Hz] with their
    damping ratios, and the ``status`` of the actuator at rest. NaN where there is no such rest, where nothing
    oscillates, and for the antiresonance of a joint that has no free drive (its link's frequency is the resonance).

    Raises
    ------
    InputError : the actuator has no setting

    Notes
    -----
    Spong (1987), doi 10.1115/1.3143860, for the linear model of an elastic joint.
    """
    import xarray as xr

    actuator = case.plant.actuator
    if actuator.setting_unit is None:
        raise InputError(f"a {actuator.kind} has no setting", field="settings")
    values = np.atleast_1d(np.asarray(settings, dtype=float))
    rows = [_at(case, float(value)) for value in values]
    variables: dict[str, Any] = {
        name: ("setting", np.array([row[name] for row in rows]), about)
        for name, about in zip(_NUMBERS, _abouts(case.plant), strict=True)
    }
    flags = {
        "long_name": "status of the actuator at rest",
        "units": "1",
        "flag_values": np.array([int(s) for s in Status], np.int8),
        "flag_meanings": " ".join(s.label for s in Status),
    }
    variables["status"] = ("setting", np.array([row["status"] for row in rows], np.int8), flags)
    about = {"long_name": "setting of the stiffness drive", "units": str(actuator.setting_unit)}
    return xr.Dataset(variables, {"setting": ("setting", values, about)}, provenance(actuator))


def _abouts(plant: Plant) -> tuple[dict[str, str], ...]:
    angle = plant.actuator.deflection_unit == "rad"
    told = (
        ("deflection at rest", "rad" if angle else "m"),
        ("tangent stiffness at rest", "N*m/rad" if angle else "N/m"),
        ("fastest natural frequency with the setting held", "Hz"),
        ("damping ratio of the resonance", "1"),
        ("natural frequency of the link with the drive held too", "Hz"),
        ("damping ratio of the antiresonance", "1"),
    )
    return tuple({"long_name": name, "units": unit} for name, unit in told)


def _at(case: Case, setting: float) -> dict[str, float]:
    row: dict[str, float] = dict.fromkeys(_NUMBERS, math.nan)
    try:
        at = rest(case, motion=float(motion_of_setting(case.plant.setting_path, setting)))
    except InputError:
        row["status"] = int(_refusal(case, setting))
        return row
    plant = without_dry_friction(case.plant)
    points = evaluate(plant.actuator, np.array([float(plant.stretch(at.motion))]), np.array([setting]))
    row["deflection"] = float(plant.deflection(at.motion))
    row["stiffness"], row["status"] = float(points.stiffness[0]), int(at.status)

    def fastest(hold: tuple[Coordinate, ...]) -> Mode | None:
        a = plant_matrices(plant, at.motion, external_torque=at.external_torque, hold=hold).a
        swings = [mode for mode in modes_of(np.linalg.eigvals(a)) if mode.oscillates] if np.isfinite(a).all() else []
        return swings[-1] if swings else None

    both = {"link", "drive"} <= set(free_coordinates(plant))
    for name, mode in (
        ("resonance", fastest(("motion",))),
        ("antiresonance", fastest(("motion", "drive")) if both else None),
    ):
        if mode is not None:
            row[name], row[f"{name}_damping"] = mode.frequency, mode.damping_ratio
    return row


def _refusal(case: Case, setting: float) -> Status:
    """Status at the start's deflection if the actuator has no numbers there, else: there is no such equilibrium."""
    deflection = float(case.plant.stretch(start_of(case)))
    status = Status(int(evaluate(case.plant.actuator, np.array([deflection]), np.array([setting])).status[0]))
    return status if status in (Status.ELEMENT_TOO_SHORT, Status.OUTSIDE_VALIDITY) else Status.NO_SOLUTION
