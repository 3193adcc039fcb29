"""A twisted prism seen from the side: its silhouette, and the lines along it that are not hidden."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from varistiff.report.view import Array

SHARP = 0.3  # turn of the boundary that counts as an edge [rad]
TIGHT = 0.15  # radius of curvature over the element's, below which a rounded edge is one
LINES = 24  # along an element without edges


@dataclass(frozen=True)
class Edges:
    """Points of the outline whose lines along the element are drawn, shape (n, 2)."""

    points: Array

    @staticmethod
    def facing(outline: Array) -> Edges:
        """The point nearest to a viewer at +x, or the middle of a flat that faces him."""
        x = outline[:, 0]
        nearest = outline[x > x.max() - 1e-6 * np.abs(outline).max()]
        return Edges(0.5 * (nearest.min(axis=0) + nearest.max(axis=0))[None])


def edges_of(outline: Array) -> Edges:
    """Return the corners of a closed polyline, and the middles of its tight curves."""
    before = np.diff(outline, axis=0)
    before = np.roll(before, 1, axis=0)  # side that ends at each vertex
    after = np.roll(before, -1, axis=0)
    turn = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1))
    reach = 0.5 * (np.hypot(*before.T) + np.hypot(*after.T))
    size = float(np.hypot(*outline.T).max())
    bent = (np.abs(turn) > SHARP) | (np.abs(turn) * TIGHT * size > reach)
    runs = np.split(np.arange(turn.size), np.flatnonzero((np.diff(bent) != 0) | (np.diff(np.sign(turn)) != 0)) + 1)
    chosen = []
    for run in runs:
        total = np.cumsum(np.abs(turn[run]))
        if bent[run[0]] and total[-1] > SHARP:
            chosen.append(run[int(np.searchsorted(total, 0.5 * total[-1]))])
    return Edges(outline[chosen] if chosen else np.zeros((0, 2)))


def evenly_spread(outline: Array) -> Edges:
    """Return points at even distances along the outline."""
    place = np.insert(np.cumsum(np.hypot(*np.diff(outline, axis=0).T)), 0, 0.0)
    at = (np.arange(LINES) + 0.5) / LINES * place[-1]
    return Edges(np.stack([np.interp(at, place, outline[:, axis]) for axis in (0, 1)], axis=1))


def silhouette(outline: Array, angles: Array) -> tuple[Array, Array]:
    """Lowest and highest y of the outline turned by each angle [rad]."""
    heights = _heights(outline, angles)
    return heights.min(axis=1), heights.max(axis=1)


def seen_from_the_side(outline: Array, edges: Edges, angles: Array) -> Array:
    """Return y of each point where nothing hides it from +x, else NaN; shape (points, angles)."""
    size = float(np.hypot(*outline.T).max())
    x, y = _depths(edges.points, angles), _heights(edges.points, angles)
    near, at = _depths(outline, angles), _heights(outline, angles)
    shown = y.copy()
    for station in range(angles.size):
        hidden = _hidden(x[station], y[station], near[station], at[station], 1e-3 * size)
        shown[station, hidden] = np.nan
    return shown.T


def _hidden(x: Array, y: Array, near: Array, at: Array, clear: float) -> npt.NDArray[np.bool_]:
    """Whether the outline passes in front of points, by more than ``clear``."""
    low, high = at[:-1, None], at[1:, None]
    crossing = (low < y) != (high < y)
    with np.errstate(divide="ignore", invalid="ignore"):
        front = near[:-1, None] + (y - low) / (high - low) * (near[1:] - near[:-1])[:, None]
    found: npt.NDArray[np.bool_] = (crossing & (front > x + clear)).any(axis=0)
    return found


def _depths(points: Array, angles: Array) -> Array:
    found: Array = np.outer(np.cos(angles), points[:, 0]) - np.outer(np.sin(angles), points[:, 1])
    return found


def _heights(points: Array, angles: Array) -> Array:
    found: Array = np.outer(np.sin(angles), points[:, 0]) + np.outer(np.cos(angles), points[:, 1])
    return found
