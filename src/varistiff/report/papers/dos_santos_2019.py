"""Our figures for dos Santos and Richter (2019)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from varistiff.elastic.linear_cantilever import linear_cantilever
from varistiff.elastic.roller_contact import centreline
from varistiff.papers.dos_santos_2019.beams import leaf
from varistiff.papers.dos_santos_2019.experiment import contact, linear_forces
from varistiff.papers.dos_santos_2019.paper_values import ACTIVE_LENGTHS, BEAMS, FORCES
from varistiff.report.style import BLUE, GREEN, INK, ORANGE, SOFT, VERMILION, Drawing, ramp, styled

MM = 1e3
NAMES = {
    "aluminium_wide": "6061, 31.70 mm wide",
    "aluminium_narrow": "6061, 25.49 mm wide",
    "spring_steel": "1075 spring steel",
    "low_carbon_steel": "low-carbon steel",
}
COLOURS = dict(zip(BEAMS, (BLUE, ORANGE, VERMILION, GREEN), strict=True))
MARKERS = dict(zip(BEAMS, "os^D", strict=True))


def deflected_beam() -> Drawing:
    """Shapes of the spring-steel beam at 0.75 m under 2 N, 11 N and 20 N, by the elastica and by linear theory."""
    element, length = leaf("spring_steel"), ACTIVE_LENGTHS["l_1"]
    forces = (FORCES[0], 0.5 * sum(FORCES), FORCES[1])
    with styled():
        figure = Figure(figsize=(7.4, 3.5))
        axes = figure.add_axes((0.10, 0.12, 0.87, 0.80))
        for force, colour in zip(forces, ramp(len(forces)), strict=True):
            state = contact("spring_steel", length, force)
            line = MM * centreline(state.slope, state.active_length, tail=element.length - state.active_length)
            axes.plot(*line.T, color=colour)
            x, y = _linear_shape(state.along, state.across, element.flexural_rigidity)
            axes.plot(x * MM, y * MM, color=INK, linewidth=1.3, linestyle=(0, (4.0, 2.5)))
            axes.plot(state.along * MM, state.across * MM, "o", color="white", markeredgecolor=colour, markersize=7)
            text = f"{force:g} N, {math.degrees(state.slope):.1f}°"
            axes.text(line[-1, 0] + 8.0, line[-1, 1], text, color=INK, va="center")
        axes.set_aspect("equal")
        axes.set(xlim=(0.0, 1060.0), ylim=(-25.0, 350.0))
        axes.set(xlabel="Along the clamp's axis [mm]", ylabel="Across [mm]", title="Softest beam of the experiment")
        looks = [
            Line2D([], [], color=SOFT, label="elastica, with force P and slope"),
            Line2D([], [], color=INK, linewidth=1.3, linestyle=(0, (4.0, 2.5)), label="linear theory to the contact"),
            Line2D([], [], color="white", marker="o", markeredgecolor=SOFT, markersize=7, label="contact"),
        ]
        axes.legend(handles=looks, loc="upper left", bbox_to_anchor=(0.01, 0.99))
    caption = (
        "The spring-steel beam with an active length of 0.75 m under the least, the middle and the largest printed"
        " force, with the slope at the contact. The dashed line is linear theory to the same contact. The paper"
        " prints no shape."
    )
    return Drawing("deflected_beam", "Deflected beam", figure, caption)


def _linear_shape(along: float, across: float, rigidity: float) -> tuple[np.ndarray, np.ndarray]:
    """Cubic of an end-loaded cantilever through the contact."""
    x = np.linspace(0.0, along, 60)
    force, _, _ = linear_cantilever(across, along, rigidity)  # type: ignore[arg-type]  # floats do
    return x, np.asarray(force) * x**2 * (3.0 * along - x) / (6.0 * rigidity)


def force_at_long_length() -> Drawing:
    """Force over the load parameter at 0.75 m."""
    return _force(ACTIVE_LENGTHS["l_1"], "force_at_long_length")


def force_at_short_length() -> Drawing:
    """Force over the load parameter at 0.43 m."""
    return _force(ACTIVE_LENGTHS["l_2"], "force_at_short_length")


def _force(length: float, name: str) -> Drawing:
    forces = np.linspace(*FORCES, 25)
    with styled():
        figure = Figure(figsize=(7.4, 6.3))
        axes = figure.add_axes((0.125, 0.44, 0.55, 0.50))
        below = figure.add_axes((0.125, 0.10, 0.55, 0.26), sharex=axes)
        for beam, row in BEAMS.items():
            look: dict[str, Any] = {"color": COLOURS[beam]}
            states = [contact(beam, length, float(force)) for force in forces]
            alpha = np.array([state.load_parameter for state in states])
            computed = np.array([state.across_force for state in states])
            axes.fill_between(
                alpha, computed - row.rms_error, computed + row.rms_error, alpha=0.16, linewidth=0, **look
            )
            axes.plot(alpha, computed, marker=MARKERS[beam], markevery=6, markersize=5.5, label=NAMES[beam], **look)
            axes.plot(alpha, 0.5 * computed, linewidth=1.3, linestyle=(0, (4.0, 2.5)), **look)
            linear = np.array([abs(linear_forces(state, beam)["arc_normal"] - state.across_force) for state in states])
            below.plot(alpha, linear, marker=MARKERS[beam], markevery=6, markersize=4.5, linewidth=1.6, **look)
            below.plot(alpha[[0, -1]], [row.rms_error] * 2, linewidth=1.8, linestyle=(0, (1.0, 1.2)), **look)
        axes.set(xlim=(0.0, None), ylim=(0.0, 24.0), ylabel="Contact force P [N]", title=f"Active length {length:g} m")
        axes.tick_params(labelbottom=False)
        below.set_yscale("log")
        below.set_yticks([1e-4, 1e-2, 1.0], ["0.0001", "0.01", "1"])
        below.set(ylim=(3e-6, 20.0), xlabel="Load parameter $\\alpha_0$", ylabel="Difference [N]")
        below.xaxis.label.set_parse_math(True)
        _force_legends(figure)
    caption = (
        f"Above: P of the roller beam over the load parameter at {length:g} m, over the printed range of forces, with"
        " the printed error of each beam as a band; dashed, the force by Eqs. (3) and (15) as printed. Below: what"
        " linear theory on the same arc length, its force normal to the beam, would change, and dotted the printed"
        " errors. The trials are not published."
    )
    return Drawing(name, f"Contact force over the load parameter, {length:g} m", figure, caption)


def _force_legends(figure: Figure) -> None:
    beams = [
        Line2D([], [], color=COLOURS[beam], marker=MARKERS[beam], markersize=5.5, label=NAMES[beam]) for beam in BEAMS
    ]
    figure.legend(handles=beams, loc="upper left", bbox_to_anchor=(0.695, 0.94), title="Beam", alignment="left")
    kinds = [
        Line2D([], [], color=SOFT, label="roller beam"),
        Line2D([], [], color=SOFT, linewidth=9, alpha=0.2, label="± printed error"),
        Line2D([], [], color=SOFT, linewidth=1.3, linestyle=(0, (4.0, 2.5)), label="(3), (15) as printed"),
    ]
    figure.legend(handles=kinds, loc="upper left", bbox_to_anchor=(0.695, 0.70))
    lines = [
        Line2D([], [], color=SOFT, linewidth=1.6, label="linear theory"),
        Line2D([], [], color=SOFT, linewidth=1.8, linestyle=(0, (1.0, 1.2)), label="printed error"),
    ]
    figure.legend(handles=lines, loc="upper left", bbox_to_anchor=(0.695, 0.355))
