"""The 3-D solver against closed forms, itself at another order, and the identities of elasticity."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from varistiff.fe.torsion_bearing import Bearing, contact_pressure
from varistiff.fe.torsion_body import LEVELS, ORDER, Body
from varistiff.fe.torsion_cases import bearing_outcome, flange_outcome
from varistiff.fe.torsion_problem import TorsionProblem
from varistiff.sections import Circle, HollowCircle, Rectangle, SplinedTube, Square

pytest.importorskip("ngsolve")

G = 0.63e9


def problem(section: Any, *, active_length: float = 0.03, **changed: Any) -> TorsionProblem:
    numbers = {"shear_modulus": G, "poissons_ratio": 0.35, "length": active_length + 0.05, "bearing_length": 0.01}
    return TorsionProblem(section, active_length=active_length, **{**numbers, **changed})


def splined(root_fillet: float = 0.0005) -> SplinedTube:
    return SplinedTube(
        outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.004, rail_height=0.0025, root_fillet=root_fillet
    )


@pytest.mark.parametrize(
    "section, torsion_constant",
    [
        (Circle(radius=0.01), math.pi * 0.01**4 / 2.0),
        (HollowCircle(outer_radius=0.011, inner_radius=0.0087), math.pi * (0.011**4 - 0.0087**4) / 2.0),
    ],
)
def test_round_bar_is_exact(section: Any, torsion_constant: float) -> None:
    # a round section does not warp: clamp and flange change nothing; what is left is the order 3 and the curved edges
    found = flange_outcome(Body(problem(section), LEVELS[1])).stiffness
    for stiffness in found.values():
        assert stiffness == pytest.approx(G * torsion_constant / 0.03, rel=2e-5)
        assert stiffness > G * torsion_constant / 0.03 * (1.0 - 1e-6)


@pytest.mark.parametrize(
    "section, torsion_constant",
    [
        # Saint-Venant, e.g. Timoshenko & Goodier, section 109: k_1 = 0.1406 (1:1), 0.229 (2:1); more digits: its series
        (Square(across_flats=0.01), 0.140577 * 0.01**4),
        (Rectangle(width=0.02, height=0.01), 0.228682 * 0.02 * 0.01**3),
    ],
)
def test_long_bar_warps_as_saint_venant_says(section: Any, torsion_constant: float) -> None:
    # the difference of two lengths is free of the ends: only Saint-Venant's rate of twist is left
    found = [flange_outcome(Body(problem(section, active_length=x), LEVELS[1])).stiffness for x in (0.06, 0.12)]
    for name in ("end_flange_free", "end_flange_blocked"):
        rate = (1.0 / found[1][name] - 1.0 / found[0][name]) / 0.06
        assert 1.0 / (G * rate) == pytest.approx(torsion_constant, rel=2e-3)


def test_end_effects_have_the_signs_of_the_theory() -> None:
    # k = G J/(x + delta): held warping makes it stiffer, pressure on the rails' sides adds compliance
    section = splined()
    rigidity = G * section.torsion_constant
    body = Body(problem(section, active_length=0.051), LEVELS[0])
    flange, bearing = flange_outcome(body).stiffness, bearing_outcome(body)
    delta = {name: rigidity / k - 0.051 for name, k in {**flange, **bearing.stiffness}.items()}
    assert delta["end_flange_blocked"] < delta["end_flange_free"] < 0.0
    assert delta["bearing_pressure"] > delta["bearing_contact"] > 0.0
    # a rigid bearing cannot be softer than a given pressure of the same torque, and what it carries is pressure
    assert bearing.contact is not None
    assert 0.3 < bearing.contact.area_share <= 1.0
    assert 0.0 < bearing.local["bearing_contact"] < bearing.local["bearing_pressure"] < 0.1


def test_offset_does_not_depend_on_the_length() -> None:
    section = Rectangle(width=0.02, height=0.01)
    deltas = []
    for x in (0.06, 0.12):
        stiffness = flange_outcome(Body(problem(section, active_length=x), LEVELS[1])).stiffness["end_flange_blocked"]
        deltas.append(G * section.torsion_constant / stiffness - x)
    assert deltas[0] < -0.003
    assert deltas[1] == pytest.approx(deltas[0], abs=2e-4)  # 0.2 % of the stiffness at 0.12 m


def test_sector_agrees_with_the_whole_section() -> None:
    section = Square(across_flats=0.014)
    sector, whole = (Body(problem(section), LEVELS[0], whole=flag) for flag in (False, True))
    assert (sector.sectors, whole.sectors) == (8, 1)
    for run in (flange_outcome, bearing_outcome):
        one, other = run(sector).stiffness, run(whole).stiffness
        for name, value in one.items():
            assert value == pytest.approx(other[name], rel=8e-3)  # the two meshes differ


def test_refinement_lowers_the_stiffness_towards_a_limit() -> None:
    found = [
        flange_outcome(Body(problem(Square(across_flats=0.014)), level)).stiffness["end_flange_free"]
        for level in LEVELS[:3]
    ]
    assert found[0] > found[1] > found[2]  # conforming displacements are too stiff
    assert found[1] - found[2] < 0.8 * (found[0] - found[1])


def test_work_is_twice_the_strain_energy() -> None:
    body = Body(problem(splined()), LEVELS[0])
    solid = body.bearing_solid()
    solids = tuple(body.elastic(solid, kind) for kind in body.kinds)
    for elastic in solids:
        elastic.factorise()
    bearing = Bearing(solids, order=ORDER, one_flank=True)
    pressure = bearing.uniform() * (1.0 + 300.0 * bearing.points[:, 2])
    work = float(np.sum(pressure * bearing.answer(pressure)))
    moved = bearing.displacements(pressure)
    energy = sum(e.twice_energy(e.field(w)) for e, w in zip(solids, moved, strict=True))
    assert work == pytest.approx(2.0 * energy, rel=1e-8)  # two mirror images of the sector, their cross terms cancel


def test_contact_meets_its_conditions_and_is_stiffer_than_pressure() -> None:
    body = Body(problem(splined()), LEVELS[0])
    solid = body.bearing_solid()
    solids = tuple(body.elastic(solid, kind) for kind in body.kinds)
    for elastic in solids:
        elastic.factorise()
    bearing = Bearing(solids, order=ORDER, one_flank=True)
    pressure = contact_pressure(bearing)
    gap = bearing.answer(pressure) / bearing.weights - bearing.levers  # for one radian of the bearing
    size = float(np.max(bearing.levers))
    assert pressure.min() >= 0.0
    assert np.abs(gap[pressure > 0.0]).max() < 1e-4 * size
    assert gap[bearing.facing & (pressure == 0.0)].min() > -1e-4 * size
    assert not pressure[~bearing.facing].any()
    uniform = bearing.uniform()
    softer = bearing.torque(uniform) ** 2 / float(np.sum(uniform * bearing.answer(uniform)))
    assert bearing.torque(pressure) > softer  # the energy of all pressures of one torque is least in contact
