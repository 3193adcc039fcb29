"""What a check will take, told before its first mesh."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

pytest.importorskip("ngsolve")

from varistiff.actuators import LargeDeflection, SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.elastic.leaf import Leaf
from varistiff.fe.estimate import ALL_KEPT, Estimate
from varistiff.fe.leaf_check import check
from varistiff.fe.leaf_devices import problem_of
from varistiff.fe.leaf_estimate import leaf_estimate, leaf_outlook
from varistiff.fe.torsion_body import LEVELS, Body, bodies
from varistiff.fe.torsion_estimate import torsion_estimate, torsion_outlook
from varistiff.fe.torsion_plane import plane_mesh, thickness
from varistiff.fe.torsion_problem import TorsionProblem
from varistiff.fe.torsion_solve import solve
from varistiff.sections import Polygon, SplinedTube, Square
from varistiff.sections.outline import Arc, Loop, Outline

JOINT = SliderLeafJoint(
    leaf=Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001), count=3, clamp_radius=0.02, theory=LargeDeflection()
)


def problem(active_length: float = 0.03, section: Square | SplinedTube | None = None) -> TorsionProblem:
    return TorsionProblem(
        section=section or Square(across_flats=0.014),
        shear_modulus=0.63e9,
        poissons_ratio=0.35,
        length=0.06,
        active_length=active_length,
        bearing_length=0.01,
    )


def test_times_and_memory_are_said_as_people_say_them() -> None:
    said = [Estimate(1, 2.0**30, seconds) for seconds in (0.2, 119.0, 120.0, 700.0, 7300.0)]
    assert [estimate.time for estimate in said] == ["1 s", "119 s", "2 min", "12 min", "2 h"]
    assert [Estimate(1, 2.0**30 * share, 1.0).room for share in (0.01, 1.26, 28.4)] == ["0.1 GiB", "1.3 GiB", "28 GiB"]
    assert Estimate.one_after_the_other(said) == Estimate(1, 2.0**30, 8239.2)


def test_the_estimate_has_the_unknowns_of_what_is_solved() -> None:
    result = solve(problem(), tolerance=0.02)
    counts = [torsion_estimate(problem(), meshes=meshes).unknowns for meshes in range(1, len(LEVELS) + 1)]
    assert counts == sorted(counts)
    assert result.unknowns in counts[1:]  # one mesh says nothing about the error


def test_at_the_lock_there_is_no_end_flange() -> None:
    tube = SplinedTube(
        outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.004, rail_height=0.002, root_fillet=0.0005
    )
    locked, (body, *_) = torsion_estimate(problem(0.0, tube), meshes=1), bodies(problem(0.0, tube))
    assert isinstance(body, Body)
    assert locked.seconds < torsion_estimate(problem(0.02, tube), meshes=1).seconds


def test_kept_settings_take_no_time(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", str(tmp_path))
    both = (problem(), problem(0.02))
    assert torsion_outlook(both, tolerance=0.02).startswith("2 settings, in all: about ")
    solve(both[0], tolerance=0.02)
    assert torsion_outlook(both, tolerance=0.02).startswith("1 setting (1 more kept from an earlier run), in all: ")
    assert torsion_outlook(both[:1], tolerance=0.02) == ALL_KEPT


def test_every_leaf_is_counted_with_both_ratios(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", str(tmp_path))
    points = [(0.1, 0.025), (0.15, 0.025)]
    one = leaf_estimate(problem_of(JOINT, 0.1, 0.025, poissons_ratio=0.3))
    said = leaf_outlook(JOINT, points, poissons_ratio=0.3, tolerance=0.01)
    assert said.startswith("4 solids, in all: about ")
    assert f" and {one.room}; " in said
    assert leaf_outlook(JOINT, points, poissons_ratio=0.0, tolerance=0.01).startswith("2 solids, in all: ")
    check(JOINT, 0.1, 0.025, poissons_ratio=0.0, tolerance=0.01)
    kept = leaf_outlook(JOINT, points, poissons_ratio=0.3, tolerance=0.01)
    assert kept.startswith("3 solids (1 more kept from an earlier run), in all: ")
    assert leaf_outlook(JOINT, points[:1], poissons_ratio=0.0, tolerance=0.01) == ALL_KEPT


def eccentric() -> tuple[Loop, ...]:
    """A bore that leaves a wall of 0.06 mm: long edges would cut through it."""
    turn, far = math.radians(60.0), 0.00494
    centre = (far * math.cos(turn), far * math.sin(turn))
    outer = tuple(Arc((0.0, 0.0), 0.01, math.pi * half, math.pi) for half in range(2))
    bore = tuple(Arc(centre, 0.005, -math.pi * half, -math.pi) for half in range(2))
    return outer, bore


def test_a_mesh_whose_edges_cross_is_left_out() -> None:
    outline, level = Outline(eccentric()), LEVELS[0]
    size = level.size * thickness(outline)
    with pytest.raises(InputError, match=r"^actuator.section: the section cannot be meshed \(a straight edge along"):
        plane_mesh(outline, size=size, edge=0.5 * size, root=size, turn=math.radians(level.turn))
    section = Polygon(loops=eccentric())
    found = list(
        bodies(
            TorsionProblem(
                section=section,
                shear_modulus=1e9,
                poissons_ratio=0.3,
                length=0.06,
                active_length=0.03,
                bearing_length=0.01,
            )
        )
    )
    assert [body.level for body in found] == list(LEVELS[1:])
