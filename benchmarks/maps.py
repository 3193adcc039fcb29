"""One map of 201 x 101 points of every example, after compilation."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import varistiff
from benchmarks.timing import in_turn
from varistiff.characteristic.evaluate import evaluate

EXAMPLES = Path(__file__).parents[1] / "examples"


def table() -> list[str]:
    """Rows of the Markdown table."""
    rows = ["| example | kind | time of a map | per point |", "|---|---|---|---|"]
    for path in sorted(EXAMPLES.glob("*.yaml")):
        design = varistiff.load(path)
        d = np.linspace(*design.deflection_range, 201)[None, :]
        bounds = design.setting_range
        s = None if bounds is None else np.linspace(*bounds, 101)[:, None]
        points = 201 * (1 if s is None else 101)
        actuator = design.actuator
        seconds = in_turn([lambda a=actuator, d=d, s=s: evaluate(a, d, s)], rounds=25).seconds[0]
        rows.append(f"| {path.name} | {design.kind} | {seconds * 1e3:.1f} ms | {seconds / points * 1e9:.0f} ns |")
    return rows
