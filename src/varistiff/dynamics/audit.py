"""Energy audit: whether the account of a run balances."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from varistiff.dynamics.ledger import INFLOWS, LOSSES, Stores
from varistiff.dynamics.program import Row

SMOOTH_ALLOWANCE = 1e-6
SWITCHING_ALLOWANCE = 1e-4


@dataclass(frozen=True)
class Audit:
    """The balance of a run: stores gained + losses - inflows = residual, which should be zero.

    Every term is integrated from its own law and none is computed as what is missing, so a wrong sign or a forgotten
    term in any of them shows.

    Parameters
    ----------
    terms : each term against time [J], zero at the start
    residual : what the balance leaves open, against time [J]
    turnover : energy turned over up to each time [J]: half the sum of all powers' magnitudes, integrated
    allowance : largest residual allowed, relative to the energy turned over in the whole run
    """

    terms: dict[str, np.ndarray]
    residual: np.ndarray
    turnover: np.ndarray
    allowance: float

    @property
    def relative(self) -> float:
        """Largest magnitude of the residual over the energy turned over in the whole run; 0 where nothing moves."""
        worst, whole = _largest(self.residual), float(self.turnover[-1])
        return worst / whole if whole > 0.0 else worst

    @property
    def closes(self) -> bool:
        """Whether the balance closes within its allowance; never where it is not a number."""
        return bool(self.relative <= self.allowance)

    @property
    def open_since(self) -> int:
        """Index of the first row at which the residual exceeds what is allowed of the run's turnover."""
        bound = self.allowance * float(self.turnover[-1])
        return int(np.argmax(~(np.abs(self.residual) <= bound)))


def _largest(values: np.ndarray) -> float:
    return float(np.max(np.abs(values))) if values.size else 0.0


def audit(rows: Row, *, smooth: bool) -> Audit:
    """Balance of a run's rows.

    Parameters
    ----------
    rows : of one run, arrays of shape (samples,)
    smooth : whether the equations have no switchings and no dry friction: 1e-6 is allowed, 1e-4 otherwise
    """
    stores = {name: value - value[0] for name, value in zip(Stores._fields, map(np.asarray, rows.stores), strict=True)}
    ledger = rows.state.ledger
    still = np.zeros_like(np.asarray(ledger.turnover))
    losses = {name: np.asarray(ledger.losses.get(name, still)) for name in LOSSES}
    inflows = {name: np.asarray(ledger.inflows[name]) for name in INFLOWS}
    residual = sum(stores.values()) + sum(losses.values()) - sum(inflows.values())
    return Audit(
        terms={**stores, **losses, **inflows},
        residual=np.asarray(residual),
        turnover=np.asarray(ledger.turnover),
        allowance=SMOOTH_ALLOWANCE if smooth else SWITCHING_ALLOWANCE,
    )
