"""Small deflections against closed forms written here, from linear beam theory and geometry alone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.actuators import Maccepa, SliderLeafJoint, TorsionTube
from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.actuators.roller_beam import RollerBeam

from .catalogue import CATALOGUE, Case
from .evaluation import respond

CASES = {case.name: case for case in CATALOGUE}


def _at(case: Case, deflection: float, setting: float) -> dict[str, float]:
    found = respond(case.actuator, np.array([deflection]), np.array([setting]))
    return {name: float(value[0]) for name, value in found.items()}


def test_roller_beam_begins_as_a_linear_cantilever() -> None:
    """Torque 3 EI b x_r/x^3 at a push of 1e-6 of the length; curvature only adds terms of second order."""
    case = CASES["roller_swivelling_plain"]
    device = case.actuator
    assert isinstance(device, RollerBeam)
    rigidity, position = device.beam.flexural_rigidity, 0.31
    push = 3e-7
    angle = math.asin((0.0002 + push) / position)
    here = _at(case, angle, position)
    span = position * math.cos(angle)
    force = 3 * rigidity * push / span**3
    assert here["contact_force"] == pytest.approx(force, rel=1e-5)
    assert here["load"] == pytest.approx(force * span, rel=1e-5)
    assert here["energy"] == pytest.approx(force * push / 2, rel=1e-5)
    # the force is constant times the push, and the push changes by x_r per radian; the span hardly changes
    assert here["stiffness"] == pytest.approx(3 * rigidity / span, rel=1e-4)
    # sliding along the beam moves the contact up the slope of the link but down the slope of the beam
    slope = 1.5 * push / span
    assert here["contact_slope"] == pytest.approx(slope, rel=1e-5)
    assert here["adjusting_load"] == pytest.approx(force * (math.sin(angle) - slope), rel=1e-4)
    stress = device.beam.youngs_modulus * device.beam.thickness / 2 * force * span / rigidity
    assert here["stress"] == pytest.approx(stress, rel=1e-5)


@pytest.mark.parametrize(("name", "sign"), [("roller_lower", 1.0), ("roller_upper", -1.0)])
def test_single_roller_touches_where_geometry_says(name: str, sign: float) -> None:
    """A roller's surface meets the beam's surface, half a thickness from its centreline.

    Catalogue: centre 7 mm to the beam's far side of the link's axis, roller 12 mm, joint 6 mm beside the clamp.
    """
    case, position, push = CASES[name], 0.3, 2e-7
    device = case.actuator
    assert isinstance(device, RollerBeam)
    reach = 0.012 + device.beam.thickness / 2

    def rise(angle: float) -> float:  # of the roller's surface above the undeformed centreline, seen from below
        wall = -0.05
        joint = 0.02 * math.sin(wall) - 0.006 * math.cos(wall)
        return joint + position * math.sin(wall + angle) - 0.007 * math.cos(wall + angle) + reach

    low, high = -0.5, 0.5
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if rise(middle) < push else (low, middle)
    here = _at(case, sign * high, position)
    turn = high - 0.05
    span = 0.02 * math.cos(0.05) - 0.006 * math.sin(0.05) + position * math.cos(turn) + 0.007 * math.sin(turn)
    assert here["contact_force"] == pytest.approx(3 * device.beam.flexural_rigidity * push / span**3, rel=1e-4)
    assert here["contact_slope"] == pytest.approx(sign * 1.5 * push / span, rel=1e-4)


@pytest.mark.parametrize("name", ["slider_small_length", "slider_large_length"])
def test_slider_at_rest(name: str) -> None:
    """Both theories begin at N E b h^3 l_2^2/(4 l_1^3) and -N E b h^3 phi^2 (l_1^2 + 4 r l_1 + 3 r^2)/(8 l_1^4)."""
    case, length, angle = CASES[name], 0.021, 1e-5
    device = case.actuator
    assert isinstance(device, SliderLeafJoint)
    modulus, width, thickness, radius = 206e9, 0.025, 0.001, 0.025
    scale = 3 * modulus * width * thickness**3
    stiffness = scale * (radius + length) ** 2 / (4 * length**3)
    here = _at(case, angle, length)
    assert here["stiffness"] == pytest.approx(stiffness, rel=1e-7)
    assert here["load"] == pytest.approx(stiffness * angle, rel=1e-7)
    assert here["energy"] == pytest.approx(stiffness * angle**2 / 2, rel=1e-7)
    push = -scale * angle**2 * (length**2 + 4 * radius * length + 3 * radius**2) / (8 * length**4)
    assert here["adjusting_load"] == pytest.approx(push, rel=1e-5)
    assert here["leaf_rotation"] == pytest.approx(1.5 * (radius + length) * angle / length, rel=1e-7)
    assert here["stress"] == pytest.approx(
        modulus * thickness / 2 * 3 * (radius + length) * angle / length**2, rel=1e-7
    )


@pytest.mark.parametrize("name", ["slider_small_length", "slider_large_length"])
def test_slider_exactly_at_rest(name: str) -> None:
    """The fork has no play: at rest the joint is stiff and unloaded."""
    here, near = _at(CASES[name], 0.0, 0.02), _at(CASES[name], 1e-7, 0.02)
    assert here["load"] == here["energy"] == here["adjusting_load"] == here["stress"] == 0.0
    assert here["stiffness"] == pytest.approx(near["stiffness"], rel=1e-9)
    assert here["status"] == 0


@pytest.mark.parametrize("name", ["slider_small", "slider_large"])
def test_disc_and_length_are_one_joint(name: str) -> None:
    """A setting by disc angle is the setting by the length that the groove gives it; the disc's torque is power."""
    disc, length = CASES[f"{name}_disc"], CASES[f"{name}_length"]
    device = disc.actuator
    assert isinstance(device, SliderLeafJoint)

    def radius(angle: float) -> float:
        """Where the ray meets the groove: a circle of 36.8 mm through A (0, 25) and C, 54 mm out at 47 degrees."""
        a, c = np.array([0.0, 0.025]), 0.054 * np.array([math.sin(math.radians(47)), math.cos(math.radians(47))])
        middle, along = (a + c) / 2, c - a
        height = math.sqrt(0.0368**2 - float(along @ along) / 4)
        across = np.array([-along[1], along[0]]) / math.hypot(*along)
        centre = min((middle + height * across, middle - height * across), key=lambda p: math.hypot(*p))
        ray = np.array([math.sin(angle), math.cos(angle)])
        reach = float(ray @ centre)
        roots = [reach + s * math.sqrt(reach**2 - float(centre @ centre) + 0.0368**2) for s in (1, -1)]
        return max(roots)

    angle = 0.55
    by_disc = _at(disc, 0.015, angle)
    by_length = _at(length, 0.015, radius(angle) - 0.025)
    for key in ("energy", "load", "stiffness", "stress"):
        assert by_disc[key] == pytest.approx(by_length[key], rel=1e-10)
    rate = (radius(angle + 1e-6) - radius(angle - 1e-6)) / 2e-6
    assert by_disc["adjusting_load"] == pytest.approx(by_length["adjusting_load"] * rate, rel=1e-7)
    assert by_length["disc_angle"] == pytest.approx(angle, abs=1e-12)
    assert by_disc["active_length"] == pytest.approx(radius(angle) - 0.025, rel=1e-12)


