"""The groove of the stiffness disc: what 47 degrees reach, and how straight it can be (Eqs. 13 to 16, Fig. 5).

The arc radius r_s is not published. It is found here, in the code, as the one whose l_1(alpha) lies closest to a
straight line over the whole groove; p and q are the least squares line over the effective range.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float
from scipy.optimize import minimize_scalar

from varistiff.actuators import SliderLeafJoint
from varistiff.dynamics.control import wang_chain
from varistiff.dynamics.control.straight_line import straight_line
from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import Numbers, answer, effective_lengths, groove, joint

LARGEST_RADIUS = 10.0  # m: straight to 4 micrometres between A and C


def half_chord() -> float:
    """Half the distance from A to C [m], the smallest arc radius."""
    r_1, r_2, angle = paper.OUTER_RADIUS, paper.CLAMP_RADIUS, paper.OUTER_ANGLE
    return 0.5 * math.hypot(r_1 * math.sin(angle), r_1 * math.cos(angle) - r_2)


@partial(jax.jit, static_argnames="centre")
def whole_groove_error(radius: float, centre: str) -> Float[Array, ""]:
    """Largest distance [m] of l_1(alpha) from its least squares line over the 47 degrees; infinite off the groove."""
    disc = groove(radius, centre=centre)
    lengths = disc.active_length(jnp.linspace(0.0, paper.OUTER_ANGLE, 101))
    outward = jnp.all(jnp.diff(lengths) > 0.0)  # the slot has to move the slider outward all the way; NaN is no
    return jnp.where(outward, straight_line(disc, 0.0, paper.OUTER_ANGLE).error, jnp.inf)


def _best_radius(error: Callable[[float], float]) -> tuple[float, float]:
    """Arc radius [m] with the least error, and that error [m]; by a coarse search and a fine one about its best."""
    radii = np.geomspace(1.001 * half_chord(), LARGEST_RADIUS, 40)
    errors = np.array([error(float(radius)) for radius in radii])
    best = int(np.argmin(errors))
    low, high = radii[max(best - 1, 0)], radii[min(best + 1, radii.size - 1)]
    found = minimize_scalar(error, bounds=(low, high), method="bounded", options={"xatol": 1e-8})
    return min((float(found.x), float(found.fun)), (float(radii[best]), float(errors[best])), key=lambda pair: pair[1])


@cache
def straightest(centre: str) -> tuple[float, float]:
    """Arc radius [m] of the groove closest to its least squares line with this centre, and its largest error [m]."""
    return _best_radius(lambda radius: float(whole_groove_error(radius, centre)))


def arc_radius() -> float:
    """Arc radius r_s [m] of the straightest groove, with the centre near the axis."""
    return straightest("near")[0]


class Course(NamedTuple):
    """What a groove does; SI units."""

    length_at_limit: float  # l_1 at 47 degrees
    angle_min: float  # disc angle at 6 mm
    angle_max: float  # at 25 mm
    slope: float  # p
    intercept: float  # q
    error: float  # the largest distance from the line, 6 to 25 mm


@jax.jit  # one compilation in place of one for each operation
def _course(radius: float) -> tuple[Float[Array, ""], ...]:
    disc = groove(radius)
    low, high = (disc.angle(jnp.asarray(length)) for length in (paper.LENGTH_MIN, paper.LENGTH_MAX))
    line = map(jnp.asarray, straight_line(disc, low, high))
    return (disc.active_length(jnp.asarray(paper.OUTER_ANGLE)), low, high, *line)


@jax.jit
def _active_length(radius: float, angles: Float[Array, "..."]) -> Float[Array, "..."]:
    return groove(radius).active_length(angles)


@cache
def course(arc_radius: float | None = None) -> Course:
    """What the groove with an arc radius [m] does, the centre near the axis; the straightest where none is given."""
    radius = straightest("near")[0] if arc_radius is None else arc_radius
    return Course(*(float(number) for number in _course(radius)))


def length_at_limit_angle() -> float:
    """Active length [m] at a disc angle of 47 degrees: r_1 - r_2, whatever the arc radius."""
    return course().length_at_limit


def passes_a_and_c() -> float:
    """1e-9 m less the largest distance of S from A at 0 and from C at 47 degrees [m], over a range of arc radii."""
    ends = jnp.asarray([0.0, paper.OUTER_ANGLE])
    wanted = np.array([0.0, paper.OUTER_RADIUS - paper.CLAMP_RADIUS])
    lengths = [np.asarray(_active_length(radius, ends)) for radius in (0.025, 0.03, 0.04, 0.1, 1.0)]
    return float(1e-9 - np.abs(np.array(lengths) - wanted).max())


def angle_of_effective_range() -> float:
    """Disc angle [rad] from 6 to 25 mm in the straightest groove."""
    return course().angle_max - course().angle_min


def line_slope() -> float:
    """Slope p [m/rad] of Eq. (16) over the effective range, for the straightest groove."""
    return course().slope


def line_intercept() -> float:
    """Intercept q [m] of Eq. (16) over the effective range, for the straightest groove."""
    return course().intercept


def line_error() -> float:
    """Largest distance [m] of the groove from its line over the effective range."""
    return course().error


def nearly_linear(*, largest: float) -> float:
    """``largest`` less the error of the line over the travel of the effective range, for the straightest groove [-]."""
    return largest - line_error() / (paper.LENGTH_MAX - paper.LENGTH_MIN)


@jax.jit
def _chain_errors(radius: float, stiffness: Float[Array, " n"]) -> Float[Array, " n"]:
    """Relative stiffness error of Wang's chain at commands [N m/rad]."""
    printed = joint()
    with_groove = SliderLeafJoint(printed.leaf, printed.count, printed.clamp_radius, printed.theory, groove(radius))
    chain = wang_chain(with_groove, setting_min=paper.LENGTH_MIN, setting_max=paper.LENGTH_MAX)
    return jax.vmap(chain.stiffness_error)(stiffness) / stiffness


