"""Every status of a roller beam, on both sides of its border, decided without the package."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from independent.references.rod_bvp import NoShapeError, roller_contact
from varistiff.actuators import FixedPair, RollerBeam, Rollers, SingleLower, SingleUpper, SwivellingPair
from varistiff.core.status import Status
from varistiff.elastic.leaf import Leaf

from .evaluation import statuses
from .predicates import Vector, distance_to_rod, fold_angle, rod

E, WIDTH, THICKNESS = 194e9, 0.02545, 0.00316
RIGIDITY = E * WIDTH * THICKNESS**3 / 12
RADIUS = 0.012
WALL, ALONG, ACROSS = 0.06, 0.035, -0.005


def beam(length: float = 3.0, strength: float = math.inf) -> Leaf:
    return Leaf(youngs_modulus=E, width=WIDTH, thickness=THICKNESS, length=length, yield_strength=strength)


def plain(rollers: Rollers, leaf: Leaf | None = None) -> RollerBeam:
    """Joint at the clamp, link along the beam at rest."""
    return RollerBeam(beam=beam() if leaf is None else leaf, rollers=rollers)


def offset(rollers: Rollers, leaf: Leaf | None = None) -> RollerBeam:
    """Joint away from the clamp, link at a mounting angle."""
    return RollerBeam(
        beam=beam() if leaf is None else leaf,
        rollers=rollers,
        mounting_angle=WALL,
        clamp_offset_along=ALONG,
        clamp_offset_across=ACROSS,
    )


def place(deflection: float, setting: float, across: float) -> Vector:
    """Point of the link of an `offset` device at (setting, across), in the clamp's frame."""
    turn = WALL + deflection
    x = -ALONG * math.cos(WALL) + ACROSS * math.sin(WALL) + setting * math.cos(turn) - across * math.sin(turn)
    y = -ALONG * math.sin(WALL) - ACROSS * math.cos(WALL) + setting * math.sin(turn) + across * math.cos(turn)
    return x, y


def crossing(f: Callable[[float], float], low: float, high: float) -> float:
    """Zero of an increasing function."""
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    return (low + high) / 2


@pytest.mark.parametrize("ratio", [0.0, 0.05, -0.01, 0.2])
def test_fold(ratio: float) -> None:
    """Without offsets the centre's polar angle is the deflection: the fold is the largest that Eq. (12) reaches."""
    setting = 0.3
    rollers = SingleLower(offset=0.0, radius=ratio * setting - THICKNESS / 2)
    border = fold_angle(ratio)
    points = [(border - 1e-6, setting), (border + 1e-6, setting), (border - 0.05, setting), (2.9, setting)]
    assert statuses(plain(rollers), points) == [
        Status.OK,
        Status.NO_SOLUTION,
        Status.OK,
        Status.NO_SOLUTION,
    ]
    upper = SingleUpper(offset=0.0, radius=rollers.radius)
    assert statuses(plain(upper), [(-d, s) for d, s in points]) == statuses(plain(rollers), points)


def test_fold_is_where_the_rod_slips_off() -> None:
    """The same border by continuation of the boundary-value rod, with offsets."""
    rollers, setting = SwivellingPair(offset=0.006, clearance=0.003), 0.4

    def excess(deflection: float) -> float:
        x, y = place(deflection, setting, 0.006)
        return math.atan2(y, x) - fold_angle(-0.003 / math.hypot(x, y))

    border = crossing(excess, 0.5, 2.0)
    inside, beyond = place(border - 0.004, setting, 0.006), place(border + 0.004, setting, 0.006)
    assert roller_contact(inside, radius=-0.003, flexural_rigidity=1.0, tolerance=1e-5).length < 3.0
    with pytest.raises(NoShapeError):
        roller_contact(beyond, radius=-0.003, flexural_rigidity=1.0, tolerance=1e-5)
    device = offset(rollers)
    close = [(border - 1e-6, setting), (border + 1e-6, setting)]
    assert statuses(device, close) == [Status.OK, Status.NO_SOLUTION]


def test_settings_that_no_shuttle_has() -> None:
    """x_r <= 0 is no mechanism, whatever the contact; the smallest positive one is."""
    device = plain(SingleLower(offset=-0.1, radius=RADIUS))
    points = [(0.0, 0.0), (0.0, -0.1), (0.0, 1e-300)]
    assert statuses(device, points) == [Status.NO_SOLUTION, Status.NO_SOLUTION, Status.NO_CONTACT]


