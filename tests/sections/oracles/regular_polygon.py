"""Exact torsion of regular polygons: images of the unit disk under Schwarz and Christoffel's map.

z(w) = sum of c_k w^(nk + 1) with z'(w) = (1 - w^n)^(-2/n). The potential with the boundary values |z|^2/2 is the real
part of a power series in w^n whose coefficients are the autocorrelation of the c_k, as in ``mapped_disk``.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.signal import fftconvolve
from scipy.special import gamma

TERMS = 2**16  # what they leave out of J falls with their number squared: below 1e-12 from 20 sides on
AVERAGES = 24  # of neighbouring partial sums of the alternating series, again and again


class RegularPolygon(NamedTuple):
    """J and the largest stress over G theta', in the middle of a side, for the circumscribed radius 1."""

    torsion_constant: float
    largest_stress: float


def regular_polygon(sides: int) -> RegularPolygon:
    """Regular polygon of 5 sides or more."""
    n = sides
    k = np.arange(1, TERMS)
    c = np.concatenate([[1.0], np.cumprod((k - 1.0 + 2.0 / n) / k)]) / (n * np.arange(TERMS) + 1.0)
    radius = gamma(1.0 / n) * gamma(1.0 - 2.0 / n) / (n * gamma(1.0 - 1.0 / n))  # z(1), the sum of all c_k
    potential = fftconvolve(c, c[::-1])[TERMS:]
    area, turn = 0.5 * n * radius**2 * np.sin(2.0 * np.pi / n), np.cos(2.0 * np.pi / n)
    polar = area * radius**2 * (2.0 + turn) / 6.0
    constant = polar - np.pi * (n * k * potential**2).sum()
    partial = np.cumsum(n * k * potential * (-1.0) ** k)[-AVERAGES - 1 :]
    for _ in range(AVERAGES):
        partial = 0.5 * (partial[1:] + partial[:-1])
    stress = abs(float(partial[0])) * 2.0 ** (2.0 / n) + radius * np.cos(np.pi / n)
    return RegularPolygon(float(constant / radius**4), float(stress / radius))
