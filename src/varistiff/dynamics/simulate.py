"""Run a case, judge it, and say what happened when."""

from __future__ import annotations

import math
from dataclasses import dataclass

import jax
import numpy as np

from varistiff.core.errors import InputError
from varistiff.dynamics.audit import Audit, audit
from varistiff.dynamics.events import events_of
from varistiff.dynamics.judge import judge
from varistiff.dynamics.linear.fastest_rate import fastest_rate
from varistiff.dynamics.outcome import Event, Outcome
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.program import Case, Row, rows_of, run_one
from varistiff.dynamics.switching import switch_names

_RESOLVED = 0.2  # of the fastest rate times the step: fourth order then errs by about 1e-6 a radian
_STABLE = 2.0  # of the same product, with every stop in contact; the method is stable up to 2.6
_MOST_SUBSTEPS = 256
_LONGEST = 2_000_000  # samples; about a gigabyte of rows


@dataclass(frozen=True)
class Run:
    """A case and what came of it.

    Parameters
    ----------
    case : what was run
    rows : numbers at each sample, arrays of shape (samples,); cut where the state stops being finite
    audit : the energy balance
    outcome : whether it is a result
    failed_at : when it went wrong [s]; None for a result
    events : what happened on the way, in order
    step : of the integration [s]
    """

    case: Case
    rows: Row
    audit: Audit
    outcome: Outcome
    failed_at: float | None
    events: tuple[Event, ...]
    step: float

    @property
    def time(self) -> np.ndarray:
        """Instants of the rows [s]."""
        return np.asarray(self.rows.time)


def is_smooth(plant: Plant, names: tuple[str, ...]) -> bool:
    """Whether the equations have neither switchings nor dry friction."""
    dry = any(member.friction.dry is not None for member in (plant.link, plant.drive, plant.setting))
    return not names and not dry


def simulate(case: Case, *, duration: float, step: float | None = None) -> Run:
    """Integrate a case from 0 to ``duration``.

    Parameters
    ----------
    duration : [s], a whole number of ``case.period``
    step : of the integration [s], the period divided by a whole number; None for one that resolves the plant's fastest
        motion, halved until the energy balance closes

    Raises
    ------
    InputError : a duration or step that the period does not fit, or more samples than memory should hold
    """
    _check(case, duration)
    names = switch_names(case.plant, case.inputs, duration)
    smooth = is_smooth(case.plant, names)
    chosen = step is None
    fastest = fastest_rate(case, duration=duration)
    moving = fastest_rate(case, duration=duration, stops=False)
    # a stop must not make the method unstable; whether its contact is resolved the audit tells
    parts = case.period * max(moving / _RESOLVED, fastest / _STABLE)
    substeps = _given(case.period, step) if step is not None else max(1, math.ceil(parts))
    if chosen and substeps > _MOST_SUBSTEPS:
        substeps = _MOST_SUBSTEPS
    while True:
        rows = jax.tree.map(np.asarray, rows_of(case, run_one(case, duration=duration, substeps=substeps)))
        kept = _finite_rows(rows)
        balance = audit(_cut(rows, kept), smooth=smooth)
        if not chosen or (kept == len(rows.time) and balance.closes) or substeps >= _MOST_SUBSTEPS:
            break
        substeps *= 2
    outcome, failed_at = judge(case, rows, kept, balance, step=case.period / substeps, fastest=fastest)
    rows = _cut(rows, kept)
    return Run(case, rows, balance, outcome, failed_at, events_of(case, rows), case.period / substeps)


def _check(case: Case, duration: float) -> None:
    samples = duration / case.period
    if not (math.isfinite(samples) and samples >= 1.0) or abs(samples - round(samples)) > 1e-6 * samples:
        raise InputError(
            f"is {duration!r} s; allowed is a whole number of periods of {case.period!r} s", field="duration"
        )
    if samples > _LONGEST:
        raise InputError(f"has {round(samples)} samples; allowed are at most {_LONGEST}", field="duration")


def _given(period: float, step: float) -> int:
    parts = period / step if step > 0.0 else math.nan
    if not math.isfinite(parts) or parts < 0.5 or abs(parts - round(parts)) > 1e-6 * parts:
        raise InputError(
            f"is {step!r} s; allowed is the period of {period!r} s divided by a whole number", field="step"
        )
    return round(parts)


def _finite_rows(rows: Row) -> int:
    """Number of rows before the first that is not finite."""
    leaves = [*rows.state.motion, rows.state.charge, rows.state.ledger.turnover, *rows.stores, rows.flows.response.load]
    bad = ~np.isfinite(np.stack(leaves)).all(axis=0)
    return int(np.argmax(bad)) if bad.any() else bad.size


def _cut(rows: Row, kept: int) -> Row:
    cut: Row = jax.tree.map(lambda values: values[:kept], rows)
    return cut
