"""Write ``src/varistiff/elastic/contact_coefficients.json``: the polynomials of the roller contact.

Run with the ``test`` extra installed: ``python tools/contact_coefficients.py``. Everything is computed in 40 digits
from Carlson's integrals; the printed errors are those before rounding to float64.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import mpmath as mp
import numpy as np

mp.mp.dps = 40
TARGET = Path(__file__).parents[1] / "src/varistiff/elastic/contact_coefficients.json"
LEMNISCATE = mp.gamma(mp.mpf(1) / 4) ** 2 / (2 * mp.sqrt(2 * mp.pi))
TOP = (mp.pi / 2) ** 2


def second_integral(t: mp.mpf) -> mp.mpf:
    """I2(t) = int_0^t sqrt(sin psi) dpsi on [0, pi]."""
    if t > mp.pi / 2:
        return 2 * mp.pi / LEMNISCATE - second_integral(mp.pi - t)
    s = mp.sin(t)
    return mp.mpf(2) / 3 * s * mp.sqrt(s) * mp.elliprd(1 - s, 1 + s, 1)


def length(z: mp.mpf) -> mp.mpf:
    """I1/(2 sqrt(sin t)) as a function of z = t^2."""
    s = mp.sin(mp.sqrt(z))
    return mp.elliprf(1 - s, 1 + s, 1)


def offset(z: mp.mpf) -> mp.mpf:
    """I2/(2 t sqrt(sin t)) as a function of z = t^2."""
    t = mp.sqrt(z)
    return second_integral(t) / (2 * t * mp.sqrt(mp.sin(t)))


def power_series(function: Callable[[mp.mpf], mp.mpf], terms: int) -> list[float]:
    """Chebyshev interpolant on [0, (pi/2)^2], rewritten in powers of z."""
    nodes = [mp.cos(mp.pi * (k + mp.mpf(1) / 2) / terms) for k in range(terms)]
    points = [TOP * (x + 1) / 2 for x in nodes]
    matrix = mp.matrix(terms, terms)
    for row, z in enumerate(points):
        for column in range(terms):
            matrix[row, column] = z**column
    solution = mp.lu_solve(matrix, mp.matrix([function(z) for z in points]))
    checks = [TOP * mp.mpf(i) / 97 for i in range(1, 98)]
    error = max(abs(mp.polyval(list(reversed(solution)), z) - function(z)) for z in checks)
    print(f"{function.__name__:8s} {terms} terms, error {mp.nstr(error, 2)}")
    return [float(v) for v in solution]


def centre_angle(t: mp.mpf, epsilon: mp.mpf) -> mp.mpf:
    """Polar angle beta of the roller centre at contact slope t and r/rho = epsilon (the explicit inverse)."""
    gamma = mp.atan(second_integral(t) / (2 * mp.sqrt(mp.sin(t))))
    return t - gamma - mp.asin(epsilon * mp.cos(gamma))


def fold(epsilon: mp.mpf) -> mp.mpf:
    """Contact slope at which beta is largest."""

    def rate(t: mp.mpf) -> mp.mpf:
        h = second_integral(t) / (2 * mp.sqrt(mp.sin(t)))
        m = 1 / mp.sqrt(1 + h * h)
        return 1 - (mp.mpf(1) / 2 - h * mp.cot(t) / 2) * m * m * (1 - epsilon * h * m / mp.sqrt(1 - (epsilon * m) ** 2))

    low, high = mp.mpf(2), mp.pi - mp.mpf(10) ** -18
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if rate(middle) > 0 else (low, middle)
    return low


def starting_guess(nodes: np.ndarray, folds: np.ndarray, half_tangent: np.ndarray) -> list[list[float]]:
    """Coefficients c_ij of t/(1 - u) = sum c_ij u^i epsilon^j, fitted over the whole stable branch.

    u = sqrt((b_fold - b)/(b_fold - b_contact)) with b = tan(beta/2) takes the square root out of the fold.
    """
    rows, values, weights = [], [], []
    for epsilon, top in zip(nodes, folds, strict=True):
        t = top * np.sin(np.linspace(0, np.pi / 2, 122)[1:-1]) ** 2
        b = np.array([float(mp.tan(centre_angle(mp.mpf(v), mp.mpf(epsilon)) / 2)) for v in t])
        b_fold = np.polynomial.polynomial.polyval(epsilon, half_tangent)
        b_contact = -epsilon / (1 + np.sqrt(1 - epsilon**2))
        u = np.sqrt(np.clip((b_fold - b) / (b_fold - b_contact), 0, 1))
        rows.append(np.stack([u**i * epsilon**j for i in range(6) for j in range(6)], axis=1))
        values.append(t / (1 - u))
        weights.append(np.full_like(t, 1.0 if abs(epsilon) < 0.5 else 0.3 if abs(epsilon) < 0.9 else 0.05))
    design, value, weight = np.concatenate(rows), np.concatenate(values), np.concatenate(weights)
    weight = weight / value
    solution, *_ = np.linalg.lstsq(design * weight[:, None], value * weight, rcond=None)
    error = np.abs(design @ solution / value - 1)
    print(f"starting guess: relative error up to {error[np.abs(design[:, 1]) < 0.9].max():.1e} for |r/rho| < 0.9")
    return [[float(v) for v in row] for row in solution.reshape(6, 6)]


def main() -> None:
    """Compute every table and write the file."""
    nodes = np.cos(np.pi * (np.arange(48) + 0.5) / 48)
    folds = [fold(mp.mpf(float(x))) for x in nodes]
    half = [mp.tan(centre_angle(t, mp.mpf(float(x))) / 2) for t, x in zip(folds, nodes, strict=True)]
    cheb = np.polynomial.chebyshev
    fold_slope = cheb.cheb2poly(cheb.chebfit(nodes, np.array(folds, float), 19))
    half_tangent = cheb.cheb2poly(cheb.chebfit(nodes, np.array(half, float), 11))
    fit = np.polynomial.polynomial.polyval(nodes, fold_slope)
    print(f"fold slope: error {np.abs(fit - np.array(folds, float)).max():.1e} rad")
    tables = {
        "sine": power_series(lambda z: mp.sin(mp.sqrt(z)) / mp.sqrt(z), 9),
        "cosine": power_series(lambda z: mp.cos(mp.sqrt(z)), 9),
        "length": power_series(length, 15),
        "offset": power_series(offset, 14),
        "fold_slope": fold_slope.tolist(),
        "fold_half_tangent": half_tangent.tolist(),
        "start": starting_guess(nodes, np.array(folds, float), half_tangent),
    }
    TARGET.write_text(json.dumps(tables, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
