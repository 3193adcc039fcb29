"""Trajectories from files: CSV with units, and OpenSim's .sto and .mot; nothing is guessed about unit or sign."""

from __future__ import annotations

import csv
import io
import math
import os
import re
from array import array
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from varistiff.core.errors import InputError
from varistiff.core.number_cell import NUMBER, parse_cell
from varistiff.core.quantity import ANGLE, ENERGY, FORCE, LENGTH, TIME, TORQUE, Kind, parse_quantity
from varistiff.core.suggest import nearest, printable, quoted
from varistiff.core.textfile import printable_path, read_text

TRAJECTORY_LIMIT = 20_000_000  # bytes
ROWS_LIMIT = 200_000  # a minute and a half at 2 kHz
TORQUE_PER_MASS = Kind(
    "a torque per body mass",
    "0.6 N*m/kg",
    "N*m/kg",
    ((("force", 1), ("length", 1), ("mass", -1)), (("angle", -1), ("energy", 1), ("mass", -1))),
)

_TIME = "time"
_OPENSIM_SI = (LENGTH, FORCE, TORQUE, ENERGY)  # OpenSim writes these in SI units; an angle's unit is in the header
_ENTRY = re.compile(r"([A-Za-z_]+)\s*[=\s]\s*(\S.*)")
_WHOLE = re.compile(r"[0-9]{1,9}", re.ASCII)
_HEADER_LINES = 200


@dataclass(frozen=True, slots=True)
class TrajectoryColumn:
    """A column that is wanted of a file.

    Parameters
    ----------
    name : as in the file, without its unit
    kind : what it must measure
    sign : +1, or -1 where the file counts the other direction positive
    unit : where the file states none; where it states one, the same
    """

    name: str
    kind: Kind
    sign: int
    unit: str | None = None


@dataclass(frozen=True, slots=True)
class Trajectory:
    """Columns of a file over time, in SI units and with the caller's signs.

    Parameters
    ----------
    times : [s], strictly increasing, as in the file
    values : by name of the column
    ignored : columns that are not used
    """

    times: array[float]
    values: dict[str, array[float]]
    ignored: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Table:
    """A file taken apart: labels with their units, and rows of cells with where they stand."""

    names: list[str]
    units: list[str | None]
    rows: Iterator[tuple[str, list[str]]]
    declared_rows: int | None = None
    degrees: bool | None = None  # OpenSim's inDegrees
    opensim: bool = False


def read_trajectory(
    path: str | os.PathLike[str], columns: Sequence[TrajectoryColumn], *, time_unit: str | None = None
) -> Trajectory:
    """Return columns of a ``.csv``, ``.sto`` or ``.mot`` file over its column ``time``.

    CSV: a header such as ``time [s],knee_angle [deg]``, then numbers, separated by commas. OpenSim: a header that ends
    with ``endheader``, a line of labels, then numbers; time is in seconds, angles in what ``inDegrees`` says, forces,
    torques and lengths in SI units unless the caller declares another unit. Other columns may hold anything.

    Parameters
    ----------
    columns : what is wanted, each with its kind and sign
    time_unit : of a CSV file whose header states none

    Raises
    ------
    InputError : an unreadable or too large file, a missing column, a unit that is missing, contradicts or is of another
        kind, a cell that is no finite number, or time that does not increase; says file, row and column
    """
    file = printable_path(os.fspath(path))
    for column in columns:
        if column.sign not in (1, -1):
            raise InputError(f"is {quoted(column.sign)}; allowed is +1 or -1", field="sign")
    suffix = Path(path).suffix.lower()
    if suffix not in (".csv", ".sto", ".mot"):
        problem = f"ends in {quoted(suffix)}; allowed are files that end in .csv, .sto or .mot"
        raise InputError(problem, file=file)
    text = read_text(path, limit=TRAJECTORY_LIMIT)
    try:
        table = _csv_table(text) if suffix == ".csv" else _opensim_table(text)
        return _read(table, columns, time_unit)
    except InputError as error:
        raise error.located(file=file) from None


