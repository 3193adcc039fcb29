"""What torque, stiffness, resistance, energy and stress owe each other: how well it is met, and that a factor shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from varistiff.papers.wang_2024 import limits, work
from varistiff.papers.wang_2024.device import Answer, answer


@pytest.mark.parametrize(
    ("margin", "room"),
    [
        (work.stiffness_is_slope_of_torque, 1e-6),
        (work.energy_is_work, 1e-9),
        (work.resistance_is_slope_of_energy, 1e-6),
        (work.energy_is_returned, 1e-9),
        (limits.leaf_is_a_cantilever, 1e-9),
    ],
)
def test_rounding_and_truncation_take_a_tenth_of_the_room_at_most(margin: Callable[[], float], room: float) -> None:
    assert 0.9 * room < margin() <= room


def test_a_wrong_factor_shows(monkeypatch: pytest.MonkeyPatch) -> None:
    def doubled(*arguments: Any, **named: Any) -> Answer:
        found = answer(*arguments, **named)
        return found._replace(energy=2.0 * found.energy, stress=2.0 * found.stress, thrust=-found.thrust)

    monkeypatch.setattr(work, "answer", doubled)
    monkeypatch.setattr(limits, "answer", doubled)
    assert work.energy_is_work() == pytest.approx(-1.0)
    assert limits.leaf_is_a_cantilever() == pytest.approx(-1.0)
    assert work.resistance_is_slope_of_energy() < -1.0
    assert work.energy_is_returned() < -0.5
