"""Figures 2 to 9 of Wang et al. (2024), computed; beside each curve what the paper prints."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import jax.numpy as jnp
import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.corrected_reading import search
from varistiff.papers.wang_2024.device import answer, groove, joint
from varistiff.papers.wang_2024.groove_disc import arc_radius, course
from varistiff.papers.wang_2024.limits import largest_torque, limited_deflections
from varistiff.report.figures.curves import plain_numbers
from varistiff.report.style import (
    BLACK,
    BLUE,
    FAINT,
    GREEN,
    INK,
    PURPLE,
    SKY,
    SOFT,
    VERMILION,
    Drawing,
    canvas,
    ramp,
    styled,
)

Numbers = npt.NDArray[np.float64]

MM, DEGREE = 1e3, 180.0 / math.pi
LEGEND_X = 0.785
_PRINTED: dict[str, Any] = {"color": VERMILION, "linewidth": 1.8, "linestyle": (0, (1.2, 1.6))}
_LENGTHS = np.linspace(paper.LENGTH_MIN, paper.LENGTH_MAX, 96)


def _legend(figure: Figure, axes: Axes, title: str | None = None) -> None:
    figure.legend(
        *axes.get_legend_handles_labels(),
        title=title,
        loc="upper left",
        bbox_to_anchor=(LEGEND_X, 0.91),
        alignment="left",
        labelspacing=0.6,
    )


def _over_length(axes: Axes, deflections: Sequence[float], quantity: str, *, sign: float = 1.0) -> None:
    """One curve a deflection [deg], a dot where the leaf turns by 9 degrees."""
    lengths, allowed = limited_deflections(count=39)
    for degrees, colour in zip(deflections, ramp(len(deflections)), strict=True):
        phi = math.radians(degrees)
        values = sign * getattr(answer(joint(), deflection=phi, length=_LENGTHS), quantity)
        axes.plot(_LENGTHS * MM, values, color=colour, label=f"{degrees:g}°")
        if allowed[0] < phi < allowed[-1]:
            at = float(np.interp(phi, allowed, lengths))
            value = sign * getattr(answer(joint(), deflection=phi, length=at), quantity)
            axes.plot(at * MM, value, "o", color=colour, markersize=7, markeredgecolor="white", zorder=4)
    axes.plot([], [], "o", color=SOFT, markersize=7, label="leaf turns\nby 9°; left of\nit by more")


def _along(axes: Axes, low: float, high: float, *, start: float = 5.0) -> None:
    """Active length below, a logarithmic axis from ``low`` to ``high`` beside."""
    axes.set_yscale("log")
    axes.set(xlim=(start, 30.0 if start == 0.0 else 26.0), ylim=(low, high), xlabel="Active length l₁ [mm]")
    axes.set_xticks(np.arange(start, 31.0 if start == 0.0 else 26.0, 5.0))
    plain_numbers(axes, log=True)


def figure_2() -> Drawing:
    """Groove of the stiffness disc with its centre, and the spiral that it stands for."""
    with styled():
        figure, axes = canvas()
        radius = arc_radius()
        disc = groove(radius)
        angles = np.linspace(0.0, paper.OUTER_ANGLE, 200)
        arc = (paper.CLAMP_RADIUS + np.asarray(disc.active_length(jnp.asarray(angles)))) * MM
        x_o, y_o = (float(value) * MM for value in disc.centre_position)
        turn = np.linspace(0.0, 2.0 * math.pi, 400)
        axes.plot(x_o + radius * MM * np.sin(turn), y_o + radius * MM * np.cos(turn), color=FAINT, linewidth=1.2)
        axes.plot(arc * np.sin(angles), arc * np.cos(angles), color=PURPLE, linewidth=4.0, label="groove, an arc")
        spiral = np.linspace(arc[0], arc[-1], angles.size)
        axes.plot(
            spiral * np.sin(angles), spiral * np.cos(angles), **{**_PRINTED, "color": BLACK}, label="spiral, A to C"
        )
        slider, reach = math.radians(25.0), float(np.interp(math.radians(25.0), angles, arc))
        axes.plot([0.0, 54.0 * math.sin(slider)], [0.0, 54.0 * math.cos(slider)], color=SOFT, linewidth=0.9)
        marks = [
            ("O", 0.0, 0.0, (-3.0, -3.5)),
            ("O₁", x_o, y_o, (2.0, -3.5)),
            ("A", 0.0, arc[0], (-4.5, -1.0)),
            ("S", reach * math.sin(slider), reach * math.cos(slider), (-4.5, 1.0)),
            ("C", arc[-1] * math.sin(angles[-1]), arc[-1] * math.cos(angles[-1]), (2.5, -1.0)),
        ]
        for name, x, y, (right, up) in marks:
            axes.plot(x, y, "o", color=INK, markersize=6)
            axes.text(x + right, y + up, name, fontsize=12.5)
        axes.set(xlim=(-16, 70), ylim=(-9, 48), aspect="equal", title="Groove of the stiffness disc")
        axes.set(xlabel="x [mm]", ylabel="y [mm]")
        _legend(figure, axes)
    caption = (
        f"The straightest groove: r_s = {radius * MM:.2f} mm, centre near the axis; thin: its circle. The paper prints"
        " A, C and the form of the equations, not r_s, and calls the groove an Archimedean spiral in its abstract."
        " The arc and the spiral through A and C differ by up to"
        f" {np.abs(arc - spiral).max():.1f} mm in radius."
    )
    return Drawing("figure_2", "Groove of the stiffness disc (Figure 2)", figure, caption)


def figure_3() -> Drawing:
    """Stiffness over active length and deflection, by Eq. (9) and by the exact leaf."""
    with styled():
        figure, axes = canvas()
        for degrees, colour, width in ((0.0, SKY, 5.0), (3.03, BLUE, 1.8)):
            values = answer(joint(), deflection=math.radians(degrees), length=_LENGTHS).stiffness
            axes.plot(_LENGTHS * MM, values, color=colour, linewidth=width, label=f"Eq. (9), {degrees:g}°")
        exact = answer(joint(exact=True), deflection=paper.DEFLECTION_LIMIT, length=_LENGTHS).stiffness
        axes.plot(_LENGTHS * MM, exact, color=BLACK, linewidth=1.6, linestyle="--", label="exact leaf,\n3.03°")
        axes.axhline(9.0, **_PRINTED, label="printed low\nend: 9")
        _along(axes, 5.0, 1e4)
        axes.set(ylabel="Stiffness [N·m/rad]", title="Stiffness over length and deflection")
        _legend(figure, axes)
    caption = (
        "Stiffness of the printed leaf; by Eq. (9) the two deflections coincide. The exact leaf softens at"
        " short lengths. The printed lower end, 9 N m/rad, is 23 times below the curve at 25 mm."
    )
    return Drawing("figure_3", "Stiffness over length and deflection (Figure 3)", figure, caption)


def figure_4() -> Drawing:
    """Stiffness over deflection at several active lengths, relative to the stiffness at rest."""
    lengths = (0.006, 0.010, 0.015, 0.025)
    phi = np.linspace(0.0, paper.DEFLECTION_LIMIT, 61)
    with styled():
        figure, axes = canvas()
        published = answer(joint(), deflection=phi, length=lengths[0]).stiffness
        axes.plot(
            phi * DEGREE, 100.0 * published / published[0], color=VERMILION, linewidth=3.0, label="Eq. (9),\nany length"
        )
        for length, colour in zip(lengths, ramp(len(lengths)), strict=True):
            exact = answer(joint(exact=True), deflection=phi, length=length).stiffness
            turned = answer(joint(), deflection=phi, length=length).rotation > paper.ROTATION_ASSUMED
            share = 100.0 * exact / exact[0]
            axes.plot(
                phi * DEGREE, np.where(turned, np.nan, share), color=colour, label=f"exact leaf,\n{length * MM:g} mm"
            )
            axes.plot(phi * DEGREE, np.where(turned, share, np.nan), color=colour, linewidth=1.4, linestyle=":")
        axes.set(
            xlim=(0.0, 3.03), ylim=(60.0, 103.0), xlabel="Deflection φ [deg]", ylabel="Stiffness over that at rest [%]"
        )
        axes.set_title("Stiffness over deflection")
        _legend(figure, axes)
    caption = (
        "Stiffness over its value at rest. Printed: it hardly changes, which is true of Eq. (9), 0.14 % at 3.03"
        " degrees, and not of the leaf. Dotted: the leaf turns by more than the 10 degrees that the paper allows."
    )
    return Drawing("figure_4", "Stiffness over deflection (Figure 4)", figure, caption)


def figure_5() -> Drawing:
    """Active length over the disc's angle, and the straight line."""
    angles = np.linspace(0.0, paper.OUTER_ANGLE, 200)
    with styled():
        figure, axes = canvas()
        for radius, name in ((0.025, "arc of 25 mm"), (1.0, "arc of 1 m")):
            other = np.asarray(groove(radius).active_length(jnp.asarray(angles)))
            axes.plot(
                angles * DEGREE,
                other * MM,
                color=SOFT,
                linewidth=1.2,
                linestyle="-" if radius < 0.1 else "-.",
                label=name,
            )
        lengths = np.asarray(groove(arc_radius()).active_length(jnp.asarray(angles)))
        axes.plot(
            angles * DEGREE,
            lengths * MM,
            color=PURPLE,
            linewidth=3.0,
            label=f"straightest,\n{arc_radius() * MM:.2f} mm",
        )
        own = course()
        used = np.array([own.angle_min, own.angle_max])
        axes.plot(
            used * DEGREE,
            (own.slope * used + own.intercept) * MM,
            color=BLACK,
            linestyle="--",
            linewidth=1.4,
            label="line p α + q,\n6 to 25 mm",
        )
        axes.plot(
            47.0,
            25.0,
            "X",
            color=VERMILION,
            markersize=11,
            markeredgecolor="white",
            clip_on=False,
            zorder=5,
            label="25 mm at 47°,\nif they belong\ntogether",
        )
        axes.set(
            xlim=(0.0, 48.0),
            ylim=(0.0, 30.0),
            xlabel="Angle α of the stiffness disc [deg]",
            ylabel="Active length l₁ [mm]",
        )
        axes.set_title("Active length over disc angle")
        _legend(figure, axes, "Groove")
    caption = (
        f"The arc radius is not published. In the straightest groove the line l₁ = {own.slope * MM:.2f} mm/rad α"
        f" − {abs(own.intercept) * MM:.2f} mm is true to {own.error * MM:.2f} mm. Every groove reaches 29 mm"
        " at 47 degrees."
    )
    return Drawing("figure_5", "Active length over disc angle (Figure 5)", figure, caption)


