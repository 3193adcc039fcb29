"""One HTML file with everything about a run; its only script is the player's, allowed by its hash."""

from __future__ import annotations

import base64
import hashlib
import math
from collections.abc import Mapping, Sequence
from importlib.resources import files
from typing import Any

from markupsafe import Markup

from varistiff.core.citations import citation
from varistiff.core.errors import InputError
from varistiff.dynamics.outcome import Metric
from varistiff.report.display import MISSING, Display, display
from varistiff.report.html import KIND_NAMES, Picture, embedded, filled
from varistiff.report.simulation.balance import Balance, Term
from varistiff.report.simulation.run import Run, compact

MOST_EVENTS = 200  # in the table
KEY_METRICS = (
    "position_settling_time",
    "position_overshoot",
    "position_rise_time",
    "position_bandwidth",
    "position_error_max",
    "position_error_late",
    "stiffness_variation_time_no_load",
    "stiffness_variation_time_nominal_load",
    "stiffness_error_max",
    "stiffness_error_late",
    "load_max",
    "drive_torque_max",
    "drive_current_max",
    "drive_power_max",
    "setting_torque_max",
    "setting_current_max",
    "setting_power_max",
    "energy_drawn",
    "energy_returned",
    "energy_lost",
)
MOST_TILES = 12


def render_page(run: Run, pictures: Sequence[Picture], motion: Mapping[str, Any] | None) -> str:
    """Return the report's HTML; everything that a user wrote is escaped.

    Parameters
    ----------
    run : the simulation
    pictures : figures in order; the one named ``mechanism`` stands in for the player where no script runs
    motion : of ``motion.motion``; None for a kind without a drawing
    """
    shown = [embedded(picture) for picture in pictures]
    mechanism = next((picture for picture in shown if picture["name"] == "mechanism"), None)
    script = _script()
    context = {
        **_head(run),
        **_numbers(run),
        **_provenance(run),
        "mechanism": mechanism if motion is not None else None,
        "motion": motion,
        "time_unit": run.time_display.unit,
        "time_factor": f"{run.time_display.factor:g}",
        "script": Markup(script),  # ours, from the package
        "script_hash": base64.b64encode(hashlib.sha256(script.encode()).digest()).decode(),
        "figures": [picture for picture in shown if picture["name"] != "mechanism"],
    }
    return filled("simulation.html.j2", context)


def _script() -> str:
    return files("varistiff.report").joinpath("templates", "simulation_player.js").read_text(encoding="utf-8")


def _head(run: Run) -> dict[str, Any]:
    simulation, balance = run.simulation, Balance.of(run)
    outcome = simulation.outcome
    failure = {
        "what": outcome.value.replace("_", " "),
        "time": run.time_text(run.stopped_at),
        "meaning": outcome.meaning,
        "remedy": outcome.remedy,
    }
    return {
        "name": simulation.name or "Unnamed scenario",
        "design_name": simulation.design.name or "an unnamed design",
        "kind_name": KIND_NAMES.get(run.kind, run.kind),
        "failure": None if run.done else failure,
        "balance": balance.sentence,
        "closes": balance.closes,
        "warnings": list(simulation.design.warnings),
    }


def _numbers(run: Run) -> dict[str, Any]:
    balance, metrics = Balance.of(run), run.simulation.metrics
    telling = [metrics[name] for name in KEY_METRICS if name in metrics and metrics[name].value]
    events = [
        {"time": run.time_text(event.time), "name": event.name.replace("_", " "), "text": event.text}
        for event in run.events
    ]
    groups = (("Entered", balance.inflows), ("Stored", balance.stores), ("Lost", balance.losses))
    most = max((abs(float(term.values[-1])) for _, terms in groups for term in terms), default=1.0)
    return {
        "tiles": [_metric(metric) for metric in telling if math.isfinite(metric.value or 0.0)][:MOST_TILES],
        "metrics": [_metric(metric) for metric in metrics.values()],
        "events": events[:MOST_EVENTS],
        "more_events": max(len(events) - MOST_EVENTS, 0),
        "energy": [_group(title, terms, display("J", most)) for title, terms in groups if terms],
        "residual": f"{compact(float(balance.residual[-1]))} J" if balance.residual.size else MISSING,
    }


def _metric(metric: Metric) -> dict[str, str]:
    value = None if metric.value is None else float(metric.value)
    text = display(metric.unit, abs(value or 0.0)).text(value)
    return {"label": metric.long_name[:1].upper() + metric.long_name[1:], "value": text, "note": metric.note}


def _group(title: str, terms: Sequence[Term], unit: Display) -> dict[str, Any]:
    ends = [float(term.values[-1]) for term in terms]
    rows = [
        {"label": term.long_name[:1].upper() + term.long_name[1:], "value": unit.text(end), "name": term.name}
        for term, end in zip(terms, ends, strict=True)
    ]
    return {"title": title, "rows": rows, "sum": unit.text(sum(ends))}


def _provenance(run: Run) -> dict[str, Any]:
    data, design = run.simulation.data, run.simulation.design
    attrs = data.attrs
    about = (
        ("Design file", design.path, True),
        ("Design hash", attrs.get("design_hash", design.hash), True),
        ("Scenario hash", attrs.get("scenario_hash", ""), True),
        ("Computed with", attrs.get("versions", ""), False),
        ("Computed at", attrs.get("created", ""), False),
    )
    return {
        "version": attrs.get("varistiff_version", ""),
        "sign_convention": attrs.get("sign_convention", ""),
        "variables": [
            {
                "name": name,
                "unit": data[name].attrs.get("units", ""),
                "long_name": data[name].attrs.get("long_name", ""),
            }
            for name in map(str, data.variables)
        ],
        "about": [{"label": label, "text": text, "code": code} for label, text, code in about if text],
        "scenario_text": attrs.get("scenario", ""),
        "design_text": attrs.get("design", design.text),
        "sources": [_source(key) for key in str(attrs.get("references", "")).split()],
    }


def _source(key: str) -> str:
    try:
        return str(citation(key))
    except InputError:
        return key
