"""Centrelines of bent leaves from what the map already holds: nothing is solved twice to be drawn."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from varistiff.elastic.roller_contact import centreline
from varistiff.report.mechanism.sheet import MM, Pose
from varistiff.report.view import Array, View


def detail(view: View, pose: Pose, name: str) -> float:
    """A detail variable of the map at a pose; NaN where there is none."""
    values = np.atleast_2d(np.asarray(view.dataset[name].values, float))
    return float(values[pose.row, pose.column])


def bent(*, slope: float, length: float, drawn: float) -> Array:
    """Elastica under a normal force at its contact, straight beyond it; clamp at the origin, (N, 2) [mm]."""
    if not (math.isfinite(slope) and abs(slope) > 1e-9):
        return np.array([[0.0, 0.0], [drawn * MM, 0.0]])
    line = centreline(abs(slope), length, points=61, tail=max(drawn - length, 0.0))
    return np.asarray(line * np.array([1.0, math.copysign(1.0, slope)]) * MM, float)


def cubic(*, length: float, offset: float, drawn: float) -> Array:
    """Cantilever of small-deflection theory with an end offset, straight beyond its load; shape (N, 2) [mm]."""
    part = np.linspace(0.0, 1.0, 61)
    line = np.stack([length * part, offset * part**2 * (3.0 - part) / 2.0], axis=1)
    tail = max(drawn - length, 0.0) * np.array([1.0, 1.5 * offset / length])
    return np.concatenate([line, (line[-1] + tail)[None]]) * MM


def between_horizontals(span: float, rise: float, *, radius: float = math.inf, points: int = 61) -> Array:
    """Free elastica from (0, 0) to (span, rise), horizontal at both ends; shape (N, 2), units as given.

    Where it would bend tighter than ``radius`` at its ends it lies on circles of that radius there. Everything about
    the point-symmetric half is one turning angle, found by bisection; plain quadrature, because compiling the
    actuator's own law once more would take longer than the whole drawing. Tests hold it against that law.
    """
    chord = math.atan2(rise, span)
    turn = _bisect(lambda t: t - math.atan2(_across(t), 2.0 * math.sqrt(math.sin(t))) - chord, 1e-9, 0.95 * math.pi)
    scale = 0.5 * math.hypot(span, rise) / math.hypot(2.0 * math.sqrt(math.sin(turn)), _across(turn))
    arc = 0.0
    # the ends are the tightest place up to 90 degrees of slope
    if math.isfinite(radius) and scale < radius * math.sqrt(math.sin(turn)):
        middle = np.array([0.5 * span, 0.5 * rise - radius]) / radius  # from the centre of the circle
        turn = _bisect(lambda psi: float(np.hypot(*_from_centre(psi)) - np.hypot(*middle)), 1e-9, 0.95 * math.pi)
        away = _from_centre(turn)
        arc = math.atan2(middle[1], middle[0]) - math.atan2(away[1], away[0])
        scale = radius * math.sqrt(math.sin(turn))
    # turned since the middle; even in its square root, as the arc length is
    turned = turn * np.linspace(1.0, 0.0, points) ** 2
    along, across = 2.0 * scale * np.sqrt(np.sin(turned)), scale * np.array([_across(psi) for psi in turned])
    cosine, sine = math.cos(arc + turn), math.sin(arc + turn)
    half = np.stack([along * cosine + across * sine, along * sine - across * cosine], axis=1)
    middle = 0.5 * np.array([span, rise])
    lower = middle - half
    if arc > 0.0:
        angles = np.linspace(0.0, arc, 12)[:-1]
        lower = np.concatenate([radius * np.stack([np.sin(angles), 1.0 - np.cos(angles)], axis=1), lower])
    return np.concatenate([lower, (2.0 * middle - lower)[-2::-1]])


_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(24)


def _across(turn: float) -> float:
    """Integral of sqrt(sin psi) from 0 to the turn, smooth in u = sqrt(psi)."""
    half = 0.5 * math.sqrt(turn)
    u = half * (_NODES + 1.0)
    return float(half * (_WEIGHTS @ (2.0 * u * np.sqrt(np.maximum(np.sin(u * u), 0.0)))))


def _from_centre(turn: float) -> Array:
    """Middle of a wrapped leaf from the centre of its circle, in radii, before the arc turns it."""
    sine = math.sin(turn)
    across = math.sqrt(sine) * _across(turn)
    x = 2.0 * sine * math.cos(turn) + across * sine
    return np.array([x, 2.0 * sine * sine - across * math.cos(turn) - 1.0])


def _bisect(function: Callable[[float], float], low: float, high: float) -> float:
    for _ in range(48):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)
