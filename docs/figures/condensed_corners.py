"""Nodes of an angle with graded and with condensed corners, and what they cost in two sections."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from varistiff.core.errors import InputError
from varistiff.report.style import BLUE, INK, METAL_LIGHT, ORANGE, SOFT, styled
from varistiff.sections.boundary import boundary_of
from varistiff.sections.condensed import place_condensed
from varistiff.sections.outline import Line, Outline
from varistiff.sections.panels import Nodes, place_nodes
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.saint_venant import solve_torsion

ANGLE = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
STAR = np.tile([1.0, 0.6], 20) * np.exp(1j * np.pi * np.arange(40) / 20)
HALF_A_POINT = Outline(((Line((1.0, 0.0), (STAR[1].real, STAR[1].imag)),),), rotations=20, mirror=True)
GRADED = ((3, 1e-3), (4, 1e-4), (4, 1e-5), (6, 1e-5), (6, 1e-6), (8, 1e-6), (8, 1e-7), (10, 1e-8))
CONDENSED = tuple((order, 1e-9) for order in (3, 4, 5, 6, 7, 8, 9, 10))
SHOWN = {"graded": (6, 1e-5), "condensed": (6, 1e-9)}


def draw() -> Figure:
    """Two pictures of nodes, and error over number of nodes."""
    angle = polygon_of_points(ANGLE).outline()
    star = polygon_of_points([(float(z.real), float(z.imag)) for z in STAR]).outline()
    with styled():
        figure = Figure(figsize=(9.0, 4.4))
        for number, (name, place) in enumerate((("graded", place_nodes), ("condensed", place_condensed))):
            order, share = SHOWN[name]
            nodes = place(boundary_of(angle), order=order, tolerance=share)
            _outline(figure.add_axes((0.01, 0.53 - 0.49 * number, 0.26, 0.40)), nodes, name)
        axes = figure.add_axes((0.37, 0.145, 0.60, 0.80))
        for outline, exact, marker, name in (
            (angle, solve_torsion(angle, order=16, tolerance=1e-12).torsion_constant, "o", "angle"),
            (star, solve_torsion(HALF_A_POINT, order=12, tolerance=1e-10).torsion_constant, "^", "star"),
        ):
            for place, rungs, colour in ((place_nodes, GRADED, ORANGE), (place_condensed, CONDENSED, BLUE)):
                counts, errors = _errors(outline, exact, place, rungs)
                axes.loglog(counts, errors, color=colour, marker=marker, markersize=5.0, linewidth=1.4)
                where, is_star = (-1 if colour == BLUE else 0), marker == "^"
                axes.annotate(
                    f"{name}, {'condensed' if colour == BLUE else 'graded'}",
                    (counts[where], errors[where]),
                    (8, -2) if is_star and colour == BLUE else (0, -6 if colour == BLUE else 6),
                    textcoords="offset points",
                    color=colour,
                    ha="left" if is_star and colour == BLUE else "center",
                    va="top" if colour == BLUE else "bottom",
                )
        axes.set(xlabel="Nodes", ylabel="Relative error of J", xlim=(30.0, 6000.0), ylim=(1e-11, 1.0))
    return figure


def _errors(
    outline: Outline, exact: float, place: Callable[..., Nodes], rungs: Sequence[tuple[int, float]]
) -> tuple[list[int], list[float]]:
    counts, errors = [], []
    for order, share in rungs:
        with suppress(InputError):
            nodes = place(boundary_of(outline), order=order, tolerance=share, limit=3600)
            counts.append(nodes.weight.size)
            errors.append(abs(solve_torsion(outline, nodes=nodes).torsion_constant / exact - 1.0))
    return counts, errors


def _outline(axes: Axes, nodes: Nodes, name: str) -> None:
    corners = np.array(ANGLE)
    axes.fill(*corners.T, facecolor=METAL_LIGHT, edgecolor=SOFT, linewidth=0.8)
    axes.plot(*(nodes.position + nodes.origin).T, ".", color=ORANGE if name == "graded" else BLUE, markersize=4.0)
    axes.text(1.08, 1.92, f"{nodes.weight.size} nodes,\n{name}", color=INK, va="top")
    axes.set(aspect="equal", xlim=(-0.1, 2.35), ylim=(-0.1, 2.1))
    axes.axis("off")
