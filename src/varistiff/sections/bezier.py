"""Cubic Bezier segment of a boundary."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from varistiff.sections.outline import Points


@dataclass(frozen=True)
class Bezier:
    """Cubic Bezier curve between two points by way of two control points [m]: a ``Segment``."""

    start: tuple[float, float]
    control_one: tuple[float, float]
    control_two: tuple[float, float]
    end: tuple[float, float]

    def point(self, t: Points) -> Points:
        """See ``Segment``."""
        s = 1.0 - t
        weights = np.stack([s**3, 3.0 * s**2 * t, 3.0 * s * t**2, t**3], axis=1)
        return np.asarray(weights @ np.array([self.start, self.control_one, self.control_two, self.end]))

    def velocity(self, t: Points) -> Points:
        """See ``Segment``."""
        s = 1.0 - t
        sides = np.diff(np.array([self.start, self.control_one, self.control_two, self.end]), axis=0)
        weights = 3.0 * np.stack([s**2, 2.0 * s * t, t**2], axis=1)
        return np.asarray(weights @ sides)
