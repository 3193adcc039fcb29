"""Torsion modulus of a tube with six rails over the fillet at their roots."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from varistiff.report.style import BLUE, SOFT, canvas, styled
from varistiff.sections import HollowCircle, SplinedTube

FILLETS = np.array(
    [0.0, 0.001, 0.005, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.65, 0.8, 1.0, 1.25, 1.5, 1.75, 2.0]
)  # mm


def draw() -> Figure:
    """Draw W, and the one of the tube without rails."""
    moduli = [1e9 * _tube(1e-3 * fillet).torsion_modulus for fillet in FILLETS]
    plain = 1e9 * HollowCircle(outer_radius=0.011, inner_radius=0.0087).torsion_modulus
    with styled():
        figure, axes = canvas(height=4.0, right=0.96)
        axes.plot(FILLETS, moduli, color=BLUE, marker="o", markersize=5.0)
        axes.axhline(plain, color=SOFT, linewidth=1.6, linestyle=(0, (6, 2)))
        axes.text(1.98, plain + 15.0, "tube without rails", color=SOFT, ha="right", va="bottom")
        axes.text(0.75, 730.0, "with six rails, 7 mm wide and 2.25 mm high", color=BLUE, va="top")
        axes.set(xlim=(0.0, 2.03), ylim=(0.0, 1400.0))
        axes.set(xlabel="Root fillet [mm]", ylabel="Torsion modulus W [mm³]")
    return figure


def _tube(fillet: float) -> SplinedTube:
    return SplinedTube(
        outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.007, rail_height=0.00225, root_fillet=fillet
    )
