"""How long changes of stiffness take, without load and under load."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from varistiff.dynamics.outcome import Metric
from varistiff.dynamics.response_metrics import step_metrics

NO_LOAD = 0.05  # of the largest load of the run: at most this much counts as none
NO_DEFLECTION = 1e-5  # rad or m: what it makes counts as no load either
_HELP = "the wanted stiffness has to change from one level to another, once {when}"


class Variation(NamedTuple):
    """One change of the wanted stiffness from one level to another.

    Parameters
    ----------
    start : instant [s]
    settling : from there until the stiffness stays within 2 % of the change [s], None where it does not
    load : magnitude of its mean until the stiffness has settled, or until the next change [N m or N]
    loaded : whether that is more than a small part of the largest load of the run
    """

    start: float
    settling: float | None
    load: float
    loaded: bool


def stiffness_variations(time: np.ndarray, wanted: np.ndarray, real: np.ndarray, load: np.ndarray) -> list[Variation]:
    """Every change of the wanted stiffness from one level to another, with the time that the stiffness takes.

    Parameters
    ----------
    time : [s], shape (n,), even
    wanted, real : stiffness, shape (n,)
    load : of the elastic element, shape (n,)
    """
    level = np.flatnonzero(np.diff(wanted) == 0.0)
    if not level.size:
        return []
    # plateaus: runs of samples between which the wanted value does not change
    first = level[np.flatnonzero(np.diff(level, prepend=-2) > 1)]
    last = level[np.flatnonzero(np.diff(level, append=wanted.size + 1) > 1)] + 1
    ends = np.append(last[1:], wanted.size - 1)
    found = []
    for start, after, end in zip(last[:-1], first[1:], ends[:-1], strict=True):
        part = slice(start, end + 1)
        if wanted[start] == wanted[after]:
            continue
        # the reached level counts from its own plateau, however long the way to it
        metrics = step_metrics(time[part], _held(wanted[part]), real[part], "", "stiffness")
        settling = metrics["stiffness_settling_time"].value
        instant = float(time[start + 1])
        way = part if settling is None else slice(start, int(np.searchsorted(time, instant + settling)) + 1)
        carried = abs(float(load[way].mean()))  # signed: what only swings is not carried
        none = max(NO_LOAD * float(np.abs(load).max()), NO_DEFLECTION * float(np.abs(real[way]).mean()))
        found.append(Variation(instant, settling, carried, carried > none))
    return found


def _held(wanted: np.ndarray) -> np.ndarray:
    """The same change as a jump at its first instant: the time counts from there."""
    return np.where(np.arange(wanted.size) == 0, wanted[0], wanted[-1])


def variation_metrics(variations: list[Variation], load_unit: str) -> dict[str, Metric]:
    """Stiffness-variation times without load, and at the nominal load: the largest that is carried at a change."""
    most = max((each.load for each in variations), default=0.0)
    groups = {
        "no_load": [each for each in variations if not each.loaded],
        "nominal_load": [each for each in variations if each.loaded and each.load >= 0.5 * most],
    }
    return {
        f"stiffness_variation_time_{key}": _slowest(group, f"at {key.replace('_', ' ')}", load_unit)
        for key, group in groups.items()
    }


def _slowest(variations: list[Variation], when: str, load_unit: str) -> Metric:
    name = f"stiffness-variation time {when}"
    if not variations:
        return Metric(None, "s", name, _HELP.format(when=when))
    missing = [each for each in variations if each.settling is None]
    slowest = missing[0] if missing else max(variations, key=lambda each: each.settling or 0.0)
    what = "not reached" if missing else f"slowest of {len(variations)}" if len(variations) > 1 else "2 % band"
    note = f"{what}; change at {slowest.start:.3g} s, load {slowest.load:.3g} {load_unit}"
    return Metric(slowest.settling, "s", name, note)
