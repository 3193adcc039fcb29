"""Root of a few force balances: a damped Newton iteration that stays where the forces are defined."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

Unbalance = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]

_POSITION = 1e-12  # [rad or m] that a position may be off by
_FORCE = 1e-11  # of the stiffness times 1 rad or m, plus the forces that act
_ITERATIONS = 60
_HALVINGS = 40
_LADDER = np.geomspace(1e-6, 10.0, 281)  # distances [rad or m] searched for a change of sign, 6 % apart


class Root(NamedTuple):
    """Unknowns, the largest unbalance left there, and whether that counts as zero."""

    unknowns: np.ndarray
    residual: float
    converged: bool


def balance(unbalance: Unbalance, guess: np.ndarray, scale: float) -> Root:
    """Unknowns at which every unbalance vanishes, near a guess.

    Newton's method with steps halved until the unbalance shrinks; points where it is not a number count as infinitely
    unbalanced. A single unknown that it does not find (a dead band has no slope) is searched for between the nearest
    points of opposite sign.

    Parameters
    ----------
    unbalance : forces left over (n,) and their derivatives with respect to the unknowns (n, n)
    guess : unknowns to start from (n,)
    scale : magnitude of the forces that act [N m or N]
    """
    root = _newton(unbalance, guess, scale)
    if root.converged or guess.size != 1:
        return root
    bracket = _bracket(unbalance, float(guess[0]))
    if bracket is None:
        return root
    found = brentq(lambda x: float(unbalance(np.array([x]))[0][0]), *bracket, xtol=_POSITION, rtol=8.9e-16)
    polished = _newton(unbalance, np.array([found]), scale)
    return polished if polished.converged else root


def _newton(unbalance: Unbalance, guess: np.ndarray, scale: float) -> Root:
    x = np.array(guess, dtype=float)
    forces, slopes = unbalance(x)
    for _ in range(_ITERATIONS):
        if _balanced(forces, slopes, scale) or not _finite(forces, slopes):
            break
        step = np.linalg.lstsq(slopes, -forces, rcond=None)[0]
        moved = _shortened(unbalance, x, step, forces)
        if moved is None:
            break
        x, forces, slopes = moved
    worst = float(np.max(np.abs(forces), initial=0.0))
    return Root(x, worst, bool(_finite(forces, slopes) and _balanced(forces, slopes, scale)))


def _shortened(
    unbalance: Unbalance, x: np.ndarray, step: np.ndarray, forces: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray] | None:
    size = np.linalg.norm(forces)
    for halving in range(_HALVINGS):
        trial = x + 0.5**halving * step
        found, slopes = unbalance(trial)
        if _finite(found, slopes) and np.linalg.norm(found) < size:
            return trial, found, slopes
    return None


def _finite(forces: np.ndarray, slopes: np.ndarray) -> bool:
    return bool(np.isfinite(forces).all() and np.isfinite(slopes).all())


def _balanced(forces: np.ndarray, slopes: np.ndarray, scale: float) -> bool:
    allowed = _FORCE * scale + _POSITION * np.abs(slopes).sum(axis=1)
    return bool((np.abs(forces) <= allowed).all())


def _bracket(unbalance: Unbalance, guess: float) -> tuple[float, float] | None:
    """Neighbouring points between which the unbalance changes sign, the nearest to the guess."""

    def force(x: float) -> float:
        return float(unbalance(np.array([x]))[0][0])

    start = force(guess)
    best: tuple[float, float] | None = None
    for side in (1.0, -1.0):
        before, value = guess, start
        for distance in _LADDER:
            here = guess + side * distance
            now = force(here)
            if np.isfinite(value) and np.isfinite(now) and (value < 0.0) != (now < 0.0):
                if best is None or abs(here - guess) < abs(best[1] - guess):
                    best = (before, here)
                break
            before, value = here, now
    return best
