"""Section 4: the states of the test rig, and what its errors can tell."""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from varistiff.characteristic.evaluate import Points, evaluate
from varistiff.elastic.linear_cantilever import linear_cantilever
from varistiff.papers.dos_santos_2019.beams import leaf
from varistiff.papers.dos_santos_2019.elastica import (
    contact_place,
    defined_force,
    defined_load,
    load_limit,
    load_parameter,
    printed_integral,
    printed_load_parameter,
    printed_roots,
    slope_of,
)
from varistiff.papers.dos_santos_2019.mechanism import IDENTITY, joint
from varistiff.papers.dos_santos_2019.paper_values import ACTIVE_LENGTHS, BEAMS, FORCES, TRIALS

CLOSE = 0.01  # a printed curve cannot show less


class Contact(NamedTuple):
    """The beam at one contact, as the device answers; SI units."""

    slope: float  # theta_0 [rad]
    active_length: float
    along: float  # a
    across: float  # b
    along_force: float  # nP, against u_b
    across_force: float  # P, along v_b
    root_moment: float
    stress: float

    @property
    def load_parameter(self) -> float:
        """alpha_0 by the integral of Eq. (3) without its 1/sqrt(2)."""
        return load_parameter(self.slope)


@cache
def contact(beam: str, active_length: float, force: float) -> Contact:
    """State of a beam at an active length [m] under a transverse force P [N].

    The roller's place follows from the elastica; forces, slope and length there are those of ``RollerBeam``, the
    components of the force by its load and adjusting force.
    """
    rigidity = leaf(beam).flexural_rigidity
    slope = slope_of(defined_load(force, active_length=active_length, flexural_rigidity=rigidity))
    a, b = (active_length * part for part in contact_place(slope))
    return _answer(evaluate(joint(beam), math.atan2(b, a), math.hypot(a, b)))


def _answer(points: Points) -> Contact:
    angle, distance = float(points.deflection), float(points.setting)
    radial, turning = float(points.adjusting_load), float(points.load) / distance
    x, y = math.cos(angle), math.sin(angle)
    return Contact(
        slope=float(points.details["contact_slope"]),
        active_length=float(points.details["active_length"]),
        along=distance * x,
        across=distance * y,
        along_force=-(radial * x - turning * y),
        across_force=radial * y + turning * x,
        root_moment=float(points.details["root_moment"]),
        stress=float(points.stress),
    )


@cache
def states() -> tuple[Contact, ...]:
    """Every beam at both active lengths under the least, the middle and the largest printed force."""
    forces = (FORCES[0], 0.5 * sum(FORCES), FORCES[1])
    return tuple(
        contact(beam, length, force) for beam in BEAMS for length in ACTIVE_LENGTHS.values() for force in forces
    )


def _beams() -> list[str]:
    return [beam for beam in BEAMS for _ in range(3 * len(ACTIVE_LENGTHS))]


def _rigidities() -> list[float]:
    return [leaf(beam).flexural_rigidity for beam in _beams()]


def conditions_at_one_end() -> float:
    """Margin of Eq. (2), no slope and no curvature at one end: 1e-6, less what is left at the better end [rad].

    At the contact that is the largest slope, at the clamp the largest curvature times the active length.
    """
    clamp = [s.root_moment * s.active_length / rigidity for s, rigidity in zip(states(), _rigidities(), strict=True)]
    return 1e-6 - min(max(state.slope for state in states()), max(clamp))


def moment_at_clamp() -> float:
    """Margin of Eq. (1) at the clamp: P a + n P b, and the stress of that moment, against the device's."""
    misses = []
    for state, beam in zip(states(), _beams(), strict=True):
        element = leaf(beam)
        moment = state.across_force * state.along + state.along_force * state.across
        misses.append(abs(moment / state.root_moment - 1.0))
        misses.append(abs(6.0 * moment / (element.width * element.thickness**2) / state.stress - 1.0))
    return IDENTITY - max(misses)


def zero_lambda() -> float:
    """Margin of lambda = sin(theta_0) - n cos(theta_0) = 0, with n the ratio of the device's force components."""
    misses = [math.sin(s.slope) - s.along_force / s.across_force * math.cos(s.slope) for s in states()]
    return IDENTITY - max(map(abs, misses))


def normal_force() -> float:
    """Margin of Eqs. (6) and (7): the angle of the device's force less the slope, against a right angle."""
    misses = [math.atan2(s.across_force, -s.along_force) - s.slope - 0.5 * math.pi for s in states()]
    return IDENTITY - max(map(abs, misses))


def defined_force_agrees() -> float:
    """Margin of Eq. (15): its force, with alpha_0 from the integral without 1/sqrt(2), against the device's."""
    return IDENTITY - max(abs(ratio - 1.0) for ratio in _force_ratios(printed=False))


def printed_force_agrees() -> float:
    """Margin of Eqs. (3) and (15) together, as printed, against the device's force."""
    return CLOSE - max(abs(ratio - 1.0) for ratio in _force_ratios(printed=True))


def _force_ratios(*, printed: bool) -> list[float]:
    ratios = []
    for state, rigidity in zip(states(), _rigidities(), strict=True):
        alpha = printed_load_parameter(state.slope) if printed else printed_integral(state.slope)
        force = defined_force(alpha, active_length=state.active_length, flexural_rigidity=rigidity)
        ratios.append(force / state.across_force)
    return ratios


