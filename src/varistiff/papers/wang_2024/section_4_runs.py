"""The simulations of Section 4 in batches, and the facts that follow from them."""

from __future__ import annotations

from typing import Any, NamedTuple

import jax
import numpy as np

from varistiff.dynamics.program import run
from varistiff.papers.wang_2024.section_4_cases import AMPLITUDE, PositionSet, SettingSet, position_case, stiffness_case
from varistiff.papers.wang_2024.section_4_measures import (
    POSITION_SAMPLES,
    SETTING_SAMPLES,
    length_course,
    lever_numbers,
    sine_numbers,
    step_numbers,
    stiffness_course,
    stiffness_numbers,
)

_POSITION, _SETTING = len(PositionSet._fields), len(SettingSet._fields)
RUNS = ("small", "small_loaded", "large", "large_loaded", "sine", "sine_loaded")


class PositionFacts(NamedTuple):
    """What Figs. 16 and 18a, b show of one set: shares, seconds and radians; NaN where a run does not settle.

    ``..._by_load`` is with load minus without it, ``..._by_stroke`` large stroke minus small one without load.
    """

    small_overshoot: float
    small_settling: float
    large_overshoot: float
    large_settling: float
    small_overshoot_by_load: float
    small_settling_by_load: float
    large_overshoot_by_load: float
    large_settling_by_load: float
    overshoot_by_stroke: float
    settling_by_stroke: float
    first_error: float
    first_error_loaded: float
    later_error: float
    later_error_loaded: float


class SettingFacts(NamedTuple):
    """What Figs. 17 and 18c show of one set: shares, seconds and N m/rad; NaN where a run does not settle."""

    regulation_time: float
    regulation_time_loaded: float
    lever_overshoot: float
    lever_overshoot_loaded: float
    stiffness_error: float
    stiffness_error_loaded: float


@jax.jit
def _links(rows: Any) -> Any:
    """Courses of link and drive of position tests, shape (run, 2, sample), one run after the other."""

    def one(row: Any) -> Any:
        own = PositionSet(*row[:_POSITION])
        loaded, step, sine = row[_POSITION:]
        motion = run(position_case(own, loaded=loaded, step=step, sine=sine), POSITION_SAMPLES, 1, ()).state.motion
        return jax.numpy.stack([motion.link, motion.drive])

    return jax.lax.map(one, rows)


def position_courses(sets: np.ndarray, tests: tuple[str, ...] = RUNS) -> np.ndarray:
    """Courses of link and drive [rad] of the six position tests of each set.

    Parameters
    ----------
    sets : numbers of ``PositionSet``, shape (set, 10)
    tests : which of ``RUNS`` to run; the others stay zero

    Returns
    -------
    Shape (set, 6, 2, 3001): the tests in the order of ``RUNS``, link and drive.
    """
    rows = np.zeros((len(sets), len(RUNS), _POSITION + 3))
    rows[..., :_POSITION] = sets[:, None]
    rows[:, 1::2, _POSITION] = 1.0
    rows[:, 0:2, _POSITION + 1] = sets[:, None, PositionSet._fields.index("small")]
    rows[:, 2:4, _POSITION + 1] = sets[:, None, PositionSet._fields.index("large")]
    rows[:, 4:6, _POSITION + 2] = AMPLITUDE
    chosen = [RUNS.index(test) for test in tests]
    courses = np.zeros((len(sets), len(RUNS), 2, POSITION_SAMPLES))
    links = np.asarray(_links(rows[:, chosen].reshape(-1, rows.shape[-1])))
    courses[:, chosen] = links.reshape(len(sets), len(chosen), 2, -1)
    return courses


def position_facts(own: PositionSet, courses: np.ndarray) -> PositionFacts:
    """Facts of one set from its courses, shape (6, 2, 3001)."""
    links = courses[:, 0]
    if not np.isfinite(links).all():
        return PositionFacts(*[np.nan] * len(PositionFacts._fields))
    strokes = (own.small, own.small, own.large, own.large)
    small, small_loaded, large, large_loaded = (
        step_numbers(link, 0.0, stroke) for link, stroke in zip(links[:4], strokes, strict=True)
    )
    free, loaded = sine_numbers(links[4]), sine_numbers(links[5])
    return PositionFacts(
        small.overshoot,
        small.settling,
        large.overshoot,
        large.settling,
        small_loaded.overshoot - small.overshoot,
        small_loaded.settling - small.settling,
        large_loaded.overshoot - large.overshoot,
        large_loaded.settling - large.settling,
        large.overshoot - small.overshoot,
        large.settling - small.settling,
        free.first,
        loaded.first,
        free.later,
        loaded.later,
    )


def setting_runs(own: PositionSet, sets: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Courses of the stiffness tests without and with load, of each set of gains.

    Parameters
    ----------
    own : what the position does meanwhile
    sets : numbers of ``SettingSet``, shape (set, 5)

    Returns
    -------
    Steps and sines, of shapes (set, 2, 2, samples): disc angle and deflection [rad].
    """
    loads = np.tile([0.0, 1.0], len(sets))
    rows = np.column_stack([np.repeat(sets, 2, axis=0), loads])
    tests = np.concatenate([np.column_stack([rows, np.full(len(rows), sine)]) for sine in (0.0, 1.0)])
    courses = np.asarray(_settings(np.array(own), tests))
    steps, sines = courses.reshape(2, len(sets), 2, 2, -1)
    return steps, sines


@jax.jit
def _settings(own: Any, rows: Any) -> Any:
    """Courses of disc angle and deflection of stiffness tests, shape (run, 2, sample)."""

    def one(row: Any) -> Any:
        loaded, sine = row[_SETTING:]
        case = stiffness_case(PositionSet(*own), SettingSet(*row[:_SETTING]), loaded=loaded, sine=sine)
        motion = run(case, SETTING_SAMPLES, 2, ()).state.motion  # two steps a period: up to 1200 rad/s at 6 mm
        return jax.numpy.stack([motion.motion, motion.drive - motion.link])

    return jax.lax.map(one, rows)


def setting_facts(steps: np.ndarray, sines: np.ndarray) -> SettingFacts:
    """Facts of one set from its courses, shapes (2, 2, samples): without and with load, disc angle and deflection."""
    if not (np.isfinite(steps).all() and np.isfinite(sines).all()):
        return SettingFacts(*[np.nan] * len(SettingFacts._fields))
    free, loaded = (lever_numbers(length_course(motion)) for motion, _ in steps)
    errors = [stiffness_numbers(stiffness_course(*course)).first for course in sines]
    return SettingFacts(free.settling, loaded.settling, free.overshoot, loaded.overshoot, *errors)
