"""Every status of the other kinds on both sides of its border, and what each status does to the numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest

from independent.references.discrete_rod import sleeve
from independent.references.rod_bvp import roller_contact
from varistiff.actuators import (
    Actuator,
    FixedPair,
    Groove,
    LargeDeflection,
    LeafJointTheory,
    Maccepa,
    RollerBeam,
    SeriesElastic,
    SliderLeafJoint,
    SmallDeflection,
    TorsionTube,
)
from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.core.status import Status
from varistiff.elastic.end_effect import EndEffect
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafLaw
from varistiff.elastic.sliding_leaf import SlidingLeaf
from varistiff.elastic.wrapped_leaf import WrappedLeaf
from varistiff.sections import Circle, HollowCircle, SplinedTube

from .evaluation import energy, respond, statuses
from .predicates import fold_angle

ABOVE, BELOW = 1 + 1e-9, 1 - 1e-9


def test_torsion_tube() -> None:
    """Lock, end of the element, and von Mises shear yield of two springs in series."""
    tube = TorsionTube(
        shear_modulus=0.63e9,
        section=HollowCircle(outer_radius=0.011, inner_radius=0.0087),
        length=0.17,
        series_stiffness=650.0,
        yield_strength=48e6,
    )
    assert statuses(tube, [(0.01, 0.0), (0.01, -0.02), (0.01, 1e-6)]) == [1, 1, Status.OK]
    assert statuses(tube, [(0.01, 0.17), (0.01, 0.17 * ABOVE)]) == [Status.OK, Status.ELEMENT_TOO_SHORT]
    polar = math.pi / 2 * (0.011**4 - 0.0087**4)
    torque = 48e6 / math.sqrt(3) * polar / 0.011
    twist = torque * (0.1 / (0.63e9 * polar) + 1 / 650.0)
    points = [(twist * BELOW, 0.1), (twist * ABOVE, 0.1), (-twist * ABOVE, 0.1), (9.0, 0.18)]
    assert statuses(tube, points) == [Status.OK, Status.YIELDED, Status.YIELDED, Status.ELEMENT_TOO_SHORT]
    endless = TorsionTube(shear_modulus=0.63e9, section=Circle(radius=0.009))
    assert statuses(endless, [(5.0, 1.0), (0.0, 100.0)]) == [Status.OK, Status.OK]


def _rails(root_fillet: float) -> SplinedTube:
    return SplinedTube(
        outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.004, rail_height=0.0025, root_fillet=root_fillet
    )


def test_torsion_tube_with_an_end_model() -> None:
    """Numbers outside the fitted lengths are given, and said to be outside; no length, no solution."""
    tube = TorsionTube(
        shear_modulus=0.63e9,
        section=HollowCircle(outer_radius=0.011, inner_radius=0.0087),
        length=0.17,
        yield_strength=48e6,
        end_effect=EndEffect(offset=-0.002, lock_offset=0.0, decay=1.0, shortest=0.01, longest=0.15),
    )
    settings = [0.0, 0.002 * BELOW, 0.005, 0.01, 0.15, 0.16, 0.17 * ABOVE]
    expected = [Status.NO_SOLUTION] * 2 + [Status.OUTSIDE_VALIDITY] + [Status.OK] * 2
    expected += [Status.OUTSIDE_VALIDITY, Status.ELEMENT_TOO_SHORT]
    assert statuses(tube, [(1e-4, setting) for setting in settings]) == expected
    assert np.isfinite(respond(tube, [1e-4], [0.005])["load"]).all()


def test_a_sharp_root_has_no_stress_to_hold_against() -> None:
    """Infinite under load, 0 at rest, never yielded; a fillet has a stress and yields."""
    sharp, filleted = (
        TorsionTube(shear_modulus=0.63e9, section=_rails(fillet), yield_strength=1e6) for fillet in (0.0, 0.0005)
    )
    answer = respond(sharp, [0.0, 0.2, -0.2], [0.1, 0.1, 0.1])
    assert list(answer["stress"]) == [0.0, math.inf, math.inf]
    assert list(answer["status"]) == [Status.OK] * 3
    assert statuses(filleted, [(0.2, 0.1)]) == [Status.YIELDED]


def _leaves(law: LeafLaw, *, length: float = math.inf, strength: float = math.inf) -> AntagonisticLeaves:
    leaf = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005, length=length, yield_strength=strength)
    return AntagonisticLeaves(leaf=leaf, law=law, roller_distance=0.345, clamp_height=0.0405)


@pytest.mark.parametrize("law", [GuidedLeaf(), SlidingLeaf()], ids=["guided", "sliding"])
def test_leaves_without_span(law: LeafLaw) -> None:
    """A span (D - delta)/2 -+ d of zero or less, or nuts that have met, are no mechanism."""
    device = _leaves(law)
    points = [(0.0, 0.345), (0.0, 0.4), (0.081 * ABOVE, 0.183), (-0.081 * ABOVE, 0.183), (0.0, 0.0), (0.0, -0.1)]
    assert statuses(device, points) == [Status.NO_SOLUTION] * 6
    inside = [(0.081 * 0.99, 0.183), (-0.081 * 0.99, 0.183), (0.0, 0.344), (0.0, 1e-6)]
    assert statuses(device, inside) == [Status.OK] * 4


def test_leaves_too_short() -> None:
    """The longer leaf of the two decides; length by energy minimisation, whose error here is below 1e-6."""
    needed = sleeve(0.081 + 0.012, 0.0405, flexural_rigidity=1.0, elements=96).active_length
    for shift in (0.012, -0.012):
        assert statuses(_leaves(SlidingLeaf(), length=needed * (1 + 1e-5)), [(shift, 0.183)]) == [Status.OK]
        short = _leaves(SlidingLeaf(), length=needed * (1 - 1e-5), strength=1.0)
        assert statuses(short, [(shift, 0.183)]) == [Status.ELEMENT_TOO_SHORT]
    assert statuses(_leaves(GuidedLeaf(), length=0.05), [(0.0, 0.183)]) == [Status.ELEMENT_TOO_SHORT]
    assert statuses(_leaves(GuidedLeaf(), length=0.2), [(0.0, 0.183)]) == [Status.OK]


def test_leaves_yield() -> None:
    """The tighter leaf yields first: curvature of the minimiser's end hinge, corrected to the end.

    The curvature is linear in height along a free elastica (moment of one force), and its hinge sits half an
    element before the clamp.
    """
    span, elements = 0.081 - 0.012, 96
    found = sleeve(span, 0.0405, flexural_rigidity=1.0, elements=elements)
    middle = np.array([span, 0.0405]) / 2
    direction = np.array([math.cos(found.slope), math.sin(found.slope)])
    hinge = np.array([(found.x[0] + found.x[1]) / 2, (found.y[0] + found.y[1]) / 2])
    arms = [abs(float((point - middle) @ direction)) for point in (np.zeros(2), hinge)]
    stress = 210e9 * 0.0005 / 2 * found.curvature_max * arms[0] / arms[1]
    for shift in (0.012, -0.012):
        assert statuses(_leaves(SlidingLeaf(), strength=stress * 1.001), [(shift, 0.183)]) == [Status.OK]
        assert statuses(_leaves(SlidingLeaf(), strength=stress * 0.999), [(shift, 0.183)]) == [Status.YIELDED]


def test_protecting_radius_is_met_before_two() -> None:
    """R = E t/(2 sigma_y) = 35 mm: the leaf is at its yield strength near span/height 2.1 (guided), 2.03."""
    for law, ratio in ((GuidedLeaf(), 2.1), (SlidingLeaf(), 2.03)):
        device = _leaves(law, strength=1500e6)
        nuts = [0.345 - 2 * 0.0405 * (ratio + step) for step in (0.05, -0.05)]
        assert statuses(device, [(0.0, value) for value in nuts]) == [Status.OK, Status.YIELDED]


def test_wrapped_leaves_stop_where_the_arcs_meet() -> None:
    """Two arcs of one radius and angle: height 2 R (1 - cos), span 2 R sin."""
    radius = 0.035
    turn = math.acos(1 - 0.0405 / (2 * radius))
    stop = 2 * radius * math.sin(turn)
    half = (0.345 - 0.183) / 2
    device = _leaves(WrappedLeaf(protection_radius=radius))
    for sign in (1.0, -1.0):
        inside, beyond = sign * (half - stop * (1 + 1e-5)), sign * (half - stop * (1 - 1e-5))
        assert statuses(device, [(inside, 0.183), (beyond, 0.183)]) == [Status.OK, Status.NO_SOLUTION]
    # wrapping holds the stress at E t/(2 R)
    limit = 210e9 * 0.0005 / 2 / radius
    strong = _leaves(WrappedLeaf(protection_radius=radius), strength=limit * ABOVE)
    weak = _leaves(WrappedLeaf(protection_radius=radius), strength=limit * BELOW)
    assert statuses(strong, [(0.0, 0.2)]) == [Status.OK]
    assert statuses(weak, [(0.0, 0.2)]) == [Status.YIELDED]


def _slider(
    theory: LeafJointTheory,
    *,
    groove: bool = False,
    driven_by: str = "length",
    length: float = math.inf,
    strength: float = math.inf,
) -> SliderLeafJoint:
    disc = Groove(
        inner_radius=0.025,
        outer_radius=0.054,
        outer_angle=math.radians(47),
        arc_radius=0.0368,
        centre="near",
    )
    return SliderLeafJoint(
        leaf=Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001, length=length, yield_strength=strength),
        count=2,
        clamp_radius=0.025,
        theory=theory,
        groove=disc if groove else None,
        driven_by=driven_by,
    )


@pytest.mark.parametrize("theory", [SmallDeflection(), LargeDeflection()], ids=["small", "large"])
def test_slider_settings(theory: LeafJointTheory) -> None:
    """No length, beyond the leaf, beyond the groove's travel of 29 mm or 47 degrees."""
    assert statuses(_slider(theory), [(0.001, 0.0), (0.001, -0.01), (0.001, 0.06)]) == [1, 1, Status.OK]
    short = _slider(theory, length=0.02)
    assert statuses(short, [(0.0, 0.02), (0.0, 0.02 * ABOVE)]) == [Status.OK, Status.ELEMENT_TOO_SHORT]
    grooved = _slider(theory, groove=True)
    assert statuses(grooved, [(0.001, 0.029 * BELOW), (0.001, 0.029 * 1.0001)]) == [Status.OK, 1]
    disc = _slider(theory, groove=True, driven_by="disc")
    end = math.radians(47)
    points = [(0.001, 0.3), (0.001, end * BELOW), (0.001, end * 1.0001), (0.001, 0.0), (0.001, -0.1)]
    assert statuses(disc, points) == [Status.OK, Status.OK, 1, 1, 1]


