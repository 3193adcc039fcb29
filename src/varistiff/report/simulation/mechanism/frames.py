"""The instants that are drawn, more of them where more moves."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from varistiff.report.simulation.run import Run
from varistiff.report.view import Array, Mask

MOST = 120
BEYOND = 3.0  # ranges of deflection within which an element is drawn
FAR = 1e4  # radians or metres, or as many ranges of deflection


@dataclass(frozen=True)
class Frames:
    """Positions at the instants that are drawn, SI, each of shape (frames,).

    Parameters
    ----------
    index : of the instants among the samples of the run
    time : [s]
    link, drive : positions [rad] or [m]; ``drive`` None for a joint without one
    deflection : of the elastic element; differs from drive minus link by backlash
    setting : 0 for a kind without one
    wanted : position of the link that is wanted, None where nothing is
    stops : lowest and highest position of the link [rad] or [m], infinite where nothing stops it
    upright : angle [rad] that the picture is turned by, so that a link with weight hangs down
    """

    index: np.ndarray
    time: Array
    link: Array
    drive: Array | None
    deflection: Array
    setting: Array
    wanted: Array | None = None
    stops: tuple[float, float] = (-math.inf, math.inf)
    upright: float = 0.0

    @property
    def count(self) -> int:
        """Number of frames."""
        return int(self.time.size)

    @property
    def driven(self) -> Array:
        """Position of the drive, or the fixed zero of a joint without one."""
        return np.zeros(self.count) if self.drive is None else self.drive

    @staticmethod
    def of(run: Run, most: int = MOST) -> Frames | None:
        """Choose the frames of a run; None where there is no position to draw."""
        link, deflection = run.given("link"), run.given(run.stretch)
        if link is None or deflection is None:
            return None
        drive, setting, wanted = (run.given(name) for name in ("drive", "setting", "wanted_position"))
        moving = [part for part in (link, drive, deflection, setting) if part is not None]
        chosen = choose(run.time, moving, most, usable=_drawable(run, moving, setting))
        if not chosen.size:
            return None
        rest = run.simulation.data.attrs.get("gravity_rest")

        def at(values: Array | None) -> Array | None:
            return None if values is None else values[chosen]

        return Frames(
            index=chosen,
            time=run.time[chosen],
            link=link[chosen],
            drive=at(drive),
            deflection=deflection[chosen],
            setting=np.zeros(chosen.size) if setting is None else setting[chosen],
            wanted=at(wanted),
            stops=run.limits("link"),
            upright=0.0 if rest is None else -0.5 * math.pi - float(rest),
        )


def _drawable(run: Run, moving: list[Array], setting: Array | None) -> Mask:
    """Where everything is known and near enough to the design's ranges to be drawn: a run may have gone astray."""
    design = run.simulation.design
    reach = max(map(abs, design.deflection_range))
    places, deflection = np.stack(moving), run.given(run.stretch)
    near = np.isfinite(places).all(axis=0) & (np.abs(places).max(axis=0) <= FAR * max(reach, 1.0))
    if deflection is not None:
        near &= np.abs(deflection) <= BEYOND * reach
    if setting is not None and design.setting_range is not None:
        low, high = design.setting_range
        near &= (setting > low - (high - low)) & (setting < high + (high - low))
        near &= (setting > 0.0) | (design.setting_unit == "rad")
    return np.asarray(near)


def choose(time: Array, moving: list[Array], most: int, *, usable: Mask) -> np.ndarray:
    """Indices of at most so many usable samples: half even in time, half even in what all parts move together."""
    whole = np.flatnonzero(usable)
    if whole.size <= most:
        return whole
    place = _shares(time[whole])
    travel = sum(_shares(np.insert(np.cumsum(np.abs(np.diff(part[whole]))), 0, 0.0)) for part in moving)
    place = 0.5 * (place + _shares(np.asarray(travel)))
    nearest = np.searchsorted(place, np.linspace(0.0, place[-1], most) - 1e-12)
    return whole[np.unique(np.minimum(nearest, whole.size - 1))]


def _shares(rising: Array) -> Array:
    """A rising series from 0 to 1; zeros where it does not rise."""
    length = float(rising[-1] - rising[0])
    return np.asarray((rising - rising[0]) / length if length > 0.0 else np.zeros(rising.size))
