"""Whether a run is a result, and if not, since when and why."""

from __future__ import annotations

import numpy as np

from varistiff.characteristic.evaluate import evaluate
from varistiff.core.status import Status
from varistiff.dynamics.audit import Audit
from varistiff.dynamics.linear.closed_loop import closed_loop
from varistiff.dynamics.outcome import Outcome
from varistiff.dynamics.program import Case, Row

_STABLE = 2.6  # Runge-Kutta of fourth order is unstable beyond 2.79 on the real axis, 2.83 on the imaginary one
_AHEAD = 8  # steps that the last finite state is followed to find where it was going


def judge(
    case: Case, rows: Row, kept: int, balance: Audit, *, step: float, fastest: float
) -> tuple[Outcome, float | None]:
    """Outcome and the instant at which it went wrong, None for a result.

    Parameters
    ----------
    rows : of the whole run; ``kept`` of them are finite
    balance : energy account of those
    step, fastest : of the integration [s], and the plant's fastest rate [1/s]
    """
    ended = kept < len(rows.time)
    last = float(rows.time[max(kept - 1, 0)])
    if ended and step * fastest > _STABLE:
        return Outcome.STEP_TOO_LARGE, last
    if ended and (kept == 0 or _leaves_map(case, rows, kept)):
        return Outcome.LEFT_MAP, last
    runaway = _runs_away(case, rows, kept)
    if runaway is not None:
        return Outcome.UNSTABLE, runaway
    if ended:
        return Outcome.UNSTABLE, last
    short = np.flatnonzero(np.asarray(rows.flows.storage.shortfall)[:kept])
    if not balance.closes and short.size:
        return Outcome.STORAGE_OVERDRAWN, float(rows.time[short[0]])
    if not balance.closes:
        since = float(rows.time[balance.open_since])
        return (Outcome.STEP_TOO_LARGE if step * fastest > _STABLE else Outcome.AUDIT_OPEN), since
    return Outcome.DONE, None


def _leaves_map(case: Case, rows: Row, kept: int) -> bool:
    """Whether the last finite motion, followed in a straight line, comes to where the actuator has no solution."""
    motion, plant = rows.state.motion, case.plant
    last = type(motion)(*(np.asarray(values)[kept - 1] for values in motion))
    ahead = np.linspace(0.0, _AHEAD * case.period, 65)
    moved = last._replace(
        link=last.link + last.link_rate * ahead,
        drive=last.drive + last.drive_rate * ahead,
        motion=last.motion + last.motion_rate * ahead,
    )
    setting = np.asarray(plant.setting_path.at(moved.motion).value)
    points = evaluate(plant.actuator, np.asarray(plant.stretch(moved)), setting)
    return bool(np.isin(points.status, (Status.NO_SOLUTION, Status.ELEMENT_TOO_SHORT)).any() or points.status.size == 0)


def _runs_away(case: Case, rows: Row, kept: int) -> float | None:
    """Instant from which an unstable loop swings faster than it did before; None for a loop that does not.

    The instant is where a rate first exceeds twice its largest value in the first tenth of the run; that alone would
    be any late motion, so the loop must also have a pole outside the unit circle.
    """
    if case.loop.drive is None and case.loop.setting is None:
        return None
    motion = rows.state.motion
    swing = np.abs(np.stack([motion.link_rate, motion.drive_rate, motion.motion_rate])[:, :kept])
    early = swing[:, : max(kept // 10, 2)].max(axis=1, keepdims=True)
    grown = (swing > 2.0 * early).any(axis=0)
    if not grown.any() or not closed_loop(case).unstable:
        return None
    return float(rows.time[int(np.argmax(grown))])
