"""A moving mechanism as data: bodies with a pose per frame, and parts drawn on them; millimetres."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from varistiff.report.mechanism.sheet import Bounds
from varistiff.report.style import FAINT, INK, METAL, SOFT
from varistiff.report.view import Array

LINK, DRIVE, ELEMENT, SETTING = "#0072B2", "#E69F00", "#009E73", "#CC79A7"  # as in the figures over time
PALE = "#d3e6f3"  # of LINK


@dataclass(frozen=True)
class Body:
    """A rigid body: its origin [mm] and angle [rad] per frame, shape (frames, 3), in the fixed frame."""

    poses: Array


@dataclass(frozen=True)
class Part:
    """A line, an area or a disc.

    Parameters
    ----------
    body : that carries it
    points : shape (N, 2) on the body, or (frames, N, 2) if it deforms; NaN lifts the pen; a disc has one point
    fill, edge : colours, empty for none
    pixels : width of the line at the size of the page
    width : least width of the line in millimetres, for parts of true thickness
    radius : of a disc [mm]
    """

    body: Body
    points: Array
    fill: str = ""
    edge: str = INK
    pixels: float = 1.2
    width: float = 0.0
    radius: float = 0.0
    closed: bool = False
    dashed: bool = False

    @property
    def deforms(self) -> bool:
        """Whether its points differ from frame to frame."""
        return self.points.ndim == 3

    def at(self, frame: int) -> Array:
        """Points in the fixed frame."""
        x, y, angle = self.body.poses[frame]
        c, s = np.cos(angle), np.sin(angle)
        points = self.points[frame] if self.deforms else self.points
        return np.asarray(points @ np.array([[c, s], [-s, c]]) + (x, y))


@dataclass(frozen=True)
class Scene:
    """Parts in the order in which they are painted.

    Parameters
    ----------
    key : of the colours, as (name, colour, look of ``report.mechanism.sheet.legend``)
    caption : what is seen, plain text
    scaled : whether lengths are to scale
    """

    parts: tuple[Part, ...]
    key: tuple[tuple[str, str, str], ...]
    caption: str
    scaled: bool = True

    @property
    def frames(self) -> int:
        """Number of frames."""
        return self.parts[0].body.poses.shape[0]

    @cached_property
    def bounds(self) -> Bounds:
        """Rectangle that holds every part at every frame."""
        return self.bounds_at(range(self.frames))

    def bounds_at(self, frames: Iterable[int]) -> Bounds:
        """Rectangle that holds every part at some frames."""
        points, chosen = [], list(frames)
        for part in self.parts:
            for frame in chosen:
                found = part.at(frame)
                found = found[np.isfinite(found).all(axis=1)]
                around = max(part.radius, 0.5 * part.width)
                points += [found - around, found + around]
        return Bounds.around(*points, margin=0.02)


@dataclass
class Builder:
    """Collects the parts of a scene.

    Parameters
    ----------
    frames : their number
    upright : angle that the whole picture is turned by [rad], about its origin
    origin : where that is in the fixed frame [mm]
    """

    frames: int
    upright: float = 0.0
    origin: tuple[float, float] = (0.0, 0.0)
    parts: list[Part] = field(default_factory=list)

    def body(self, angle: Array | float = 0.0, *, x: Array | float = 0.0, y: Array | float = 0.0) -> Body:
        """A body at (x, y) [mm] turned by an angle [rad], each a number or one per frame, before the picture turns."""
        poses = np.empty((self.frames, 3))
        c, s = np.cos(self.upright), np.sin(self.upright)
        poses[:, 0] = self.origin[0] + c * np.asarray(x) - s * np.asarray(y)
        poses[:, 1] = self.origin[1] + s * np.asarray(x) + c * np.asarray(y)
        poses[:, 2] = np.asarray(angle) + self.upright
        return Body(poses)

    def line(self, body: Body, points: Array, colour: str, *, pixels: float = 2.0, width: float = 0.0) -> None:
        """A line, rigid or deforming."""
        self.parts.append(Part(body, np.asarray(points, float), edge=colour, pixels=pixels, width=width))

    def dashes(self, body: Body, points: Array, colour: str = SOFT) -> None:
        """A thin broken line."""
        self.parts.append(Part(body, np.asarray(points, float), edge=colour, pixels=1.4, dashed=True))

    def area(self, body: Body, points: Array, fill: str = METAL, edge: str = INK, *, pixels: float = 1.0) -> None:
        """A filled polygon."""
        self.parts.append(Part(body, np.asarray(points, float), fill=fill, edge=edge, pixels=pixels, closed=True))

    def block(self, body: Body, centre: tuple[float, float], wide: float, high: float, fill: str = METAL) -> None:
        """A filled rectangle about its centre."""
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (0.5 * wide, 0.5 * high)
        self.area(body, corners + centre, fill)

    def beam(self, body: Body, start: float, end: float, wide: float) -> None:
        """A link along x that carries other parts: pale, so that they stand out."""
        corners = np.array([[start, -0.5], [end, -0.5], [end, 0.5], [start, 0.5]]) * (1.0, wide)
        self.area(body, corners, PALE, LINK, pixels=1.6)

    def disc(
        self,
        body: Body,
        centre: tuple[float, float],
        radius: float,
        *,
        fill: str = "",
        edge: str = INK,
        pixels: float = 1.4,
    ) -> None:
        """A round part."""
        point = np.array([centre], float)
        self.parts.append(Part(body, point, fill=fill, edge=edge, pixels=pixels, radius=radius))

    def joint(self, body: Body, radius: float) -> None:
        """A revolute joint at the body's origin."""
        self.disc(body, (0.0, 0.0), radius, fill="#ffffff", pixels=1.8)
        self.disc(body, (0.0, 0.0), 0.28 * radius, fill=INK)

    def dial(self, radius: float) -> None:
        """A fixed scale around the joint: a tick every 10 degrees, a longer one every 30."""
        ticks = []
        for step in range(36):
            angle = np.radians(10.0 * step)
            way = np.array([np.cos(angle), np.sin(angle)])
            ticks += [radius * way, (1.08 if step % 3 == 0 else 1.04) * radius * way, np.full(2, np.nan)]
        body = self.body()
        self.line(body, np.array(ticks), SOFT, pixels=1.0)
        self.disc(body, (0.0, 0.0), radius, edge=FAINT, pixels=1.0)


def resampled(line: Array, points: int) -> Array:
    """A polyline with so many points, even along its length."""
    steps = np.hypot(*np.diff(line, axis=0).T)
    place = np.insert(np.cumsum(steps), 0, 0.0)
    even = np.linspace(0.0, place[-1], points)
    return np.stack([np.interp(even, place, line[:, axis]) for axis in (0, 1)], axis=1)
