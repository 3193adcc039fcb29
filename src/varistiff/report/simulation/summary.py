"""A run as plain data, for programs: outcome, energy, events, metrics."""

from __future__ import annotations

import math
from typing import Any

from varistiff.report.simulation.balance import Balance
from varistiff.report.simulation.run import Run

KEPT = ("kind", "versions", "varistiff_version", "design_hash", "scenario_hash", "created")


def as_dict(run: Run) -> dict[str, Any]:
    """The run without its samples; SI units, and null for what is not known."""
    simulation, balance = run.simulation, Balance.of(run)
    attrs = simulation.data.attrs
    return {
        "name": simulation.name,
        "design": simulation.design.name,
        "outcome": simulation.outcome.value,
        "is_result": run.done,
        "failed_at": simulation.failed_at,
        "meaning": simulation.outcome.meaning,
        "energy": {
            "closes": balance.closes,
            "residual": _plain(balance.largest),
            "allowance": _plain(balance.allowance),
            "turnover": _plain(balance.turnover),
            **{
                group: {term.name: _plain(float(term.values[-1])) for term in terms}
                for group, terms in (("entered", balance.inflows), ("stored", balance.stores), ("lost", balance.losses))
            },
        },
        "metrics": {
            name: {
                "value": _plain(metric.value),
                "unit": metric.unit,
                "long_name": metric.long_name,
                "note": metric.note,
            }
            for name, metric in simulation.metrics.items()
        },
        "events": [{"time": event.time, "name": event.name, "text": event.text} for event in run.events],
        "about": {key: str(attrs[key]) for key in KEPT if key in attrs},
    }


def _plain(value: float | None) -> float | None:
    return None if value is None or not math.isfinite(value) else float(value)