def test_torsion_in_series() -> None:
    """Two springs in series, the tube's from the polar second moment."""
    case, twist, length = CASES["torsion_series"], 0.17, 0.08
    assert isinstance(case.actuator, TorsionTube)
    polar = math.pi / 2 * (0.011**4 - 0.0087**4)
    tube = 0.63e9 * polar / length
    stiffness = 1 / (1 / tube + 1 / 650.0)
    here = _at(case, twist, length)
    assert here["stiffness"] == pytest.approx(stiffness, rel=1e-14)
    assert here["load"] == pytest.approx(stiffness * twist, rel=1e-14)
    assert here["energy"] == pytest.approx(stiffness * twist**2 / 2, rel=1e-14)
    assert here["stress"] == pytest.approx(stiffness * twist * 0.011 / polar, rel=1e-14)
    # only the tube's part of the energy depends on its length: -torque^2/(2 G J)
    assert here["adjusting_load"] == pytest.approx(-((stiffness * twist) ** 2) / (2 * 0.63e9 * polar), rel=1e-14)


@pytest.mark.parametrize("name", ["leaves_guided", "leaves_sliding"])
def test_flat_leaves_are_linear_cantilevers(name: str) -> None:
    """At rest and flat: U = 6 EI y_f^2/x_f^3 a leaf, four leaves; corrections of order (y_f/x_f)^2."""
    built = CASES[name].actuator
    assert isinstance(built, AntagonisticLeaves)
    rise, distance, nuts = 0.0005, 0.345, 0.1
    device = AntagonisticLeaves(leaf=built.leaf, law=built.law, roller_distance=distance, clamp_height=rise)
    span = (distance - nuts) / 2
    rigidity = built.leaf.flexural_rigidity
    here = {key: float(v[0]) for key, v in respond(device, np.array([0.0]), np.array([nuts])).items()}
    energy = 4 * 6 * rigidity * rise**2 / span**3
    assert here["energy"] == pytest.approx(energy, rel=1e-4)
    assert here["stiffness"] == pytest.approx(energy * 12 / span**2, rel=1e-4)
    assert here["adjusting_load"] == pytest.approx(energy * 3 / span / 2, rel=1e-4)
    assert here["load"] == pytest.approx(0.0, abs=1e-9 * energy / span)
    assert here["stress"] == pytest.approx(210e9 * 0.0005 / 2 * 6 * rise / span**2, rel=1e-4)
    assert here["leaf_length_needed"] == pytest.approx(span + 0.6 * rise**2 / span, rel=1e-8)


def test_maccepa_at_rest() -> None:
    """k B C P/|C - B| at rest (Van Ham et al. 2007): elongation P, lever arm B C sin(phi)/A."""
    case = CASES["maccepa"]
    assert isinstance(case.actuator, Maccepa)
    rate, lever, distance, pretension = 394.0, 0.036, 0.135, 0.012
    here = _at(case, 0.0, pretension)
    assert here["stiffness"] == pytest.approx(rate * lever * distance * pretension / (distance - lever), rel=1e-12)
    assert here["energy"] == pytest.approx(rate * pretension**2 / 2, rel=1e-12)
    assert here["adjusting_load"] == pytest.approx(rate * pretension, rel=1e-12)
    away = _at(case, 0.7, pretension)
    side = math.sqrt(lever**2 + distance**2 - 2 * lever * distance * math.cos(0.7))
    pull = rate * (side + pretension - (distance - lever))
    assert away["load"] == pytest.approx(pull * lever * distance * math.sin(0.7) / side, rel=1e-12)
    assert math.isnan(away["stress"])


def test_series_elastic_is_a_spring() -> None:
    here = _at(CASES["series_elastic"], -0.11, 0.0)
    assert here["load"] == pytest.approx(-17.6, rel=1e-14)
    assert here["stiffness"] == pytest.approx(160.0, rel=1e-14)
    assert here["energy"] == pytest.approx(0.968, rel=1e-14)
    assert math.isnan(here["stress"])
    assert math.isnan(here["adjusting_load"])
