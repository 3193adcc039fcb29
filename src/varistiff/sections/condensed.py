"""Nodes of an outline whose corners between straight sides are condensed instead of graded."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.sections.boundary import Boundary
from varistiff.sections.outline import Points
from varistiff.sections.panels import NODES_MAX, Condensed, Nodes, grading_levels, nodes_between, panel_ends
from varistiff.sections.separation import CROWDED, Breaks, overlong_panels, split_overlong
from varistiff.sections.wedge import NARROW

Values = NDArray[np.float64]
Complex = NDArray[np.complex128]
Integers = NDArray[np.int_]
ROOM = 2.5  # largest length of a condensed panel over its distance to the rest of the boundary
GROWTH = 5.0  # largest length of a straight panel over its distance to a corner
CHORDS = 48  # in place of a curve, where distances to it are asked
POINTS = np.array([0.25, 0.5, 0.75, 1.0])  # of a condensed panel, to see what is near it
TOUCHING = 1e-9  # share of a side
SAME = 1e-8  # share of a segment within which two panel ends are one
CELLS = 10_000  # pairs of corner and chord at a time, for the memory


class _Sides:
    """The segments of a boundary, and which of their corners are condensed; places as complex numbers."""

    def __init__(self, boundary: Boundary, tolerance: float) -> None:
        self.boundary = boundary
        self.levels = grading_levels(boundary, tolerance)
        self.start, self.chord = _complex(boundary.starts), _complex(boundary.chords)
        self.way = self.chord / boundary.lengths  # of no use for curves
        counts = np.cumsum([len(piece) for piece in boundary.outline.pieces])
        before = np.concatenate([np.roll(part, 1) for part in np.split(np.arange(counts[-1]), counts[:-1])])
        straight = np.ones(before.size, dtype=bool)
        straight[boundary.curved] = False
        angle = boundary.angles[:, 0]
        graded = (self.levels[:, 0] > 0) | (self.levels[before, 1] > 0)
        chosen = graded & straight & straight[before] & (np.minimum(angle, 2.0 * np.pi - angle) > NARROW)
        self.corners: Complex = self.start[graded]
        self.after = np.flatnonzero(chosen)
        self.before = before[self.after]

    def fewest(self) -> int:
        """Panels that are needed whatever is near: one a segment, or one for each condensed end."""
        ends = np.bincount(np.concatenate([self.before, self.after]), minlength=self.start.size)
        return int(np.maximum(1, ends).sum())

    def lengths(self) -> Values:
        """Of the condensed panels [m]: halved until each is short beside its distance to other segments."""
        whole = self.boundary.lengths
        found: Values = 0.5 * np.minimum(whole[self.before], whole[self.after])
        chords = self._chords()
        height = max(1, CELLS // chords[0].size)
        for low in range(0, found.size, height):
            active = np.arange(low, min(low + height, found.size))
            while active.size:
                active = active[found[active] > ROOM * self._distance(active, found[active], *chords)]
                found[active] *= 0.5
        return found

    def _distance(self, which: Integers, length: Values, start: Complex, chord: Complex, owner: Integers) -> Values:
        """From the condensed panels of some corners to all segments but their own two."""
        before, after = self.before[which], self.after[which]
        steps = (length[:, None] * np.stack([-self.way[before], self.way[after]], axis=1))[:, :, None] * POINTS
        gap = (self.start[after, None] + steps.reshape(which.size, -1))[:, :, None] - start
        share = np.clip((gap * chord.conj()).real / np.abs(chord) ** 2, 0.0, 1.0)
        distance = np.abs(gap - share * chord).min(axis=1)
        distance[(owner == before[:, None]) | (owner == after[:, None])] = np.inf
        found: Values = distance.min(axis=1)
        return found

    def _chords(self) -> tuple[Complex, Complex, Integers]:
        """Starts and differences of straight lines along the boundary, and the segments that they belong to."""
        straight = np.setdiff1d(np.arange(self.start.size), self.boundary.curved)
        starts, chords, owners = [self.start[straight]], [self.chord[straight]], [straight]
        for number in self.boundary.curved:
            curve = self.boundary.segments[number].point(np.linspace(0.0, 1.0, CHORDS + 1))
            points = _complex(curve - self.boundary.origin)
            starts.append(points[:-1])
            chords.append(np.diff(points))
            owners.append(np.full(CHORDS, number))
        return np.concatenate(starts), np.concatenate(chords), np.concatenate(owners)


def _complex(points: Points) -> Complex:
    return points[:, 0] + 1.0j * points[:, 1]


def place_condensed(boundary: Boundary, *, order: int, tolerance: float, limit: int = NODES_MAX) -> Nodes:
    """Return quadrature nodes with the corners between straight sides condensed.

    Each such corner has one panel on each of its sides, both of one length: half the shorter side, or less where other
    parts of the boundary are near. From there panels grow away from all corners. Straight panels may lie as close to
    each other as they like, so a thin wall costs nodes at its ends only; curves, and the few corners that are too
    narrow, are treated as ``place_nodes`` does.

    Parameters
    ----------
    boundary : of an outline without symmetry
    order, tolerance, limit : as of ``place_nodes``

    Raises
    ------
    InputError : more nodes than the limit would be needed
    """
    sides = _Sides(boundary, tolerance)
    if sides.fewest() > limit // order:
        raise InputError(CROWDED)
    length = sides.lengths()
    ends = np.zeros((sides.start.size, 2))  # of each segment, 0 where no corner is condensed
    ends[sides.after, 0] = ends[sides.before, 1] = length
    breaks = [_marked(sides, number, *pair) for number, pair in enumerate((ends / boundary.lengths[:, None]).tolist())]
    breaks = split_overlong(breaks, partial(_too_long, sides=sides, tolerance=tolerance), limit // order)
    nodes = nodes_between(boundary, breaks, order)
    first = order * np.cumsum([0, *(marks.size - 1 for marks in breaks)])
    outward = np.arange(order)
    rows = np.concatenate([first[sides.before + 1, None] - 1 - outward, first[sides.after, None] + outward], axis=1)
    angle = boundary.angles[sides.after, 0]
    return nodes._replace(condensed=Condensed(rows, angle, length, boundary.starts[sides.after]))


def _marked(sides: _Sides, number: int, low: float, high: float) -> Values:
    """Panel ends along one segment, as its own ends ask for them; ``low`` and ``high`` are its condensed shares."""
    segment, (first, last) = sides.boundary.segments[number], sides.levels[number].tolist()
    first, last = 0 if low else first, 0 if high else last
    ends = panel_ends(segment, first, last).tolist() if first or last or not (low or high) else [0.0, 1.0]
    rising, falling = _grown(low), [1.0 - mark for mark in _grown(high)]
    if rising and falling and falling[-1] - rising[-1] < SAME:  # they meet in the middle
        falling.pop()
    return np.array(sorted(ends + rising + falling))


def _grown(length: float) -> list[float]:
    """Ends of a condensed panel, and of those that grow from it up to the middle of the segment."""
    marks = []
    while 0.0 < length <= 0.5 + SAME:
        marks.append(length)
        length *= 1.0 + GROWTH
    return marks


def _too_long(breaks: Breaks, sides: _Sides, tolerance: float) -> NDArray[np.bool_]:
    """Which panels of all are too long for what is near them."""
    boundary = sides.boundary
    counts = [marks.size - 1 for marks in breaks]
    owner = np.repeat(np.arange(len(breaks)), counts)
    first = np.cumsum([0, *counts])
    condensed = np.zeros(owner.size, dtype=bool)
    condensed[first[sides.after]] = condensed[first[sides.before + 1] - 1] = True
    straight = np.ones(owner.size, dtype=bool)
    straight[np.isin(owner, boundary.curved)] = False
    long = _near_corners(sides, breaks, owner) & straight & ~condensed
    if boundary.curved:
        ignored = (straight[:, None] & straight) | condensed
        long |= overlong_panels(breaks, boundary, tolerance, ignored)
    return long


def _near_corners(sides: _Sides, breaks: Breaks, owner: Integers) -> NDArray[np.bool_]:
    """Which panels are long beside their distance to a corner that they do not touch."""
    length = np.concatenate([np.diff(marks) for marks in breaks]) * sides.boundary.lengths[owner]
    low = np.concatenate([marks[:-1] for marks in breaks]) * sides.boundary.lengths[owner]
    along = (sides.corners - sides.start[owner, None]) * sides.way[owner, None].conj()
    gap = along - np.clip(along.real, low[:, None], (low + length)[:, None])
    distance = np.abs(gap)
    distance[distance < TOUCHING * sides.boundary.lengths[owner, None]] = np.inf
    found: NDArray[np.bool_] = length > GROWTH * distance.min(axis=1, initial=np.inf) * (1.0 + TOUCHING)
    return found
