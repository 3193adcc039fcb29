"""The points file of ``varistiff evaluate``: CSV in SI units, checked cell by cell."""

from __future__ import annotations

import csv
import io
import math
import os
import re
from array import array
from collections.abc import Iterator
from dataclasses import dataclass

from varistiff.core.errors import InputError
from varistiff.core.suggest import nearest, printable, quoted
from varistiff.core.textfile import printable_path, read_text

POINTS_LIMIT = 50_000_000  # bytes; about a million points
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?", re.ASCII)
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)", re.IGNORECASE)
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
    file = printable_path(os.fspath(path))
    text = read_text(path, limit=POINTS_LIMIT)
    try:
        return _points(text, has_setting)
    except InputError as error:
        raise error.located(file=file) from None


def _points(text: str, has_setting: bool) -> PointsTable:
    rows = _rows(text)
    _, header = next(rows, (0, []))
    names = [name.strip() for name in header]
    deflection_column = _column(names, "deflection", header)
    setting_column = _column(names, "setting", header) if has_setting or "setting" in names else None
    ignored = tuple(printable(name) for name in names if name not in ("deflection", "setting"))
    deflection, setting = array("d"), array("d")
    for number, (line, row) in enumerate(rows, start=1):
        if len(row) != len(names):
            cells = "1 cell" if len(row) == 1 else f"{len(row)} cells"
            raise InputError(f"has {cells}; allowed are {len(names)}, as in the header", field=_row(number, line))
        deflection.append(_number(row[deflection_column], number, line, "deflection"))
        if setting_column is None or (not has_setting and row[setting_column].strip().lower() in _NO_VALUE):
            setting.append(math.nan)
        else:
            setting.append(_number(row[setting_column], number, line, "setting"))
    return PointsTable(deflection=deflection, setting=setting, ignored=ignored)


def _rows(text: str) -> Iterator[tuple[int, list[str]]]:
    """Yield line number and cells of every row that is not blank."""
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    try:
        for row in reader:
            if len(row) > 1 or (row and row[0].strip()):
                yield reader.line_num, row
    except csv.Error as error:
        raise InputError(f"is not CSV: {error}", field=f"line {reader.line_num}") from None


def _column(names: list[str], wanted: str, header: list[str]) -> int:
    count = names.count(wanted)
    if count == 1:
        return names.index(wanted)
    if count > 1:
        raise InputError(f"the column {wanted} is there {count} times; allowed is once", field="header")
    if len(header) == 1 and (";" in header[0] or "\t" in header[0]):
        raise InputError("the columns are not separated by commas; allowed: deflection,setting", field="header")
    match = nearest(wanted, [name for name in names if name not in ("deflection", "setting")])
    hint = f" (is {quoted(match)} meant?)" if match else ""
    raise InputError(f"the column {wanted} is missing{hint}; allowed: deflection,setting", field="header")


def _number(cell: str, number: int, line: int, column: str) -> float:
    text = cell.strip()
    where = f"{_row(number, line)}, column {column}"
    if not text:
        raise InputError("is blank; allowed is a finite number in SI units", field=where)
    if _NOT_FINITE.fullmatch(text):
        raise InputError(f"{quoted(text)} is not finite; allowed is a finite number in SI units", field=where)
    if len(text) > 400 or not _NUMBER.fullmatch(text):
        raise InputError(f"{quoted(text)} is not a number; allowed is a finite number in SI units", field=where)
    value = float(text)
    if not math.isfinite(value):
        raise InputError(f"{quoted(text)} is too large; allowed is a finite number in SI units", field=where)
    return value


def _row(number: int, line: int) -> str:
    return f"row {number} (line {line})"
