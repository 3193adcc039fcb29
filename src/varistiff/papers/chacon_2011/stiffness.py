"""Force and stiffness of the prototype: figures 7 and 8, and the variation of 1500 %."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from varistiff.core.status import Status
from varistiff.papers.chacon_2011.devices import Theory, aspect_ratios, ends, states
from varistiff.papers.chacon_2011.paper_values import ASPECT_RATIO_SOFT, ASPECT_RATIO_STIFF, CLAMP_HEIGHT

_FIRST = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12.0  # first derivative, fourth order


def rest_stiffness(*, theory: Theory) -> tuple[float, float]:
    """Tangent stiffness at rest [N/m] at the softest and the stiffest aspect ratio of the prototype."""
    soft, stiff = states(theory, 0.0, ends()).stiffness
    return float(soft), float(stiff)


def variation(*, theory: Theory) -> float:
    """Increase of the stiffness at rest over the prototype's range of aspect ratios, over the lower one [-].

    >>> round(variation(theory="linear"), 3)
    15.413
    """
    soft, stiff = rest_stiffness(theory=theory)
    return stiff / soft - 1.0


@cache
def elastic_variation(*, theory: Theory) -> float:
    """Largest stiffness over the least - 1 among all states of the prototype's range in which no leaf yields.

    Every displacement counts, not only rest: a grid over both, and a finer one of aspect ratios around its largest.
    """
    ratios, displacement = aspect_ratios(181), np.linspace(0.0, ASPECT_RATIO_STIFF * CLAMP_HEIGHT, 61)[:-1]
    coarse = _elastic_stiffness(theory, displacement[:, None], ratios)  # mirror images left out
    row, column = np.unravel_index(np.argmax(np.nan_to_num(coarse)), coarse.shape)
    step = ratios[0] - ratios[1]
    near = np.clip(ratios[column] + np.linspace(-step, step, 4001), ASPECT_RATIO_STIFF, ASPECT_RATIO_SOFT)
    fine = _elastic_stiffness(theory, displacement[row], near)
    return float(np.nanmax(fine) / np.nanmin(coarse) - 1.0)


def _elastic_stiffness(theory: Theory, displacement: ArrayLike, ratios: np.ndarray) -> np.ndarray:
    found = states(theory, displacement, ratios)
    return np.where(found.status == Status.OK, found.stiffness, np.nan)


def variation_over_readings() -> tuple[float, float]:
    """Increase of the stiffness over the lowest one [-], in two readings of a range that is not printed.

    By the paper's model over its elastic states; and of exact leaves on the printed cylinders, which do not yield, at a
    displacement of 10 mm and the stiffest aspect ratio, over rest at the softest one.
    """
    soft, _ = rest_stiffness(theory="wrapped")
    bent = states("wrapped", 0.01, ASPECT_RATIO_STIFF)
    return elastic_variation(theory="guided"), float(bent.stiffness) / soft - 1.0


def range_margin() -> float:
    """Margin of "the prototype can show the model's range" [N/m]: its smaller overlap over the model's, at both ends.

    The prototype has exact leaves on cylinders; both at rest.
    """
    (low, high), (soft, stiff) = (rest_stiffness(theory=one) for one in ("guided", "wrapped"))
    return min(low - soft, stiff - high)


def derivatives_margin() -> float:
    """Margin of "force and stiffness are derivatives of the energy" [-]: 1e-5 minus the largest relative error.

    Energy and force are differenced to fourth order. The force vanishes at rest, so its error counts against the
    stiffness times a hundredth of a metre. The wrapped leaf lies on its cylinders in all states.
    """
    displacement, worst = np.array([0.0, 0.001, 0.002]), 0.0
    cases: tuple[tuple[Theory, np.ndarray, float], ...] = (
        ("guided", aspect_ratios(7), 1e-4),
        ("sliding", aspect_ratios(7), 1e-4),
        ("wrapped", np.array([1.85, 1.8]), 1e-5),
    )
    for theory, ratios, step in cases:
        offsets = step * np.arange(-2, 3)[:, None, None]
        found = states(theory, displacement[:, None] + offsets, ratios)
        here = (found.load[2], found.stiffness[2])
        load, rate = (np.tensordot(_FIRST, values, 1) / step for values in (found.energy, found.load))
        worst = max(worst, float(np.max(np.abs(load - here[0]) / (0.01 * np.abs(here[1])))))
        worst = max(worst, float(np.max(np.abs(rate / here[1] - 1.0))))
    return 1e-5 - worst


def force_at(*, theory: Theory, displacement: float) -> tuple[float, float]:
    """Force [N] at a displacement [m], at the softest and the stiffest aspect ratio of the prototype."""
    soft, stiff = states(theory, displacement, ends()).load
    return float(soft), float(stiff)


def nonlinearity() -> float:
    """Margin of a force that is not linear: least growth of the stiffness over that at rest, off rest [-].

    Displacements from a hundredth of the rise to as much as the rise, over the prototype's range.
    """
    displacement = CLAMP_HEIGHT * np.concatenate([[0.0], np.geomspace(0.01, 1.0, 30)])
    stiffness = states("guided", displacement[:, None], aspect_ratios(31)).stiffness
    return float(np.min((stiffness[1:] - stiffness[0]) / np.abs(stiffness[0])))


def error_of_linear_theory(*, allowed: float) -> float:
    """Margin of "the curvature cannot be linearised": relative error of the stiffest stiffness - allowed [-]."""
    return rest_stiffness(theory="linear")[1] / rest_stiffness(theory="guided")[1] - 1.0 - allowed
