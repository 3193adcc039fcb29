"""The check as users meet it: results, cache, limits, refusals, STEP."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from varistiff.core.errors import InputError
from varistiff.fe import cache
from varistiff.fe.estimate import direct_solver
from varistiff.fe.step import write_step
from varistiff.fe.torsion_body import LEVELS, Body, unknowns
from varistiff.fe.torsion_problem import TorsionProblem
from varistiff.fe.torsion_solve import solve
from varistiff.sections import P3G, Circle, SplinedTube, Square

pytest.importorskip("ngsolve")


def problem(section: Any = None, **changed: Any) -> TorsionProblem:
    numbers = {
        "shear_modulus": 0.63e9,
        "poissons_ratio": 0.35,
        "length": 0.08,
        "active_length": 0.03,
        "bearing_length": 0.01,
    }
    return TorsionProblem(section or Circle(radius=0.01), **{**numbers, **changed})


def splined() -> SplinedTube:
    return SplinedTube(
        outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.004, rail_height=0.0025, root_fillet=0.0005
    )


def test_result_of_a_round_bar() -> None:
    told: list[tuple[str, float]] = []
    result = solve(problem(), progress=lambda text, share: told.append((text, share)))
    assert [case.name for case in result.cases] == ["end_flange_free", "end_flange_blocked", "bearing_bonded"]
    assert result.error <= 0.005
    assert result.contact is None
    assert result.stress.torsion_ratio == pytest.approx(1.0, abs=2e-3)
    shares = [share for _, share in told]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    surface = next(field for field in result.fields if field.name == "bearing_surface")
    radius = np.hypot(surface.points[:, 0], surface.points[:, 1])
    assert np.allclose(radius, 0.01, rtol=1e-4)  # on the circle, not on its chords
    assert surface.triangles.max() == len(surface.points) - 1
    assert np.isfinite(surface.equivalent).all()


def test_rigid_lock_is_finite_under_pressure_only() -> None:
    result = solve(problem(splined(), active_length=0.0))
    (case,) = result.cases
    assert case.name == "bearing_pressure"
    assert result.contact is None
    assert math.isnan(result.stress.torsion)
    # far stiffer than the bar of one bearing length, and all of it local
    assert 0.63e9 * splined().torsion_constant / 0.01 < case.stiffness < math.inf
    assert case.local_share > 0.1
    with pytest.raises(InputError, match="rigid clamp"):
        problem(active_length=0.0)


def test_clearance_is_lost_motion_and_no_stiffness() -> None:
    tight, loose = (
        solve(problem(Square(across_flats=0.014), bearing_clearance=gap), tolerance=0.02) for gap in (0.0, 1e-4)
    )
    stiffness = [result.case("bearing_contact").stiffness for result in (tight, loose)]
    assert stiffness[0] == pytest.approx(stiffness[1], rel=1e-4)  # the contact's own tolerance
    assert tight.contact is not None
    assert loose.contact is not None
    assert tight.contact.lost_motion == 0.0
    # a square sleeve closes at its corners, half the side from the middle of a flat
    assert loose.contact.lost_motion == pytest.approx(1e-4 / 0.007, rel=0.1)


def test_bearing_beyond_the_end_is_cut() -> None:
    assert problem(active_length=0.075).bearing_end == 0.08


@pytest.mark.parametrize(
    "field, value",
    [
        ("active_length", -0.001),
        ("active_length", 0.08),
        ("active_length", math.nan),
        ("poissons_ratio", 0.5),
        ("shear_modulus", 0.0),
        ("bearing_length", math.inf),
        ("bearing_clearance", -1e-6),
    ],
)
def test_numbers_out_of_range_are_refused(field: str, value: float) -> None:
    with pytest.raises(InputError) as caught:
        problem(**{field: value})
    assert caught.value.field == field


def test_too_little_memory_is_said_before_solving() -> None:
    with pytest.raises(InputError, match="GiB for"):
        solve(problem(), memory_limit=1e4)


def test_unknowns_are_known_before_the_solid_exists() -> None:
    body = Body(problem(Square(across_flats=0.014)), LEVELS[0])
    elastic = body.elastic(body.bearing_solid(), "antisymmetric")
    assert unknowns(body, bearing=True) == elastic.unknowns
    assert direct_solver(60_000).memory > direct_solver(30_000).memory


def test_cache_gives_the_same_result_and_survives_damage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", str(tmp_path))
    first = solve(problem(), tolerance=0.02)
    (entry,) = (tmp_path / "varistiff" / "verify").iterdir()
    second = solve(problem(), tolerance=0.02)
    assert second.cases[0].stiffness == first.cases[0].stiffness
    assert second.seconds == first.seconds  # read, not computed
    assert np.array_equal(second.fields[0].equivalent, first.fields[0].equivalent)
    entry.write_text(entry.read_text()[:-100])
    assert cache.read_entry(entry.stem) is None
    assert solve(problem(), tolerance=0.02).cases[0].stiffness == pytest.approx(first.cases[0].stiffness, rel=1e-9)
    solve(problem(poissons_ratio=0.3), tolerance=0.02)
    assert len(list(entry.parent.iterdir())) == 2


def test_interruption_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", str(tmp_path))

    def interrupt(text: str, _: float) -> None:
        if "bearing" in text:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        solve(problem(), progress=interrupt)
    assert list(tmp_path.rglob("*")) == []


def test_step_holds_the_volume_of_the_section(tmp_path: Path) -> None:
    from netgen.occ import OCCGeometry

    tube = splined()
    path = tmp_path / "element.step"
    assert write_step(tube, length=0.17, path=path, flange_radius=0.02, flange_thickness=0.005) == 0.0
    shape = OCCGeometry(str(path)).shape
    flange = math.pi * (0.02**2 - 0.0087**2) * 0.005  # the bore goes through
    assert len(shape.solids) == 1
    assert shape.mass == pytest.approx(1e9 * (tube.area * 0.17 + flange), rel=1e-6)
    assert str(tmp_path) not in path.read_text()


def test_step_states_the_deviation_of_a_curve(tmp_path: Path) -> None:
    deviation = write_step(P3G(mean_diameter=0.02, eccentricity=0.0005), length=0.1, path=tmp_path / "p3g.step")
    assert 0.0 < deviation < 1e-7


def test_step_refuses_and_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="length"):
        write_step(Circle(radius=0.01), length=-1.0, path=tmp_path / "no.step")
    assert list(tmp_path.iterdir()) == []
