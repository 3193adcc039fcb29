"""Groove of the stiffness disc: the three circle conditions, both centres, both directions."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.actuators import Groove
from varistiff.design.spec import GrooveSpec

RADII = {"inner_radius": 0.025, "outer_radius": 0.054, "outer_angle": math.radians(47.0)}
GOOD = [
    Groove(**RADII, arc_radius=0.022, centre="near"),
    Groove(**RADII, arc_radius=0.0368, centre="near"),
    Groove(**RADII, arc_radius=0.1, centre="near"),
    Groove(**RADII, arc_radius=0.1, centre="far"),
]


@pytest.mark.parametrize("groove", GOOD)
def test_slider_rides_on_the_circle_from_a_to_c(groove: Groove) -> None:
    x, y = (float(v) for v in groove.centre_position)
    angle = np.linspace(0.0, groove.outer_angle, 25)
    radius = groove.inner_radius + np.asarray(groove.active_length(jnp.asarray(angle)))
    slider = np.stack([radius * np.sin(angle), radius * np.cos(angle)])
    assert np.hypot(slider[0] - x, slider[1] - y) == pytest.approx(groove.arc_radius, rel=1e-12)  # rounding
    assert radius[0] == pytest.approx(groove.inner_radius, rel=1e-12)
    assert radius[-1] == pytest.approx(groove.outer_radius, rel=1e-12)


def test_near_is_nearer_than_far() -> None:
    near, far = (Groove(**RADII, arc_radius=0.1, centre=side) for side in ("near", "far"))
    assert math.hypot(*map(float, near.centre_position)) < math.hypot(*map(float, far.centre_position))


@pytest.mark.parametrize("groove", GOOD)
def test_rate_is_the_derivative(groove: Groove) -> None:
    angle, step = np.linspace(0.1, 0.7, 7), 1e-5
    ahead, behind = (np.asarray(groove.active_length(jnp.asarray(angle + s))) for s in (step, -step))
    rate = np.asarray(groove.active_length_rate(jnp.asarray(angle)))
    assert rate == pytest.approx((ahead - behind) / (2 * step), rel=1e-7)  # second order in the step


@pytest.mark.parametrize("groove", GOOD)
def test_angle_inverts_the_active_length(groove: Groove) -> None:
    angle = np.linspace(0.25, groove.outer_angle, 21)
    length = groove.active_length(jnp.asarray(angle))
    rising = np.asarray(groove.active_length_rate(jnp.asarray(angle))) > 1e-3
    assert rising.sum() > 10
    assert np.asarray(groove.angle(length))[rising] == pytest.approx(angle[rising], abs=1e-9)  # 1e-12/1e-3
    assert np.isnan(groove.angle(jnp.asarray(0.2)))


@pytest.mark.parametrize("centre", ["near", "far"])
@pytest.mark.parametrize("arc_radius", [0.0207, 0.022, 0.03, 0.0368, 0.045, 0.05, 0.1, 1.0])
@pytest.mark.parametrize("outer_angle", [20.0, 47.0, 80.0])
def test_design_files_refuse_grooves_that_an_angle_meets_twice(
    centre: str, arc_radius: float, outer_angle: float
) -> None:
    groove = Groove(0.025, 0.054, math.radians(outer_angle), arc_radius, centre)
    spec = GrooveSpec.model_construct(
        outer_radius=0.054, outer_angle=math.radians(outer_angle), arc_radius=arc_radius, centre=centre
    )
    x, y = (float(v) for v in groove.centre_position)
    if math.isnan(x):
        return  # too small to join the ends, which the design file refuses before
    # walk along the shorter arc from A to C: the disc angle must never turn back
    start = math.atan2(groove.inner_radius - y, -x)
    turn = math.atan2(0.054 * math.cos(groove.outer_angle) - y, 0.054 * math.sin(groove.outer_angle) - x) - start
    turn = (turn + math.pi) % (2.0 * math.pi) - math.pi
    walk = start + turn * np.linspace(0.0, 1.0, 4001)
    angle = np.arctan2(x + arc_radius * np.cos(walk), y + arc_radius * np.sin(walk))
    assert spec.meets_each_angle_once(0.025) == bool((np.diff(angle) > -1e-12).all())  # rounding
