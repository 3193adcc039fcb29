"""What happened during a run, each with its instant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from varistiff.core.status import Status
from varistiff.dynamics.control import StiffnessPid
from varistiff.dynamics.outcome import Event
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.program import Case, Row
from varistiff.dynamics.stop import Stop

_HAIR = 1e-9  # rounding of a reference that goes to the end of the range
_MOST = 20  # of one name; a chattering contact has thousands


def events_of(case: Case, rows: Row) -> tuple[Event, ...]:
    """What a reader has to know of a run, in the order of time.

    Stops reached, contact lost, saturation, overheating, empty storage, statuses of the map, and a wanted stiffness
    that no setting gives.
    """
    found = [
        *_stops(case.plant, rows),
        *_contact(case.plant, rows),
        *_drives(case.plant, rows),
        *_storage(rows),
        *_statuses(rows),
        *_wanted_stiffness(case, rows),
    ]
    return tuple(sorted(_thinned(found), key=lambda event: event.time))


def _thinned(events: list[Event]) -> Iterator[Event]:
    counts: dict[str, int] = {}
    totals = {name: sum(event.name == name for event in events) for name in {event.name for event in events}}
    for event in events:
        counts[event.name] = counts.get(event.name, 0) + 1
        if counts[event.name] < _MOST or totals[event.name] <= _MOST:
            yield event
        elif counts[event.name] == _MOST:
            more = totals[event.name] - _MOST
            yield Event(event.time, event.name, f"{event.text} ({more} more of these follow)")


def _begins(happens: np.ndarray) -> np.ndarray:
    """Indices at which a condition becomes true."""
    before = np.concatenate([[False], happens[:-1]])
    return np.flatnonzero(happens & ~before)


def _instants(rows: Row, indices: np.ndarray) -> list[float]:
    """Instants of what began before these rows: the located switching where there is one, else the row's own."""
    located = np.asarray(rows.first_switching)[indices]
    return [float(at) if np.isfinite(at) else float(rows.time[i]) for at, i in zip(located, indices, strict=True)]


def _stops(plant: Plant, rows: Row) -> Iterator[Event]:
    motion = rows.state.motion
    travels: list[tuple[str, Stop | None, Any]] = [
        ("link", plant.link.stop, motion.link),
        ("drive", plant.drive.stop, motion.drive),
        ("setting drive", plant.setting.stop, motion.motion),
        ("deflection", plant.deflection_stop, rows.deflection),
    ]
    for part, stop, position in travels:
        if stop is None:
            continue
        for end, inside in (("lower", position < stop.lower), ("upper", position > stop.upper)):
            name = f"{part} at its {end} stop"
            for time in _instants(rows, _begins(np.asarray(inside))):
                yield Event(time, name, f"The {part} reaches its {end} stop.")


def _contact(plant: Plant, rows: Row) -> Iterator[Event]:
    if not plant.actuator.loses_contact:
        return
    free = np.asarray(rows.flows.response.status) == Status.NO_CONTACT
    for time in _instants(rows, _begins(free)):
        yield Event(time, "contact lost", "The drive leaves the elastic element.")


def _drives(plant: Plant, rows: Row) -> Iterator[Event]:
    for part, motor, command, flows, heat in (
        ("drive", plant.drive_motor, rows.command.drive, rows.flows.drive, rows.state.drive_heat),
        ("setting drive", plant.setting_motor, rows.command.setting, rows.flows.setting, rows.state.setting_heat),
    ):
        asked, given = np.asarray(command), np.asarray(flows.torque + 0.0)
        reached = motor.torque_limit
        limited = np.abs(asked) >= float(reached) * (1.0 - 1e-9)
        for index in _begins(limited):
            text = f"The {part} is at its limit: {asked[index]:.4g} asked, {given[index]:.4g} given."
            yield Event(float(rows.time[index]), f"{part} saturated", text)
        hot = np.asarray(heat.winding) > float(motor.temperature_limit)
        for index in _begins(hot):
            yield Event(float(rows.time[index]), f"{part} too hot", f"The winding of the {part} exceeds its limit.")


def _storage(rows: Row) -> Iterator[Event]:
    for index in _begins(np.asarray(rows.flows.storage.shortfall) != 0.0):
        yield Event(float(rows.time[index]), "storage overdrawn", "The storage cannot give the power that is asked.")


def _statuses(rows: Row) -> Iterator[Event]:
    status = np.asarray(rows.flows.response.status)
    for which in (Status.OUTSIDE_VALIDITY, Status.YIELDED):
        for index in _begins(status == which):
            yield Event(float(rows.time[index]), which.label, which.meaning)


def _wanted_stiffness(case: Case, rows: Row) -> Iterator[Event]:
    channel = case.loop.setting
    if channel is None or not isinstance(channel.controller, StiffnessPid):
        return
    least, most = map(float, channel.controller.chain.reach())
    wanted = np.asarray(rows.wanted_stiffness)
    beyond = (wanted < least * (1.0 - _HAIR)) | (wanted > most * (1.0 + _HAIR))
    for index in _begins(beyond):
        text = f"The wanted stiffness is {wanted[index]:.4g}, the settings give {least:.4g} to {most:.4g}."
        yield Event(float(rows.time[index]), "stiffness out of reach", text)
