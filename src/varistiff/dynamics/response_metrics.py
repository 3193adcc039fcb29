"""Step response and bandwidth, from a wanted and a real course in time."""

from __future__ import annotations

import numpy as np

from varistiff.dynamics.outcome import Metric

_BAND = 0.02
_NO_STEP = "the wanted value does not go from one level to another and stay there"


def step_metrics(time: np.ndarray, wanted: np.ndarray, real: np.ndarray, unit: str, name: str) -> dict[str, Metric]:
    """Rise time (10 to 90 %), overshoot and settling time (2 % band) of a course that follows a step.

    Parameters
    ----------
    time : [s], shape (n,), even
    wanted, real : courses in ``unit``, shape (n,)
    name : of the course, for the names of the metrics

    Returns
    -------
    Metrics ``<name>_rise_time``, ``<name>_overshoot``, ``<name>_settling_time``; their values are None where the
    wanted course does not change from one level to another once, or the real one does not get there.
    """
    empty = {
        f"{name}_rise_time": Metric(None, "s", f"{name} rise time", _NO_STEP),
        f"{name}_overshoot": Metric(None, "%", f"{name} overshoot", _NO_STEP),
        f"{name}_settling_time": Metric(None, "s", f"{name} settling time", _NO_STEP),
    }
    height = wanted[-1] - wanted[0]
    moves = np.flatnonzero(wanted != wanted[0])
    if height == 0.0 or not moves.size or (wanted[-max(wanted.size // 10, 1) :] != wanted[-1]).any():
        return empty
    start = max(int(moves[0]) - 1, 0)
    since = time[start:] - time[moves[0]]
    share = (real[start:] - wanted[0]) / height
    outside = np.flatnonzero(np.abs(share - 1.0) > _BAND)
    settled = None if outside.size and outside[-1] == share.size - 1 else _crossing(since, share, outside)
    low, high = _reaches(since, share, 0.1), _reaches(since, share, 0.9)
    rise = None if low is None or high is None else high - low
    over = max(float(share.max()) - 1.0, 0.0) * 100.0
    missing = "not reached within the run"
    return {
        f"{name}_rise_time": Metric(rise, "s", f"{name} rise time", "10 to 90 %" if rise is not None else missing),
        f"{name}_overshoot": Metric(over, "%", f"{name} overshoot", "of the step"),
        f"{name}_settling_time": Metric(
            settled, "s", f"{name} settling time", "last entry into 2 % of the step" if settled is not None else missing
        ),
    }


def _reaches(time: np.ndarray, share: np.ndarray, level: float) -> float | None:
    """First instant at which the share reaches a level, between samples by a straight line."""
    above = np.flatnonzero(share >= level)
    if not above.size:
        return None
    i = int(above[0])
    if i == 0:
        return float(time[0])
    part = (level - share[i - 1]) / (share[i] - share[i - 1])
    return float(time[i - 1] + part * (time[i] - time[i - 1]))


def _crossing(time: np.ndarray, share: np.ndarray, outside: np.ndarray) -> float:
    """Instant at which the band is entered for the last time."""
    if not outside.size:
        return 0.0
    i = int(outside[-1])
    bound = 1.0 + _BAND if share[i] > 1.0 else 1.0 - _BAND
    part = (bound - share[i]) / (share[i + 1] - share[i])
    return float(time[i] + part * (time[i + 1] - time[i]))


def bandwidth(time: np.ndarray, wanted: np.ndarray, real: np.ndarray) -> Metric:
    """Frequency at which the real course falls to 1/sqrt(2) of the wanted one, from the spectra of a sweep.

    Exists where the wanted course is a sweep: its spectrum must be broad up to that frequency.
    """
    name = "position bandwidth"
    spectrum = np.abs(np.fft.rfft((wanted - wanted.mean()) * np.hanning(wanted.size)))
    answer = np.abs(np.fft.rfft((real - real.mean()) * np.hanning(real.size)))
    frequency = np.fft.rfftfreq(time.size, time[1] - time[0])
    excited = spectrum > 0.2 * spectrum.max()
    if spectrum.max() == 0.0 or excited.sum() < 10:
        return Metric(None, "Hz", name, "the wanted course is no sweep")
    ratio = answer[excited] / spectrum[excited]
    low = np.flatnonzero(ratio < np.sqrt(0.5))
    if not low.size:
        return Metric(None, "Hz", name, f"above {frequency[excited][-1]:.3g} Hz, the end of the sweep")
    return Metric(float(frequency[excited][low[0]]), "Hz", name, "first frequency of the sweep below -3 dB")