def line_serves_the_chain(*, largest: float) -> float:
    """``largest`` less the relative stiffness error that the line costs, over the effective range (section 4.2)."""
    commands = answer(joint(), deflection=0.0, length=effective_lengths()).stiffness
    return largest - float(np.abs(_chain_errors(arc_radius(), jnp.asarray(commands))).max())


_WHOLE = np.linspace(0.0, paper.OUTER_ANGLE, 101)  # rad
_CENTRES = ("near", "far")


@jax.jit
def _both_grooves(radius: float) -> Float[Array, "2 101"]:
    """Active lengths of the two circles of one radius, over the 47 degrees."""
    return jnp.stack([groove(radius, centre=centre).active_length(jnp.asarray(_WHOLE)) for centre in _CENTRES])


def from_spiral(lengths: Numbers) -> float:
    """Largest distance [m] of active lengths, evenly over the 47 degrees, from the closest spiral l_2 = a + p alpha.

    Infinite where they do not grow all the way.
    """
    if not (np.diff(lengths) > 0.0).all():  # NaN is no
        return math.inf
    # for a slope p the best a halves what is left; that is convex in p
    mean = float(np.ptp(lengths)) / paper.OUTER_ANGLE
    found = minimize_scalar(
        lambda slope: 0.5 * float(np.ptp(lengths - slope * _WHOLE)),
        bounds=(0.0, 2.0 * mean),
        method="bounded",
        options={"xatol": 1e-5 * mean},
    )
    return float(found.fun)


def spiral_distance(radius: float) -> float:
    """Radial distance [m] of the closer of the two grooves with an arc radius [m] from its closest spiral."""
    return min(from_spiral(lengths) for lengths in np.asarray(_both_grooves(radius)))


def spiral_error() -> float:
    """Least radial distance [m] of any circular groove through A and C from an Archimedean spiral over 47 degrees."""
    return _best_radius(spiral_distance)[1]


def is_a_spiral(*, within: float) -> float:
    """``within`` [m], what a cutter would hold, less the least distance from an Archimedean spiral [m]."""
    return within - spiral_error()
