"""Runs against closed forms and an adaptive method, and the energy audit on every kind of joint."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import equinox as eqx
import jax
import numpy as np
import pytest

from varistiff.dynamics import program
from varistiff.dynamics.audit import audit
from varistiff.dynamics.carried_mass import Carried, CarriedMass
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.ledger import INFLOWS, LOSSES, Stores
from varistiff.dynamics.program import rows_of, run_many, run_one, start_state

from . import cases
from .reference import reference_motion

SMOOTH = {
    "two masses": cases.two_masses,
    "leaf joint": cases.leaf_joint,
    "exact leaf joint": lambda: cases.leaf_joint(exact=True),
    "knee": cases.knee,
}
DURATION = 0.5


def _rows(case, duration, substeps):
    return jax.tree.map(np.asarray, rows_of(case, run_one(case, duration=duration, substeps=substeps)))


@cache
def _smooth(name, substeps):
    return _rows(SMOOTH[name](), DURATION, substeps)


def _forget_compiled():
    program._compiled.cache_clear()
    program._observed.cache_clear()


@cache
def _hit():
    return _rows(cases.wall(), 1.0, 4)


def test_two_masses_swing_at_their_frequency():
    case = cases.two_masses(stiffness=160.0, link=0.2, drive=0.5)
    rows = _rows(case, 1.0, 2)
    pulsation = math.sqrt(160.0 * (1.0 / 0.2 + 1.0 / 0.5))
    # fourth order at 0.017 rad a step: (wh)^5/120 a step, 2000 steps, about 3e-8 of 0.1 rad
    np.testing.assert_allclose(rows.deflection, -0.1 * np.cos(pulsation * rows.time), atol=1e-8)
    centre = 0.2 * rows.state.motion.link + 0.5 * rows.state.motion.drive
    np.testing.assert_allclose(centre, 0.02, rtol=1e-13)  # momentum is linear: kept to rounding


def test_nothing_moves_from_rest_without_a_load():
    case = eqx.tree_at(lambda case: case.motion.link, cases.two_masses(), 0.0)
    rows = _rows(case, 0.1, 1)
    assert not np.any(np.stack(rows.state.motion))
    assert audit(rows, smooth=True).relative == 0.0


@pytest.mark.parametrize("name", SMOOTH)
def test_the_balance_closes_at_the_order_of_the_stepper(name):
    residuals = [audit(_smooth(name, substeps), smooth=True).relative for substeps in (2, 4, 8)]
    assert residuals[0] < 1e-6  # what the audit allows
    ratios = [a / b for a, b in pairwise(residuals)]
    floor = 2e-11  # rounding, and contact slopes that are solved to 1e-11 near first contact
    assert all(ratio > 11.0 or fine < floor for ratio, fine in zip(ratios, residuals[1:], strict=True))  # 16 or 32


def test_the_balance_closes_through_a_wall_backlash_and_stick():
    balance = audit(_hit(), smooth=False)
    assert balance.closes
    assert balance.allowance == 1e-4
    assert balance.terms["stop_loss"][-1] > 0.0
    assert balance.terms["friction_drive"][-1] > 0.0


@pytest.mark.parametrize("name", [*Stores._fields, *LOSSES, *INFLOWS])
def test_a_wrong_sign_of_any_term_breaks_the_balance(name):
    sign = -1.0 if name in INFLOWS else 1.0
    wrong = {}
    for title, rows in (("knee", _smooth("knee", 4)), ("leaf", _smooth("leaf joint", 4)), ("wall", _hit())):
        balance = audit(rows, smooth=title != "wall")
        turned = balance.residual - 2.0 * sign * balance.terms[name]
        wrong[title] = float(np.abs(turned).max() / balance.turnover[-1] / balance.allowance)
    assert max(wrong.values()) > 10.0


@pytest.mark.parametrize("wrong", ["coriolis", "friction"])
def test_a_wrong_sign_in_the_equations_breaks_the_balance(wrong, monkeypatch):
    if wrong == "coriolis":
        right = CarriedMass.at

        def at(self, motion):
            mass = right(self, motion)
            return Carried(mass.body_inertia, -mass.body_rate, mass.own_inertia, mass.own_rate)

        monkeypatch.setattr(CarriedMass, "at", at)
    else:
        monkeypatch.setattr(Friction, "force", lambda self, rate: self.viscous * -rate)
    _forget_compiled()
    balance = audit(_rows(cases.knee(), DURATION, 2), smooth=True)
    _forget_compiled()
    if wrong == "coriolis":
        assert not balance.closes
    else:  # friction that drives has a power of its own, and shows as a loss below zero
        assert balance.closes
        assert balance.terms["friction_link"].min() < 0.0


@pytest.mark.parametrize("name", SMOOTH)
def test_agreement_with_an_adaptive_method_of_order_eight(name):
    case = SMOOTH[name]()
    rows = _smooth(name, 4)
    expected = reference_motion(case, start_state(case), duration=DURATION)
    for field, real, wanted in zip(expected._fields, rows.state.motion, expected, strict=True):
        scale = max(float(np.abs(wanted).max()), 1e-3)
        np.testing.assert_allclose(real, wanted, atol=1e-6 * scale, err_msg=field)  # what the issue asks


def test_a_batch_gives_what_single_runs_give():
    batch = [cases.leaf_joint(gain=gain) for gain in (0.9, 1.0, 1.1)]
    together = jax.tree.map(np.asarray, run_many(batch, duration=0.5, substeps=1))
    for index, case in enumerate(batch):
        alone = jax.tree.map(np.asarray, run_one(case, duration=0.5, substeps=1))
        for one, all_ in zip(jax.tree.leaves(alone), jax.tree.leaves(together), strict=True):
            np.testing.assert_allclose(all_[index], one, rtol=1e-9, atol=1e-12)  # another order of rounding
