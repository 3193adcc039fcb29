"""What the command line says beside its results, on standard error."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from varistiff.core.status import Status

if TYPE_CHECKING:
    from varistiff.design.design import Design


def warn(design: Design) -> None:
    """Print the design's warnings."""
    for warning in design.warnings:
        print(f"varistiff: {design.path}: warning: {warning}", file=sys.stderr)


def say_statuses(design: Design, statuses: dict[Status, int]) -> None:
    """Print how many points are ok, and of the others how many and why."""
    total = sum(statuses.values())
    print(f"varistiff: {statuses.get(Status.OK, 0)} of {total} points ok", file=sys.stderr)
    for status, count in sorted(statuses.items()):
        if status is Status.OK or not count:
            continue
        reason = status.meaning
        if status is Status.OUTSIDE_VALIDITY and design.actuator.broken_assumption:
            reason = f"{reason} Here: {design.actuator.broken_assumption}."
        print(f"varistiff: {count} {status.label}: {reason} {status.remedy}", file=sys.stderr)