def _read(table: _Table, columns: Sequence[TrajectoryColumn], time_unit: str | None) -> Trajectory:
    wanted = [column.name for column in columns]
    time_place, *places = (_place(table.names, name) for name in (_TIME, *wanted))
    time = TrajectoryColumn(_TIME, TIME, 1, time_unit)
    time_factor = _factor(table, time_place, time)
    factors = [column.sign * _factor(table, place, column) for place, column in zip(places, columns, strict=True)]
    times = array("d")
    values = [array("d") for _ in columns]
    for where, cells in table.rows:
        if len(times) == ROWS_LIMIT:
            raise InputError(f"has more than {ROWS_LIMIT} rows; allowed are at most that many", field=where)
        if len(cells) != len(table.names):
            counted = "1 cell" if len(cells) == 1 else f"{len(cells)} cells"
            raise InputError(f"has {counted}; allowed are {len(table.names)}, as in the header", field=where)
        times.append(_number(cells[time_place], time_factor, where, _TIME))
        if len(times) > 1 and times[-1] <= times[-2]:
            raise InputError(
                f"{quoted(cells[time_place])} is not later than the row before; allowed is increasing time",
                field=f"{where}, column {_TIME}",
            )
        for own, place, factor, name in zip(values, places, factors, wanted, strict=True):
            own.append(_number(cells[place], factor, where, name))
    if table.declared_rows is not None and len(times) != table.declared_rows:
        raise InputError(
            f"declares {table.declared_rows} rows and has {len(times)}; allowed are as many as declared", field="nRows"
        )
    if len(times) < 2:
        raise InputError(f"has {len(times)} rows of numbers; allowed are at least 2")
    ignored = tuple(printable(name) for name in table.names if name not in (_TIME, *wanted))
    return Trajectory(times, dict(zip(wanted, values, strict=True)), ignored)


def _number(cell: str, factor: float, where: str, name: str) -> float:
    field = f"{where}, column {printable(name)}"
    value = factor * parse_cell(cell, where=field, unit="without a unit")
    if not math.isfinite(value):
        raise InputError(f"{quoted(cell)} is too large; allowed is a finite number in SI units", field=field)
    return value + 0.0  # -1 times 0 is 0


def _place(names: list[str], wanted: str) -> int:
    count = names.count(wanted)
    if count == 1:
        return names.index(wanted)
    if count > 1:
        raise InputError(f"the column {printable(wanted)} is there {count} times; allowed is once", field="header")
    if names and NUMBER.fullmatch(names[0]):
        raise InputError("is missing; allowed is a first line such as time [s],knee_angle [deg]", field="header")
    match = nearest(wanted, names)
    hint = f" (is {quoted(match)} meant?)" if match else ""
    allowed = ", ".join(printable(name) for name in names[:12])
    raise InputError(f"the column {printable(wanted)} is missing{hint}; the file has {allowed}", field="header")


def _factor(table: _Table, place: int, column: TrajectoryColumn) -> float:
    """SI value of 1 in a column."""
    stated, kind = table.units[place], column.kind
    if table.opensim and kind is TIME:
        stated = "s"
    elif table.opensim and kind is ANGLE and table.degrees is not None:
        stated = "deg" if table.degrees else "rad"
    field = f"column {printable(column.name)}"
    factors = [_unit(unit, kind, field) for unit in (stated, column.unit) if unit is not None]
    if len(factors) == 2 and factors[0] != factors[1]:
        raise InputError(f"is declared in {quoted(column.unit)}, but the file states {quoted(stated)}", field=field)
    if factors:
        return factors[0]
    if table.opensim and kind in _OPENSIM_SI:
        return 1.0
    where = "inDegrees=yes or no in the header" if table.opensim else f"{printable(column.name)} [...] in the header"
    raise InputError(f"has no unit; allowed is {where}, or a declared unit; {kind.allowed()}", field=field)


