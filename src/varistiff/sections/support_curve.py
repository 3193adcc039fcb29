"""The curve of the DIN polygon profiles."""

from __future__ import annotations

import numpy as np

from varistiff.sections.outline import Curve, Points


def support_curve(*, mean_radius: float, eccentricity: float, lobes: int, end: float) -> Curve:
    """Envelope of the tangents at the distance h(a) = mean_radius - eccentricity cos(lobes a), a from 0 to ``end``.

    x = h cos a - h' sin a, y = h sin a + h' cos a; d(x, y)/da = (h + h'') (-sin a, cos a).
    """

    def curve(t: Points) -> tuple[Points, Points]:
        a = end * t
        h = mean_radius - eccentricity * np.cos(lobes * a)
        slope = lobes * eccentricity * np.sin(lobes * a)
        curvature_radius = mean_radius + (lobes**2 - 1) * eccentricity * np.cos(lobes * a)
        c, s = np.cos(a), np.sin(a)
        point = np.stack([h * c - slope * s, h * s + slope * c], axis=1)
        return point, (end * curvature_radius)[:, None] * np.stack([-s, c], axis=1)

    return Curve(curve)
