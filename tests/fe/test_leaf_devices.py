"""The elastica of the three leaf devices against the solid."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import pytest

pytest.importorskip("ngsolve")

from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.actuators.leaf_joint_theory import LargeDeflection, SmallDeflection
from varistiff.actuators.maccepa import Maccepa
from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import FixedPair, SingleLower, SingleUpper, SwivellingPair
from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.sliding_leaf import SlidingLeaf
from varistiff.elastic.wrapped_leaf import WrappedLeaf
from varistiff.fe.leaf_check import check
from varistiff.fe.leaf_devices import beam_answer, energy_of, load_of, problem_of, problems_of, stiffness_of
from varistiff.fe.leaf_estimate import leaf_estimate
from varistiff.fe.leaf_problem import LeafResult, SlidingContact
from varistiff.fe.leaf_solve import solve

BEAM = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316, length=0.9)
STRIP = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005)
SPRING = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001)


@pytest.fixture(autouse=True)
def _nothing_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", "off")


def roller_beam(rollers: object) -> RollerBeam:
    return RollerBeam(
        beam=BEAM, rollers=rollers, mounting_angle=0.05, clamp_offset_along=0.03, clamp_offset_across=-0.012
    )


def antagonistic(law: object) -> AntagonisticLeaves:
    return AntagonisticLeaves(leaf=STRIP, law=law, roller_distance=0.345, clamp_height=0.0405)


def slider(**more: object) -> SliderLeafJoint:
    return SliderLeafJoint(leaf=SPRING, count=3, clamp_radius=0.02, theory=LargeDeflection(), **more)


def solved(actuator: object, deflection: float, setting: float, poissons_ratio: float = 0.0) -> list[LeafResult]:
    problems = problems_of(actuator, deflection, setting, poissons_ratio=poissons_ratio)
    return [solve(problem) for problem in problems]


CASES = {
    "lower": (roller_beam(SingleLower(offset=-0.004, radius=0.01)), 0.4, 0.25),
    "upper": (roller_beam(SingleUpper(offset=0.006, radius=0.015)), -0.35, 0.3),
    "swivelling": (roller_beam(SwivellingPair(offset=0.003, clearance=0.002)), 0.45, 0.28),
    "swivelling, mirrored": (roller_beam(SwivellingPair(offset=0.003, clearance=0.002)), -0.5, 0.28),
    "fixed pair": (roller_beam(FixedPair(offset=0.002, radius=0.01, clearance=0.001)), 0.3, 0.3),
    "sliding": (antagonistic(SlidingLeaf()), 0.012, 0.15),
    "wrapped, free there": (antagonistic(WrappedLeaf(0.03)), -0.005, 0.15),
    "guided": (antagonistic(GuidedLeaf()), 0.012, 0.15),
    "slider": (slider(), 0.25, 0.025),
    "slider, mirrored": (slider(), -0.25, 0.025),
}


@pytest.mark.parametrize("name", CASES)
def test_plain_solid_is_the_elastica(name: str) -> None:
    """Poisson's ratio 0: what remains is shear and thickness, of order (h/L)^2 (0.6 for a cantilever's load)."""
    actuator, deflection, setting = CASES[name]
    beam, _ = beam_answer(actuator, deflection, setting)
    results = solved(actuator, deflection, setting)
    thickness = results[0].problem.thickness
    slender = max((thickness / result.arc_length) ** 2 for result in results)
    bound = 3.0 * slender + 3e-4
    scale = sum(abs(result.load) for result in results)
    assert load_of(results) == pytest.approx(beam.load, abs=bound * scale)
    assert stiffness_of(results) == pytest.approx(beam.stiffness, rel=3.0 * bound)
    assert energy_of(results) == pytest.approx(beam.energy, rel=bound)
    # the stress is taken a thickness from the clamp, where the moment has dropped by about that part of the length
    stress = max(result.stress for result in results)
    assert beam.stress * (1.0 - 4.0 * math.sqrt(slender)) < stress < beam.stress * (1.0 + 2.0 * math.sqrt(slender))


@pytest.mark.parametrize("name", ["swivelling", "slider"])
def test_contact_of_the_plain_solid_is_the_elastica(name: str) -> None:
    actuator, deflection, setting = CASES[name]
    _, details = beam_answer(actuator, deflection, setting)
    (result,) = solved(actuator, deflection, setting)
    arc, slope = (
        ("active_length", "contact_slope") if "contact_slope" in details else ("active_arc_length", "leaf_rotation")
    )
    assert result.contact_force == pytest.approx(details["contact_force"], rel=3e-3)
    assert result.arc_length == pytest.approx(details[arc], rel=1e-3)
    assert result.contact_slope == pytest.approx(abs(details[slope]), rel=3e-3)


def test_check_of_the_slider_with_steel() -> None:
    """A leaf as wide as it is long is nearly a plate: close to, and below, 1/(1 - nu^2)."""
    told: list[str] = []
    result = check(slider(), 0.15, 0.025, poissons_ratio=0.3, progress=told.append)
    ratio = result.solid_load / result.plain_load
    assert 1.03 < ratio < 1.0 / (1.0 - 0.3**2)
    assert 1.03 < result.solid_stiffness / result.plain_stiffness < 1.0 / (1.0 - 0.3**2)
    assert result.plain_load == pytest.approx(result.beam_load, rel=5e-3)
    assert result.error < 0.005
    assert told
    assert all("\n" not in line for line in told)


def test_a_narrow_leaf_knows_no_plate_effect() -> None:
    """Width of two thicknesses: E I, whatever Poisson's ratio."""
    rod = Leaf(youngs_modulus=206e9, width=0.002, thickness=0.001)
    joint = SliderLeafJoint(leaf=rod, count=1, clamp_radius=0.02, theory=LargeDeflection())
    (result,) = solved(joint, 0.1, 0.03, poissons_ratio=0.3)
    assert result.load == pytest.approx(beam_answer(joint, 0.1, 0.03)[0].load, rel=6e-3)


