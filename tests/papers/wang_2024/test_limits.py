"""Deflection, rotation, torque and stress of Wang et al. (2024) by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.papers.wang_2024 import limits
from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import answer, effective_lengths, joint


def deflection_by_hand(rotation: float, length: float) -> float:
    """Eqs. (1) and (2): theta = 3 l_2 tan(phi)/(2 l_1)."""
    return math.atan(2.0 * length * rotation / (3.0 * (0.025 + length)))


@pytest.mark.parametrize("length", [0.006, 0.013, 0.025])
def test_deflection_at_a_rotation_by_hand(length: float) -> None:
    found = limits.deflection_at_rotation(math.radians(9.0), length=length)
    assert found == pytest.approx(deflection_by_hand(math.radians(9.0), length), rel=1e-9)  # bracketing


def test_nine_degrees_make_three_at_the_long_end() -> None:
    low, high = limits.deflection_range()
    assert math.degrees(deflection_by_hand(math.radians(9.0), 0.025)) == pytest.approx(3.00, abs=0.005)
    assert low < math.radians(3.03) < high
    assert math.degrees(deflection_by_hand(math.radians(9.1), 0.025)) == pytest.approx(3.03, abs=0.005)


def test_one_stop_cannot_limit_the_rotation_at_all_lengths() -> None:
    lengths = effective_lengths()
    rotation = np.degrees(answer(joint(), deflection=math.radians(3.03), length=lengths).rotation)
    by_hand = np.degrees(1.5 * (0.025 + lengths) * math.tan(math.radians(3.03)) / lengths)
    assert rotation == pytest.approx(by_hand, rel=1e-12)  # rounding
    assert (np.diff(rotation) < 0.0).all()
    assert rotation[0] > 2.0 * 10.0
    assert np.degrees(limits.largest_rotation()) == pytest.approx([by_hand[-1], by_hand[0]], rel=1e-12)
    # a stop that follows the length keeps the rotation of the long end
    assert by_hand[-1] < 10.0
    # the exact leaf does no better
    exact = answer(joint(exact=True), deflection=math.radians(3.03), length=0.006)
    assert math.degrees(float(exact.rotation)) > 2.0 * 10.0


def test_largest_torque_by_hand() -> None:
    stiffness = 206e9 * 0.025 * 0.001**3 * 0.031**2 / (4.0 * 0.006**3)
    low, high = limits.largest_torque()
    assert high == pytest.approx(stiffness * math.sin(math.radians(3.03)), rel=1e-12)  # rounding
    assert low == pytest.approx(stiffness * math.sin(deflection_by_hand(math.radians(9.0), 0.006)), rel=1e-9)
    assert low > 7.0 * 14.6
    # by the printed deflection limit alone, 14.6 N m is neither the largest nor the smallest torque
    smallest = 206.0 * math.sin(math.radians(3.03))
    assert smallest < 14.6 < high


def test_deflection_limit_breaks_the_leaf_at_the_short_end() -> None:
    # E h/2 times the root curvature 3 w/l_1^2 = 2 theta/l_1
    for length, printed in ((0.025, 1.3e9), (0.006, 5.4e9)):
        by_hand = 206e9 * 0.001 / 2.0 * 2.0 * math.radians(9.0) / length
        assert limits.root_stress(length=length) == pytest.approx(by_hand, rel=1e-9)  # bracketing
        assert by_hand == pytest.approx(printed, rel=0.01)  # two digits


def test_small_deflection_errs_upward_and_more_when_short() -> None:
    lengths, allowed = limits.limited_deflections(paper.ROTATION_DESIGN)
    published = answer(joint(), deflection=allowed, length=lengths).torque
    exact = answer(joint(exact=True), deflection=allowed, length=lengths).torque
    error = published / exact - 1.0
    assert (error > 0.01).all()
    assert error[0] > error[-1]
    stiffness, torque = limits.assumption_holds(largest=0.0)
    assert stiffness < torque < -error.max()  # 10 degrees err more than 9, and the slope more than the torque


def test_stress_at_one_deflection_grows_as_the_leaf_is_shortened() -> None:
    # E h/2 times 3 l_2 tan(phi)/l_1^2
    by_hand = (0.031 / 0.006**2) / (0.050 / 0.025**2)
    assert limits.stress_when_short() == pytest.approx(by_hand - 1.0, rel=1e-9)  # rounding
