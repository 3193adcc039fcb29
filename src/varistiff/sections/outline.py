"""The boundary of a cross-section: closed loops of smooth segments, with their symmetry."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]


class Segment(Protocol):
    """One smooth piece of a boundary, run through by t in [0, 1] with the material on its left."""

    def point(self, t: Points) -> Points:
        """Points [m], shape (n, 2), at t of shape (n,)."""
        ...

    def velocity(self, t: Points) -> Points:
        """d(point)/dt [m], shape (n, 2)."""
        ...


@dataclass(frozen=True)
class Line:
    """Straight segment between two points [m]."""

    start: tuple[float, float]
    end: tuple[float, float]

    def point(self, t: Points) -> Points:
        """See ``Segment``."""
        return np.array(self.start) + t[:, None] * np.subtract(self.end, self.start)

    def velocity(self, t: Points) -> Points:
        """See ``Segment``."""
        return np.broadcast_to(np.subtract(self.end, self.start), (t.size, 2)).astype(float)


@dataclass(frozen=True)
class Arc:
    """Circular arc: centre and radius [m], start angle and sweep [rad]; a negative sweep runs clockwise."""

    centre: tuple[float, float]
    radius: float
    start_angle: float
    sweep: float

    def point(self, t: Points) -> Points:
        """See ``Segment``."""
        angle = self.start_angle + self.sweep * t
        return np.array(self.centre) + self.radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)

    def velocity(self, t: Points) -> Points:
        """See ``Segment``."""
        angle = self.start_angle + self.sweep * t
        return self.radius * self.sweep * np.stack([-np.sin(angle), np.cos(angle)], axis=1)


@dataclass(frozen=True)
class Curve:
    """Any other smooth curve, from a function of t that returns points and velocities, shapes (n, 2)."""

    function: Callable[[Points], tuple[Points, Points]]

    def point(self, t: Points) -> Points:
        """See ``Segment``."""
        return self.function(t)[0]

    def velocity(self, t: Points) -> Points:
        """See ``Segment``."""
        return self.function(t)[1]


@dataclass(frozen=True)
class Image:
    """A segment turned by an angle [rad] about the origin, after a reflection at the x axis where ``mirrored``.

    A reflection swaps the sides, so a mirrored segment runs backwards: the material stays on its left.
    """

    segment: Segment
    angle: float = 0.0
    mirrored: bool = False

    def _transform(self) -> Points:
        c, s, m = math.cos(self.angle), math.sin(self.angle), -1.0 if self.mirrored else 1.0
        return np.array([[c, s], [-s * m, c * m]])  # acts on rows

    def point(self, t: Points) -> Points:
        """See ``Segment``."""
        return self.segment.point(1.0 - t if self.mirrored else t) @ self._transform()

    def velocity(self, t: Points) -> Points:
        """See ``Segment``."""
        velocity = self.segment.velocity(1.0 - t if self.mirrored else t) @ self._transform()
        return -velocity if self.mirrored else velocity


Loop = tuple[Segment, ...]


@dataclass(frozen=True)
class Outline:
    """Closed loops around a cross-section, one fundamental piece each.

    Parameters
    ----------
    pieces : outer loop first and counter-clockwise, then each hole clockwise; with a symmetry only the part of each
        loop in the fundamental sector, from the angle 0 to pi/rotations (2 pi/rotations without a mirror) about the
        origin, or backwards for a hole. A hole off the origin needs ``rotations`` 1 and no mirror.
    rotations : order of the rotational symmetry about the origin
    mirror : whether the x axis is a mirror line too
    """

    pieces: tuple[Loop, ...]
    rotations: int = 1
    mirror: bool = False

    @property
    def loops(self) -> tuple[Loop, ...]:
        """The whole boundary: every loop closed, the outer one first."""
        return tuple(self._closed(piece, 1.0 if number == 0 else -1.0) for number, piece in enumerate(self.pieces))

    def _closed(self, piece: Loop, way: float) -> Loop:
        sector: Loop = piece
        if self.mirror:
            mirrored = tuple(Image(segment, mirrored=True) for segment in reversed(piece))
            sector = mirrored + piece if way > 0.0 else piece + mirrored
        if self.rotations == 1:
            return sector
        step = way * 2.0 * math.pi / self.rotations
        return tuple(
            _turned(segment, turn * step) if turn else segment for turn in range(self.rotations) for segment in sector
        )

    def polylines(self, per_segment: int = 48) -> list[Points]:
        """Closed polylines of the loops for drawing, shapes (n, 2) [m]; straight segments give two points."""
        t = np.linspace(0.0, 1.0, per_segment + 1)[:-1]
        ends = np.zeros(1)
        found = []
        for loop in self.loops:
            parts = [segment.point(ends if is_straight(segment) else t) for segment in loop]
            found.append(np.concatenate([*parts, parts[0][:1]]))
        return found

    @property
    def radius(self) -> float:
        """Largest distance of the boundary from the origin [m]."""
        t = np.linspace(0.0, 1.0, 65)
        return max(float(np.hypot(*segment.point(t).T).max()) for segment in self.pieces[0])


def _turned(segment: Segment, angle: float) -> Segment:
    if isinstance(segment, Image):
        return Image(segment.segment, segment.angle + angle, segment.mirrored)
    return Image(segment, angle)


def is_straight(segment: Segment) -> bool:
    """Whether a segment is a straight line."""
    return isinstance(segment.segment if isinstance(segment, Image) else segment, Line)
