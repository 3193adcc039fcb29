"""What the introduction says about earlier work."""

from __future__ import annotations

from varistiff.papers.dos_santos_2019.paper_values import (
    ADJUSTER_ACTUATORS,
    FIRST_WORK,
    MOTORS,
    YEAR,
)


def years_since_first_work() -> float:
    """Years from the first cited work on large deflections to the paper."""
    return float(YEAR - FIRST_WORK)


def fewer_actuators() -> float:
    """Actuators of the mechanical impedance adjuster less the motors of the roller beam."""
    return float(ADJUSTER_ACTUATORS - MOTORS)
