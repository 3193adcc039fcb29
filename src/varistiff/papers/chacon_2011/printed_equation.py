"""The differential equation in Cartesian coordinates: as printed, and with the right sign.

The curvature of a curve y(x) is y''/(1 + y'^2)^(3/2). The paper prints y''/(1 - y'^2)^(3/2), the sign of the
arc-length form, where Y' is a sine.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from scipy.optimize import brentq

from varistiff.core.errors import InputError
from varistiff.papers.chacon_2011.devices import law, leaf, states
from varistiff.papers.chacon_2011.paper_values import ASPECT_RATIO_SOFT, ASPECT_RATIO_STIFF, CLAMP_HEIGHT
from varistiff.papers.chacon_2011.shapes import end_curvature

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(60)
_PART, _WEIGHT = 0.5 * (_NODES + 1.0), 0.5 * _WEIGHTS  # u = x/x_f


def bracket_departure(*, aspect_ratio: float, sign: float) -> float:
    """How far y''/(1 + sign y'^2)^(3/2) of the printed closed form is from a straight line, over its largest value.

    Zero means that the closed form solves the differential equation with this sign (printed: -1). y' and y'' follow
    from sin(theta) = a (x^2 - x_f x); a from the end curvature a x_f of the project's leaf.
    """
    bend = float(end_curvature(states("guided", 0.0, aspect_ratio))) * aspect_ratio * CLAMP_HEIGHT  # a x_f^2
    u = np.linspace(0.0, 1.0, 201)
    sine, rate = bend * (u * u - u), bend * (2.0 * u - 1.0)
    slope, second = sine / np.sqrt(1.0 - sine**2), rate / (1.0 - sine**2) ** 1.5
    bracket = second / (1.0 + sign * slope**2) ** 1.5
    straight = bracket[0] + (bracket[-1] - bracket[0]) * u
    return float(np.max(np.abs(bracket - straight)) / np.max(np.abs(bracket)))


def closed_form_margin(*, aspect_ratio: float) -> float:
    """Margin of "the closed form solves the printed equation" [-]: rounding minus its departure."""
    return 1e-6 - bracket_departure(aspect_ratio=aspect_ratio, sign=-1.0)


def _slopes(load: float) -> tuple[np.ndarray, np.ndarray]:
    """|y'| and |y''| x_f of a solution of the printed equation: y'/sqrt(1 - y'^2) = load (u - u^2)."""
    ramp = load * (_PART - _PART**2)
    root = np.sqrt(1.0 + ramp**2)
    return ramp / root, np.abs(load * (1.0 - 2.0 * _PART)) / root**3


def rise_over_span(load: float) -> float:
    """Rise over span of the printed equation's solution at its parameter: below 1 however large that is."""
    return float(_WEIGHT @ _slopes(load)[0])


def printed_load(aspect_ratio: float) -> float:
    """Parameter of the printed equation's solution between horizontal ends.

    Raises
    ------
    InputError : an aspect ratio of 1 or less; |y'| < 1 everywhere then leaves the rise out of reach

    >>> round(printed_load(3.5), 3)
    1.831
    """
    if not aspect_ratio > 1.0:
        raise InputError(f"{aspect_ratio:g}: as printed the equation has solutions above 1 only", field="aspect_ratio")

    def miss(load: float) -> float:
        return rise_over_span(load) - 1.0 / aspect_ratio

    return float(brentq(miss, 0.0, 50.0 / (1.0 - 1.0 / aspect_ratio) ** 2, xtol=1e-13))


def printed_energy(aspect_ratio: float) -> float:
    """U y_f/EI of the shape that solves the printed equation, with the true curvature [-]."""
    slope, second = _slopes(printed_load(aspect_ratio))
    return 0.5 * float(_WEIGHT @ (second**2 / (1.0 + slope**2) ** 2.5)) / aspect_ratio


@cache
def printed_variation() -> float:
    """Increase of the stiffness at rest over the prototype's range, with the printed equation's shapes [-].

    >>> round(printed_variation(), 2)
    17.09
    """
    step = 0.02 * np.arange(-3, 4)
    weights = np.array([2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0])  # second derivative, sixth order
    soft, stiff = (
        float(weights @ [printed_energy(ratio + float(offset)) for offset in step])
        for ratio in (ASPECT_RATIO_SOFT, ASPECT_RATIO_STIFF)
    )
    return stiff / soft - 1.0


def printed_shape(aspect_ratio: float, points: int = 101) -> np.ndarray:
    """Points (N, 2) of the printed equation's solution over x_f and y_f, from the roller to the clamp."""
    load = printed_load(aspect_ratio)
    u = np.linspace(0.0, 1.0, points)
    inner = u[:-1, None] + np.diff(u)[:, None] * _PART
    ramp = load * (inner - inner**2)
    steps = np.diff(u) * ((ramp / np.sqrt(1.0 + ramp**2)) @ _WEIGHT)
    height = np.concatenate([[0.0], np.cumsum(steps)])
    return np.stack([u, height / height[-1]], axis=1)


def shape_error(*, aspect_ratio: float) -> float:
    """Largest vertical distance [m] of the printed equation's shape from the closed form."""
    paper = law("guided").centreline(leaf(), aspect_ratio * CLAMP_HEIGHT, CLAMP_HEIGHT, 401)
    printed = printed_shape(aspect_ratio, 401)
    height = np.interp(paper[:, 0] / (aspect_ratio * CLAMP_HEIGHT), printed[:, 0], printed[:, 1])
    return float(np.max(np.abs(CLAMP_HEIGHT * height - paper[:, 1])))
