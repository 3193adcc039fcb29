"""Stiffness-variation times of courses whose times are known beforehand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.dynamics.stiffness_variation import stiffness_variations, variation_metrics

TIME = np.arange(4001) * 1e-3
LAG = 0.05  # s, of a first-order answer: it stays within 2 % after LAG ln 50


def answer(time: np.ndarray, steps: list[tuple[float, float]], lag: float) -> np.ndarray:
    """First-order answer to steps (instant, height)."""
    return 100.0 + sum(h * np.where(time > t, 1.0 - np.exp(-(time - t) / lag), 0.0) for t, h in steps)


def wanted(steps: list[tuple[float, float]]) -> np.ndarray:
    return 100.0 + sum(h * (t <= TIME) for t, h in steps)


STEPS = [(0.5, 60.0), (1.5, -60.0), (2.5, 30.0)]


def test_each_change_has_its_own_time_and_load() -> None:
    load = np.where(TIME > 2.2, 5.0, 0.0)
    found = stiffness_variations(TIME, wanted(STEPS), answer(TIME, STEPS, LAG), load)
    assert [each.start for each in found] == pytest.approx([0.5, 1.5, 2.5], abs=1e-12)  # sample instants
    for each in found:
        assert each.settling == pytest.approx(LAG * math.log(50.0), abs=2e-4)  # a straight line between samples
    assert [each.loaded for each in found] == [False, False, True]
    assert found[-1].load == pytest.approx(5.0, rel=1e-12)  # constant over the window


def test_metrics_pair_the_slowest_change_without_load_with_that_under_load() -> None:
    slow = [(0.5, 60.0)]
    stiffness = answer(TIME, slow, 2.0 * LAG) + answer(TIME, STEPS[1:], LAG) - 100.0
    load = np.where(TIME > 2.2, 5.0, 0.0)
    found = variation_metrics(stiffness_variations(TIME, wanted(STEPS), stiffness, load), "N*m")
    calm, loaded = (found[f"stiffness_variation_time_{key}"] for key in ("no_load", "nominal_load"))
    assert calm.value == pytest.approx(2.0 * LAG * math.log(50.0), abs=4e-4)  # the slower of the two
    assert loaded.value == pytest.approx(LAG * math.log(50.0), abs=1e-3)  # what is left of the slow one
    assert "load 5 N*m" in loaded.note
    assert "0.5 s" in calm.note


def test_a_ramp_counts_from_its_beginning() -> None:
    ramp = np.clip((TIME - 1.0) / 0.5, 0.0, 1.0) * 80.0 + 100.0
    (found,) = stiffness_variations(TIME, ramp, ramp, np.zeros_like(TIME))
    assert found.start == pytest.approx(1.001, abs=1e-9)  # the first sample that differs
    assert found.settling == pytest.approx(0.98 * 0.5, abs=2e-3)  # a perfect follower is in the band at 98 %


def test_without_change_there_is_no_time_and_the_note_says_so() -> None:
    sine = 100.0 + 20.0 * np.sin(TIME)
    for course in (sine, np.full_like(TIME, 100.0)):
        found = variation_metrics(stiffness_variations(TIME, course, course, np.zeros_like(TIME)), "N*m")
        assert all(metric.value is None and "level" in metric.note for metric in found.values())


def test_what_is_not_reached_has_no_time() -> None:
    found = variation_metrics(
        stiffness_variations(TIME, wanted(STEPS[:1]), np.full_like(TIME, 100.0), np.zeros_like(TIME)), "N*m"
    )
    metric = found["stiffness_variation_time_no_load"]
    assert metric.value is None
    assert "not reached" in metric.note
