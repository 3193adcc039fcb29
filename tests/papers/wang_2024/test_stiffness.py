"""Stiffness claims of Wang et al. (2024) by hand and by limits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024 import stiffness
from varistiff.papers.wang_2024.device import answer, joint


def by_hand(length: float) -> float:
    """Eq. (9) at rest, from the printed digits."""
    return 206e9 * 0.025 * 0.001**3 * (0.025 + length) ** 2 / (4.0 * length**3)


def test_printed_leaf_cannot_be_as_soft_as_printed() -> None:
    assert by_hand(0.025) == pytest.approx(206.0, rel=1e-12)  # rounding
    assert stiffness.softest()[1] == pytest.approx(by_hand(0.025), rel=1e-12)  # rounding
    # even where the groove ends, 29 mm, and at the deflection limit, the stiffness is 17 times the printed 9
    assert stiffness.softest()[0] == pytest.approx(by_hand(0.029) * math.cos(paper.DEFLECTION_LIMIT), rel=1e-12)
    # Eq. (9) falls with l_1 without end: 9 needs a length that does not fit into half the diameter
    assert by_hand(0.070 - 0.025) > 5.0 * 9.0


def test_the_short_end_by_hand() -> None:
    assert stiffness.stiffest() == pytest.approx(by_hand(0.006), rel=1e-12)  # rounding


def test_an_infinite_leaf_is_soft() -> None:
    values = stiffness.rest_stiffness(np.array([1.0, 10.0, 100.0, 1000.0]))
    assert (np.diff(values) < 0.0).all()
    assert values[-1] == pytest.approx(206e9 * 0.025 * 1e-9 / 4.0 / 1000.0, rel=1e-4)  # r_2 << l_1


def test_a_vanishing_leaf_is_rigid() -> None:
    assert stiffness.growth_towards_zero() == pytest.approx(1.0, abs=1e-3)  # l_1^-3, up to l_1/r_2


def test_the_leaf_softens_where_the_formula_is_flat() -> None:
    # the torque that bends the exact leaf, differentiated here, not its closed-form stiffness
    for length, phi in ((0.006, 0.0200), (0.025, 0.0500)):
        step = 1e-4
        ends = np.array([phi - step, phi + step])
        published, exact = joint(), joint(exact=True)
        assert math.degrees(float(answer(published, deflection=phi, length=length).rotation)) < 10.0
        torque = answer(exact, deflection=ends, length=length).torque
        tangent = float(np.diff(torque)[0]) / (2.0 * step)
        assert tangent < 0.97 * by_hand(length)  # three percent at least
        assert float(answer(published, deflection=phi, length=length).stiffness) > 0.998 * by_hand(length)


def test_200_lies_where_the_printed_25_millimetres_end() -> None:
    # at 24.5 mm the leaf is stiffer, at 25.5 mm, which rounds to 25 or 26, softer
    assert by_hand(0.0255) < 200.0 < by_hand(0.025) < by_hand(0.0245)
    low, high = stiffness.level_in_effective_range()
    assert low < 0.0 < high
    for margin, longest in ((low, 0.0245), (high, 0.0255)):
        assert by_hand(longest - margin) == pytest.approx(200.0, rel=1e-9)  # Cardano against Eq. (9)


@pytest.mark.parametrize("largest", [0.01, 0.02])
def test_margin_of_hardly_changes_moves_with_its_threshold(largest: float) -> None:
    change = 1.0 - math.cos(paper.DEFLECTION_LIMIT)
    assert stiffness.hardly_changes(exact=False, largest=largest) == pytest.approx(largest - change, abs=1e-12)


def test_more_leaves_are_stiffer_in_proportion() -> None:
    one, three = (float(stiffness.rest_stiffness(0.011, count=count)) for count in (1, 3))
    assert three == pytest.approx(3.0 * one, rel=1e-12)  # rounding
