"""Torsion results into and out of the cache."""

from __future__ import annotations

import itertools
from dataclasses import asdict

import numpy as np

from varistiff.fe.cache import cache_key, read_entry, write_entry
from varistiff.fe.torsion_problem import (
    ContactState,
    LoadCase,
    StressField,
    StressPeaks,
    TorsionProblem,
    TorsionResult,
)


def torsion_key(problem: TorsionProblem, *, tolerance: float, whole: bool) -> str:
    """Name of a problem's entry: from the points of the outline, so every section has one."""
    outline = problem.section.outline()
    t = np.linspace(0.0, 1.0, 17)
    points = [segment.point(t) for segment in itertools.chain.from_iterable(outline.pieces)]
    lengths = [len(piece) for piece in outline.pieces]
    rails = [getattr(problem.section, name, None) for name in ("shape", "rails", "rail_width")]
    numbers = [problem.shear_modulus, problem.poissons_ratio, problem.length, problem.active_length,
               problem.bearing_length, problem.bearing_clearance, float(problem.section.torsion_modulus)]  # fmt: skip
    return cache_key("torsion", tolerance, whole, outline.rotations, outline.mirror, lengths, rails, numbers, *points)


def recall(problem: TorsionProblem, *, tolerance: float, whole: bool) -> TorsionResult | None:
    """The kept result of a problem, if there is one."""
    entry = read_entry(torsion_key(problem, tolerance=tolerance, whole=whole))
    if entry is None:
        return None
    facts, arrays = entry
    try:
        fields = tuple(
            StressField(name, *(arrays[f"{name}.{part}"] for part in ("points", "triangles", "equivalent")))
            for name in facts["fields"]
        )
        contact = facts["contact"]
        return TorsionResult(
            cases=tuple(LoadCase(**case) for case in facts["cases"]),
            contact=None if contact is None else ContactState(**contact),
            stress=StressPeaks(**facts["stress"]),
            fields=fields,
            **{name: facts[name] for name in ("order", "unknowns", "seconds", "method")},
        )
    except (KeyError, TypeError):
        return None


def remember(problem: TorsionProblem, result: TorsionResult, *, tolerance: float, whole: bool) -> None:
    """Keep a result."""
    facts = {
        "cases": [asdict(case) for case in result.cases],
        "contact": None if result.contact is None else asdict(result.contact),
        "stress": asdict(result.stress),
        "fields": [field.name for field in result.fields],
        **{name: getattr(result, name) for name in ("order", "unknowns", "seconds", "method")},
    }
    arrays = {
        f"{field.name}.{part}": getattr(field, part)
        for field in result.fields
        for part in ("points", "triangles", "equivalent")
    }
    write_entry(torsion_key(problem, tolerance=tolerance, whole=whole), facts, arrays)
