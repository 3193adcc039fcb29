"""What the report asks of a simulation, and nothing more."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

import xarray as xr

from varistiff.design.design import Design
from varistiff.dynamics.outcome import Event, Metric, Outcome

if TYPE_CHECKING:
    from varistiff.dynamics.audit import Audit


class SimulationLike(Protocol):
    """A finished run, partial ones included.

    ``data`` has the dimension ``time`` [s] and, in SI with ``units`` and ``long_name``, any of

    - link, drive, setting, deflection, stretch, load, stiffness, stress, status, external_torque;
    - wanted_position, wanted_stiffness: NaN throughout where nothing is wanted;
    - drive_command, drive_torque, drive_current, drive_voltage, drive_power and the same with ``setting_``;
    - storage_energy, storage_voltage, drive_temperature, setting_temperature.

    What a run does not have is absent, NaN or zero throughout, and is not shown. A variable may carry the attribute
    ``limits``: the lowest and the highest value that is allowed, in SI. Attributes of the dataset that are read:
    ``gravity_rest`` (link position [rad] in which it hangs down; absent without gravity), ``scenario`` and
    ``scenario_hash``, ``design`` and ``design_hash``, ``versions``, ``varistiff_version``, ``created``,
    ``references``, ``sign_convention``.
    """

    @property
    def name(self) -> str:
        """Name of the scenario."""

    @property
    def design(self) -> Design:
        """The design that was simulated."""

    @property
    def data(self) -> xr.Dataset:
        """Everything over time."""

    @property
    def audit(self) -> Audit:
        """The energy balance; its terms and residual have the shape of ``time``."""

    @property
    def outcome(self) -> Outcome:
        """How it ended."""

    @property
    def failed_at(self) -> float | None:
        """When it stopped being a result [s]; None for a result."""

    @property
    def events(self) -> Sequence[Event]:
        """What happened, in order of time."""

    @property
    def metrics(self) -> Mapping[str, Metric]:
        """Numbers that sum it up, by name."""
