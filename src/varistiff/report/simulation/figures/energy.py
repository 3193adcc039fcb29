"""Where every joule went: what came in, what is stored, what is lost."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from varistiff.report.display import Display
from varistiff.report.simulation.balance import Balance, Term
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import Panel, Trace, draw_panel, finish, key, sheet
from varistiff.report.style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, YELLOW, Drawing, styled

TITLE = "Energy"
MOST = 1000  # points of the edge of a filled area
ROW = 0.19  # inches of a line in the key
LINES: tuple[tuple[str, Any], ...] = (
    (BLUE, "solid"),
    (VERMILION, "solid"),
    (GREEN, (0, (6.0, 1.5))),
    (ORANGE, (0, (1.2, 1.4))),
    (PURPLE, (0, (6.0, 1.5, 1.2, 1.5))),
    (BLACK, (0, (3.0, 1.3))),
    (SKY, "solid"),
)
AREAS = (
    (ORANGE, ""),
    (SKY, ""),
    (GREEN, ""),
    (YELLOW, ""),
    (BLUE, ""),
    (VERMILION, ""),
    (PURPLE, ""),
    (ORANGE, "///"),
    (SKY, "///"),
    (GREEN, "///"),
    (YELLOW, "///"),
)


def draw(run: Run) -> Drawing | None:
    """Draw all terms of the balance that are not zero; None where there are none."""
    balance = Balance.of(run)
    held = [(f"in: {term.label}", term) for term in balance.inflows]
    held += [(term.label, term) for term in balance.stores]
    if not held and not balance.losses:
        return None
    heights = [max(2.0, 0.25 + ROW * count) for count in (len(held), len(balance.losses)) if count]
    with styled():
        figure, axes = sheet(run, heights, TITLE)
        if held:
            _held(run, axes[0], held)
        if balance.losses:
            _losses(run, axes[-1], balance.losses)
    caption = (
        "Every term of the energy balance that is not zero, each integrated from its own law. Lines: energy that came"
        " in from outside and energy stored, since the start. Areas: losses, stacked; the upper edge is their sum."
        " What came in equals what is stored plus what is lost, but for the residual."
    )
    return Drawing("energy", TITLE, figure, caption)


def _held(run: Run, axes: Axes, terms: list[tuple[str, Term]]) -> None:
    looks = (LINES[index % len(LINES)] for index in range(len(terms)))
    traces = [Trace(term.values, label, *look) for (label, term), look in zip(terms, looks, strict=True)]
    drawn = draw_panel(run, axes, Panel("In and stored", "J", tuple(traces)))
    key(axes, drawn.handles)


def _losses(run: Run, axes: Axes, terms: tuple[Term, ...]) -> None:
    step = max(run.time.size // MOST, 1)
    # the largest at the bottom: thin ones would bend with it otherwise
    ordered = sorted(terms, key=lambda term: -float(np.nanmax(term.values)))
    layers = np.nan_to_num(np.stack([term.values for term in ordered]))[:, ::step]
    total = layers.sum(axis=0)
    shown: Display = run.shown("J", [total])
    x, low, handles = run.x[::step], np.zeros_like(total), []
    for term, layer, (colour, hatch) in zip(ordered, layers, AREAS, strict=False):
        high = low + layer * shown.factor
        look: dict[str, Any] = {"facecolor": colour, "hatch": hatch, "edgecolor": "white", "linewidth": 0.6}
        axes.fill_between(x, low, high, zorder=2.0, **look)
        handles.append(Patch(label=term.label, **look))
        low = high
    axes.plot(x, low, color=BLACK, linewidth=1.4, zorder=3.0)
    axes.set_ylim(0.0, 1.07 * float(low.max()))
    finish(axes, "Lost", shown)
    key(axes, handles[::-1])  # as they lie above each other
