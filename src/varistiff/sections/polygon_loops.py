"""Corners to a closed loop."""

from __future__ import annotations

from collections.abc import Sequence

from varistiff.sections.outline import Line, Loop

Point = Sequence[float]


def loop_of_points(points: Sequence[Point]) -> Loop:
    """Closed loop of straight lines through corners [m], in the order given."""
    corners = [(float(x), float(y)) for x, y in points]
    return tuple(Line(one, two) for one, two in zip(corners, corners[1:] + corners[:1], strict=True))