@pytest.mark.parametrize("lower", [True, False])
@pytest.mark.parametrize("degrees", [25.0, 80.0])
def test_element_too_short(degrees: float, lower: bool) -> None:
    """The rod's length to the contact, a micrometre more and a micrometre less."""
    setting, sign = 0.35, 1.0 if lower else -1.0
    kind = SingleLower if lower else SingleUpper
    rollers = kind(offset=-0.01 * sign, radius=RADIUS)
    deflection = math.radians(degrees) * sign
    x, y = place(deflection, setting, -0.01 * sign)
    needed = rod((x, sign * y), RADIUS + THICKNESS / 2, RIGIDITY).length
    point = [(deflection, setting)]
    assert statuses(offset(rollers, beam(needed + 1e-6)), point) == [Status.OK]
    assert statuses(offset(rollers, beam(needed - 1e-6)), point) == [Status.ELEMENT_TOO_SHORT]


def test_too_short_comes_before_yielded_and_after_no_solution() -> None:
    weak = plain(SwivellingPair(offset=0.0, clearance=0.001), beam(0.3, 1e6))
    points = [(0.5, 0.25), (0.5, 0.4), (1.9, 0.4), (0.0, 0.4)]
    wanted = [Status.YIELDED, Status.ELEMENT_TOO_SHORT, Status.NO_SOLUTION, Status.NO_CONTACT]
    assert statuses(weak, points) == wanted


@pytest.mark.parametrize(
    ("rollers", "across", "reach", "sign"),
    [
        (SingleLower(offset=-0.011, radius=RADIUS), -0.011, RADIUS + THICKNESS / 2, 1.0),
        (SingleUpper(offset=0.009, radius=RADIUS), 0.009, RADIUS + THICKNESS / 2, -1.0),
        (SwivellingPair(offset=0.004, clearance=0.002), 0.004, -0.002, 1.0),
        (SwivellingPair(offset=0.004, clearance=0.002), 0.004, -0.002, -1.0),
        (FixedPair(offset=0.002, radius=0.005, clearance=0.003), -0.00758, 0.00658, 1.0),
        (FixedPair(offset=0.002, radius=0.005, clearance=0.003), 0.01158, 0.00658, -1.0),
    ],
)
def test_contact_begins_where_surfaces_meet(rollers: Rollers, across: float, reach: float, sign: float) -> None:
    """Overlap of the roller with the undeformed beam: a nanometre of gap, a nanometre of overlap."""
    setting = 0.3

    def overlap(deflection: float) -> float:
        return sign * place(sign * deflection, setting, across)[1] + reach

    border = crossing(overlap, -0.4, 0.4)
    step = 1e-9 / setting
    points = [(sign * (border - step), setting), (sign * (border + step), setting)]
    assert statuses(offset(rollers), points) == [Status.NO_CONTACT, Status.OK]


def test_a_picometre_is_no_contact() -> None:
    """A gap or overlap under 1e-12 m counts as no contact."""
    for overlap, wanted in ((0.5e-12, Status.NO_CONTACT), (-0.5e-12, Status.NO_CONTACT), (2e-12, Status.OK)):
        rollers = SingleLower(offset=-RADIUS - THICKNESS / 2 + overlap, radius=RADIUS)
        assert statuses(plain(rollers), [(0.0, 0.3)]) == [wanted]


