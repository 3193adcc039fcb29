"""What Section 4 of Wang et al. (2024) says, computed with the stored sets.

Every function returns SI numbers (shares are 1.0 for 100 %) of runs that are simulated once. A function whose name ends
in ``margin`` belongs to a statement in words and is positive where that is true.
"""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.section_4 import POSITION_SETS, position_set, setting_set
from varistiff.papers.wang_2024.section_4_cases import CENTRE, LENGTH_MAX, LENGTH_MIN, stiffness_at
from varistiff.papers.wang_2024.section_4_measures import step_numbers, stiffness_course
from varistiff.papers.wang_2024.section_4_runs import (
    PositionFacts,
    SettingFacts,
    position_courses,
    position_facts,
    setting_facts,
    setting_runs,
)

FIRST_PRINTED = math.radians(11.0)  # without load
FIRST_PRINTED_LOADED = math.radians(13.0)
LATER_PRINTED = math.radians(6.0), math.radians(4.0)  # without and with load, in the printed order
ALMOST = 0.1  # what "almost the same" and "ignored" may leave, as a share


class PositionRun(NamedTuple):
    """Courses of link and drive of one set, shape (6, 2, 3001) [rad], and their facts."""

    courses: np.ndarray
    facts: PositionFacts


class SettingRun(NamedTuple):
    """Disc angle and deflection without and with load, shapes (2, 2, samples) [rad], and their facts."""

    steps: np.ndarray
    sines: np.ndarray
    facts: SettingFacts


@cache
def position_runs() -> dict[str, PositionRun]:
    """Every position test of every stored set, by set."""
    sets = [position_set(name) for name in POSITION_SETS]
    courses = position_courses(np.array(sets))
    runs = zip(POSITION_SETS, sets, courses, strict=True)
    return {name: PositionRun(own, position_facts(values, own)) for name, values, own in runs}


@cache
def setting_run() -> SettingRun:
    """The stiffness tests with the stored gains, while the position moves by the set ``steps``."""
    steps, sines = setting_runs(position_set("steps"), np.array([setting_set()]))
    return SettingRun(steps[0], sines[0], setting_facts(steps[0], sines[0]))


def position_fact(*, name: str, fact: str) -> float:
    """One of ``PositionFacts`` of one stored set."""
    return float(getattr(position_runs()[name].facts, fact))


def setting_fact(*, fact: str) -> float:
    """One of ``SettingFacts``."""
    return float(getattr(setting_run().facts, fact))


def load_slows_margin(*, name: str) -> float:
    """Smallest of the four rises of overshoot and settling time by load, each as a share of its value without load."""
    facts = position_runs()[name].facts
    return min(
        facts.small_overshoot_by_load / facts.small_overshoot,
        facts.small_settling_by_load / facts.small_settling,
        facts.large_overshoot_by_load / facts.large_overshoot,
        facts.large_settling_by_load / facts.large_settling,
    )


def lever_speed_margin() -> float:
    """A tenth minus the change of the lever's settling time by load, as a share of that time."""
    facts = setting_run().facts
    return ALMOST - abs(facts.regulation_time_loaded / facts.regulation_time - 1.0)


def lever_overshoot_change() -> float:
    """Overshoot of the lever with load minus that without, as a share of its stroke."""
    facts = setting_run().facts
    return facts.lever_overshoot_loaded - facts.lever_overshoot


def lever_overshoot_margin() -> float:
    """A tenth of the stroke minus the change of the lever's overshoot by load."""
    return ALMOST - abs(lever_overshoot_change())


def first_error_margin(*, name: str) -> float:
    """Largest error at first minus the later one, the smaller of without and with load [rad]."""
    facts = position_runs()[name].facts
    return min(facts.first_error - facts.later_error, facts.first_error_loaded - facts.later_error_loaded)


def spring_share_margin() -> float:
    """Deflection limit of Table 2 minus half of the printed first error [rad]: above zero the spring could be most."""
    return paper.DEFLECTION_LIMIT - 0.5 * FIRST_PRINTED


def printed_order_margin() -> tuple[float, float]:
    """Error with load minus that without, as printed [rad]: of the later errors, and of the first ones."""
    return LATER_PRINTED[1] - LATER_PRINTED[0], FIRST_PRINTED_LOADED - FIRST_PRINTED


def good_tracking_margin() -> float:
    """A tenth of the amplitude less the printed later error without load [rad]."""
    return 0.1 * paper.POSITION_AMPLITUDE - LATER_PRINTED[0]


def later_error_by_load(*, name: str) -> float:
    """Later error with load minus that without [rad]."""
    facts = position_runs()[name].facts
    return facts.later_error_loaded - facts.later_error


def deflection_largest(*, name: str) -> float:
    """Largest elastic deflection in the sine with load [rad]."""
    link, drive = position_runs()[name].courses[-1]
    return float(np.abs(drive - link).max())


def stiffness_by_load_margin() -> float:
    """A tenth minus what the load adds to the stiffness error, as a share of the mean stiffness."""
    facts = setting_run().facts
    return ALMOST - (facts.stiffness_error_loaded - facts.stiffness_error) / CENTRE


def stiffness_settling() -> float:
    """Time [s] in which the stiffness itself, not the lever, comes to stay within 2 % of its step; NaN for never."""
    course = stiffness_course(*setting_run().steps[0])
    return step_numbers(course, stiffness_at(LENGTH_MAX), stiffness_at(LENGTH_MIN)).settling
