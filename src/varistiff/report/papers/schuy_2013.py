"""Figures 3, 4 and 8 to 11 of Schuy et al. (2013), computed."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013 import prototype, strength, stress_pattern
from varistiff.papers.schuy_2013.corrected_reading import prototype as reading
from varistiff.papers.schuy_2013.device import respond, stiffness, tube_of
from varistiff.papers.schuy_2013.rails import bare_section
from varistiff.report.figures.section_stress import colour_top, mark, paint
from varistiff.report.section_field import section_field
from varistiff.report.style import (
    BLACK,
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SOFT,
    VERMILION,
    WIDTH,
    Drawing,
    canvas,
    ramp,
    styled,
)
from varistiff.sections import SplinedTube

NAMES = {"pe": "PE-HD", "pa2200": "PA 2200", "pom": "POM-C", "peek": "PEEK", "tpu": "TPU 80 A"}
LOOKS: dict[str, dict[str, Any]] = {
    "pe": {"color": BLUE, "linestyle": "solid"},
    "pa2200": {"color": VERMILION, "linestyle": (0, (6, 2))},
    "pom": {"color": GREEN, "linestyle": (0, (6, 2, 1.2, 2))},
    "peek": {"color": PURPLE, "linestyle": (0, (2.5, 1.5))},
    "tpu": {"color": ORANGE, "linestyle": (0, (1.2, 1.4))},
}
STEP = 21.0  # mm between the middles of the four sections
MM = 1e3


def figure_3() -> Drawing:
    """Draw the least radius of a solid cylinder over torque, one line a plastic."""
    torque = np.geomspace(0.5, 50.0, 41)
    with styled():
        figure, axes = canvas(height=4.2, right=0.78)
        for key in strength.PLASTICS:
            allowed = strength.plastic(key).allowed
            radius = [MM * strength.smallest_radius(torque=float(one), allowed=allowed) for one in torque]
            axes.plot(torque, radius, **LOOKS[key])
        axes.set(xscale="log", yscale="log", xlim=(0.5, 50.0), ylim=(1.8, 40.0))
        axes.set_xticks([0.5, 1, 2, 5, 10, 20, 50], ["0.5", "1", "2", "5", "10", "20", "50"])
        axes.set_yticks([2, 5, 10, 20, 40], ["2", "5", "10", "20", "40"])
        axes.minorticks_off()
        axes.set(xlabel="Torque [N·m]", ylabel="Least radius [mm]", title="Radius that carries a torque")
        _name_plastics(figure)
    caption = (
        "Least radius of a solid cylinder over the torque that it carries, with the strengths of our material table "
        f"and a safety factor of {strength.SAFETY:g}. The paper prints no value of its curves, nor its strengths."
    )
    return Drawing("figure_3", "Least radius over torque", figure, caption)


def figure_4() -> Drawing:
    """Draw the active length over the radius for both ends of the stiffness range, one line a plastic."""
    with styled():
        figure = Figure(figsize=(WIDTH, 4.3))
        for number, wanted in enumerate((paper.STIFFNESS_MAX, paper.STIFFNESS_MIN)):
            axes = figure.add_axes((0.1 + 0.345 * number, 0.145, 0.31, 0.76))
            _length_lines(axes, wanted)
            axes.set(title=f"{wanted:.0f} N·m/rad", xlabel="Radius [mm]")
            if number:
                axes.tick_params(labelleft=False)
            else:
                axes.set_ylabel("Active length [mm]")
        _name_plastics(figure)
    caption = (
        "Active length over radius for both ends of the required range. Whatever the radius and the plastic, the "
        "second is seven times the first. The dots are the least radius for "
        f"{strength.TORQUE:g} N·m; thinner cylinders fail. The paper prints no value of its curves."
    )
    return Drawing("figure_4", "Active length over radius", figure, caption)


def figure_8() -> Drawing:
    """Draw torque over twist of the corrected reading at the six lengths that the paper shows."""
    twist = np.radians([-10.0, 10.0])
    with styled():
        figure, axes = canvas(right=0.72)
        for length, colour in zip(paper.SHOWN_LENGTHS, ramp(len(paper.SHOWN_LENGTHS)), strict=True):
            torque = [float(respond(reading(), twist=float(one), active_length=length).load) for one in twist]
            axes.plot(np.degrees(twist), torque, color=colour, label=f"{MM * length:.0f} mm")
        axes.plot(
            np.degrees(twist),
            paper.MEASURED_MIN * twist,
            color=BLACK,
            linestyle=(0, (1.0, 2.5)),
            label="printed",
        )
        axes.set(xlim=(-10.0, 10.0), xlabel="Twist [deg]", ylabel="Torque [N·m]", title="Torque over twist")
        axes.legend(title="Active length", loc="upper left", bbox_to_anchor=(1.03, 1.0))
    caption = (
        "Torque over twist at six active lengths of the tests, by the corrected reading, which was fitted to the one "
        "measured stiffness that is printed, 71.56 N·m/rad at 166 mm (dots). Lines through the origin, as the paper "
        "says of its measurements."
    )
    return Drawing("figure_8", "Torque over twist", figure, caption)


def figure_9() -> Drawing:
    """Draw stiffness over active length: analytic, rails alone, the whole drive train, and what is printed."""
    x = np.linspace(0.008, 0.170, 163)
    tube = reading()
    bare = tube_of(shear_modulus=tube.shear_modulus, section=bare_section())
    alone = tube_of(shear_modulus=tube.shear_modulus, section=tube.section)
    inside = x[x <= tube.length]
    analytic = np.array([stiffness(bare, active_length=float(one)) for one in x])
    rails = np.array([stiffness(alone, active_length=float(one)) for one in x])
    whole = np.array([prototype.measured_stiffness(active_length=float(one)) for one in inside])
    with styled():
        figure, axes = canvas(height=5.2, right=0.965)
        raised = (1.0 + paper.SOLID_EXCESS) * analytic
        axes.fill_between(MM * x, analytic, raised, color="#e9ecef", label="printed: finite elements up to 62 % above")
        axes.plot(MM * x, analytic, color=INK, linestyle=(0, (1.0, 1.8)), label="tube without rails (analytic)")
        axes.plot(MM * x, rails, color=VERMILION, linestyle=(0, (6, 2)), label="tube with rails, section theory")
        axes.plot(MM * inside, whole, color=BLUE, label="the same with 650 N·m/rad in series")
        axes.axvline(MM * paper.CROSSING, color=SOFT, linewidth=1.2)
        axes.annotate(
            "printed: measured = analytic",
            (MM * paper.CROSSING, 410.0),
            (6.0, 0.0),
            textcoords="offset points",
            color=SOFT,
            va="center",
        )
        end = MM * paper.TESTED_LENGTHS[-1]
        for value, marker, words in (
            (paper.MEASURED_MIN, "x", "71.56 N·m/rad measured, printed"),
            (paper.ANALYTIC_MIN, "+", "53.13 N·m/rad analytic, printed"),
        ):
            look: dict[str, Any] = {"linestyle": "none", "markersize": 9.0, "markeredgewidth": 2.0}
            axes.plot(end, value, marker=marker, color=BLACK, label=words, zorder=5.0, **look)
        axes.set(xlim=(0.0, 172.0), ylim=(0.0, 700.0))
        axes.set(xlabel="Active length [mm]", ylabel="Stiffness [N·m/rad]", title="Stiffness over active length")
        axes.legend(loc="upper right")
    caption = (
        "Stiffness over active length at 0.63 GPa. The rails of the dashed line and the 650 N·m/rad of the full line "
        "are fitted to the two printed statements about the measured curve: 71.56 N·m/rad at 166 mm, and equal to the "
        "analytic curve at 40 mm. The grey band ends 62 % above the analytic curve."
    )
    return Drawing("figure_9", "Stiffness over active length", figure, caption)


def figure_10() -> Drawing:
    """Draw the stress in the four sections of Table I at 1 N m in a row, to one scale."""
    names = ("circle", "square", "hexagon", "octagon")
    peaks = {name: stress_pattern.largest_stress(section=name) * 1e-6 for name in names[1:]}
    peaks["circle"] = paper.PICTURED_TORQUE / float(stress_pattern.table_section("circle").torsion_modulus) * 1e-6
    with styled():
        figure = Figure(figsize=(WIDTH, 3.5))
        axes = figure.add_axes((0.01, 0.235, 0.98, 0.755))
        axes.set_axis_off()
        axes.set_aspect("equal")
        for number, name in enumerate(names):
            section, offset = stress_pattern.table_section(name), number * STEP
            field = section_field(section)
            image = paint(axes, field, torque=paper.PICTURED_TORQUE, top=max(peaks.values()), offset=offset)
            size = paper.TABLE_RADIUS if name == "circle" else paper.ACROSS_FLATS[name]
            if name != "circle":
                mark(axes, section.properties(), offset=offset)
            share = peaks[name] / peaks["circle"]
            printed = 100.0 * paper.STRESS_RATIOS.get(name, 1.0)
            symbol = "R" if name == "circle" else "b"
            words = (
                f"{name}, {symbol} = {MM * size:.1f} mm\n{peaks[name]:.2f} MPa, {100.0 * share:.1f} %\n"
                f"printed {printed:.0f} %"
            )
            axes.text(offset, -9.6, words, ha="center", va="top", fontsize=10.0, linespacing=1.3)
        axes.set(xlim=(-0.5 * STEP, 3.5 * STEP), ylim=(-17.5, 10.0))
        bar = figure.colorbar(image, cax=figure.add_axes((0.2, 0.175, 0.6, 0.04)), orientation="horizontal")
        bar.outline.set_linewidth(0.6)
        bar.set_label("Shear stress at 1 N·m [MPa]")
    caption = (
        "Shear stress at 1 N·m in the four sections of Table I with their printed dimensions and exact factors, the "
        "circle solid; below each its largest stress, also as a share of the circle's. The printed shares follow from "
        "the printed factors. Rings mark where the largest stress sits. In the corners themselves it vanishes."
    )
    return Drawing("figure_10", "Stress in four sections", figure, caption)


def figure_11() -> Drawing:
    """Draw the stress in the prototype's section at 1 N m, with the assumed rails."""
    section = reading().section
    assert isinstance(section, SplinedTube)  # what the reading's file says
    field = section_field(section)
    top = colour_top(field, section.properties()) * paper.PICTURED_TORQUE * 1e-6
    with styled():
        figure = Figure(figsize=(WIDTH, 5.0))
        axes = figure.add_axes((0.118, 0.13, 0.62, 0.79))
        axes.set_aspect("equal")
        axes.grid(visible=False)
        axes.set(xlim=(-14.5, 14.5), ylim=(-14.5, 14.5))
        image = paint(axes, field, torque=paper.PICTURED_TORQUE, top=top)
        mark(axes, section.properties())
        axes.set(xlabel="x [mm]", ylabel="y [mm]", title="Prototype at 1 N·m")
        bar = figure.colorbar(image, cax=figure.add_axes((0.79, 0.13, 0.026, 0.79)))
        bar.outline.set_linewidth(0.6)
        bar.set_label("Shear stress [MPa]", labelpad=8)
    share = stress_pattern.rails_share(section)
    caption = (
        "Shear stress in the prototype's section far from flange and bearing, with the rails of the corrected reading. "
        f"The rails carry {100.0 * share:.0f} % of the tube's mean squared stress. The largest stress, ringed, sits "
        "in the fillets at their roots."
    )
    return Drawing("figure_11", "Stress in the prototype", figure, caption)