def figure_6() -> Drawing:
    """Stiffness over active length: printed leaf and corrected reading."""
    lengths = np.linspace(0.001, paper.OUTER_RADIUS - paper.CLAMP_RADIUS, 160)
    found = search()
    with styled():
        figure, axes = canvas()
        axes.axvspan(
            paper.LENGTH_MIN * MM,
            paper.LENGTH_MAX * MM,
            color=FAINT,
            alpha=0.35,
            linewidth=0.0,
            label="effective\nrange",
        )
        for leaf, colour, name in (
            (joint(), BLUE, "printed leaf,\nh = 1 mm"),
            (joint(thickness=found.thickness), GREEN, f"corrected\nreading,\nh = {found.thickness * MM:g} mm"),
        ):
            axes.plot(lengths * MM, answer(leaf, deflection=0.0, length=lengths).stiffness, color=colour, label=name)
        axes.axhline(9.0, **_PRINTED, label="printed low\nend: 9")
        axes.axhline(paper.TEST_STIFFNESS, color=BLACK, linewidth=1.2, linestyle="--", label="tests: 200")
        _along(axes, 3.0, 5e4, start=0.0)
        axes.set(ylabel="Stiffness at rest [N·m/rad]", title="Stiffness over active length")
        _legend(figure, axes)
    caption = (
        "Stiffness at rest by Eq. (9). It grows without bound towards zero length, as printed; the printed lower end"
        " takes a leaf of 0.35 mm. The tests run at 200 N m/rad, which the printed leaf reaches at 25.4 mm."
    )
    return Drawing("figure_6", "Stiffness over active length (Figure 6)", figure, caption)


