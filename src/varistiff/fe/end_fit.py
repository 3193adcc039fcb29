"""The end model of a torsion element, fitted to three-dimensional results."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import least_squares

from varistiff.core.errors import InputError
from varistiff.elastic.end_effect import EndEffect

ENOUGH = 0.001  # relative; a solid's own error is of this size


@dataclass(frozen=True)
class EndFit:
    """An end effect and how well it meets the results that it was fitted to.

    Parameters
    ----------
    effect : the fitted ``EndEffect``
    residual : largest relative difference of the stiffness at the fitted points
    """

    effect: EndEffect
    residual: float

    @property
    def lock_length(self) -> float:
        """Effective length at an active length of zero [m]."""
        return self.effect.offset + self.effect.lock_offset


def fit_end_effect(*, active_length: ArrayLike, stiffness: ArrayLike, rigidity: float) -> EndFit:
    """Fit k = G J/(x + offset + lock_offset exp(-x/decay)) to stiffness over active length.

    Parameters
    ----------
    active_length : x [m], shape (n,), n >= 4, different and not negative
    stiffness : of the element alone, nothing in series [N m/rad], shape (n,)
    rigidity : G J of section theory [N m^2], which is not fitted: from k(x) alone it could not be told from the rest

    Relative differences of the stiffness are minimised, so every length counts alike. Where the offset alone meets
    every point to ``ENOUGH``, or with four points only, ``lock_offset`` is 0. A compliance in series
    with the element has the same effect as the offset, and cannot be told from it either; give it as
    ``series_stiffness``.

    Raises
    ------
    InputError : too few points, or no positive effective length fits
    """
    x, k = np.asarray(active_length, float), np.asarray(stiffness, float)
    if np.unique(x).size < 4:
        raise InputError(f"the end model needs results at 4 settings or more, not {np.unique(x).size}", field="setting")
    added = rigidity / k - x
    far = float(added[np.argmax(x)])
    near = float(added[np.argmin(x)]) - far

    def residual(p: NDArray[np.float64]) -> NDArray[np.float64]:
        length = x + p[0] + p[1] * np.exp(-x / p[2])
        return np.log(np.maximum(length, 1e-12) * k / rigidity)

    span = float(x.max() - x.min())
    low, high = [-np.inf, -np.inf, 1e-3 * span], [np.inf, np.inf, 0.5 * span]
    alone = least_squares(lambda p: residual(np.array([p[0], 0.0, span])), [far], x_scale=span)
    if x.size < 5 or float(np.abs(alone.fun).max()) <= ENOUGH:  # three numbers cannot be held against four points
        return _fit(x, k, rigidity, float(alone.x[0]), 0.0, span)
    starts = [np.array([far, near, share * span]) for share in (0.01, 0.03, 0.1, 0.3)]
    scale = [span, span, span]
    found = min(
        (least_squares(residual, start, bounds=(low, high), x_scale=scale) for start in starts),
        key=lambda one: float(one.cost),
    )
    return _fit(x, k, rigidity, *(float(value) for value in found.x))


def _fit(
    x: NDArray[np.float64], k: NDArray[np.float64], rigidity: float, offset: float, lock_offset: float, decay: float
) -> EndFit:
    effect = EndEffect(
        offset=offset, lock_offset=lock_offset, decay=decay, shortest=float(x.min()), longest=float(x.max())
    )
    length = x + offset + lock_offset * np.exp(-x / decay)
    if not np.all(length > 0.0):
        raise InputError("no end model with a positive effective length fits the results", field="end_model")
    return EndFit(effect, float(np.abs(rigidity / length / k - 1.0).max()))
