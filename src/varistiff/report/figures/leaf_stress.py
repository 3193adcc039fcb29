"""Bending stress over a solid leaf, laid flat."""

from __future__ import annotations

import numpy as np

from varistiff.fe.leaf_problem import LeafResult
from varistiff.report.style import INK, Drawing, canvas, styled


def draw(leaf: LeafResult) -> Drawing:
    """Draw the larger of the stresses in both faces over arc length and width; the contact is a line."""
    stress = np.maximum(np.abs(leaf.stress_upper), np.abs(leaf.stress_lower)) * 1e-6
    arc, across = leaf.arc * 1e3, leaf.across * 1e3
    # the clamp's edge is singular: what lies within the stated distance would take the scale
    away = leaf.arc >= leaf.stress_distance
    top = float(np.nanmax(stress[away])) if away.any() else float(np.nanmax(stress))
    with styled():
        figure, axes = canvas(right=0.84)
        shown = axes.pcolormesh(
            arc, across, stress.T, shading="gouraud", cmap="cividis", vmin=0.0, vmax=top, rasterized=True
        )
        contact = leaf.arc_length * 1e3
        if contact <= arc.max() * (1.0 + 1e-9):
            axes.axvline(contact, color="white", linewidth=2.6)
            axes.axvline(contact, color=INK, linewidth=1.2, linestyle="--")
        axes.set(
            xlabel="Arc length from the clamp [mm]",
            ylabel="Across the leaf [mm]",
            title="Bending stress of the solid leaf",
        )
        axes.grid(visible=False)
        bar = figure.colorbar(shown, cax=figure.add_axes((0.87, 0.145, 0.022, 0.76)), extend="max")
        bar.set_label("Bending stress [MPa]")
    caption = (
        "The larger stress along the leaf in its two faces, laid flat; the dashed line is the contact. Across the leaf "
        "a beam has one stress; clamp and contact hold a wide leaf straight across. The scale leaves out what lies "
        f"within {1e3 * leaf.stress_distance:.3g} mm of the clamp, whose edge is singular."
    )
    return Drawing("leaf_stress", "Stress of the leaf", figure, caption)
