"""The straight line that stands for a groove (Wang et al. 2024, Eq. 16)."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from varistiff.actuators.groove import Groove
from varistiff.dynamics.control.checks import check_range, is_traced
from varistiff.dynamics.control.controller import Number, as_scalar

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)  # exact to rounding for a circular arc
_SAMPLES = np.linspace(-1.0, 1.0, 1001)


class StraightLine(NamedTuple):
    """l_1 = p a + q, and how far from it the groove is at most on the fitted range."""

    slope: Number  # p [m/rad]
    intercept: Number  # q [m]
    error: Number  # the largest |p a + q - l_1(a)| [m]


def straight_line(groove: Groove, angle_min: Number, angle_max: Number) -> StraightLine:
    """Least squares line l_1 = p a + q over the disc angles from ``angle_min`` to ``angle_max`` [rad].

    The paper prints neither p and q nor how they were found; the mean square of the error in l_1, uniform over the
    angle, is minimised here.

    Raises
    ------
    InputError : the range is empty
    """
    check_range("angle", angle_min, angle_max)
    middle, half = 0.5 * as_scalar(angle_min + angle_max), 0.5 * as_scalar(angle_max - angle_min)
    lengths = groove.active_length(middle + half * _NODES)
    # the first two Legendre coefficients
    mean = 0.5 * jnp.sum(_WEIGHTS * lengths)
    tilt = 1.5 * jnp.sum(_WEIGHTS * _NODES * lengths)
    slope = tilt / half
    intercept = mean - slope * middle
    error = mean + tilt * _SAMPLES - groove.active_length(middle + half * _SAMPLES)
    found = (slope, intercept, jnp.max(jnp.abs(error)))
    # plain numbers where they are known: they are handed over faster, run by run
    return StraightLine(*(value if is_traced(value) else float(value) for value in found))