def test_slider_rotation_limit() -> None:
    """tan(rotation's linear value) from Eqs. (1) and (2): 3 l_2 tan(phi)/(2 l_1) = 10 degrees."""
    length = 0.018
    limit = math.atan(math.radians(10) * 2 * length / (3 * (0.025 + length)))
    points = [(limit * BELOW, length), (limit * ABOVE, length), (-limit * ABOVE, length)]
    wanted = [Status.OK, Status.OUTSIDE_VALIDITY, Status.OUTSIDE_VALIDITY]
    assert statuses(_slider(SmallDeflection()), points) == wanted
    assert statuses(_slider(LargeDeflection()), points) == [Status.OK] * 3
    weak = _slider(SmallDeflection(), strength=1e6)
    assert statuses(weak, points) == [Status.YIELDED, Status.OUTSIDE_VALIDITY, Status.OUTSIDE_VALIDITY]
    numbers = respond(weak, np.array([limit * 2]), np.array([length]))
    assert math.isfinite(numbers["load"][0])
    # the formulas have no fold: numbers go on, and are not believed where tan(phi) is small again
    assert statuses(_slider(SmallDeflection()), [(2.0, length), (math.pi, length), (-3.0, length)]) == [4, 4, 4]


def test_slider_small_deflection_yields() -> None:
    """E h/2 3 l_2 tan(phi)/l_1^2."""
    length, angle = 0.02, 0.03
    stress = 206e9 * 0.0005 * 3 * 0.045 * math.tan(angle) / length**2
    assert statuses(_slider(SmallDeflection(), strength=stress * ABOVE), [(angle, length)]) == [Status.OK]
    assert statuses(_slider(SmallDeflection(), strength=stress * BELOW), [(angle, length)]) == [Status.YIELDED]


