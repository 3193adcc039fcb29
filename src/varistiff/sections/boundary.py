"""The boundary of a cross-section as the solver sees it: segments, corners, symmetry, size."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from varistiff.sections.outline import Image, Outline, Points, Segment, is_straight

SMOOTH = 1e-3  # a corner flatter than this [rad] is a tangent joint, which drawings round to 1e-6 of a length
ENDS = np.array([0.0, 1.0])


@dataclass(frozen=True)
class Corner:
    """Joint of two segments: where, and the angle inside the material [rad]."""

    point: tuple[float, float]
    interior_angle: float

    @property
    def is_reentrant(self) -> bool:
        """Whether the ideal stress is unbounded here."""
        return self.interior_angle > math.pi + SMOOTH

    @property
    def is_sharp(self) -> bool:
        """Whether the tangent jumps."""
        return abs(self.interior_angle - math.pi) > SMOOTH


class Placed(NamedTuple):
    """All nodes as one element of the symmetry group places them; ``sign`` is -1 for a reflection."""

    position: Points
    tangent: Points
    sign: float


@cache
def gauss(order: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Gauss-Legendre nodes and weights on [0, 1]."""
    nodes, weights = np.polynomial.legendre.leggauss(order)
    return 0.5 * (nodes + 1.0), 0.5 * weights


def images(outline: Outline, position: Points, tangent: Points) -> list[Placed]:
    """Place nodes by every element of the outline's symmetry group, the identity first."""
    found = []
    for turn in range(outline.rotations):
        angle = 2.0 * math.pi * turn / outline.rotations
        c, s = math.cos(angle), math.sin(angle)
        rotation = np.array([[c, s], [-s, c]])
        found.append(Placed(position @ rotation, tangent @ rotation, 1.0))
        if outline.mirror:
            flipped = np.array([1.0, -1.0])
            found.append(Placed((position * flipped) @ rotation, -(tangent * flipped) @ rotation, -1.0))
    return found


class Boundary(NamedTuple):
    """What every placing of nodes on an outline needs to know of it, for its fundamental segments.

    ``starts``, from ``origin``, and ``chords`` [m], shape (n, 2); ``curved`` tells which are not their chords;
    ``angles`` holds the interior ones at both ends, shape (n, 2), ``lengths`` [m] shape (n,); what a place costs of J
    goes with its share of ``size`` [m].
    """

    outline: Outline
    segments: list[Segment]
    curved: list[int]
    starts: Points
    chords: Points
    lengths: NDArray[np.float64]
    angles: NDArray[np.float64]
    corners: tuple[Corner, ...]
    origin: Points
    size: float

    def traced(self, parameters: Sequence[NDArray[np.float64]]) -> tuple[Points, Points]:
        """Points from the origin and velocities at t on each segment, one after another, shapes (m, 2)."""
        counts = [t.size for t in parameters]
        velocity = np.repeat(self.chords, counts, axis=0)
        point = np.repeat(self.starts, counts, axis=0) + np.concatenate(parameters)[:, None] * velocity
        first = np.cumsum([0, *counts])
        for number in self.curved:
            own, segment, t = slice(*first[number : number + 2]), self.segments[number], parameters[number]
            point[own], velocity[own] = segment.point(t) - self.origin, segment.velocity(t)
        return point, velocity


def boundary_of(outline: Outline) -> Boundary:
    """The boundary of an outline, from an origin within it so that nothing is lost where it lies far away."""
    segments: list[Segment] = []
    ends: list[Points] = []
    angles: list[NDArray[np.float64]] = []
    corners: list[Corner] = []
    for number, piece in enumerate(outline.pieces):
        joints = _interior_angles(outline, number)
        points = np.array([segment.point(ENDS) for segment in piece])
        segments += piece
        ends.append(points)
        angles.append(np.stack([joints[:-1], joints[1:]], axis=1))
        places = [*points[:, 0].tolist(), points[-1, 1].tolist()]
        corners += [Corner((x, y), angle) for (x, y), angle in zip(places, joints.tolist(), strict=True)]
    starts, stops = np.concatenate(ends).transpose(1, 0, 2)
    lengths = np.hypot(*(stops - starts).T)
    curved = [number for number, segment in enumerate(segments) if not is_straight(segment)]
    for number in curved:
        lengths[number] = np.hypot(*np.diff(segments[number].point(np.linspace(0.0, 1.0, 9)), axis=0).T).sum()
    found = Boundary(
        outline=outline,
        segments=segments,
        curved=curved,
        starts=starts,
        chords=stops - starts,
        lengths=lengths,
        angles=np.concatenate(angles),
        corners=tuple(corner for corner in corners if corner.is_sharp),
        origin=np.zeros(2),
        size=0.0,
    )
    if outline.rotations == 1 and not outline.mirror:
        origin = starts.mean(axis=0)
        found = found._replace(starts=starts - origin, origin=origin)
    return found._replace(size=_size(found))


def sharp_corners(outline: Outline) -> tuple[Corner, ...]:
    """Corners of an outline's fundamental pieces."""
    return boundary_of(outline).corners


def _size(boundary: Boundary) -> float:
    """Length that goes with J by the fourth root [m]: 2.3 (A^4/(40 Ip))^(1/4), which is the diagonal of a square.

    Saint-Venant's estimate of J from the area and the polar moment is low for tubes: the size is rather too small.
    """
    t, w = gauss(16)
    placed = images(boundary.outline, *boundary.traced([t] * len(boundary.segments)))
    velocity = np.concatenate([one.tangent for one in placed])
    point = np.concatenate([one.position for one in placed])
    point -= point.mean(axis=0)  # the origin may lie anywhere
    flux = (point[:, 0] * velocity[:, 1] - point[:, 1] * velocity[:, 0]) * np.tile(w, len(point) // w.size)
    area = 0.5 * float(flux.sum())
    centroid = (point * flux[:, None]).sum(axis=0) / (3.0 * area)
    polar = 0.25 * float(((point**2).sum(axis=1) * flux).sum()) - area * float(centroid @ centroid)
    return 2.3 * area / (40.0 * polar) ** 0.25


def _neighbours(outline: Outline, piece: tuple[Segment, ...], way: float) -> tuple[Segment, Segment]:
    """The segments before and after a fundamental piece, as the symmetry continues it."""
    step = 2.0 * math.pi / outline.rotations
    if not outline.mirror:
        return Image(piece[-1], -way * step), Image(piece[0], way * step)
    low, high = Image(piece[0], 0.0, mirrored=True), Image(piece[-1], step, mirrored=True)
    if way > 0.0:
        return low, high
    return Image(piece[0], step, mirrored=True), Image(piece[-1], 0.0, mirrored=True)


def _interior_angles(outline: Outline, number: int) -> NDArray[np.float64]:
    """At the joints of a fundamental piece's segments, from its start to its end."""
    piece = outline.pieces[number]
    before, after = _neighbours(outline, piece, 1.0 if number == 0 else -1.0)
    velocity = np.array([segment.velocity(ENDS) for segment in (before, *piece, after)]) @ [1.0, 1.0j]
    found: NDArray[np.float64] = math.pi - np.angle(velocity[1:, 0] / velocity[:-1, 1])
    return found
