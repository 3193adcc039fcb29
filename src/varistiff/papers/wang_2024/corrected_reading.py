"""Which single change makes 9 N m/rad, 14.6 N m and 3.03 degrees of Wang et al. (2024) consistent.

The softest joint is a function of E, b, h, r_2 and the longest l_1 alone (Eq. 9 at rest). Each is searched, the others
as printed, for the interval that rounds to 9 N m/rad at the long end. What is left is asked for 14.6 N m at 3.03
degrees (Eq. 7) at a shortest length that rounds to the printed 6 mm. The 200 N m/rad of section 4.3 are not used in
the search; they are a check.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import answer, joint

SOFTEST = (8.5, 9.5)  # N m/rad, what is printed as 9
TORQUE = (14.55, 14.65)  # N m, what is printed as 14.6
SHORTEST = (0.0055, 0.0065)  # m, what is printed as 6 mm
GAUGE = 0.05e-3  # m, step of the thicknesses in which thin spring strip is commonly sold


class Repair(NamedTuple):
    """One number changed, the others as printed.

    Parameters
    ----------
    name : which one
    printed : as in the paper, SI
    low, high : interval that gives 9 N m/rad; NaN where no value does
    shortest : active lengths [m] at which its two ends give 14.6 N m at 3.03 degrees; NaN where not asked
    possible : whether the interval exists, the joint has room for it, and the lengths print as 6 mm
    remark : why, in words
    """

    name: str
    printed: float
    low: float
    high: float
    shortest: tuple[float, float]
    possible: bool
    remark: str


@dataclass(frozen=True)
class Evidence:
    """What the search finds; SI units.

    Parameters
    ----------
    repairs : every number that was changed alone
    softness_demand, torque_demand : b h^3 [m^4] that 9 N m/rad at 25 mm, and 14.6 N m at 6 mm, ask for
    pairs : of each thickness from 0.2 to 1 mm [m] the widths from and to [m] that give 9 N m/rad
    thickness : the only thickness of the gauge series in its interval, with the printed width
    shortest_length : at which this leaf gives 14.6 N m at 3.03 degrees
    softest : stiffness at 25 mm
    deflection_at_nine_degrees : at 25 mm
    test_length : length of 200 N m/rad, which was not used in the search
    rotation, stress : leaf rotation and root stress at the shortest length and 3.03 degrees
    """

    repairs: tuple[Repair, ...]
    softness_demand: tuple[float, float]
    torque_demand: tuple[float, float]
    pairs: tuple[tuple[float, float, float], ...]
    thickness: float
    shortest_length: float
    softest: float
    deflection_at_nine_degrees: float
    test_length: float
    rotation: float
    stress: float

    def repair(self, name: str) -> Repair:
        """The repair of one number."""
        return next(repair for repair in self.repairs if repair.name == name)


def _softness(**changed: float) -> float:
    """Stiffness at rest [N m/rad] at the long end, of the printed joint with some numbers changed."""
    length = changed.pop("longest_length", paper.LENGTH_MAX)
    return float(answer(joint(**changed), deflection=0.0, length=length).stiffness)  # type: ignore[arg-type]  # floats only


def _solve(function: Callable[[float], float], wanted: float, low: float, high: float) -> float:
    """Where a monotone function takes a value between two ends; NaN where it does not."""
    ends = function(low) - wanted, function(high) - wanted
    if ends[0] * ends[1] > 0.0:
        return math.nan
    # a brief logarithmic bracket: rigidity goes over decades
    return math.exp(
        brentq(lambda log: function(math.exp(log)) - wanted, math.log(low), math.log(high), xtol=1e-13, rtol=1e-13)
    )


def shortest_length(*, thickness: float = paper.THICKNESS, torque: float = 14.6, **changed: float) -> float:
    """Active length [m] at which a changed joint has a torque [N m] at 3.03 degrees (Eq. 7)."""
    actuator = joint(thickness=thickness, **changed)  # type: ignore[arg-type]  # floats only
    return _solve(
        lambda length: float(answer(actuator, deflection=paper.DEFLECTION_LIMIT, length=length).torque),
        torque,
        1e-3,
        paper.LENGTH_MAX,
    )


_CHANGES = {
    # name: printed, from, to, largest that the joint has room for
    "thickness": (paper.THICKNESS, 1e-5, 1e-2, math.inf),
    "width": (paper.WIDTH, 1e-4, 1.0, math.inf),
    "youngs_modulus": (paper.YOUNGS_MODULUS, 1e8, 1e13, math.inf),
    "clamp_radius": (paper.CLAMP_RADIUS, 1e-9, 1.0, math.inf),
    "longest_length": (paper.LENGTH_MAX, 1e-3, 10.0, 0.5 * paper.JOINT_DIAMETER - paper.CLAMP_RADIUS),
}
_REMARKS = {
    "thickness": "a thin strip; 0.35 mm is a common thickness of spring strip",
    "width": "about as wide as it is thick: a wire, not a leaf",
    "youngs_modulus": "a plastic; the paper prints the modulus of steel",
    "clamp_radius": "even a leaf clamped on the axis gives more than 9.5 N m/rad",
    "longest_length": "longer than the joint of 140 mm has room for",
}


def _repair(name: str) -> Repair:
    printed, start, stop, largest = _CHANGES[name]
    ends = sorted(_solve(lambda value: _softness(**{name: value}), wanted, start, stop) for wanted in SOFTEST)
    shortest = (math.nan, math.nan)
    possible = bool(np.isfinite(ends).all()) and ends[1] <= largest
    if possible:
        lengths = [shortest_length(torque=torque, **{name: end}) for end, torque in zip(ends, TORQUE, strict=True)]
        shortest = min(lengths), max(lengths)
        possible = shortest[0] < SHORTEST[1] and shortest[1] > SHORTEST[0]
    return Repair(name, printed, ends[0], ends[1], shortest, possible, _REMARKS[name])


@cache
def search() -> Evidence:
    """Search every number alone; then find what the chosen one, the thickness, makes of the others.

    >>> round(1e3 * search().thickness, 2)
    0.35
    """
    from varistiff.papers.wang_2024.limits import deflection_at_rotation

    repairs = tuple(_repair(name) for name in _CHANGES)
    strip = next(repair for repair in repairs if repair.name == "thickness")
    gauges = GAUGE * np.arange(math.ceil(strip.low / GAUGE), math.floor(strip.high / GAUGE) + 1)
    if gauges.size != 1:
        raise ArithmeticError(f"{gauges.size} thicknesses of the series fit, not one")
    thickness = round(float(gauges[0]), 9)
    leaf = joint(thickness=thickness)
    shortest = shortest_length(thickness=thickness)
    end = answer(leaf, deflection=paper.DEFLECTION_LIMIT, length=shortest)
    at_six = float(answer(joint(), deflection=paper.DEFLECTION_LIMIT, length=paper.LENGTH_MIN).torque)
    moment = paper.WIDTH * paper.THICKNESS**3  # torque and stiffness are proportional to b h^3
    softness = (moment * SOFTEST[0] / _softness(), moment * SOFTEST[1] / _softness())
    return Evidence(
        repairs=repairs,
        softness_demand=softness,
        torque_demand=(moment * TORQUE[0] / at_six, moment * TORQUE[1] / at_six),
        pairs=tuple((h, softness[0] / h**3, softness[1] / h**3) for h in GAUGE * np.arange(4, 21)),
        thickness=thickness,
        shortest_length=shortest,
        softest=_softness(thickness=thickness),
        deflection_at_nine_degrees=deflection_at_rotation(paper.ROTATION_DESIGN, length=paper.LENGTH_MAX),
        test_length=_solve(
            lambda length: float(answer(leaf, deflection=0.0, length=length).stiffness),
            paper.TEST_STIFFNESS,
            1e-3,
            paper.LENGTH_MAX,
        ),
        rotation=float(end.rotation),
        stress=float(end.stress),
    )
