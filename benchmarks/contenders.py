"""What a user would write instead: the paper's algorithm, a vectorised Newton, a boundary-value solver.

All take a point contact at the given centre, with the roller's radius, and return the slope at the contact.
"""

from __future__ import annotations

import warnings

import numpy as np
from scipy.integrate import quad, solve_bvp
from scipy.optimize import fsolve
from scipy.special import elliprd

LEMNISCATE = 2.6220575542921198


def quad_and_fsolve(x: float, y: float, radius: float) -> float:
    """Algorithm 1 of dos Santos and Richter (2019): n = tan(theta_0), integrals by quad, fsolve; NaN on failure."""

    def mismatch(unknown: np.ndarray) -> float:
        top = float(unknown[0])
        n = np.tan(top)

        def root(angle: float) -> float:
            return np.sqrt(-np.sin(angle) + n * np.cos(angle))

        a = quad(lambda angle: np.cos(angle) / root(angle), 0.0, top)[0]
        b = quad(lambda angle: np.sin(angle) / root(angle), 0.0, top)[0]
        return b / a - (y + radius * np.cos(top)) / (x - radius * np.sin(top))

    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        found, _, flag, _ = fsolve(mismatch, [1.2 * np.arctan2(y, x)], full_output=True)
    return float(found[0]) if flag == 1 else float("nan")


def carlson_newton(x: np.ndarray, y: np.ndarray, radius: np.ndarray, steps: int = 12) -> np.ndarray:
    """Vectorised Newton on the contact condition with SciPy's Carlson integral R_D."""
    slope = np.clip(1.5 * np.arctan2(y + radius, x), 1e-6, 2.6)
    for _ in range(steps):
        bent = np.minimum(slope, np.pi - slope)
        s, c = np.sin(slope), np.cos(slope)
        near = 2.0 / 3.0 * s**1.5 * elliprd(1.0 - np.sin(bent), 1.0 + np.sin(bent), 1.0)
        second = np.where(slope > 0.5 * np.pi, 2.0 * np.pi / LEMNISCATE - near, near)
        h = second / (2.0 * np.sqrt(s))
        along, across = x * c + y * s, x * s - y * c
        g = across - radius - along * h
        slope = np.clip(slope - g / (along + across * h - along * (0.5 - 0.5 * h * c / s)), 1e-6, 3.0)
    return slope


def boundary_value(x: float, y: float, radius: float) -> float:
    """Rod ODE with unknown length and force by solve_bvp, tolerance 1e-8; NaN on failure."""
    guess = 1.5 * np.arctan2(y + radius, x)
    s = np.linspace(0.0, 1.0, 30)

    def rod(_: np.ndarray, state: np.ndarray, unknown: np.ndarray) -> np.ndarray:
        length, force, tip = unknown
        angle, moment = state[2], state[3]
        # the force is normal to the tip: its moment changes with the cosine of what is left to turn
        return length * np.stack([np.cos(angle), np.sin(angle), moment, -force * np.cos(tip - angle)])

    def ends(a: np.ndarray, b: np.ndarray, unknown: np.ndarray) -> np.ndarray:
        contact_x, contact_y = x - radius * np.sin(b[2]), y + radius * np.cos(b[2])
        return np.array([*a[:3], b[3], b[0] - contact_x, b[1] - contact_y, b[2] - unknown[2]])

    start = np.stack([x * s, y * s**2, guess * (2 * s - s**2), 2 * guess / x * (1 - s)])
    with np.errstate(all="ignore"):
        unknown = [np.hypot(x, y), 2 * guess / x**2, guess]
        solution = solve_bvp(rod, ends, s, start, p=unknown, tol=1e-8, max_nodes=5000)
    return float(solution.y[2, -1]) if solution.success else float("nan")
