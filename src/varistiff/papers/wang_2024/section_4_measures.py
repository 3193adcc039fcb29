"""What is read off the courses of the Section 4 simulations."""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from varistiff.dynamics.response_metrics import step_metrics
from varistiff.papers.wang_2024.section_4_cases import (
    AMPLITUDE,
    CENTRE,
    FREQUENCY,
    LENGTH_MAX,
    LENGTH_MIN,
    PERIOD,
    STEP_TIME,
    SWING,
    groove,
    joint,
)

POSITION_SAMPLES, SETTING_SAMPLES = 3001, 1501  # of the position tests, of the stiffness tests
STEP_SAMPLES = 2101  # in which a step of the position has to settle


class StepNumbers(NamedTuple):
    """Overshoot as a share of the step, and time until it stays within 2 % [s]; NaN where it does not."""

    overshoot: float
    settling: float


class ErrorNumbers(NamedTuple):
    """Largest error at first and later, in the unit of the course."""

    first: float
    later: float


def instants(samples: int) -> np.ndarray:
    """Sample instants [s]."""
    return np.arange(samples) * PERIOD


def step_numbers(course: np.ndarray, before: float, after: float) -> StepNumbers:
    """Overshoot and settling of a course, shape (n,), that follows a step at ``STEP_TIME``."""
    course = course[:STEP_SAMPLES]
    time = instants(course.size)
    found = step_metrics(time, np.where(time < STEP_TIME, before, after), course, "1", "course")
    settled, over = found["course_settling_time"].value, found["course_overshoot"].value
    assert over is not None  # there is a step
    return StepNumbers(over / 100.0, math.nan if settled is None else settled)


def lever_numbers(length: np.ndarray) -> StepNumbers:
    """Of the slider on its way from 25 mm to 6 mm; active lengths [m] of shape (n,)."""
    return step_numbers(length, LENGTH_MAX, LENGTH_MIN)


def wave(samples: int) -> np.ndarray:
    """sin(2 pi f t) with the paper's frequency."""
    return np.sin(2.0 * math.pi * FREQUENCY * instants(samples))


def sine_numbers(link: np.ndarray) -> ErrorNumbers:
    """Largest position error [rad] in the first half second and in the third second; positions of shape (3001,)."""
    error = np.abs(link - AMPLITUDE * wave(link.size))
    return ErrorNumbers(float(error[: round(0.5 / PERIOD) + 1].max()), float(error[-round(1.0 / PERIOD) - 1 :].max()))


def stiffness_numbers(stiffness: np.ndarray) -> ErrorNumbers:
    """Largest stiffness error [N m/rad] in the whole run and after its first second; shape (n,)."""
    error = np.abs(stiffness - CENTRE - SWING * wave(stiffness.size))
    return ErrorNumbers(float(error.max()), float(error[round(1.0 / PERIOD) :].max()))


def length_course(motion: np.ndarray) -> np.ndarray:
    """Active length [m] at disc angles [rad]."""
    return np.asarray(groove().active_length(jnp.asarray(motion)))


def stiffness_course(motion: np.ndarray, deflection: np.ndarray) -> np.ndarray:
    """Tangent stiffness by Eq. (9) [N m/rad] at disc angles and deflections [rad], all of shape (n,)."""
    return np.asarray(joint().respond(jnp.asarray(deflection), jnp.asarray(length_course(motion)))[0].stiffness)
