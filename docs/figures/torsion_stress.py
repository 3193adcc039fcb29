"""Shear stress in the four sections of Table I at 1 N m, to one scale (Fig. 10 of the paper)."""

from __future__ import annotations

from matplotlib.figure import Figure

from varistiff.report.figures.section_stress import mark, paint
from varistiff.report.section_field import section_field
from varistiff.report.style import WIDTH, styled
from varistiff.sections import Hexagon, HollowCircle, Octagon, Section, Square

TORQUE = 1.0  # N m
SECTIONS: tuple[tuple[str, Section], ...] = (
    ("circle, R = 7.8 mm", HollowCircle(outer_radius=7.8e-3, inner_radius=3.9e-3)),
    ("square, b = 14.1 mm", Square(across_flats=14.1e-3)),
    ("hexagon, b = 14.8 mm", Hexagon(across_flats=14.8e-3)),
    ("octagon, b = 15.1 mm", Octagon(across_flats=15.1e-3)),
)
STEP = 21.0  # mm between middles


def draw() -> Figure:
    """Draw the sections in a row under one scale of colours, each with its largest stress."""
    top = max(TORQUE / section.torsion_modulus for _, section in SECTIONS) * 1e-6
    with styled():
        figure = Figure(figsize=(WIDTH, 3.3))
        axes = figure.add_axes((0.01, 0.235, 0.98, 0.755))
        axes.set_axis_off()
        axes.set_aspect("equal")
        for number, (name, section) in enumerate(SECTIONS):
            offset = number * STEP
            image = paint(axes, section_field(section), torque=TORQUE, top=top, offset=offset)
            if section.shape != "hollow_circle":
                mark(axes, section.properties(), offset=offset)
            peak = TORQUE / section.torsion_modulus * 1e-6
            axes.text(offset, -10.5, f"{name}\n{peak:.2f} MPa", ha="center", va="top", fontsize=10.0)
        axes.set(xlim=(-0.5 * STEP, 3.5 * STEP), ylim=(-15.5, 10.0))
        bar = figure.colorbar(image, cax=figure.add_axes((0.2, 0.185, 0.6, 0.04)), orientation="horizontal")
        bar.outline.set_linewidth(0.6)
        bar.set_label("Shear stress at 1 N·m [MPa]")
    return figure
