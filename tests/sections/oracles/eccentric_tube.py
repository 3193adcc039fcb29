"""Exact torsion of a circle with an eccentric circular hole, by images.

With the hole's centre e off, r^2/2 on the hole is e x + constant and on the outer circle constant. The potential with
these values is a dipole in the hole, reflected in the outer circle, reflected in the hole, and so on; its conjugate is
single-valued, as the warping must be. Its energy follows from residues; the images fall geometrically.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class EccentricTube(NamedTuple):
    """J and the largest stress over G theta' on each circle, for the outer radius 1."""

    torsion_constant: float
    outer_stress: float
    hole_stress: float


def eccentric_tube(hole_radius: float, offset: float) -> EccentricTube:
    """Solve for the outer radius 1 about the origin and the hole's centre at x = ``offset``."""
    r, e = hole_radius, offset
    strength, place, energy = e * r**2, 0.0, 0.0
    images = []
    for _ in range(200):
        gap = 1.0 - e * (e + place)
        energy += np.pi * e * strength * (1.0 + r**2 / gap**2)
        images.append((strength, place))
        place = (e + place) * r**2 / gap
        strength *= (r**2 + e * place) / gap
    polar = 0.5 * np.pi * (1.0 - r**4) - np.pi * r**2 * e**2

    def stress(z: np.ndarray) -> float:
        slope = np.zeros_like(z)
        for p, q in images:
            slope += -p / (z - e - q) ** 2 - p / (1.0 - (e + q) * z) ** 2
        return float(np.abs(slope - z.conj()).max())

    ring = np.exp(2j * np.pi * np.arange(720) / 720)  # the extremes lie on the x axis, which is among the points
    return EccentricTube(polar - energy, stress(ring), stress(e + r * ring))
