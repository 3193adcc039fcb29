"""Exact torsion of the image of the unit disk under a polynomial z(w), one-to-one for |w| <= 1.

The potential with the boundary values |z|^2/2 is the real part of a power series in w whose coefficients are the
autocorrelation of those of z; everything else is a finite sum or an integral of polynomials over the disk.
Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, par. 134.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import polynomial

from varistiff.sections.outline import Curve, Outline, Points


@dataclass(frozen=True)
class MappedDisk:
    """The shape z(w) = sum of c_k w^k, k from 0."""

    coefficients: tuple[complex, ...]

    @property
    def potential(self) -> np.ndarray:
        """Coefficients of F(w), Re F = |z|^2/2 on the boundary, without the constant."""
        c = np.array(self.coefficients)
        found = [np.vdot(c[: c.size - m], c[m:]) for m in range(1, c.size)]
        return np.array([0.0, *found])

    @property
    def torsion_constant(self) -> float:
        """Polar moment less the energy of the potential, both as sums over coefficients."""
        c, f = np.array(self.coefficients), self.potential
        moment = polynomial.polymul(c, polynomial.polyder(c))
        polar = np.pi * (np.abs(moment) ** 2 / np.arange(1, moment.size + 1)).sum()
        return float(polar - np.pi * (np.arange(f.size) * np.abs(f) ** 2).sum())

    def stress(self, angle: np.ndarray) -> np.ndarray:
        """Shear stress over G theta' at w = exp(i angle)."""
        w = np.exp(1j * angle)
        z, slope = (polynomial.polyval(w, poly) for poly in (self.coefficients, polynomial.polyder(self.coefficients)))
        return np.abs(polynomial.polyval(w, polynomial.polyder(self.potential)) / slope - z.conj())

    @property
    def largest_stress(self) -> float:
        """The largest of it, on 20000 points."""
        return float(self.stress(np.linspace(0.0, 2.0 * np.pi, 20001)).max())

    def integral(self, weight: object) -> float:
        """Integral over the section of weight(z, omega), by a rule that is exact for these polynomials."""
        r, share = np.polynomial.legendre.leggauss(40)
        r, share = 0.5 * (r + 1.0), 0.5 * share
        w = r[:, None] * np.exp(2j * np.pi * np.arange(96) / 96)
        z, slope = (polynomial.polyval(w, poly) for poly in (self.coefficients, polynomial.polyder(self.coefficients)))
        omega = -polynomial.polyval(w, self.potential).imag
        area = (share * r)[:, None] * (2.0 * np.pi / 96) * np.abs(slope) ** 2
        return float((weight(z, omega) * area).sum())

    @property
    def area(self) -> float:
        """Area."""
        return self.integral(lambda z, omega: 1.0)

    @property
    def centroid(self) -> complex:
        """Centroid."""
        return (self.integral(lambda z, _: z.real) + 1j * self.integral(lambda z, _: z.imag)) / self.area

    @property
    def second_moments(self) -> tuple[float, float, float]:
        """Integrals of x^2, y^2 and x y about the centroid."""
        g = self.centroid
        return (
            self.integral(lambda z, _: (z - g).real ** 2),
            self.integral(lambda z, _: (z - g).imag ** 2),
            self.integral(lambda z, _: (z - g).real * (z - g).imag),
        )

    @property
    def shear_centre(self) -> complex:
        """Trefftz: the axis of twist whose warping has no linear part in the least-squares sense."""
        g = self.centroid
        along_x = self.integral(lambda z, omega: (z - g).real * omega)
        along_y = self.integral(lambda z, omega: (z - g).imag * omega)
        xx, yy, xy = self.second_moments
        # twisted about c instead of the origin, the bar warps by omega - x c_y + y c_x; both its moments vanish
        return complex(*np.linalg.solve([[-xy, xx], [-yy, xy]], [along_x, along_y]))

    def outline(self, segments: int) -> Outline:
        """The boundary, cut into so many curves."""
        return Outline((tuple(self._curve(n / segments, 1.0 / segments) for n in range(segments)),))

    def _curve(self, start: float, share: float) -> Curve:
        def curve(t: Points) -> tuple[Points, Points]:
            w = np.exp(2j * np.pi * (start + share * t))
            z = polynomial.polyval(w, self.coefficients)
            speed = 2j * np.pi * share * w * polynomial.polyval(w, polynomial.polyder(self.coefficients))
            return np.stack([z.real, z.imag], axis=1), np.stack([speed.real, speed.imag], axis=1)

        return Curve(curve)