def test_slider_large_deflection() -> None:
    """Length and yield by the boundary-value rod, the fold by the largest polar angle of the slider."""
    length, angle = 0.02, 0.35
    x, y = 0.045 * math.cos(angle) - 0.025, 0.045 * math.sin(angle)
    rod = roller_contact((x, y), radius=0.0, flexural_rigidity=1.0)
    point = [(angle, length)]
    assert statuses(_slider(LargeDeflection(), length=rod.length * (1 + 1e-7)), point) == [Status.OK]
    assert statuses(_slider(LargeDeflection(), length=rod.length * (1 - 1e-7)), point) == [2]
    stress = 206e9 * 0.0005 * rod.moment_max
    assert statuses(_slider(LargeDeflection(), strength=stress * (1 + 1e-6)), point) == [Status.OK]
    assert statuses(_slider(LargeDeflection(), strength=stress * (1 - 1e-6)), point) == [Status.YIELDED]
    fold = fold_angle(0.0)
    # polar angle of the slider about the clamp: sine rule in the triangle axis, clamp, slider
    border = fold - math.asin(0.025 / 0.045 * math.sin(fold))
    points = [(border - 1e-6, length), (border + 1e-6, length), (-border - 1e-6, length)]
    assert statuses(_slider(LargeDeflection()), points) == [Status.OK, 1, 1]