def printed_place_agrees() -> float:
    """Margin of Eqs. (4) and (5) as printed, with alpha_0 as the integral of Eq. (3), against the device's a and b."""
    misses = []
    for state in states():
        over = state.active_length / math.sqrt(2.0) / printed_load_parameter(state.slope)
        misses.append(abs(over * printed_integral(state.slope, "cos") / state.along - 1.0))
        misses.append(abs(over * printed_integral(state.slope, "sin") / state.across - 1.0))
    return IDENTITY - max(misses)


def one_root() -> float:
    """Half, less the number of roots of Eq. (12) below 90 degrees beside the one that is wanted."""
    return 0.5 - max(abs(printed_roots(s.across / s.along) - 1) for s in states())


def load_span() -> float:
    """alpha_0 that the printed forces cover, as a share of all that has an equilibrium, less a half."""
    values = [
        defined_load(force, active_length=length, flexural_rigidity=leaf(beam).flexural_rigidity)
        for beam in BEAMS
        for length in ACTIVE_LENGTHS.values()
        for force in FORCES
    ]
    return (max(values) - min(values)) / load_limit()[0] - 0.5


def largest_slope() -> float:
    """Largest slope at the contact that the printed forces can make [rad]."""
    return max(state.slope for state in states())


def large_displacement() -> float:
    """Largest displacement of the contact over the active length, less a tenth."""
    return max(state.across / state.active_length for state in states()) - 0.1


def linear_forces(state: Contact, beam: str) -> dict[str, float]:
    """P [N] by linear theories that take the contact's place or slope from ``state``.

    ``arc`` is the active length, ``chord`` the distance from the clamp to the contact, ``span`` its part along the
    clamp's axis; the force stands ``normal`` to the beam or ``across`` the clamp's axis. ``slope`` is
    2 E I theta_0/L^2.
    """
    rigidity, length = leaf(beam).flexural_rigidity, state.active_length

    def bent(over: float) -> tuple[float, float]:
        force, rotation, _ = linear_cantilever(state.across, over, rigidity)  # type: ignore[arg-type]  # floats do
        return float(force), float(force) * math.cos(float(rotation))

    return {
        "chord_normal": bent(math.hypot(state.along, state.across))[1],
        "arc_normal": bent(length)[1],
        "arc_across": bent(length)[0],
        "slope": 2.0 * rigidity * state.slope / length**2,
        "span_across": bent(state.along)[0],
    }


@cache
def linear_errors() -> dict[str, float]:
    """Largest difference of P [N] between each linear theory and the elastica over the printed forces."""
    rows = []
    for beam in BEAMS:
        for length in ACTIVE_LENGTHS.values():
            for force in np.linspace(*FORCES, 19):  # every newton
                forces = linear_forces(contact(beam, length, float(force)), beam)
                rows.append({theory: abs(value - float(force)) for theory, value in forces.items()})
    return {theory: max(row[theory] for row in rows) for theory in rows[0]}


def experiment_tells_theories_apart() -> tuple[float, float]:
    """Least and largest error of linear theories in the experiment, less the least printed error [N]."""
    errors, noise = linear_errors().values(), min(row.rms_error for row in BEAMS.values())
    return min(errors) - noise, max(errors) - noise


def excellent_agreement() -> float:
    """A twentieth of the largest contact force, less the largest of the beams' errors [N]."""
    return 0.05 * FORCES[1] - max(row.rms_error for row in BEAMS.values())


def same_load_same_shape() -> float:
    """Margin of "arbitrary dimensions": spread over beams and lengths of a/L, b/L and P L^2/(E I) at one alpha_0."""
    spread = 0.0
    for alpha in (0.15, 0.5, 1.3):
        rows = []
        for beam in BEAMS:
            rigidity = leaf(beam).flexural_rigidity
            for length in (*ACTIVE_LENGTHS.values(), 0.05):
                force = defined_force(alpha, active_length=length, flexural_rigidity=rigidity)
                state = contact(beam, length, force)
                rows.append((state.along / length, state.across / length, state.across_force * length**2 / rigidity))
        spread = max(spread, float(np.ptp(np.array(rows), axis=0).max()))
    return IDENTITY - spread


@cache
def growth_of_active_length(beam: str, setting: float) -> float:
    """What the active length [m] gains under a locked roller from no force to the largest; clamp at the joint."""
    device = joint(beam)

    def excess(angle: float) -> float:
        return _answer(evaluate(device, angle, setting)).across_force - FORCES[1]

    angle = brentq(excess, 1e-3, 0.5, xtol=1e-10)
    return _answer(evaluate(device, angle, setting)).active_length - setting


def constant_active_length() -> float:
    """Half a unit of the last digit of 0.750 m, less the largest gain of that length under a locked roller [m]."""
    return 0.0005 - max(growth_of_active_length(beam, ACTIVE_LENGTHS["l_1"]) for beam in BEAMS)


def pooled_error(*sizes: int) -> float:
    """Error over all trials [N] of groups with these sizes, in the order of Table 1, by Eq. (14)."""
    squares = sum(size * row.rms_error**2 for size, row in zip(sizes, BEAMS.values(), strict=True))
    return math.sqrt(squares / sum(sizes))


def overall_error() -> tuple[float, float]:
    """Least and largest error over all trials [N] that the four printed ones allow, one trial or more per beam."""
    rest = TRIALS - len(BEAMS) + 1
    ends = [pooled_error(*(rest if beam == most else 1 for beam in BEAMS)) for most in BEAMS]
    return min(ends), max(ends)
