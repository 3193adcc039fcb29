"""The search for the unpublished numbers, on functions whose answer is known, and the file that it writes."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
import yaml

from varistiff.papers.wang_2024 import section_4_search as search
from varistiff.papers.wang_2024.section_4 import POSITION_SETS, position_set, setting_set
from varistiff.papers.wang_2024.section_4_runs import PositionFacts
from varistiff.papers.wang_2024.section_4_table import FACTS

SCENARIOS = Path(__file__).parents[3] / "examples" / "scenarios"
SHOWN = {"wang_figure_16": "steps", "wang_figure_16_no_load": "steps", "wang_figure_17": "steps"}


def test_search_finds_a_known_minimum_twice():
    bounds = np.log([(0.1, 10.0), (1.0, 100.0)])
    wanted = np.log([0.7, 33.0])

    def costs(places: np.ndarray) -> np.ndarray:
        return np.square(places - wanted).sum(axis=1)

    place, cost, evaluations = search._search(costs, bounds, coarse=64, generations=20, best=16)
    assert place == pytest.approx(wanted, abs=1e-3)
    assert cost < 1e-6
    assert evaluations <= 64 + 16 * 21 + search.POLISH + 10
    again = search._search(costs, bounds, coarse=64, generations=20, best=16)
    assert again[0].tolist() == place.tolist()


def test_cost_counts_steps_from_what_is_printed():
    blank = PositionFacts(*[0.0] * len(PositionFacts._fields))
    met = blank._replace(**{aim.fact: aim.printed for aim in search.SINE})
    assert search.cost_of(met, search.SINE, search.CEILINGS) == 0.0
    off = met._replace(first_error=met.first_error + math.radians(1.0), large_overshoot=0.41)
    assert search.cost_of(off, search.SINE, search.CEILINGS) == pytest.approx(2.0**2 + 2.0**2)
    lost = met._replace(later_error=math.nan)
    assert search.cost_of(lost, search.SINE, ()) == search.WORST


def test_aims_are_the_printed_digits():
    """Of each fact of the table there is an aim with the same value: one number, written twice."""
    aims = {aim.fact: aim.printed for aim in (*search.BY_LOAD, *search.SINE, *search.SETTING)}
    for fact in FACTS:
        assert aims[fact.field] == pytest.approx(float(fact.printed) * fact.factor), fact.words


def test_file_is_what_the_search_writes():
    text = search.FILE.read_text(encoding="utf-8")
    assert search.text_of(yaml.safe_load(text)) == text


@pytest.mark.parametrize("name", POSITION_SETS)
def test_sets_lie_in_the_searched_ranges(name):
    own = position_set(name)._asdict()
    for field, (low, high) in search._BOUNDS.items():
        assert low * 0.995 <= own[field] <= high * 1.005, field  # stored with three digits


@pytest.mark.parametrize("name", sorted([*SHOWN, "wang_figure_18"]))
def test_scenarios_hold_the_numbers_of_the_sets(name):
    """The examples are text; their gains and inertias are those of the sets that their first lines name."""
    text = (SCENARIOS / f"{name}.yaml").read_text(encoding="utf-8")
    loop = position_set(SHOWN.get(name, "steps"))
    setting = setting_set()
    wanted = [loop.proportional, loop.integral, loop.derivative, loop.limit, loop.drive_inertia, loop.drive_friction]
    if "chain: wang_line" in text:
        wanted += [setting.proportional, setting.integral, setting.derivative, setting.load_torque]
    numbers = {float(number) for number in re.findall(r": ([0-9.e+-]+) (?:N|kg)", text)}
    assert {float(f"{value:.3g}") for value in wanted} <= numbers
