"""P3G and P4C against the equations of DIN 32711 and DIN 32712, and J of a P3G by another method."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.sections import P3G, P4C

from .oracles import rational


def din(a: np.ndarray, mean_diameter: float, eccentricity: float, lobes: int) -> np.ndarray:
    """The standards' curve as complex numbers."""
    h, slope = 0.5 * mean_diameter - eccentricity * np.cos(lobes * a), lobes * eccentricity * np.sin(lobes * a)
    x, y = h * np.cos(a) - slope * np.sin(a), h * np.sin(a) + slope * np.cos(a)
    return x + 1j * y


def boundary(section: P3G | P4C) -> np.ndarray:
    t = np.linspace(0.0, 1.0, 60)
    return np.concatenate([segment.point(t) for segment in section.outline().loops[0]]) @ [1.0, 1.0j]


@pytest.mark.parametrize("eccentricity", [0.0, 0.0005, 0.0012])
def test_p3g_is_the_curve_of_the_standard(eccentricity: float) -> None:
    """Constant width Dm, area pi (Dm^2/4 - 4 e^2), and every point on the curve."""
    section = P3G(mean_diameter=0.02, eccentricity=eccentricity)
    z = boundary(section)
    curve = din(np.linspace(0.0, 2.0 * math.pi, 40001), 0.02, eccentricity, 3)
    assert np.abs(z[:, None] - curve[None, ::8]).min(axis=1).max() < 2e-5  # the spacing of the points
    for angle in np.linspace(0.0, math.pi, 7):
        across = (z * np.exp(-1j * angle)).real
        assert across.max() - across.min() == pytest.approx(0.02, rel=1e-3)
    assert section.area == pytest.approx(math.pi * (0.01**2 - 4.0 * eccentricity**2), rel=1e-12)


def test_p4c_is_the_curve_cut_by_the_circle() -> None:
    section = P4C(inner_diameter=0.021, outer_diameter=0.025, eccentricity=0.0035)
    z = boundary(section)
    assert np.abs(z).max() == pytest.approx(0.0125, rel=1e-12)
    assert np.abs(z).min() == pytest.approx(0.0105, rel=1e-12)
    curve = din(np.linspace(0.0, 2.0 * math.pi, 40001), 0.028, 0.0035, 4)
    inside = np.abs(z) < 0.0125 * (1.0 - 1e-9)
    assert np.abs(z[inside, None] - curve[None, ::2]).min(axis=1).max() < 2e-5


@pytest.mark.parametrize("eccentricity", [0.02, 0.05, 0.08])
def test_p3g_by_harmonic_polynomials(eccentricity: float) -> None:
    """A Dirichlet fit by powers of z^3: its misfit, below 1e-8, is the tolerance."""
    t, w = np.polynomial.legendre.leggauss(80)
    end = math.pi / 3.0
    a = 0.5 * end * (t + 1.0)
    z = din(a, 2.0, eccentricity, 3)
    step = 0.5 * end * w * (1.0 + 8.0 * eccentricity * np.cos(3.0 * a)) * 1j * np.exp(1j * a)
    fitted = rational.symmetric_curve(z, step, 3, 26)
    assert fitted.misfit < 1e-8
    found = P3G(mean_diameter=2.0, eccentricity=eccentricity).torsion_constant
    assert found == pytest.approx(fitted.torsion_constant, rel=1e-8)