@pytest.mark.parametrize(
    ("clearance", "length", "sign"),
    [(0.0004, 0.9, 1.0), (0.0004, 0.9, -1.0), (0.0015, 3.0, 1.0), (0.0015, 3.0, -1.0)],
    ids=["tight", "tight, upper", "loose", "loose, upper"],
)
def test_both_rollers_of_a_fixed_pair(clearance: float, length: float, sign: float) -> None:
    """Where the device says that both would bear, the other centre is closer than r to the deformed beam."""
    rollers, leaf, setting = FixedPair(offset=0.001, radius=0.01, clearance=clearance), beam(length), 0.35
    reach = 0.01 + THICKNESS / 2

    def room(deflection: float) -> float:
        """Of the other roller, by the boundary-value rod."""
        acting = place(deflection, setting, 0.001 - sign * (reach + clearance))
        other = place(deflection, setting, 0.001 + sign * (reach + clearance))
        shape = rod((acting[0], sign * acting[1]), reach, RIGIDITY)
        return distance_to_rod(shape, length, (other[0], sign * other[1])) - reach

    device = offset(rollers, leaf)
    angles = [sign * (0.02 + 0.01 * i) for i in range(100)]
    found = statuses(device, [(angle, setting) for angle in angles])
    borders = [i for i in range(99) if {found[i], found[i + 1]} == {Status.OK, Status.OUTSIDE_VALIDITY}]
    assert borders
    for i in borders:
        low, high = angles[i], angles[i + 1]
        for _ in range(30):
            middle = (low + high) / 2
            low, high = (middle, high) if statuses(device, [(middle, setting)])[0] == found[i] else (low, middle)
        for angle in (low - 2e-4 * sign, high + 2e-4 * sign):
            blocked = statuses(device, [(angle, setting)]) == [Status.OUTSIDE_VALIDITY]
            assert blocked == (room(angle) < 0)
    for i in (5, 40, 95):
        if found[i] in (Status.OK, Status.OUTSIDE_VALIDITY):
            assert (found[i] == Status.OUTSIDE_VALIDITY) == (room(angles[i]) < 0)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_second_roller_on_the_bent_part(sign: float) -> None:
    """With the joint ahead of the clamp the link turns more than the beam: the other roller nears the bent part."""
    setting, clearance, ahead = 0.2, 0.0002, 0.2
    reach = 0.01 + THICKNESS / 2
    device = RollerBeam(
        beam=beam(0.7),
        rollers=FixedPair(offset=0.0, radius=0.01, clearance=clearance),
        clamp_offset_along=-ahead,
    )

    def room(angle: float) -> float:
        c, s, spread = math.cos(angle), math.sin(angle), reach + clearance
        acting = (ahead + setting * c + spread * s, setting * s - spread * c)
        other = (ahead + setting * c - spread * s, setting * s + spread * c)
        shape = rod(acting, reach, RIGIDITY)
        beside = (other[0] - shape.x[-1]) * math.cos(shape.end_slope)
        beside += (other[1] - shape.y[-1]) * math.sin(shape.end_slope)
        assert beside < 0  # before the contact: on the bent part
        return distance_to_rod(shape, 0.7, other) - reach

    border = crossing(lambda angle: -room(angle), 0.1, 0.9)
    points = [(sign * (border - 1e-5), setting), (sign * (border + 1e-5), setting)]
    assert statuses(device, points) == [Status.OK, Status.OUTSIDE_VALIDITY]


def test_second_roller_beyond_the_end_of_the_beam() -> None:
    """A beam that ends just after the contact leaves the other roller free; a longer one meets it."""
    clearance, setting, deflection = 0.0004, 0.35, 0.5
    reach = 0.01 + THICKNESS / 2
    rollers = FixedPair(offset=0.001, radius=0.01, clearance=clearance)
    acting = place(deflection, setting, 0.001 - reach - clearance)
    other = place(deflection, setting, 0.001 + reach + clearance)
    shape = rod(acting, reach, RIGIDITY)
    seen = set()
    for tail in (1e-5, 0.002, 0.004, 0.008, 0.02):
        length = shape.length + tail
        blocked = distance_to_rod(shape, length, other) < reach
        wanted = Status.OUTSIDE_VALIDITY if blocked else Status.OK
        assert statuses(offset(rollers, beam(length)), [(deflection, setting)]) == [wanted]
        seen.add(wanted)
    assert len(seen) == 2


@pytest.mark.parametrize("degrees", [25.0, 85.0, -70.0])
def test_yielded(degrees: float) -> None:
    """The rod's largest moment decides, also where it lies inside the beam (slopes beyond 90 degrees)."""
    setting, sign = 0.3, math.copysign(1.0, degrees)
    rollers = SwivellingPair(offset=0.004, clearance=0.002)
    deflection = math.radians(degrees)
    x, y = place(deflection, setting, 0.004)
    shape = rod((x, sign * y), -0.002, RIGIDITY)
    stress = E * THICKNESS / 2 * shape.moment_max / RIGIDITY
    point = [(deflection, setting)]
    assert statuses(offset(rollers, beam(3.0, stress * (1 + 1e-5))), point) == [Status.OK]
    assert statuses(offset(rollers, beam(3.0, stress * (1 - 1e-5))), point) == [Status.YIELDED]
    if degrees == 85.0:
        assert shape.end_slope > math.pi / 2
        assert shape.moment_max > 1.05 * shape.root_moment


def test_double_contact_comes_before_yielded() -> None:
    weak = offset(FixedPair(offset=0.001, radius=0.01, clearance=0.0004), beam(0.9, 1e6))
    assert statuses(weak, [(0.5, 0.35)]) == [Status.OUTSIDE_VALIDITY]
