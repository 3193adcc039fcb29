"""How a run ended."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Outcome(Enum):
    """Whether a run is a result, and if not, why; each with its remedy."""

    DONE = "done"
    UNSTABLE = "unstable"
    LEFT_MAP = "left_map"
    STEP_TOO_LARGE = "step_too_large"
    STORAGE_OVERDRAWN = "storage_overdrawn"
    AUDIT_OPEN = "audit_open"

    @property
    def meaning(self) -> str:
        """One sentence: what the outcome says."""
        return _TEXTS[self][0]

    @property
    def remedy(self) -> str:
        """One sentence: what to do about it."""
        return _TEXTS[self][1]


_TEXTS = {
    Outcome.DONE: ("The run is complete and its energy balance closes.", "Nothing to do."),
    Outcome.UNSTABLE: (
        "The controlled joint runs away.",
        "Lower the gains or the delay, sample faster, or add damping.",
    ),
    Outcome.LEFT_MAP: (
        "The motion reached a deflection or setting for which the actuator has no solution.",
        "Reduce the motion or the load, add stops, or choose a longer element.",
    ),
    Outcome.STEP_TOO_LARGE: (
        "The step is too large for the fastest motion of the joint.",
        "Leave `step` out, or make it smaller.",
    ),
    Outcome.STORAGE_OVERDRAWN: (
        "The storage was asked for power that it cannot give: the drives' torques are not to be had.",
        "Take a larger or fuller storage with less resistance, or limit the drives.",
    ),
    Outcome.AUDIT_OPEN: (
        "The energy balance does not close: the numbers are no result.",
        "Leave `step` out, or make it smaller.",
    ),
}


@dataclass(frozen=True)
class Event:
    """Something that happened at an instant.

    Parameters
    ----------
    time : [s]
    name : short, the same for the same kind of event
    text : one sentence for people
    """

    time: float
    name: str
    text: str


@dataclass(frozen=True)
class Metric:
    """A number that judges a run; None where the run does not have it, and the note says why.

    Parameters
    ----------
    value : in ``unit``
    unit : SI, "%" or ""
    long_name : what it is
    note : how it was taken
    """

    value: float | None
    unit: str
    long_name: str
    note: str = ""
