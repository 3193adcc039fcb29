"""Outlines of cross-sections from files: corners as CSV, drawings as DXF."""

from __future__ import annotations

import csv
import io
import os
import re
from collections.abc import Iterator
from pathlib import Path

from varistiff.core.errors import InputError
from varistiff.core.number_cell import NUMBER, parse_cell
from varistiff.core.suggest import quoted, unknown
from varistiff.core.textfile import printable_path, read_text
from varistiff.sections.loops import check_loops
from varistiff.sections.outline import Loop
from varistiff.sections.polygon_loops import loop_of_points

CSV_LIMIT = 1_000_000  # bytes; a thousand corners have about 30 000
_COLUMNS = ("x", "y", "loop")
_WHOLE = re.compile(r"[0-9]{1,9}", re.ASCII)


def read_outline(path: str | os.PathLike[str], *, unit: float | None = None) -> tuple[Loop, ...]:
    """Return the loops of a cross-section from a ``.csv`` or ``.dxf`` file [m], checked by ``check_loops``.

    A CSV file has the columns ``x`` and ``y``, one corner a row. With a third column ``loop``, loop 0 is the outer one;
    without it a blank line begins a hole. Of a DXF file see ``dxf_loops``. Coordinates stay as they are: J does not
    depend on where the origin lies.

    Parameters
    ----------
    unit : what 1 in the file stands for [m]; a DXF file may state it itself

    Raises
    ------
    InputError : an unreadable file, no unit or two, or loops that bound no cross-section; says where
    """
    file = printable_path(os.fspath(path))
    suffix = Path(path).suffix.lower()
    if suffix == ".csv":
        if unit is None:
            raise InputError("is missing; allowed is the unit of the numbers in the file, such as mm", field="unit")
        text = read_text(path, limit=CSV_LIMIT)
        try:
            names, loops = _csv_loops(text, unit)
            return check_loops(loops, names)
        except InputError as error:
            raise error.located(file=file) from None
    if suffix == ".dxf":
        from varistiff.design.outline_dxf import dxf_loops

        drawn = dxf_loops(path, unit=unit)
        try:
            return check_loops(drawn, ["the largest loop", *(f"hole {number}" for number in range(1, len(drawn)))])
        except InputError as error:
            raise error.located(file=file) from None
    raise InputError(f"ends in {quoted(suffix)}; allowed are files that end in .csv or .dxf", field="file")


def _csv_loops(text: str, unit: float) -> tuple[list[str], list[Loop]]:
    """Names and loops, the outer one first."""
    corners: dict[int, list[tuple[float, float]]] = {}
    number = 0
    for line, cells in _rows(text):
        where = f"line {line}"
        if "loop" in cells:
            previous, number = number, _loop_number(cells["loop"], where)
            if number in corners and number != previous:
                raise InputError(
                    f"loop {number} goes on after loop {previous}; allowed is one loop at a time", field=where
                )
        elif not cells:  # a blank line
            number = len(corners)
            continue
        x, y = (parse_cell(cells[name], where=f"{where}, column {name}", unit="without a unit") for name in "xy")
        corners.setdefault(number, []).append((unit * x, unit * y))
    if 0 not in corners:
        raise InputError("has no loop 0; allowed is loop 0 as the outer one, its corners as rows below the header")
    order = sorted(corners)
    return [f"loop {number}" for number in order], [loop_of_points(corners[number]) for number in order]


def _rows(text: str) -> Iterator[tuple[int, dict[str, str]]]:
    """Line number and cells by column of each row below the header; no cells for a blank line between loops."""
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    names: list[str] = []
    try:
        for cells in reader:
            blank = not any(cell.strip() for cell in cells)
            if not names and not blank:
                names = _header(cells)
            elif names and blank and "loop" not in names:
                yield reader.line_num, {}
            elif not blank:
                if len(cells) != len(names):
                    counted = "1 cell" if len(cells) == 1 else f"{len(cells)} cells"
                    raise InputError(
                        f"has {counted}; allowed are {len(names)}, as in the header", field=f"line {reader.line_num}"
                    )
                yield reader.line_num, dict(zip(names, cells, strict=True))
    except csv.Error as error:
        raise InputError(f"is not CSV: {error}", field=f"line {reader.line_num}") from None


def _header(cells: list[str]) -> list[str]:
    names = [cell.strip() for cell in cells]
    if len(names) == 1 and (";" in names[0] or "\t" in names[0]):
        raise InputError("the columns are not separated by commas; allowed: x,y or x,y,loop", field="header")
    if names and NUMBER.fullmatch(names[0]):
        raise InputError("is missing; allowed is a first line x,y or x,y,loop", field="header")
    for name in names:
        if name not in _COLUMNS:
            raise InputError(unknown("column", name, _COLUMNS), field="header")
        if names.count(name) > 1:
            raise InputError(f"the column {name} is there {names.count(name)} times; allowed is once", field="header")
    for name in ("x", "y"):
        if name not in names:
            raise InputError(f"the column {name} is missing; allowed: x,y or x,y,loop", field="header")
    return names


def _loop_number(cell: str, where: str) -> int:
    text = cell.strip()
    if not _WHOLE.fullmatch(text):
        said = f"{quoted(text)} is not a whole number" if text else "is blank"
        raise InputError(
            f"{said}; allowed is 0 for the outer loop, 1 and more for holes", field=f"{where}, column loop"
        )
    return int(text)
