"""Panels that are short beside their distance to the parts of the boundary that they do not touch."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.sections.boundary import ENDS, SMOOTH, Boundary, images
from varistiff.sections.outline import Points

Breaks = list[NDArray[np.float64]]  # panel ends along each segment, from 0 to 1
SEPARATION = 1.7  # largest panel length over the distance to the rest of the boundary
SAMPLES = np.array([0.0, 0.07, 0.25, 0.5, 0.75, 0.93, 1.0])  # of a panel, to see what is near it
CROWDED = "has walls or gaps too thin, or too many corners, to be solved; allowed are thicker walls, or fewer corners"


def split_overlong(breaks: Breaks, overlong: Callable[[Breaks], NDArray[np.bool_]], limit: int) -> Breaks:
    """Halve the panels that ``overlong`` finds until it finds none.

    Raises
    ------
    InputError : that would take more panels than the limit
    """
    for _ in range(60):
        if sum(marks.size - 1 for marks in breaks) > limit:
            break
        split = overlong(breaks)
        if not split.any():
            return breaks
        breaks = _halved(breaks, split)
    raise InputError(CROWDED)


def _halved(breaks: Breaks, split: NDArray[np.bool_]) -> Breaks:
    """The panel ends with some of all panels split in their middles."""
    cuts = np.cumsum([marks.size - 1 for marks in breaks])[:-1]
    return [
        np.sort(np.concatenate([marks, (0.5 * (marks[:-1] + marks[1:]))[mask]]))
        for marks, mask in zip(breaks, np.split(split, cuts), strict=True)
    ]


def overlong_panels(
    breaks: Breaks, boundary: Boundary, tolerance: float, ignored: NDArray[np.bool_] | None = None
) -> NDArray[np.bool_]:
    """Which panels of all are long beside their distance to another, but of pairs ``ignored[target, source]``."""
    points, tangents = boundary.traced(spread(breaks, SAMPLES)[0])
    tangents /= np.hypot(*tangents.T)[:, None]
    shape = (-1, SAMPLES.size, 2)
    samples = points.reshape(shape)
    length = np.hypot(*np.diff(samples, axis=1).transpose(2, 0, 1)).sum(axis=1)
    long = np.zeros(length.size, dtype=bool)
    touching = 1e-9 * float(length.max())
    tips = _Tips.of(boundary, samples, breaks, tolerance)
    for placed, corners in zip(
        images(boundary.outline, points, tangents), images(boundary.outline, tips.corners, tips.corners), strict=True
    ):
        source, tangent = placed.position.reshape(shape), placed.tangent.reshape(shape)
        # the middles tell which pairs can be near enough at all
        middle = samples[:, None, SAMPLES.size // 2] - source[None, :, SAMPLES.size // 2]
        gap = np.hypot(middle[..., 0], middle[..., 1]) - 0.5 * (length[:, None] + length)
        near = length > SEPARATION * gap
        if ignored is not None:
            near &= ~ignored
        targets, sources = np.nonzero(near)
        reach = _reach(samples[targets], source[sources], tangent[sources], touching)
        bad = length[sources] > SEPARATION * reach
        targets, sources = targets[bad], sources[bad]
        long[sources[~tips.shared(targets, sources, corners.position, touching)]] = True
    return long


class _Tips(NamedTuple):
    """Which panels lie, whole, so near to a corner of their segment that what is there does not count.

    The share of the energy there is below a tolerance. ``near`` of shape (panels, 2) is for both ends of the segments
    ``owner``, ``corners`` (2 segments, 2) are those ends.
    """

    near: NDArray[np.bool_]
    owner: NDArray[np.int_]
    corners: Points

    @classmethod
    def of(cls, boundary: Boundary, samples: Points, breaks: Breaks, tolerance: float) -> _Tips:
        """Panels with samples of shape (panels, m, 2)."""
        owner = np.repeat(np.arange(len(breaks)), [marks.size - 1 for marks in breaks])
        angles = boundary.angles
        reach = boundary.size * tolerance ** (angles / (2.0 * math.pi))
        reach[np.abs(angles - math.pi) < SMOOTH] = 0.0
        corners, _ = boundary.traced([ENDS] * len(boundary.segments))
        away = samples[:, None] - corners.reshape(-1, 2, 2)[owner][:, :, None]
        distance = np.hypot(away[..., 0], away[..., 1]).max(axis=2)
        return cls(distance < reach[owner], owner, corners)

    def shared(
        self, targets: NDArray[np.int_], sources: NDArray[np.int_], placed: Points, touching: float
    ) -> NDArray[np.bool_]:
        """Whether pairs of panels are the two sides of one corner; ``placed`` are the corners of the sources.

        Other panels that are close to each other count however near a corner is: across a gap the warping jumps.
        """
        one, two = (
            ends.reshape(-1, 2, 2)[self.owner[panels]] for ends, panels in ((self.corners, targets), (placed, sources))
        )
        away = one[:, :, None] - two[:, None]
        same = np.hypot(away[..., 0], away[..., 1]) < touching
        found = same & self.near[targets][:, :, None] & self.near[sources][:, None]
        return np.asarray(found.any(axis=(1, 2)), dtype=np.bool_)


def _reach(target: Points, source: Points, tangent: Points, touching: float) -> NDArray[np.float64]:
    """How far each source panel's kernel is from singular at its target panel; samples (n, m, 2), result (n,) [m].

    It is |d|^2/|d.n|: the distance itself across a gap, the diameter of curvature along one smooth curve.
    """
    dx, dy = (source[:, None, :, axis] - target[:, :, None, axis] for axis in (0, 1))
    square = dx * dx + dy * dy
    across = np.abs(dx * tangent[:, None, :, 1] - dy * tangent[:, None, :, 0])
    # panels that share an end meet at a joint: the grading there deals with them
    meet = square[:, [0, 0, -1, -1], [0, -1, 0, -1]].min(axis=1) < touching**2
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = np.where(across > 1e-12 * np.sqrt(square), square / across, np.inf)
    found: NDArray[np.float64] = np.where(meet, np.inf, reach.min(axis=(1, 2)))
    return found


def spread(breaks: Breaks, shares: NDArray[np.float64]) -> tuple[list[NDArray[np.float64]], NDArray[np.float64]]:
    """The same places on every panel as t of each segment, and the widths of all panels."""
    low = np.concatenate([marks[:-1] for marks in breaks])
    width = np.concatenate([marks[1:] for marks in breaks]) - low
    first = np.cumsum([marks.size - 1 for marks in breaks])[:-1]
    return np.split((low[:, None] + width[:, None] * shares).ravel(), first * shares.size), width