def test_kinds_from_their_energy_alone() -> None:
    """A linear spring is always ok; a cable hangs slack where the spring has no elongation."""
    assert statuses(SeriesElastic(stiffness=160.0), [(0.0, 0.0), (-3.0, 0.0)]) == [Status.OK, Status.OK]
    joint = Maccepa(spring_rate=394.0, lever_length=0.036, anchor_distance=0.135)
    slack = -0.002
    side = 0.135 - 0.036 - slack
    border = math.acos((0.036**2 + 0.135**2 - side**2) / (2 * 0.036 * 0.135))
    points = [(border * 0.9999, slack), (border * 1.0001, slack), (-border * 0.9999, slack), (0.0, 0.001)]
    assert statuses(joint, points) == [Status.NO_CONTACT, Status.OK, Status.NO_CONTACT, Status.OK]


NUMBERS = ("energy", "load", "stiffness", "adjusting_load", "stress")


def _pair(strength: float, clearance: float = 0.0004) -> RollerBeam:
    beam = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316, length=0.42, yield_strength=strength)
    return RollerBeam(beam=beam, rollers=FixedPair(offset=0.0, radius=0.01, clearance=clearance))


SHOWN: list[tuple[str, Actuator, tuple[float, float], Status]] = [
    ("roller ok", _pair(math.inf, 0.02), (0.2, 0.3), Status.OK),
    ("roller no solution", _pair(math.inf, 0.02), (2.2, 0.3), Status.NO_SOLUTION),
    ("roller too short", _pair(math.inf, 0.02), (0.3, 0.45), Status.ELEMENT_TOO_SHORT),
    ("roller no contact", _pair(math.inf, 0.02), (0.01, 0.3), Status.NO_CONTACT),
    ("roller both rollers", _pair(math.inf), (0.8, 0.25), Status.OUTSIDE_VALIDITY),
    ("roller yielded", _pair(1e6, 0.02), (0.2, 0.3), Status.YIELDED),
    ("slider invalid", _slider(SmallDeflection()), (0.2, 0.01), Status.OUTSIDE_VALIDITY),
    ("slider no solution", _slider(LargeDeflection()), (0.2, -0.01), Status.NO_SOLUTION),
    ("slider turned half round", _slider(LargeDeflection()), (math.pi, 0.02), Status.NO_SOLUTION),
    ("roller behind the joint", _pair(math.inf, 0.02), (0.2, -0.3), Status.NO_SOLUTION),
    ("roller turned round", _pair(math.inf, 0.02), (3.5, 0.3), Status.NO_SOLUTION),
    ("tube locked", TorsionTube(shear_modulus=1e9, section=Circle(radius=0.01)), (0.2, 0.0), Status.NO_SOLUTION),
    ("slider too short", _slider(LargeDeflection(), length=0.01), (0.2, 0.02), Status.ELEMENT_TOO_SHORT),
    ("slider yielded", _slider(LargeDeflection(), strength=1e6), (0.2, 0.02), Status.YIELDED),
    ("leaves no solution", _leaves(SlidingLeaf()), (0.1, 0.183), Status.NO_SOLUTION),
    ("leaves too short", _leaves(SlidingLeaf(), length=0.05), (0.0, 0.183), Status.ELEMENT_TOO_SHORT),
    ("leaves yielded", _leaves(GuidedLeaf(), strength=1e6), (0.0, 0.183), Status.YIELDED),
    (
        "cable slack",
        Maccepa(spring_rate=394.0, lever_length=0.036, anchor_distance=0.135),
        (0.0, -0.01),
        Status.NO_CONTACT,
    ),
]


