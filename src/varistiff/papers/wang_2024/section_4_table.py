"""The facts of Section 4, each beside the set that was fitted for it and beside the one fitted to all."""

from __future__ import annotations

import math
from typing import NamedTuple

from varistiff.papers.wang_2024.section_4 import stored
from varistiff.papers.wang_2024.section_4_facts import position_runs, setting_run
from varistiff.papers.wang_2024.section_4_search import QUESTS, SETTING

SHARE, DEGREE, PLAIN = 0.01, math.radians(1.0), 1.0
STEP, SINE = "section 4.3, paragraph 1", "section 4.3, paragraph 3"


class Fact(NamedTuple):
    """A printed fact.

    Parameters
    ----------
    words : what it is
    locator : where it is printed
    printed : digits
    unit, factor : of the digits, and its SI value
    field : of ``PositionFacts`` or ``SettingFacts``
    quest : name of the set that was fitted to it
    """

    words: str
    locator: str
    printed: str
    unit: str
    factor: float
    field: str
    quest: str


FACTS = (
    Fact("small step: overshoot added by the load", STEP, "+5", "%", SHARE, "small_overshoot_by_load", "steps"),
    Fact("small step: settling time added by the load", STEP, "+0.25", "s", PLAIN, "small_settling_by_load", "steps"),
    Fact("large step: overshoot added by the load", STEP, "+15", "%", SHARE, "large_overshoot_by_load", "steps"),
    Fact("large step: settling time added by the load", STEP, "+0.16", "s", PLAIN, "large_settling_by_load", "steps"),
    Fact("sine: first error, no load", SINE, "11", "deg", DEGREE, "first_error", "sine"),
    Fact("sine: first error, load", SINE, "13", "deg", DEGREE, "first_error_loaded", "sine"),
    Fact("sine: later error, no load (printed of load)", SINE, "4", "deg", DEGREE, "later_error", "sine"),
    Fact("sine: later error, load (printed of no load)", SINE, "6", "deg", DEGREE, "later_error_loaded", "sine"),
    Fact("regulation: lever from 25 to 6 mm", "Table 3", "0.34", "s", PLAIN, "regulation_time", "stiffness"),
    Fact("stiffness sine: largest error, no load", SINE, "10", "N m/rad", PLAIN, "stiffness_error", "stiffness"),
    Fact("stiffness sine: largest error, load", SINE, "16", "N m/rad", PLAIN, "stiffness_error_loaded", "stiffness"),
)


class Line(NamedTuple):
    """A fact with what is computed for it, in the unit of the fact; ``together`` is None for a stiffness fact."""

    fact: Fact
    own: float
    own_meets: bool
    together: float | None
    together_meets: bool | None


def lines() -> tuple[Line, ...]:
    """The facts table: with the set fitted to each fact, and with ``steps_and_sine``."""
    scales = {aim.fact: aim.scale for quest in QUESTS.values() for aim in quest.aims}
    scales |= {aim.fact: aim.scale for aim in SETTING}
    found = []
    for fact in FACTS:
        printed, scale = float(fact.printed), scales[fact.field] / fact.factor
        if fact.quest == "stiffness":
            own = getattr(setting_run().facts, fact.field) / fact.factor
            found.append(Line(fact, own, abs(own - printed) <= scale, None, None))
            continue
        own, together = (
            getattr(position_runs()[name].facts, fact.field) / fact.factor for name in (fact.quest, "steps_and_sine")
        )
        found.append(Line(fact, own, abs(own - printed) <= scale, together, abs(together - printed) <= scale))
    return tuple(found)


def values_of(name: str) -> dict[str, float]:
    """Numbers of a stored set by field, SI units."""
    return dict(stored(name).values)
