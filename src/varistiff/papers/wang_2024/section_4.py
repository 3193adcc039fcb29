"""The numbers that Wang et al. (2024) do not print for their Section 4, as section_4.yaml holds them."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from varistiff.core.textfile import parse_yaml
from varistiff.papers.registry import paper_file
from varistiff.papers.wang_2024.section_4_cases import PositionSet, SettingSet

POSITION_SETS = ("steps", "steps_by_stroke", "sine", "sine_as_printed", "steps_and_sine")


class Stored(NamedTuple):
    """A set as stored.

    Parameters
    ----------
    values : by field of ``PositionSet`` or ``SettingSet``, SI units
    cost : sum of squared distances from the facts that were searched for, each in steps of its aim
    simulations : how many runs the search took
    meets, misses : names of the facts within and beyond one step
    """

    values: dict[str, float]
    cost: float
    simulations: int
    meets: tuple[str, ...]
    misses: tuple[str, ...]


@cache
def stored(name: str) -> Stored:
    """Return a set by name, one of ``POSITION_SETS`` or ``stiffness``."""
    (document,) = parse_yaml(paper_file("wang_2024", "section_4.yaml").read_text(encoding="utf-8"))
    entry = document["sets"][name]
    values = {field: float(value) for field, value in entry["values"].items()}
    return Stored(values, float(entry["cost"]), entry["simulations"], tuple(entry["meets"]), tuple(entry["misses"]))


def position_set(name: str) -> PositionSet:
    """Return a set of ``POSITION_SETS``."""
    return PositionSet(**stored(name).values)


def setting_set() -> SettingSet:
    """Return the set of the stiffness tests; it was searched for beside the position loop of ``steps``."""
    return SettingSet(**stored("stiffness").values)