@pytest.mark.parametrize(("_name", "device", "point", "wanted"), SHOWN, ids=[row[0] for row in SHOWN])
def test_numbers_follow_the_status(_name: str, device: Actuator, point: tuple[float, float], wanted: Status) -> None:
    """NaN where there is nothing, exactly zero without contact, finite numbers elsewhere; details too."""
    found = respond(device, np.array([point[0]]), np.array([point[1]]))
    assert found.pop("status")[0] == wanted
    both = wanted == Status.OUTSIDE_VALIDITY and device.kind == "roller_beam"
    for name, (value,) in found.items():
        if name == "stress" and device.kind == "maccepa":
            assert math.isnan(value)
        elif wanted in (Status.NO_SOLUTION, Status.ELEMENT_TOO_SHORT) or both:
            assert math.isnan(value), name
        elif wanted == Status.NO_CONTACT:
            assert value == 0.0, name
        else:
            assert math.isfinite(value), name
    if wanted in (Status.OK, Status.YIELDED):
        assert found["energy"][0] > 0
    alone = energy(device, np.array([point[0]]), np.array([point[1]]))[0]
    assert math.isnan(alone) == (wanted is Status.NO_SOLUTION)  # the energy by itself does not extrapolate either


def test_neighbours_of_bad_points_are_good() -> None:
    """A NaN stays where it belongs: one batch with every status."""
    device, single = _pair(3e8, 0.02), []
    points = [(0.05, 0.3), (2.2, 0.3), (0.3, 0.45), (0.01, 0.3), (0.2, -1.0), (0.6, 0.2)]
    for point in points:
        single += statuses(device, [point])
    assert statuses(device, points) == single
    assert {*single} >= {Status.NO_SOLUTION, Status.ELEMENT_TOO_SHORT, Status.NO_CONTACT}
