"""The octagon's factors by harmonic polynomials: no code of ``varistiff.sections`` is used."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013 import table_one

SIDE = math.pi / 8.0  # half the angle of one side, seen from the axis
TERMS = 16


def trial(terms: int = TERMS) -> tuple[float, float]:
    """Least value of the integral of (domega/dx - y)^2 + (domega/dy + x)^2, and the stress amid a side, for b = 1.

    The integral is J for the true warping function omega and larger for any other. Trial: a sum of Im z^(8 k), the
    harmonic polynomials with the octagon's symmetry. The quadrature is exact for these polynomials.
    """
    nodes, weights = np.polynomial.legendre.leggauss(8 * terms + 2)
    nodes, weights = 0.5 * (nodes + 1.0), 0.5 * weights
    x = 0.5 * nodes[:, None] + 0.0 * nodes
    slope = math.tan(SIDE) * nodes
    y = x * slope
    area = 16.0 * x * 0.5 * weights[:, None] * math.tan(SIDE) * weights  # sixteen triangles make the octagon
    powers = 8 * np.arange(1, terms + 1)
    z = (x + 1j * y).ravel()
    turned = [n * z ** (n - 1) / 0.5 ** (n - 1) for n in powers]  # domega/dy + i domega/dx
    basis = np.array([np.concatenate([f.imag, f.real]) for f in turned])
    rigid = np.concatenate([-y.ravel(), x.ravel()])
    measure = np.concatenate([area.ravel()] * 2)
    factors = np.linalg.solve(basis * measure @ basis.T, -basis * measure @ rigid)
    field = rigid + factors @ basis
    amid = 0.5 + float(factors @ powers)  # at z = 0.5 every scaled power is n
    return float(np.sum(measure * field**2)), amid


def test_upper_bound_of_the_torsion_constant() -> None:
    """0.108 is the rounded form of 0.1075 to 0.1085; J is below that, whatever the solver."""
    bound, _ = trial()
    assert bound < 0.1075
    assert bound < paper.STIFFNESS_FACTORS["octagon"] - 0.0005
    exact = table_one.stiffness_factor(section="octagon")
    assert exact <= bound * (1.0 + 1e-12)  # rounding
    assert exact == pytest.approx(bound, rel=1e-6)  # sixteen polynomials come this close


def test_more_polynomials_lower_the_bound() -> None:
    bounds = [trial(terms)[0] for terms in (1, 2, 4, 8)]
    assert bounds == sorted(bounds, reverse=True)


def test_torsion_modulus_by_harmonic_polynomials() -> None:
    constant, amid = trial()
    modulus = constant / amid  # the largest stress of a convex polygon sits amid its sides, nearest the axis
    assert modulus == pytest.approx(
        table_one.resistance_factor(section="octagon"), rel=1e-3
    )  # the corners slow the series down
    assert modulus < paper.RESISTANCE_FACTORS["octagon"] - 0.0005