def figure_7() -> Drawing:
    """Torque over active length and deflection."""
    low, high = largest_torque()
    with styled():
        figure, axes = canvas()
        _over_length(axes, (1.0, 1.5, 2.0, 2.5, 3.03), "torque")
        axes.axhline(14.6, **_PRINTED, label="printed: 14.6\nat most")
        _along(axes, 2.0, 500.0)
        axes.set(ylabel="Torque [N·m]", title="Torque over length and deflection")
        _legend(figure, axes, "Deflection")
    caption = (
        f"Torque of the printed leaf by Eq. (7). Largest at 6 mm: {high:.0f} N m at 3.03 degrees, {low:.0f} N m where"
        " the leaf turns by 9 degrees. The printed largest torque lies far below both."
    )
    return Drawing("figure_7", "Torque over length and deflection (Figure 7)", figure, caption)


def figure_8() -> Drawing:
    """Elastic energy over active length and deflection."""
    with styled():
        figure, axes = canvas()
        _over_length(axes, (1.0, 1.5, 2.0, 2.5, 3.03), "energy")
        _along(axes, 0.02, 12.0)
        axes.set(ylabel="Elastic energy [J]", title="Energy over length and deflection")
        _legend(figure, axes, "Deflection")
    caption = (
        "Elastic energy of the printed leaf by Eq. (10) with N. It falls with the length and grows with the deflection,"
        " as printed; at rest it is zero."
    )
    return Drawing("figure_8", "Energy over length and deflection (Figure 8)", figure, caption)


def figure_9() -> Drawing:
    """Adjusting force over active length and deflection."""
    with styled():
        figure, axes = canvas()
        _over_length(axes, (1.0, 1.5, 2.0, 2.5, 3.03), "thrust", sign=-1.0)
        _along(axes, 1.0, 6000.0)
        axes.set(ylabel="Resistance −∂V/∂l₁ [N]", title="Resistance over length and deflection")
        _legend(figure, axes, "Deflection")
    caption = (
        "Force with which the slider wants to run outward, by Eq. (12) with N; the paper prints it as a torque."
        " Nonlinear in both, as printed."
    )
    return Drawing("figure_9", "Resistance over length and deflection (Figure 9)", figure, caption)
