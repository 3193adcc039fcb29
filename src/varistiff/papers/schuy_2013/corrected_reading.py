"""The reading under which the paper's numbers agree: found by a search, kept in ``corrected_reading.yaml``."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from importlib import resources

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.design.design import Design, load
from varistiff.papers.registry import paper_file
from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013.device import bare_tube, stiffness
from varistiff.papers.schuy_2013.rails import height_of_factor
from varistiff.papers.schuy_2013.table_one import Interval, common_modulus, overlap

RAIL_WIDTH = 0.007  # m, assumed; solid.widths_that_meet_excess tells what supports it
_LAST_STIFFNESS = 0.005  # N m/rad, half a unit of the last digit of 53.13 and 71.56
_LAST_CROSSING = 0.005  # m, of 0.04 m


@dataclass(frozen=True)
class Reading:
    """What the search finds, SI; an interval is everything that rounds to the printed digits.

    Parameters
    ----------
    modulus_of_table : G that meets all four dimensions of Table I, cylinder hollow
    modulus_of_table_solid : the same with a solid cylinder; None, there is none
    modulus_of_prototype : G for which the prototype has 53.13 N m/rad at the longest tested length
    modulus_at_printed_length : the same at the printed length l of the element
    modulus_interval : what the first and the third have in common
    shear_modulus, bore_radius : the roundest numbers in their intervals
    section_factor, series_stiffness : J with rails over J without, and the rest of the drive train, from
        71.56 N m/rad and the crossing at 0.04 m
    section_factor_interval, series_stiffness_interval : over the last digit of the crossing
    rail_height : with which rails of ``RAIL_WIDTH`` have this section factor
    """

    modulus_of_table: Interval | None
    modulus_of_table_solid: Interval | None
    modulus_of_prototype: Interval
    modulus_at_printed_length: Interval
    modulus_interval: Interval
    shear_modulus: float
    bore_radius: float
    section_factor: float
    section_factor_interval: Interval
    series_stiffness: float
    series_stiffness_interval: Interval
    rail_height: float


@cache
def search() -> Reading:
    """Find the parameter values that make Table I, 53.13 N m/rad, 71.56 N m/rad and the crossing at 0.04 m agree.

    Raises
    ------
    ValueError : no shear modulus meets Table I and the prototype
    """
    table, prototype = common_modulus(), modulus_of_prototype(active_length=paper.TESTED_LENGTHS[-1])
    both = None if table is None else overlap([table, prototype])
    if both is None:
        raise ValueError("no shear modulus meets Table I and 53.13 N m/rad")
    modulus = 1e9 * roundest(1e-9 * both[0], 1e-9 * both[1])
    low, high = (paper.OUTER_RADIUS * (paper.RADIUS_RATIO + way * paper.HALF_RATIO) for way in (-1.0, 1.0))
    bore = 1e-3 * roundest(1e3 * low, 1e3 * high)
    rigidity = rigidity_of(shear_modulus=modulus, bore_ratio=bore / paper.OUTER_RADIUS)
    found = [drive_train(rigidity=rigidity, crossing=paper.CROSSING + way * _LAST_CROSSING) for way in (-1.0, 0.0, 1.0)]
    series = float(round(found[1][1]))
    factor = factor_of(rigidity=rigidity, series_stiffness=series)
    return Reading(
        modulus_of_table=table,
        modulus_of_table_solid=common_modulus(ratio=0.0),
        modulus_of_prototype=prototype,
        modulus_at_printed_length=modulus_of_prototype(active_length=paper.ELEMENT_LENGTH),
        modulus_interval=both,
        shear_modulus=modulus,
        bore_radius=bore,
        section_factor=factor,
        section_factor_interval=(found[0][0], found[2][0]),
        series_stiffness=series,
        series_stiffness_interval=(found[2][1], found[0][1]),
        rail_height=height_of_factor(width=RAIL_WIDTH, factor=factor),
    )


def rigidity_of(*, shear_modulus: float, bore_ratio: float) -> float:
    """Return G J of the prototype's tube without rails [N m^2]."""
    tube = bare_tube(shear_modulus=shear_modulus, bore_ratio=bore_ratio, outer_radius=paper.OUTER_RADIUS)
    return stiffness(tube, active_length=1.0)


def modulus_of_prototype(*, active_length: float) -> Interval:
    """Return the shear moduli [Pa] for which the prototype without rails has the printed 53.13 N m/rad at a length.

    Over the last digits of the stiffness and of the ratio of the radii.
    """
    low, high = (
        (paper.ANALYTIC_MIN + way * _LAST_STIFFNESS)
        * active_length
        / rigidity_of(shear_modulus=1.0, bore_ratio=paper.RADIUS_RATIO + way * paper.HALF_RATIO)
        for way in (-1.0, 1.0)
    )
    return low, high


def drive_train(*, rigidity: float, crossing: float) -> tuple[float, float]:
    """Return s and k_series [N m/rad] from 71.56 N m/rad at the longest length and from the crossing [m].

    The measured 1/k = x/(s G J) + 1/k_series equals the analytic x/(G J) at the crossing, and 1/71.56 at the end.
    """
    end = paper.TESTED_LENGTHS[-1]
    s = (end - crossing) / (rigidity / paper.MEASURED_MIN - crossing)
    return s, rigidity / (crossing * (1.0 - 1.0 / s))


def factor_of(*, rigidity: float, series_stiffness: float) -> float:
    """Return s that gives 71.56 N m/rad at the longest length with a given series stiffness [N m/rad]."""
    return paper.TESTED_LENGTHS[-1] / (rigidity * (1.0 / paper.MEASURED_MIN - 1.0 / series_stiffness))


def roundest(low: float, high: float) -> float:
    """Return the number of fewest decimals between two others, the one nearest their middle.

    >>> roundest(0.6289, 0.6312)
    0.63
    """
    for digits in range(16):
        found = round(0.5 * (low + high), digits)
        if low <= found <= high:
            return found
    return math.nan


@cache
def design() -> Design:
    """Return the design of ``corrected_reading.yaml``."""
    with resources.as_file(paper_file("schuy_2013", "corrected_reading.yaml")) as path:
        return load(path)


def prototype() -> TorsionTube:
    """Return the prototype under the corrected reading, with its rails and the rest of the drive train."""
    tube = design().actuator
    assert isinstance(tube, TorsionTube)  # what the file says
    return tube
