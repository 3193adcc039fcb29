"""Our figures of what Chacón et al. (2011) computed; see ``papers/chacon_2011/figures.yaml``."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle

from varistiff.characteristic.evaluate import Points
from varistiff.core.status import Status
from varistiff.papers.chacon_2011.devices import Theory, device, law, leaf, nut_distance, states
from varistiff.papers.chacon_2011.paper_values import (
    ASPECT_RATIO_SOFT,
    ASPECT_RATIO_STIFF,
    CLAMP_HEIGHT,
    PROTECTING_RADIUS,
    STIFFNESS_VARIATION,
)
from varistiff.papers.chacon_2011.printed_equation import printed_shape
from varistiff.papers.chacon_2011.stiffness import force_at, rest_stiffness
from varistiff.report.figures.curves import Curve, draw_curves
from varistiff.report.style import (
    BLUE,
    DPI,
    FAINT,
    GREEN,
    INK,
    LOOKS,
    METAL,
    ORANGE,
    SOFT,
    VERMILION,
    Drawing,
    canvas,
    ramp,
    styled,
)

_MM = 1e3
_RATIOS = (3.5, 3.0, 2.5, 2.0)
_DRAWN_LENGTH = 165.0  # mm of leaf beyond its clamp, enough for figure 3; unpublished
_LOOKS: dict[Theory, tuple[str, str]] = {
    "guided": ("paper's model (guided)", BLUE),
    "sliding": ("exact (sliding)", GREEN),
    "wrapped": ("exact, on cylinders of 35 mm", ORANGE),
    "linear": ("linear beam theory", SOFT),
}


def figure_3() -> Drawing:
    """The spring at both ends of its range, at rest and under one force."""
    force = 7.0
    with styled():
        figure = Figure(figsize=(7.4, 4.5), dpi=DPI)
        for row, ratio in enumerate((ASPECT_RATIO_SOFT, ASPECT_RATIO_STIFF)):
            axes = figure.add_axes((0.03, 0.53 - 0.45 * row, 0.94, 0.38))
            axes.set_aspect("equal")
            axes.axis("off")
            axes.set(xlim=(-262, 290), ylim=(-52, 52))
            nuts = float(nut_distance(ratio))
            moved = _displacement(force, ratio)
            axes.set_title(
                f"Nut distance {nuts * _MM:g} mm (α = {ratio:g}): {force:g} N displaces {moved * _MM:.1f} mm"
            )
            _spring(axes, nuts, 0.0, FAINT, 2.0)
            _spring(axes, nuts, moved, BLUE, 3.0)
            arrow = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.6, "shrinkA": 0, "shrinkB": 0}
            axes.annotate("", (288, 0), (258, 0), arrowprops=arrow)
            axes.text(272, 6, f"{force:g} N", ha="center")
        handles = [
            Line2D([], [], color=FAINT, linewidth=2.6, label="at rest"),
            Line2D([], [], color=BLUE, linewidth=2.6, label=f"under {force:g} N"),
            Line2D([], [], color=METAL, linewidth=5.0, label="nuts with clamps"),
        ]
        figure.legend(handles=handles, loc="lower center", ncols=3, bbox_to_anchor=(0.5, 0.01))
    caption = (
        "The four leaves by the paper's model, to scale, at the smallest and the largest nut distance of the prototype,"
        " at rest and under the same force on the bar with the rollers. Printed: the same force displaces less at the"
        " larger nut distance."
    )
    return Drawing("figure_3", "Two nut distances under one force", figure, caption)


def _displacement(force: float, ratio: float) -> float:
    displacement = np.linspace(0.0, CLAMP_HEIGHT, 801)
    return float(np.interp(force, states("guided", displacement, ratio).load, displacement))


def _spring(axes: Axes, nuts: float, moved: float, colour: str, zorder: float) -> None:
    gap, size = 4.0, 7.0  # the leaves' distance from the axis and the size of the rollers are unpublished
    for number, curve in enumerate(device(law("guided")).element_shapes(moved, nuts)):
        up = 1.0 if number % 2 == 0 else -1.0
        x, y = curve[:, 0] * _MM, up * (gap + (CLAMP_HEIGHT - np.abs(curve[:, 1])) * _MM)
        length = float(np.sum(np.hypot(*np.diff(curve, axis=0).T))) * _MM
        outward = np.sign(x[0]) * (_DRAWN_LENGTH - length)
        axes.plot([x[0] + outward, *x], [y[0], *y], color=colour, linewidth=2.0, zorder=zorder)
        axes.add_patch(
            Circle((x[0], y[0] + up * size), size, fill=False, edgecolor=colour, linewidth=1.3, zorder=zorder)
        )
    for side in (-0.5, 0.5):
        x_nut = side * nuts * _MM
        axes.plot([x_nut, x_nut], [-46.0, 46.0], color=METAL, linewidth=5.0, zorder=1.5)
    axes.plot([-250, 250], [0, 0], color=FAINT, linewidth=1.0, linestyle=(0, (8, 3, 1, 3)), zorder=0.5)


def figure_5() -> Drawing:
    """Shapes of the leaf, and how far other readings are from them."""
    with styled():
        figure = Figure(figsize=(7.4, 6.6), dpi=DPI)
        axes = figure.add_axes((0.105, 0.52, 0.86, 0.42))
        below = figure.add_axes((0.105, 0.095, 0.86, 0.30))
        for ratio, colour in zip(_RATIOS, ramp(len(_RATIOS)), strict=True):
            x, y = _from_clamp(law("guided").centreline(leaf(), ratio * CLAMP_HEIGHT, CLAMP_HEIGHT, 401))
            axes.plot(x, y, color=colour, label=f"α = {ratio:g}")
        axes.set(ylabel="Height y [mm]", title="Leaf from clamp to roller, paper's closed form")
        axes.set_aspect("equal", adjustable="datalim")
        axes.legend(loc="upper right")
        ratio = ASPECT_RATIO_STIFF
        span = ratio * CLAMP_HEIGHT
        x, y = _from_clamp(law("guided").centreline(leaf(), span, CLAMP_HEIGHT, 1001))
        for label, colour, dashes, curve in (
            ("exact leaf (sliding)", GREEN, "solid", law("sliding").centreline(leaf(), span, CLAMP_HEIGHT, 1001)),
            (
                "solution of the equation as printed",
                VERMILION,
                (0, (5, 2)),
                printed_shape(ratio, 1001) * np.array([span, CLAMP_HEIGHT]),
            ),
        ):
            other_x, other_y = _from_clamp(curve)
            below.plot(x, np.interp(x, other_x, other_y) - y, color=colour, linestyle=dashes, label=label)
        below.axhline(0.0, color=SOFT, linewidth=0.9)
        below.set_ylim(-1.7, 2.7)
        below.set(xlabel="Distance from the clamp x [mm]", ylabel="Δy [mm]", title="Difference from it at α = 2")
        below.legend(loc="upper right")
    caption = (
        "Above: shapes at four aspect ratios by the paper's closed form. Below: the exact leaf lies within 0.2 mm of"
        " it, so a measured shape cannot tell them apart; the equation with the printed sign has a solution that is"
        " 1.4 mm off."
    )
    return Drawing("figure_5", "Shapes of a leaf", figure, caption)


def _from_clamp(curve: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """x from the clamp and height over the roller line [mm], of points from the roller [m]."""
    x = (curve[-1, 0] - curve[::-1, 0]) * _MM
    return x, curve[::-1, 1] * _MM


def figure_6() -> Drawing:
    """Energy of one leaf over the aspect ratio."""
    ratios = np.linspace(1.6, 3.8, 221)
    with styled():
        figure, axes = canvas(right=0.965)
        axes.axvspan(ASPECT_RATIO_STIFF, ASPECT_RATIO_SOFT, color="#eef3f7", zorder=0.4)
        order: tuple[Theory, ...] = ("linear", "wrapped", "guided")
        for theory in order:
            label, colour = _LOOKS[theory]
            dashes = "solid" if theory == "guided" else (0, (5, 2))
            axes.plot(ratios, states(theory, 0.0, ratios).energy / 4.0, color=colour, linestyle=dashes, label=label)
        axes.set(xlim=(1.6, 3.8), ylim=(0.0, 4.0), title="Energy of one leaf at rest")
        axes.set(xlabel="Aspect ratio α = span/rise", ylabel="Energy of one leaf [J]")
        axes.text(2.75, 0.12, "printed range of the prototype", color=SOFT, ha="center")
        axes.legend(loc="upper right")
    caption = (
        "Energy of one leaf of the prototype at rest over its aspect ratio. The exact leaf without cylinders lies on"
        " the paper's curve at this scale (0.2 % lower at α = 2); on cylinders it rises steeply below. The paper's text"
        " gives no value."
    )
    return Drawing("figure_6", "Energy of a leaf", figure, caption)


def _family(name: str, displacement: np.ndarray) -> list[Curve]:
    curves = []
    for ratio, colour in zip(_RATIOS, ramp(len(_RATIOS)), strict=True):
        points: Points = states("guided", displacement, ratio)
        values = getattr(points, name)
        curves.append(Curve(displacement * _MM, values, points.status, f"α = {ratio:g}", colour))
    return curves


def _families(curves: list[Curve]) -> list[Line2D]:
    handles = [Line2D([], [], color=curve.colour, linewidth=2.6, label=curve.label) for curve in curves]
    dashes = LOOKS[Status.YIELDED].dashes
    return [*handles, Line2D([], [], color=SOFT, linewidth=1.5, linestyle=dashes, label="yielded")]


def figure_7() -> Drawing:
    """Force over displacement by the paper's model."""
    curves = _family("load", np.linspace(-0.025, 0.025, 201))
    with styled():
        figure, axes = canvas(right=0.965)
        draw_curves(axes, curves)
        low, high = force_at(theory="guided", displacement=0.01)
        axes.plot([10.0, 10.0], [low, high], "o", color=INK, markersize=5.0, zorder=6)
        axes.annotate(f"{high:.0f} N", (10.0, high), (7.6, high + 12.0), ha="right")
        axes.annotate(f"{low:.1f} N", (10.0, low), (10.4, low - 26.0), ha="left")
        axes.axhline(0.0, color=SOFT, linewidth=0.9, zorder=1.5)
        axes.axvline(0.0, color=SOFT, linewidth=0.9, zorder=1.5)
        axes.set(xlim=(-25, 25), xlabel="Displacement d [mm]", ylabel="Force [N]", title="Force over displacement")
        axes.legend(handles=_families(curves), loc="upper left", bbox_to_anchor=(0.02, 0.99))
    caption = (
        "Force over displacement by the paper's model at four aspect ratios; dashed where a leaf exceeds the printed"
        " yield stress. The dots, at 10 mm, are the values on the board; the paper's text gives neither forces nor"
        " displacements."
    )
    return Drawing("figure_7", "Force over displacement", figure, caption)