def test_a_wrapped_leaf_lies_on_its_cylinders() -> None:
    """A frictionless cylinder touches the solid in a line, not over an arc: up to 3 % in curvature, less in force."""
    spring = antagonistic(WrappedLeaf(0.035))
    problems = problems_of(spring, 0.012, 0.183, poissons_ratio=0.0)
    assert [problem.hold.guard_radius for problem in problems] == [0.035, math.inf]
    beam, _ = beam_answer(spring, 0.012, 0.183)
    free, _ = beam_answer(antagonistic(SlidingLeaf()), 0.012, 0.183)
    results = [solve(problem) for problem in problems]
    assert abs(load_of(results) - beam.load) < 0.02 * abs(beam.load) < 0.2 * abs(free.load - beam.load)
    assert energy_of(results) == pytest.approx(beam.energy, rel=1e-3)
    assert 1.0 < max(result.stress for result in results) / beam.stress < 1.03


def test_results_are_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", str(tmp_path))
    told: list[str] = []
    first = check(slider(), 0.1, 0.025, poissons_ratio=0.0, progress=told.append)
    count = len(told)
    assert count
    again = check(slider(), 0.1, 0.025, poissons_ratio=0.0, progress=told.append)
    assert len(told) == count
    assert (again.solid_load, again.solid_stiffness, again.error) == (
        first.solid_load,
        first.solid_stiffness,
        first.error,
    )
    assert (again.solid[0].points == first.solid[0].points).all()
    check(slider(), 0.1, 0.025, poissons_ratio=0.0, progress=told.append, fresh=True)
    assert len(told) > count


def test_estimate_counts_the_unknowns() -> None:
    (result,) = solved(slider(), 0.1, 0.025, poissons_ratio=0.3)
    estimate = leaf_estimate(result.problem)
    assert estimate.unknowns == result.unknowns
    assert 1e7 < estimate.memory < 4e9
    assert 0.5 < estimate.seconds < 120.0


def test_mirror_images_are_mirror_images() -> None:
    up = problem_of(slider(), 0.25, 0.025, poissons_ratio=0.3)
    down = problem_of(slider(), -0.25, 0.025, poissons_ratio=0.3)
    assert up.hold == down.hold
    assert (up.side, down.side) == (1.0, -1.0)
    assert up.motion.rate[1] == -down.motion.rate[1]


def test_the_solid_is_the_exact_leaf_whatever_the_theory() -> None:
    joint = SliderLeafJoint(leaf=SPRING, count=3, clamp_radius=0.02, theory=SmallDeflection())
    assert problem_of(joint, 0.25, 0.025, poissons_ratio=0.3) == problem_of(slider(), 0.25, 0.025, poissons_ratio=0.3)


def test_the_free_end_ends_with_the_leaf() -> None:
    short = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316, length=0.26)
    actuator = RollerBeam(beam=short, rollers=SwivellingPair(offset=0.0, clearance=0.0002))
    problem = problem_of(actuator, 0.15, 0.25, poissons_ratio=0.3)
    _, details = beam_answer(actuator, 0.15, 0.25)
    assert problem.tail == pytest.approx(0.26 - details["active_length"])
    assert isinstance(problem.hold, SlidingContact)
    assert problem.hold.radius == -0.0002


@pytest.mark.parametrize(
    "actuator, deflection, setting, words",
    [
        (roller_beam(SingleLower(offset=-0.004, radius=0.01)), -0.4, 0.25, "no_contact"),
        (roller_beam(SingleLower(offset=-0.004, radius=0.01)), 0.6, 1.2, "element_too_short"),
        (roller_beam(SwivellingPair(offset=0.0, clearance=0.0002)), 2.5, 0.25, "no_solution"),
        (antagonistic(SlidingLeaf()), 0.2, 0.15, "no_solution"),
        (antagonistic(WrappedLeaf(0.035)), 0.035, 0.183, "no_solution"),
        (antagonistic(WrappedLeaf(0.01)), 0.0, 0.325, "outside_validity"),
        (slider(), 0.0, 0.025, "straight"),
        (slider(), 0.1, -0.01, "no_solution"),
        (Maccepa(394.0, 0.036, 0.135), 0.1, 0.01, "is for roller_beam"),
    ],
)
def test_points_without_a_leaf_to_solve_are_refused(
    actuator: object, deflection: float, setting: float, words: str
) -> None:
    with pytest.raises(InputError, match=words) as caught:
        problems_of(actuator, deflection, setting, poissons_ratio=0.3)
    assert "\n" not in str(caught.value)


def test_missing_extra_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = problem_of(slider(), 0.1, 0.025, poissons_ratio=0.3)
    monkeypatch.setitem(sys.modules, "ngsolve", None)
    with pytest.raises(InputError, match=r"pip install 'varistiff\[fe\]'"):
        solve(problem)
