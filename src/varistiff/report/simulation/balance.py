"""The energy balance of a run as the report shows it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from varistiff.dynamics.ledger import INFLOWS, LONG_NAMES, LOSSES, Stores
from varistiff.report.simulation.run import Run, compact
from varistiff.report.view import Array


@dataclass(frozen=True)
class Term:
    """One term of the balance that is not zero throughout [J]."""

    name: str
    values: Array

    @property
    def label(self) -> str:
        """Short name for a key."""
        return self.name.replace("_", " ")

    @property
    def long_name(self) -> str:
        """What it is."""
        return LONG_NAMES.get(self.name, self.label)


@dataclass(frozen=True)
class Balance:
    """Inflows = what the stores gain + losses - residual [J], each from zero at the start.

    ``turnover`` is the energy turned over in the whole run [J], ``tolerance`` the residual that is allowed of it.
    """

    stores: tuple[Term, ...]
    losses: tuple[Term, ...]
    inflows: tuple[Term, ...]
    residual: Array
    turnover: float
    tolerance: float
    closes: bool

    @staticmethod
    def of(run: Run) -> Balance:
        """Read it from the audit of a run."""
        audit = run.simulation.audit
        turnover = float(audit.turnover[-1]) if audit.turnover.size else 0.0

        def terms(names: tuple[str, ...]) -> tuple[Term, ...]:
            found = (Term(name, np.asarray(audit.terms[name], float)) for name in names if name in audit.terms)
            return tuple(term for term in found if (np.nan_to_num(term.values) != 0.0).any())

        return Balance(
            stores=terms(Stores._fields),
            losses=terms(LOSSES),
            inflows=terms(INFLOWS),
            residual=np.asarray(audit.residual, float),
            turnover=turnover,
            tolerance=audit.allowance,
            closes=audit.closes,
        )

    @property
    def allowance(self) -> float:
        """Largest residual that is allowed [J]."""
        return self.tolerance * self.turnover

    @property
    def largest(self) -> float:
        """Largest magnitude of the residual [J]; NaN where it is not a number somewhere."""
        return float(np.max(np.abs(self.residual))) if self.residual.size else math.nan

    @property
    def sentence(self) -> str:
        """The residual in words, for the head of the report."""
        verdict = "closes" if self.closes else "does NOT close"
        share = self.largest / self.turnover if self.turnover > 0.0 else 0.0
        return (
            f"The energy balance {verdict}: its residual reaches {compact(self.largest)} J, {compact(share)} of the"
            f" {compact(self.turnover)} J turned over; allowed is {compact(self.tolerance)}."
        )