def figure_8() -> Drawing:
    """Stiffness over displacement by the paper's model, and where the printed variation is at rest."""
    soft, _ = rest_stiffness(theory="guided")
    wanted = (1.0 + STIFFNESS_VARIATION) * soft / _MM
    displacement = np.linspace(-0.025, 0.025, 201)
    curves = [
        Curve(each.x, each.y / _MM, each.status, each.label, each.colour) for each in _family("stiffness", displacement)
    ]
    with styled():
        figure = Figure(figsize=(10.4, 4.8), dpi=DPI)
        left = figure.add_axes((0.07, 0.135, 0.42, 0.77))
        right = figure.add_axes((0.565, 0.135, 0.42, 0.77))
        draw_curves(left, curves)
        left.set(xlim=(-25, 25), ylim=(0, 17.5), xlabel="Displacement d [mm]", ylabel="Tangent stiffness [N/mm]")
        left.set_title("Paper's model")
        left.legend(handles=_families(curves), loc="upper center", bbox_to_anchor=(0.5, 0.995))
        _at_rest(right)
        for axes, x, y in ((left, 0.0, wanted), (right, 2.96, 1.0 + STIFFNESS_VARIATION)):
            axes.axhline(y, color=VERMILION, linewidth=1.3, linestyle=(0, (1, 1.5)))
            axes.text(x, 1.02 * y, "printed: 1500 % above α = 3.5", color=VERMILION, ha="center", fontsize=10)
    caption = (
        "Left: stiffness over displacement by the paper's model; dashed where a leaf exceeds the printed yield stress."
        " Right: stiffness at rest over that at α = 3.5. Dots: where it is 1500 % higher. In the printed range"
        " (shaded) and at rest, of the laws drawn, only linear beam theory gets there; leaves on cylinders, which do"
        " not yield, do at α = 1.905."
    )
    return Drawing("figure_8", "Stiffness over displacement", figure, caption)


