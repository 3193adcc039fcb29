"""Leaf results into and out of the cache."""

from __future__ import annotations

from typing import Any

from varistiff.fe.cache import cache_key, read_entry, write_entry
from varistiff.fe.leaf_problem import LeafProblem, LeafResult

_NUMBERS = (
    "load",
    "stiffness",
    "energy",
    "contact_force",
    "contact_slope",
    "arc_length",
    "stress",
    "stress_distance",
    "error",
    "unknowns",
    "seconds",
    "iterations",
)
_ARRAYS = ("arc", "across", "points", "stress_upper", "stress_lower")


def leaf_key(problem: LeafProblem, *, tolerance: float) -> str:
    """Name of a problem's entry."""
    return cache_key("leaf", tolerance, problem)


def recall(problem: LeafProblem, *, tolerance: float) -> LeafResult | None:
    """The kept result of a problem, if there is one."""
    entry = read_entry(leaf_key(problem, tolerance=tolerance))
    if entry is None:
        return None
    facts, arrays = entry
    try:
        found: dict[str, Any] = {name: facts[name] for name in _NUMBERS} | {name: arrays[name] for name in _ARRAYS}
        return LeafResult(problem=problem, level_loads=tuple(facts["level_loads"]), **found)
    except (KeyError, TypeError):
        return None


def remember(result: LeafResult, *, tolerance: float) -> None:
    """Keep a result."""
    facts = {name: getattr(result, name) for name in _NUMBERS} | {"level_loads": result.level_loads}
    arrays = {name: getattr(result, name) for name in _ARRAYS}
    write_entry(leaf_key(result.problem, tolerance=tolerance), facts, arrays)
