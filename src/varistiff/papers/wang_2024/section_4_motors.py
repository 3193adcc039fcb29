"""Whether a joint of 4 kg could have the numbers that the search finds: which real motors could drive it."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from varistiff.dynamics.drives.motor_table import MotorData, motor_table
from varistiff.papers.wang_2024.section_4 import position_set
from varistiff.papers.wang_2024.section_4_cases import PERIOD
from varistiff.papers.wang_2024.section_4_facts import position_runs
from varistiff.papers.wang_2024.section_4_runs import RUNS

FRAME = 0.004  # kg m^2: 2 kg of drive disc and main drive frame at 45 mm from the axis
EFFICIENCY = 0.75  # of belt and gear
OVERLOAD = 3.0  # times its continuous torque that a motor bears for a step
HEAVIEST = 0.8  # kg, a fifth of the joint


class Demand(NamedTuple):
    """What the drive has to give in the tests of one set, at the joint [rad/s], [N m]."""

    rate: float
    torque: float  # largest
    torque_rms: float  # of the sine with load
    rotor: float  # kg m^2: inertia that is left for the rotor behind its gear


class Drive(NamedTuple):
    """A motor of the table and the gear ratios with which it could serve."""

    motor: str
    lowest: float
    highest: float


def demand(name: str) -> Demand:
    """What the drive has to give with a stored set."""
    own, courses = position_set(name), position_runs()[name].courses
    drive = courses[:, 1]
    rates = np.gradient(drive, PERIOD, axis=1)
    link, drive_rate = courses[RUNS.index("sine_loaded"), 0], rates[RUNS.index("sine_loaded")]
    spring = 200.0 * (drive[RUNS.index("sine_loaded")] - link)
    torque = own.drive_inertia * np.gradient(drive_rate, PERIOD) + own.drive_friction * drive_rate + spring
    late = torque[round(1.0 / PERIOD) :]
    return Demand(float(np.abs(rates).max()), own.limit, float(np.sqrt(np.mean(late**2))), own.drive_inertia - FRAME)


def drives(name: str) -> tuple[Drive, ...]:
    """Motors of the table that could drive the joint of a stored set, with the belt and gear that each needs."""
    need = demand(name)
    found = []
    for key, data in motor_table().items():
        limits = _ratios(data, need)
        if limits[0] <= limits[1] and (data.mass is None or data.mass <= HEAVIEST):
            found.append(Drive(key, *limits))
    return tuple(found)


def _ratios(data: MotorData, need: Demand) -> tuple[float, float]:
    """Lowest and highest gear ratio: torque asks for a high one, speed and the rotor's inertia for a low one."""
    continuous = data.torque_constant * data.continuous_current * EFFICIENCY
    if not math.isfinite(continuous):
        return math.inf, 0.0  # the sheet does not say what the motor bears
    lowest = max(need.torque / (OVERLOAD * continuous), need.torque_rms / continuous)
    return lowest, min(data.no_load_speed / need.rate, math.sqrt(max(need.rotor, 0.0) / data.rotor_inertia))