def _at_rest(axes: Axes) -> None:
    axes.axvspan(ASPECT_RATIO_STIFF, ASPECT_RATIO_SOFT, color="#eef3f7", zorder=0.4)
    stop = np.sqrt(CLAMP_HEIGHT * (4.0 * PROTECTING_RADIUS - CLAMP_HEIGHT)) / CLAMP_HEIGHT
    order: tuple[Theory, ...] = ("linear", "guided", "wrapped")
    for theory in order:
        ratios = np.linspace(1.01 * stop if theory == "wrapped" else 1.6, 3.6, 401)
        stiffness = states(theory, 0.0, ratios).stiffness / rest_stiffness(theory=theory)[0]
        label, colour = _LOOKS[theory]
        dashes = (0, (5, 2)) if theory == "linear" else "solid"
        axes.plot(ratios, stiffness, color=colour, label=label, linestyle=dashes)
        wanted = 1.0 + STIFFNESS_VARIATION
        at = float(np.interp(-wanted, -stiffness, ratios))  # the stiffness falls
        axes.plot([at], [wanted], "o", color=colour, markersize=6.0, zorder=6)
    axes.text(2.75, 0.4, "printed range", color=SOFT, ha="center")
    axes.set(xlim=(1.6, 3.6), ylim=(0, 24), xlabel="Aspect ratio α", ylabel="Stiffness over that at α = 3.5 [-]")
    axes.set_title("At rest")
    axes.legend(loc="upper right", bbox_to_anchor=(1.0, 0.63))
