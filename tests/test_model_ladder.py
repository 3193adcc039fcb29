from __future__ import annotations

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from varistiff.characteristic.ladder import RUNGS, model_ladder

ROOT = Path(__file__).parents[1]


def test_page_states_what_is_computed():
    place = importlib.util.spec_from_file_location("model_ladder_tool", ROOT / "tools/model_ladder.py")
    tool = importlib.util.module_from_spec(place)
    place.loader.exec_module(tool)
    assert tool.table(tool.ladders()) in (ROOT / "docs/model_ladder.md").read_text("utf-8")


def test_every_rung_but_the_published_body_is_exact_at_rest():
    ladder = model_ladder(radius=0.05, length=0.025, flexural_rigidity=0.4, deflection_max=1e-3, points=4)
    for rung in ladder.rungs:
        # K_Theta/gamma of the published constants against the exact 3
        wanted = 2.67617 / 0.8517 / 3.0 - 1.0 if rung.name == "pseudo-rigid body" else 0.0
        for quantity in ("torque", "stiffness"):
            assert ladder.error(rung, quantity)[0] == pytest.approx(wanted, abs=3e-6)  # phi^2 at 2.5e-4 rad


def test_linear_torque_of_a_known_leaf():
    ladder = model_ladder(radius=0.05, length=0.025, flexural_rigidity=0.4, deflection_max=0.02, points=2)
    linear = ladder.rungs[list(RUNGS).index("linear")]
    assert linear.stiffness == pytest.approx(3 * 0.4 * 0.05**2 / 0.025**3)
    assert linear.torque[-1] == pytest.approx(0.02 * linear.stiffness[-1])


def test_good_to_stops_at_the_first_excess():
    ladder = model_ladder(radius=0.4, length=0.4, flexural_rigidity=1.0, deflection_max=math.radians(40), points=400)
    for rung in ladder.rungs[:-1]:
        for quantity in ("torque", "stiffness"):
            reached = ladder.good_to(rung, quantity)
            inside = np.abs(ladder.error(rung, quantity))[ladder.deflection <= reached]
            assert (inside <= 0.01).all()
            after = ladder.deflection > reached
            assert not after.any() or abs(ladder.error(rung, quantity)[after][0]) > 0.01
    assert ladder.good_to(ladder.exact, "torque") == ladder.deflection[-1]


def test_nothing_is_good_beyond_the_fold():
    ladder = model_ladder(radius=0.4, length=0.4, flexural_rigidity=1.0, deflection_max=math.radians(120), points=120)
    # with its clamp at the joint the slider's polar angle is the deflection: the fold lies at 99.57 degrees
    for rung in ladder.rungs:
        assert math.degrees(ladder.good_to(rung, "torque", math.inf)) == pytest.approx(99.0)
