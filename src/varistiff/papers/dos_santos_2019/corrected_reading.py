"""The reading of the paper with which its numbers are consistent, found by search; ``corrected_reading.yaml`` is it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

from scipy.optimize import brentq

from varistiff.characteristic.evaluate import evaluate
from varistiff.papers.claim import Claim
from varistiff.papers.claims import load_claims
from varistiff.papers.dos_santos_2019.beams import PAPER, beam_length, leaf, material, ratio
from varistiff.papers.dos_santos_2019.elastica import defined_load, load_limit
from varistiff.papers.dos_santos_2019.experiment import contact, pooled_error
from varistiff.papers.dos_santos_2019.mechanism import joint
from varistiff.papers.dos_santos_2019.paper_values import (
    ACTIVE_LENGTHS,
    BEAMS,
    FORCES,
    MILLIMETRE,
    RMS_ERROR,
    TRIALS,
)
from varistiff.papers.printed import half_digit

Interval = tuple[float, float]
UNITS = {"kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "TPa": 1e12}
HALF_DIGIT = 0.005 * MILLIMETRE  # of the printed sides
HALF_DIGIT_MASS = 5e-5  # [kg]
ORDERS = ("thickness x width", "width x thickness")


@dataclass(frozen=True)
class OrderReading:
    """One order of the sides of Table 1: how many cells of Table 2 it gives, and its largest miss in half digits."""

    order: str
    cells: int
    agree: int
    worst: float


@dataclass(frozen=True)
class ModulusReading:
    """One unit of E: beams that can be in equilibrium over all printed forces, largest factor to the handbook's E."""

    unit: str
    beams_in_equilibrium: int
    largest_factor: float


@dataclass(frozen=True)
class BeamReading:
    """One beam as it is read; intervals are what Table 2 alone, or the printed digits, leave open [m]."""

    beam: str
    thickness: float
    width: float
    thickness_by_table_2: Interval
    width_by_table_2: Interval
    youngs_modulus: float
    length: float
    length_interval: Interval


@dataclass(frozen=True)
class Evidence:
    """What the search went through and what it found."""

    orders: tuple[OrderReading, ...]
    moduli: tuple[ModulusReading, ...]
    beams: tuple[BeamReading, ...]
    splits: int  # of the trials into four groups, in all
    fitting_splits: tuple[tuple[int, ...], ...]  # that give the printed error over all trials
    paired_splits: tuple[tuple[int, ...], ...]  # of these, even and equal for beams of one family
    equal_error: float  # over all trials with four equal groups [N]
    joint_angle: float  # at which the softest beam carries the largest printed force at l_1 [rad]
    stress_max: float  # of any beam over the printed forces, as a share of its yield strength


def search() -> Evidence:
    """Search orders of the sides, units of the modulus, lengths, group sizes and the range of the experiment."""
    fitting = fitting_splits()
    return Evidence(
        orders=tuple(order_reading(order) for order in ORDERS),
        moduli=tuple(modulus_reading(unit) for unit in UNITS),
        beams=tuple(beam_reading(beam) for beam in BEAMS),
        splits=math.comb(TRIALS - 1, len(BEAMS) - 1),
        fitting_splits=fitting,
        paired_splits=tuple(split for split in fitting if _paired(split)),
        equal_error=pooled_error(*(1 for _ in BEAMS)),
        joint_angle=joint_angle("spring_steel", setting=ACTIVE_LENGTHS["l_1"]),
        stress_max=_largest_stress_share(),
    )


def order_reading(order: str) -> OrderReading:
    """Hold an order of the printed sides against every cell of Table 2."""
    swapped = {"width": "thickness", "thickness": "width"}
    misses = []
    for claim in _cells():
        over = claim.arguments["over"] if order == ORDERS[0] else swapped[claim.arguments["over"]]
        misses.append(abs(ratio(**{**claim.arguments, "over": over}) - claim.numbers[0]) / claim.allowance)
    return OrderReading(order, len(misses), sum(miss <= 1.0 for miss in misses), max(misses))


def modulus_reading(unit: str) -> ModulusReading:
    """Hold a unit of E against the load that a beam can bear at all, and against the handbook."""
    possible, factors = 0, []
    for beam, row in BEAMS.items():
        rigidity = leaf(beam, modulus_unit=UNITS[unit]).flexural_rigidity
        most = defined_load(FORCES[1], active_length=max(ACTIVE_LENGTHS.values()), flexural_rigidity=rigidity)
        possible += most < load_limit()[0]
        handbook = material(beam).youngs_modulus
        assert handbook is not None  # every metal of the table has it
        factors.append(math.exp(abs(math.log(row.modulus * UNITS[unit] / handbook.value))))
    return ModulusReading(unit, possible, max(factors))


def beam_reading(beam: str) -> BeamReading:
    """Read a beam, and what Table 2 and the rounding leave open."""
    element, row = leaf(beam), BEAMS[beam]
    sides = {
        (over, end): bound(
            ACTIVE_LENGTHS[claim.arguments["active_length"]] / (claim.numbers[0] - sign * claim.allowance)
            for claim in _cells()
            if claim.arguments["beam"] == beam and claim.arguments["over"] == over
        )
        for over in ("thickness", "width")
        for end, sign, bound in (("low", -1.0, max), ("high", 1.0, min))
    }
    length = beam_length(beam=beam)
    error = HALF_DIGIT_MASS / row.mass + HALF_DIGIT / row.first_side + HALF_DIGIT / row.second_side
    return BeamReading(
        beam=beam,
        thickness=element.thickness,
        width=element.width,
        thickness_by_table_2=(sides["thickness", "low"], sides["thickness", "high"]),
        width_by_table_2=(sides["width", "low"], sides["width", "high"]),
        youngs_modulus=element.youngs_modulus,
        length=length,
        length_interval=(length * (1.0 - error), length * (1.0 + error)),
    )


def fitting_splits() -> tuple[tuple[int, ...], ...]:
    """Every split of the trials among the four beams whose error over all trials rounds to the printed one."""
    largest = TRIALS - len(BEAMS) + 2
    found = []
    for first in product(range(1, largest), repeat=len(BEAMS) - 1):
        last = TRIALS - sum(first)
        if last >= 1 and abs(pooled_error(*first, last) - RMS_ERROR) <= half_digit(str(RMS_ERROR)):
            found.append((*first, last))
    return tuple(found)


def joint_angle(beam: str, *, setting: float) -> float:
    """Joint angle [rad] at which a beam with its clamp at the joint presses with the largest printed force P."""

    def excess(angle: float) -> float:
        details = evaluate(joint(beam), angle, setting).details
        return float(details["contact_force"]) * math.cos(float(details["contact_slope"])) - FORCES[1]

    return float(brentq(excess, 1e-3, 0.6, xtol=1e-10))


def _cells() -> list[Claim]:
    return [claim for claim in load_claims(PAPER) if claim.computation == "beams.ratio"]


def _paired(split: tuple[int, ...]) -> bool:
    wide, narrow, spring, carbon = split
    return wide == narrow and spring == carbon and all(size % 2 == 0 for size in split)


def _largest_stress_share() -> float:
    shares = []
    for beam in BEAMS:
        strength = material(beam).yield_strength
        assert strength is not None  # every metal of the table has one
        shares += [contact(beam, length, FORCES[1]).stress / strength.value for length in ACTIVE_LENGTHS.values()]
    return max(shares)
