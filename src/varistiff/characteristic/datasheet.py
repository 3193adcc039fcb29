"""The datasheet: what an engineer asks first about an actuator, read off its characteristic map.

Everything is counted over the points of the map, so every limit is as fine as the map: the true one lies within
one step of the grid. A number that the map cannot give is None and its note says why.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from varistiff.characteristic.map_table import MapTable, Mask, extreme, spoken
from varistiff.core.status import Status

__all__ = ["Datasheet", "Group", "Limit", "Row", "StatusCount", "datasheet"]

UNBOUNDED_STRESS = "the ideal stress is unbounded at a sharp corner of the section: no point can count as yielded"
LIMIT_SETTINGS = 7  # rows of the table of limits: enough to see the trend, few enough to read


@dataclass(frozen=True)
class Row:
    """One number of the datasheet in SI units; ``value`` is None where the map has none."""

    key: str
    label: str
    value: float | None
    unit: str
    note: str = ""


@dataclass(frozen=True)
class Group:
    """Rows that belong together, under one title."""

    key: str
    title: str
    rows: tuple[Row, ...]


@dataclass(frozen=True)
class Limit:
    """How far one setting goes: the last ok deflection on the side that ends first, and what ends it.

    ``status`` is None where nothing but the edge of the map ends it; ``deflection`` is None without any ok point.
    """

    setting: float | None
    stiffness: float | None
    deflection: float | None
    load: float | None
    status: Status | None


@dataclass(frozen=True)
class StatusCount:
    """Number and fraction of the map's points with one status."""

    status: Status
    count: int
    fraction: float
    meaning: str


