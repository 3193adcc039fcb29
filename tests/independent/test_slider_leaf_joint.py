"""Exact slider leaf joint against the boundary-value rod, and the small-deflection theory against both."""

from __future__ import annotations

import itertools
import math

import pytest

from varistiff.actuators import LargeDeflection, SliderLeafJoint, SmallDeflection
from varistiff.characteristic.evaluate import evaluate
from varistiff.elastic.leaf import Leaf

from .references.discrete_rod import extrapolated, obstacle
from .references.rod_bvp import roller_contact

LEAF = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001)
RADIUS, COUNT = 0.025, 3
EXACT = SliderLeafJoint(leaf=LEAF, count=COUNT, clamp_radius=RADIUS, theory=LargeDeflection())
SMALL = SliderLeafJoint(leaf=LEAF, count=COUNT, clamp_radius=RADIUS, theory=SmallDeflection())
EI = LEAF.flexural_rigidity


@pytest.mark.parametrize("length", [0.006, 0.0153, 0.025])
@pytest.mark.parametrize("degrees", [0.5, -3.0, 14.0, -35.0])
def test_exact_joint_is_the_rod(degrees: float, length: float) -> None:
    """The slider is a point on the input disc; its push on the leaf, times its arm, is the torque."""
    angle, out = math.radians(abs(degrees)), RADIUS + length
    x, y = out * math.cos(angle) - RADIUS, out * math.sin(angle)
    if math.degrees(math.atan2(y, x)) > 99:
        here = evaluate(EXACT, [math.radians(degrees)], [length])
        assert here.status[0] == 1
        return
    rod = roller_contact((x, y), radius=0.0, flexural_rigidity=EI)
    here = evaluate(EXACT, [math.radians(degrees)], [length])
    sign = math.copysign(1.0, degrees)
    assert here.energy[0] == pytest.approx(COUNT * rod.energy, rel=1e-8)
    torque = (x + RADIUS) * rod.force_y - y * rod.force_x
    assert here.load[0] == pytest.approx(sign * COUNT * torque, rel=1e-8, abs=1e-8 * rod.force * out)
    push = math.cos(angle) * rod.force_x + math.sin(angle) * rod.force_y
    assert here.adjusting_load[0] == pytest.approx(COUNT * push, rel=1e-8, abs=1e-8 * rod.force)
    assert here.details["leaf_rotation"][0] == pytest.approx(sign * rod.end_slope, rel=1e-8)
    assert here.details["contact_force"][0] == pytest.approx(rod.force, rel=1e-8)
    assert here.details["active_arc_length"][0] == pytest.approx(rod.length, rel=1e-8)
    outer = LEAF.youngs_modulus * LEAF.thickness / 2 * rod.moment_max / EI
    assert here.stress[0] == pytest.approx(outer, rel=1e-6)


@pytest.mark.parametrize("degrees", [2.0, 12.0])
def test_exact_joint_has_the_least_energy(degrees: float) -> None:
    angle, length = math.radians(degrees), 0.02
    centre = ((RADIUS + length) * math.cos(angle) - RADIUS, (RADIUS + length) * math.sin(angle))
    found = [obstacle(centre, radius=0.0, flexural_rigidity=EI, length=0.05, elements=n) for n in (40, 80)]
    here = evaluate(EXACT, [angle], [length])
    least = COUNT * extrapolated(found[0].energy, found[1].energy)
    assert here.energy[0] == pytest.approx(least, rel=1e-4)  # ten times the difference seen


def test_small_theory_is_the_limit_of_the_exact_one() -> None:
    """Torque and stiffness differ by a share of phi^2: 1-3 % and 4-10 % at 3 degrees and 25 mm, less below."""
    gaps = []
    for degrees in (3.0, 1.5, 0.75):
        exact, small = (evaluate(device, [math.radians(degrees)], [0.025]) for device in (EXACT, SMALL))
        gaps.append((small.load[0] / exact.load[0] - 1, small.stiffness[0] / exact.stiffness[0] - 1))
    assert 0.01 < abs(gaps[0][0]) < 0.03
    assert 0.03 < abs(gaps[0][1]) < 0.10
    for (torque, stiffness), (torque_half, stiffness_half) in itertools.pairwise(gaps):
        assert torque / torque_half == pytest.approx(4.0, rel=0.05)
        assert stiffness / stiffness_half == pytest.approx(4.0, rel=0.05)