def _unit(unit: str, kind: Kind, field: str) -> float:
    try:
        return parse_quantity(f"1 {unit}", kind)
    except InputError as error:
        raise error.located(field=field) from None


# --- CSV


def _csv_table(text: str) -> _Table:
    rows = _csv_rows(text)
    _, header = next(rows, ("", []))
    if len(header) == 1 and (";" in header[0] or "\t" in header[0]):
        raise InputError("the columns are not separated by commas", field="header")
    labels = [_label(cell) for cell in header]
    return _Table([name for name, _ in labels], [unit for _, unit in labels], _numbered(rows))


def _label(cell: str) -> tuple[str, str | None]:
    """Name and unit of a header's cell; no expression that could take long on a hostile one."""
    name, opened, rest = cell.partition("[")
    unit, closed, tail = rest.partition("]")
    if bool(opened) != bool(closed) or tail.strip() or "[" in unit or "]" in name:
        raise InputError(f"cannot read {quoted(cell.strip())}; allowed is name or name [unit]", field="header")
    return name.strip(), unit.strip() if opened else None


def _csv_rows(text: str) -> Iterator[tuple[str, list[str]]]:
    """Yield line and cells of every row that is not blank."""
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    try:
        for row in reader:
            if any(cell.strip() for cell in row):
                yield f"line {reader.line_num}", row
    except csv.Error as error:
        raise InputError(f"is not CSV: {error}", field=f"line {reader.line_num}") from None


def _numbered(rows: Iterator[tuple[str, list[str]]]) -> Iterator[tuple[str, list[str]]]:
    for number, (line, cells) in enumerate(rows, start=1):
        yield f"row {number} ({line})", cells


# --- OpenSim


def _opensim_table(text: str) -> _Table:
    lines = ((f"line {number}", line) for number, line in enumerate(io.StringIO(text), start=1))
    entries = _opensim_header(lines)
    labels = next((line.split("\t") if "\t" in line else line.split() for _, line in lines if line.strip()), [])
    names = [label.strip() for label in labels]
    while names and not names[-1]:  # a tab at the end of the line
        names.pop()
    declared = _count(entries, "ncolumns", "datacolumns")
    if declared is not None and declared != len(names):
        raise InputError(
            f"declares {declared} columns and has {len(names)}; allowed are as many as declared", field="nColumns"
        )
    rows = ((line, cells.split()) for line, cells in lines if cells.strip())
    return _Table(
        names,
        [None] * len(names),
        _numbered(rows),
        declared_rows=_count(entries, "nrows", "datarows"),
        degrees=_degrees(entries),
        opensim=True,
    )


def _opensim_header(lines: Iterator[tuple[str, str]]) -> dict[str, str]:
    """Entries of a header by lower-case name, read up to and including ``endheader``."""
    entries: dict[str, str] = {}
    for number, (_, line) in enumerate(lines, start=1):
        if line.strip().lower() == "endheader":
            return entries
        if number > _HEADER_LINES:
            break
        match = _ENTRY.fullmatch(line.strip())
        if match:  # the first line is a title, and comments are allowed
            entries[match[1].lower()] = match[2].strip()
    raise InputError(f"has no endheader in its first {_HEADER_LINES} lines; allowed is an OpenSim file", field="header")


def _count(entries: dict[str, str], *names: str) -> int | None:
    for name in names:
        if name in entries:
            if not _WHOLE.fullmatch(entries[name]):
                raise InputError(f"is {quoted(entries[name])}; allowed is a whole number", field=name)
            return int(entries[name])
    return None


def _degrees(entries: dict[str, str]) -> bool | None:
    said = entries.get("indegrees")
    if said is None:
        return None
    if said.lower() not in ("yes", "no"):
        raise InputError(f"is {quoted(said)}; allowed is yes or no", field="inDegrees")
    return said.lower() == "yes"
