"""The points file of ``varistiff evaluate``: CSV in SI units, checked cell by cell."""

from __future__ import annotations

import csv
import io
import math
import os
from array import array
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from varistiff.core.errors import InputError
from varistiff.core.number_cell import parse_cell
from varistiff.core.suggest import nearest, printable, quoted
from varistiff.core.textfile import printable_path, read_text

POINTS_LIMIT = 50_000_000  # bytes; about a million points
_NO_VALUE = ("", "nan")


@dataclass(frozen=True, slots=True)
class PointsTable:
    """Points in the order of the file.

    Parameters
    ----------
    deflection, setting : SI values; the setting is NaN where the kind has none
    ignored : columns that are not used
    """

    deflection: array[float]
    setting: array[float]
    ignored: tuple[str, ...]


def read_points(path: str | os.PathLike[str], *, has_setting: bool) -> PointsTable:
    """Return the points of a CSV file with the columns ``deflection`` and ``setting``.

    Parameters
    ----------
    has_setting : whether the design's kind has a setting; without one the column may be absent or empty

    Raises
    ------
    InputError : unreadable file, a missing column, or a cell that is no finite number; says the row
    """
    columns, ignored = read_columns(path, ("deflection", "setting"), unused=() if has_setting else ("setting",))
    setting = columns.get("setting", array("d", [math.nan]) * len(columns["deflection"]))
    return PointsTable(deflection=columns["deflection"], setting=setting, ignored=ignored)


def read_columns(
    path: str | os.PathLike[str], wanted: Sequence[str], *, unused: Sequence[str] = ()
) -> tuple[dict[str, array[float]], tuple[str, ...]]:
    """Return columns of a CSV file by name, SI values in the order of the file, and the names of all others.

    Parameters
    ----------
    wanted : names of the columns
    unused : of these, columns without a meaning here: they may be absent, and their cells empty or nan

    Raises
    ------
    InputError : unreadable file, a missing column, or a cell that is no finite number; says the row
    """
    file = printable_path(os.fspath(path))
    text = read_text(path, limit=POINTS_LIMIT)
    try:
        return _columns(text, wanted, unused)
    except InputError as error:
        raise error.located(file=file) from None


def _columns(
    text: str, wanted: Sequence[str], unused: Sequence[str]
) -> tuple[dict[str, array[float]], tuple[str, ...]]:
    rows = _rows(text)
    _, header = next(rows, (0, []))
    names = [name.strip() for name in header]
    places = {name: _column(names, name, header, wanted) for name in wanted if name not in unused or name in names}
    ignored = tuple(printable(name) for name in names if name not in wanted)
    found = {name: array("d") for name in places}
    for number, (line, row) in enumerate(rows, start=1):
        if len(row) != len(names):
            cells = "1 cell" if len(row) == 1 else f"{len(row)} cells"
            raise InputError(f"has {cells}; allowed are {len(names)}, as in the header", field=_row(number, line))
        for name, place in places.items():
            if name in unused and row[place].strip().lower() in _NO_VALUE:
                found[name].append(math.nan)
            else:
                found[name].append(parse_cell(row[place], where=f"{_row(number, line)}, column {name}"))
    return found, ignored


def _rows(text: str) -> Iterator[tuple[int, list[str]]]:
    """Yield line number and cells of every row that is not blank."""
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    try:
        for row in reader:
            if len(row) > 1 or (row and row[0].strip()):
                yield reader.line_num, row
    except csv.Error as error:
        raise InputError(f"is not CSV: {error}", field=f"line {reader.line_num}") from None


def _column(names: list[str], wanted: str, header: list[str], others: Sequence[str]) -> int:
    count = names.count(wanted)
    if count == 1:
        return names.index(wanted)
    if count > 1:
        raise InputError(f"the column {wanted} is there {count} times; allowed is once", field="header")
    if len(header) == 1 and (";" in header[0] or "\t" in header[0]):
        raise InputError(f"the columns are not separated by commas; allowed: {','.join(others)}", field="header")
    match = nearest(wanted, [name for name in names if name not in others])
    hint = f" (is {quoted(match)} meant?)" if match else ""
    raise InputError(f"the column {wanted} is missing{hint}; allowed: {','.join(others)}", field="header")


def _row(number: int, line: int) -> str:
    return f"row {number} (line {line})"