def _length_lines(axes: Axes, wanted: float) -> None:
    radius = np.linspace(0.005, 0.025, 61)
    axes.set(yscale="log", xlim=(5.0, 25.0), ylim=(1.0, 1000.0))
    axes.set_yticks([1, 10, 100, 1000], ["1", "10", "100", "1000"])
    axes.minorticks_off()
    for key in strength.PLASTICS:
        plastic = strength.plastic(key)
        unit = strength.active_length(radius=0.01, stiffness=wanted, shear_modulus=plastic.shear_modulus)
        length = MM * unit * (radius / 0.01) ** 4  # J goes with the fourth power
        axes.plot(MM * radius, length, **LOOKS[key])
        least = strength.smallest_radius(torque=strength.TORQUE, allowed=plastic.allowed)
        at = MM * unit * (least / 0.01) ** 4
        if 0.005 < least < 0.025 and at > 1.0 and math.isfinite(at):
            dot: dict[str, Any] = {"markersize": 7.0, "markeredgecolor": INK, "zorder": 5.0}
            axes.plot(MM * least, at, "o", color=LOOKS[key]["color"], **dot)


def _name_plastics(figure: Figure) -> None:
    handles = [Line2D([], [], label=NAMES[key], **LOOKS[key]) for key in reversed(strength.PLASTICS)]
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.80, 0.91), handlelength=2.6)
