"""A simulation as the figures need it: plain arrays, units for people, and whether there is anything to show."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from varistiff.dynamics.outcome import Event, Outcome
from varistiff.report.display import Display, display, number
from varistiff.report.simulation.contract import SimulationLike
from varistiff.report.view import SETTING_NAMES, Array

SHORT = 0.1  # a run up to this long [s] is shown in milliseconds


@dataclass(frozen=True)
class Run:
    """A simulation with the questions that pictures ask of it."""

    simulation: SimulationLike

    @cached_property
    def time(self) -> Array:
        """Instants [s]."""
        return np.asarray(self.simulation.data["time"].values, float)

    @cached_property
    def time_display(self) -> Display:
        """Unit that times are shown in."""
        return Display(1e3, "ms") if self.time[-1] - self.time[0] <= SHORT else Display(1.0, "s")

    @cached_property
    def x(self) -> Array:
        """Instants in the unit that is shown."""
        return self.time * self.time_display.factor

    @property
    def kind(self) -> str:
        """Kind of actuator."""
        return self.simulation.design.kind

    @property
    def stretch(self) -> str:
        """Variable that deflects the elastic element: the deflection, or what backlash leaves of it."""
        return "deflection" if self.given("stretch") is None else "stretch"

    @property
    def load_name(self) -> str:
        """Torque of a joint, force of a linear device."""
        return "Force" if self.unit("load").strip() == "N" else "Torque"

    @property
    def setting_name(self) -> str:
        """What the stiffness drive moves, capitalised."""
        return "Disc angle" if self.unit("setting") == "rad" else SETTING_NAMES.get(self.kind, "Setting")

    def given(self, name: str) -> Array | None:
        """Variable over time with NaN for what is not finite; None where it has no finite value."""
        if name not in self.simulation.data:
            return None
        values = np.asarray(self.simulation.data[name].values, float)
        if values.shape != self.time.shape or not np.isfinite(values).any():
            return None
        return np.where(np.isfinite(values), values, np.nan)

    def telling(self, name: str) -> Array | None:
        """Variable over time; None where there is nothing in it but zeros."""
        values = self.given(name)
        return values if values is not None and np.nanmax(np.abs(values)) > 0.0 else None

    def unit(self, name: str) -> str:
        """SI unit of a variable."""
        if name not in self.simulation.data:
            return "1"
        return str(self.simulation.data[name].attrs.get("units", "1"))

    def long_name(self, name: str) -> str:
        """What a variable is."""
        return str(self.simulation.data[name].attrs.get("long_name", name.replace("_", " ")))

    def limits(self, name: str) -> tuple[float, float]:
        """Lowest and highest allowed value in SI; infinite where there is none."""
        if name not in self.simulation.data:
            return -math.inf, math.inf
        low, high = self.simulation.data[name].attrs.get("limits", (-math.inf, math.inf))
        return float(low), float(high)

    @property
    def events(self) -> list[Event]:
        """Events in order of time."""
        return sorted(self.simulation.events, key=lambda event: event.time)

    @property
    def done(self) -> bool:
        """Whether the run is a result."""
        return self.simulation.outcome is Outcome.DONE

    @property
    def stopped_at(self) -> float:
        """Instant [s] at which a run stopped being a result, or its end."""
        failed = self.simulation.failed_at
        return float(self.time[-1]) if failed is None else failed

    @property
    def stamp(self) -> str:
        """What a picture of a run that is no result carries; empty for a result."""
        if self.done:
            return ""
        what = self.simulation.outcome.value.replace("_", " ")
        return f"No result: {what} at {self.time_text(self.stopped_at)}"

    def time_text(self, time: float) -> str:
        """An instant for people."""
        return self.time_display.text(time)

    def shown(self, unit: str, values: Iterable[Array | None]) -> Display:
        """Unit to show several variables of one SI unit in."""
        most = [float(np.nanmax(np.abs(part))) for part in values if part is not None and np.isfinite(part).any()]
        return display(unit, max(most, default=1.0))


def compact(value: float) -> str:
    """A small or large number for people, three digits: 2.13e-9."""
    if value == 0.0 or not math.isfinite(value) or 1e-3 <= abs(value) < 1e4:
        return number(float(f"{value:.3g}"))
    mantissa, power = f"{value:.2e}".split("e")
    return f"{mantissa.rstrip('0').rstrip('.')}e{int(power)}".replace("-", "\N{MINUS SIGN}")