@dataclass(frozen=True)
class Datasheet:
    """Rows in groups, the limits per setting, and how many points have which status."""

    name: str
    kind: str
    groups: tuple[Group, ...]
    limits: tuple[Limit, ...]
    statuses: tuple[StatusCount, ...]
    units: dict[str, str]

    @property
    def rows(self) -> Iterator[Row]:
        """All rows, group after group."""
        return (row for group in self.groups for row in group.rows)

    def __getitem__(self, key: str) -> Row:
        """Row by its key."""
        for row in self.rows:
            if row.key == key:
                return row
        raise KeyError(f"{key!r}; the datasheet has {', '.join(row.key for row in self.rows)}")

    def as_dict(self) -> dict[str, Any]:
        """Plain values for JSON: SI units, None for what is not known."""
        return {
            "name": self.name,
            "kind": self.kind,
            "units": self.units,
            "groups": [asdict(group) for group in self.groups],
            "limits": [
                {**asdict(limit), "status": limit.status.label if limit.status is not None else None}
                for limit in self.limits
            ],
            "statuses": [
                {
                    "status": entry.status.label,
                    "count": entry.count,
                    "fraction": entry.fraction,
                    "meaning": entry.meaning,
                    "remedy": entry.status.remedy,
                }
                for entry in self.statuses
            ],
        }

    def as_csv(self) -> str:
        """Table ``group,key,label,value,unit,note``; the limits and statuses follow as rows of their own."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["group", "key", "label", "value", "unit", "note"])
        for group in self.groups:
            for row in group.rows:
                table.writerow([group.key, row.key, row.label, _cell(row.value), row.unit, row.note])
        for limit in self.limits:
            ends = limit.status.label if limit.status is not None else "edge of the map"
            at = "" if limit.setting is None else f"setting {limit.setting:.6g} {self.units['setting']}; "
            for key, value in (
                ("deflection", limit.deflection),
                ("load", limit.load),
                ("stiffness", limit.stiffness),
            ):
                note = at + ("at zero deflection" if key == "stiffness" else f"ended by {ends}")
                table.writerow(["limits", f"limit_{key}", f"Limit: {key}", _cell(value), self.units[key], note])
        for entry in self.statuses:
            label = entry.status.label
            table.writerow(["statuses", f"count_{label}", f"Points {label}", entry.count, "1", entry.status.remedy])
        return text.getvalue()


def datasheet(dataset: xr.Dataset) -> Datasheet:
    """Read the datasheet off a characteristic map.

    Parameters
    ----------
    dataset : map with dims (setting, deflection), or (deflection,) for a kind without a setting; the attribute
        ``strength`` [Pa], where present, is what ``stress`` is held against

    Energy capacity is V minus V at rest: the least V of the same setting among ok points and points without contact.
    """
    table = MapTable.of(dataset)
    groups = (
        Group("stiffness", "Stiffness (tangent)", tuple(_stiffness_rows(table))),
        Group("load", "Load and deflection", tuple(_load_rows(table))),
        Group("energy", "Energy", tuple(_energy_rows(table))),
        Group("adjusting", "Stiffness adjustment", tuple(_adjusting_rows(table))),
        Group("strength", "Strength", tuple(_strength_rows(table))),
        Group("element", "Elastic element and mechanism", tuple(_detail_rows(dataset, table))),
        Group("validity", "Validity", tuple(_validity_rows(table))),
    )
    return Datasheet(
        name=str(dataset.attrs.get("title", "")),
        kind=str(dataset.attrs.get("kind", "")),
        groups=tuple(group for group in groups if group.rows),
        limits=tuple(_limits(table)),
        statuses=tuple(_counts(table.status, str(dataset.attrs.get("broken_assumption", "")))),
        units=table.units,
    )


def _cell(value: float | None) -> str:
    return "" if value is None else format(value, ".17g")


def _stiffness_rows(table: MapTable) -> Iterator[Row]:
    at_rest = _next_to_rest(table)
    zero = table.deflection[table.rest]
    place = "at zero deflection" if zero == 0.0 else f"at {spoken(zero, table.units['deflection'])}, nearest to zero"
    usable = int(at_rest.sum())
    scope = f"no point {place} is ok" if usable == 0 else ""
    if usable and (table.status[:, table.rest][at_rest.any(axis=1)] == Status.NO_CONTACT).any():
        scope = "beyond the play"
    if table.setting is None:
        value = float(table.stiffness[at_rest][0]) if usable else None
        yield Row("stiffness_rest", f"Stiffness {place}", value, table.units["stiffness"], scope)
    else:
        if 0 < usable < table.status.shape[0]:
            scope = "; ".join(part for part in (scope, f"{usable} of {table.status.shape[0]} settings are ok") if part)
        yield from _range_rows(table, at_rest, "rest", place, scope)
    yield from _range_rows(table, table.ok, "ok", "over all ok points", "")


def _next_to_rest(table: MapTable) -> Mask:
    """Per setting the ok point at zero deflection, or the nearest one beyond the play around it."""
    chosen = np.zeros_like(table.ok)
    for row in range(table.status.shape[0]):
        column = _next_to_rest_column(table, row)
        if column is not None:
            chosen[row, column] = True
    return chosen


def _next_to_rest_column(table: MapTable, row: int) -> int | None:
    found = (_first_ok(table.status[row], table.rest, step) for step in (1, -1))
    columns = [column for column in found if column is not None]
    return min(columns, key=lambda column: abs(table.deflection[column])) if columns else None


def _first_ok(status: npt.NDArray[np.int8], start: int, step: int) -> int | None:
    column = start
    while 0 <= column < status.size and status[column] == Status.NO_CONTACT:
        column += step
    return column if 0 <= column < status.size and status[column] == Status.OK else None


def _range_rows(table: MapTable, mask: Mask, key: str, place: str, scope: str) -> Iterator[Row]:
    unit = table.units["stiffness"]
    low, high = (extreme(table.stiffness, mask, largest=largest) for largest in (False, True))
    if low is None or high is None:
        yield Row(f"stiffness_{key}_min", f"Smallest stiffness {place}", None, unit, scope or "no ok point")
        yield Row(f"stiffness_{key}_max", f"Largest stiffness {place}", None, unit, scope or "no ok point")
        return
    least, most = float(table.stiffness[low]), float(table.stiffness[high])
    notes = ["; ".join(part for part in (table.where(index), scope) if part) for index in (low, high)]
    yield Row(f"stiffness_{key}_min", f"Smallest stiffness {place}", least, unit, notes[0])
    yield Row(f"stiffness_{key}_max", f"Largest stiffness {place}", most, unit, notes[1])
    note = "" if least > 0.0 else "the smallest stiffness is not positive"
    yield Row(f"stiffness_{key}_ratio", f"Range ratio {place}", most / least if least > 0.0 else None, "1", note)


def _load_rows(table: MapTable) -> Iterator[Row]:
    name = table.load_name
    peak = extreme(np.abs(table.load), table.ok)
    if peak is None:
        yield Row(f"{name}_peak", f"Largest {name}", None, table.units["load"], "no ok point")
        return
    yield Row(
        f"{name}_peak",
        f"Largest {name}",
        abs(float(table.load[peak])),
        table.units["load"],
        table.where(peak),
    )
    # a row without an ok point has no limit at all: it must not hide the others
    limits = (_limit(table, row) for row in range(table.status.shape[0]))
    ends = [limit for limit in limits if limit.deflection is not None]
    if ends and table.setting is None:
        yield _limit_row(table, "deflection_limit", "Deflection range", ends[0])
    elif ends:
        shortest, longest = (pick(ends, key=lambda limit: abs(limit.deflection or 0.0)) for pick in (min, max))
        yield _limit_row(table, "deflection_limit_min", "Shortest deflection range", shortest)
        yield _limit_row(table, "deflection_limit_max", "Longest deflection range", longest)
    yield from _play_row(table)


def _limit_row(table: MapTable, key: str, label: str, limit: Limit) -> Row:
    note = f"ended by {limit.status.label if limit.status is not None else 'the edge of the map'}"
    if limit.setting is not None:
        note = f"at setting {spoken(limit.setting, table.units['setting'])}; {note}"
    return Row(key, label, abs(limit.deflection or 0.0), table.units["deflection"], note)


def _play_row(table: MapTable) -> Iterator[Row]:
    free = table.status == Status.NO_CONTACT
    if not free.any() or table.deflection.size < 2:
        return
    step = np.gradient(table.deflection)
    play = (free * step).sum(axis=1)
    row = int(np.argmax(play))
    note = "" if table.setting is None else f"at setting {spoken(table.setting[row], table.units['setting'])}"
    yield Row("play", "Largest range without contact", float(play[row]), table.units["deflection"], note)


def _energy_rows(table: MapTable) -> Iterator[Row]:
    unit = table.units["energy"]
    known = np.isfinite(table.energy) & (table.ok | (table.status == Status.NO_CONTACT))
    rest = np.where(known.any(axis=1), np.where(known, table.energy, np.inf).min(axis=1), np.nan)
    stored = table.energy - rest[:, None]
    peak = extreme(stored, table.ok)
    if peak is None:
        yield Row("energy_capacity", "Energy capacity", None, unit, "no ok point")
        return
    note = f"V minus its least at the same setting, {table.where(peak)}"
    yield Row("energy_capacity", "Energy capacity", float(stored[peak]), unit, note)
    preload = extreme(rest[:, None], np.asarray(table.ok.any(axis=1))[:, None])
    if preload is not None and rest[preload[0]] > 1e-9 * max(float(stored[peak]), 1e-300):
        at = "" if table.setting is None else f"at setting {spoken(table.setting[preload[0]], table.units['setting'])}"
        yield Row("energy_rest", "Largest energy stored at rest", float(rest[preload[0]]), unit, at)


def _adjusting_rows(table: MapTable) -> Iterator[Row]:
    if table.adjusting is None:
        return
    name = table.adjusting_name
    label = f"Largest {name.replace('_', ' ')}"
    peak = extreme(np.abs(table.adjusting), table.ok)
    if peak is None:
        yield Row(f"{name}_peak", label, None, table.units["adjusting"], "no ok point")
        return
    value = float(table.adjusting[peak])
    way = "the drive pushes to larger settings" if value > 0.0 else "the drive holds back from larger settings"
    yield Row(f"{name}_peak", label, abs(value), table.units["adjusting"], f"{table.where(peak)}; {way}")


def _strength_rows(table: MapTable) -> Iterator[Row]:
    if table.stress is None:
        return
    unit = table.units["stress"]
    peak = extreme(table.stress, table.ok)
    stress = None if peak is None else float(table.stress[peak])
    where = "no ok point" if peak is None else table.where(peak)
    if table.unbounded:
        stress, where = None, UNBOUNDED_STRESS
    yield Row("stress_peak", "Largest stress", stress, unit, where)
    if table.strength is None:
        yield Row("utilisation", "Utilisation (largest stress / strength)", None, "1", "no yield strength is given")
        return
    held = "no stress to hold against it" if table.unbounded else ""
    yield Row("strength", "Strength that the stress is held against", table.strength, unit, held)
    used = None if stress is None else stress / table.strength
    note = UNBOUNDED_STRESS if table.unbounded else "over the ok points"
    yield Row("utilisation", "Utilisation (largest stress / strength)", used, "1", note)


def _detail_rows(dataset: xr.Dataset, table: MapTable) -> Iterator[Row]:
    """What only this kind has: the largest size of each number, such as the leaf length needed, and its constants."""
    common = {"status", "energy", table.load_name, "stiffness", table.adjusting_name, "stress"}
    own = sorted(str(name) for name in dataset.data_vars if name not in common)
    for name in (name for name in own if dataset[name].ndim):
        values = np.abs(np.atleast_2d(np.asarray(dataset[name].values, float)))
        peak = extreme(values, table.ok)
        if peak is not None:
            about = dataset[name].attrs
            note = table.where(peak)
            yield Row(f"{name}_max", f"Largest {about['long_name']}", float(values[peak]), str(about["units"]), note)
    for name in (str(name) for name in dataset.data_vars if dataset[name].ndim == 0):
        value, about = float(dataset[name].values), dataset[name].attrs
        label = str(about["long_name"])
        note = str(about.get("comment", ""))
        yield Row(
            name, label[:1].upper() + label[1:], value if math.isfinite(value) else None, str(about["units"]), note
        )


def _validity_rows(table: MapTable) -> Iterator[Row]:
    size = table.status.size
    count = int(table.ok.sum())
    yield Row("points", "Points of the map", float(size), "1")
    yield Row("points_ok", "Points with status ok", float(count), "1", f"{100.0 * count / size:.3g} % of the map")


def _counts(status: npt.NDArray[np.int8], broken_assumption: str) -> Iterator[StatusCount]:
    for entry in Status:
        count = int((status == entry).sum())
        here = f" Here: {broken_assumption}." if entry is Status.OUTSIDE_VALIDITY and broken_assumption else ""
        if count:
            yield StatusCount(entry, count, count / status.size, entry.meaning + here)


def _limits(table: MapTable) -> Iterator[Limit]:
    rows = table.status.shape[0]
    for row in np.unique(np.round(np.linspace(0, rows - 1, min(rows, LIMIT_SETTINGS))).astype(int)):
        yield _limit(table, int(row))


def _limit(table: MapTable, row: int) -> Limit:
    """Walk outward from rest through ok points (and play, which ends nothing) until another status appears."""
    walks = [_walk(table.status[row], table.rest, step) for step in (1, -1)]
    setting = None if table.setting is None else float(table.setting[row])
    rest = _next_to_rest_column(table, row)
    stiffness = None if rest is None else float(table.stiffness[row, rest])
    reached = [(column, status) for column, status in walks if column is not None]
    if not reached:
        ending = next((status for _, status in walks if status is not None), Status.NO_CONTACT)
        return Limit(setting, stiffness, None, None, ending)

    def far(end: tuple[int, Status | None]) -> float:
        # an even grid is even to rounding only: of two ends alike the positive one is named
        return float(f"{abs(table.deflection[end[0]]):.9g}")

    stopped = [end for end in reached if end[1] is not None]
    column, status = min(stopped, key=far) if stopped else max(reached, key=far)
    return Limit(setting, stiffness, float(table.deflection[column]), float(table.load[row, column]), status)


def _walk(status: npt.NDArray[np.int8], start: int, step: int) -> tuple[int | None, Status | None]:
    """Last ok column from the start in one direction, and the status that ends the walk (None: the edge)."""
    last: int | None = None
    column = start
    while 0 <= column < status.size:
        here = Status(int(status[column]))
        if here is Status.OK:
            last = column
        elif here is not Status.NO_CONTACT:
            return last, here
        column += step
    return last, None
