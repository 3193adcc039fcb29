"""Table 3 of Wang et al. (2024): five joints compared, with sources and with the cells that cannot be told apart.

In the text of the paper some rows reach the reader as runs of digits. A run is cut into cells in every way in which
each cell is a number (or a range that rises); a cell that is not the same in every cut is ambiguous.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from enum import StrEnum
from functools import cache
from typing import Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from varistiff.papers.registry import paper_file

OTHERS = ("vsaut_ii", "regt_vsa", "rvsa", "clsm_vsa")  # the order of the columns after the proposed joint
_NUMBER = r"(?:0|[1-9]\d*)(?:\.\d+)?"
_CELL = {"number": re.compile(_NUMBER), "interval": re.compile(rf"{_NUMBER}[–-](?:{_NUMBER}|inf\.)")}


class Cells(StrEnum):
    """What stands in the cells of a row."""

    TEXT = "text"
    NUMBER = "number"
    INTERVAL = "interval"


class Cell(BaseModel):
    """One cell: as printed, or every way to read it, the likely one first.

    Parameters
    ----------
    printed : as printed; of an ambiguous cell the likely reading
    ambiguous : whether the digits around it leave more than one reading
    readings : of an ambiguous cell
    value, interval : parsed, of a cell that is not ambiguous; an open end is infinite
    """

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    printed: str = Field(min_length=1)
    ambiguous: bool = False
    readings: list[str] = Field(default_factory=list)
    value: float | None = Field(None, strict=False)
    interval: tuple[float, float] | None = Field(None, strict=False)

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.ambiguous != (len(self.readings) > 1) or (self.ambiguous and self.readings[0] != self.printed):
            raise ValueError(f"{self.printed}: an ambiguous cell, and no other, has readings, the printed one first")
        if self.ambiguous and (self.value is not None or self.interval is not None):
            raise ValueError(f"{self.printed}: an ambiguous cell has no parsed value")
        return self


class Row(BaseModel):
    """One property of the five joints.

    Parameters
    ----------
    key, item : name, and our words for it
    unit : of the numbers, None for words
    holds : what the cells are
    run : the four last cells as they reach the reader in the text, where nothing separates them
    cells : by joint
    note : why the likely reading is the likely one
    """

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    key: str
    item: str
    unit: str | None = None
    holds: Cells = Field(Cells.TEXT, strict=False)
    run: str | None = None
    cells: dict[str, Cell]
    note: str = ""

    @model_validator(mode="after")
    def _check(self) -> Self:
        if tuple(self.cells) != ("proposed", *OTHERS):
            raise ValueError(f"row {self.key}: cells of {', '.join(('proposed', *OTHERS))}, in this order")
        if self.run is not None:
            cuts = list(splits(self.run, len(OTHERS), self.holds))
            for place, key in enumerate(OTHERS):
                cell, found = self.cells[key], {cut[place] for cut in cuts}
                if found != set(cell.readings or [cell.printed]):
                    raise ValueError(f"row {self.key}, {key}: the run {self.run} can be read as {sorted(found)}")
        return self

    def number(self, joint: str) -> float:
        """Number of a joint; the likely one where the cell is ambiguous."""
        cell = self.cells[joint]
        return float(cell.printed) if cell.value is None else cell.value

    def interval(self, joint: str) -> tuple[float, float]:
        """Range of a joint; the likely one where the cell is ambiguous."""
        cell = self.cells[joint]
        return parse_interval(cell.printed) if cell.interval is None else cell.interval


class Joint(BaseModel):
    """One column: a joint and where the paper takes it from."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    name: str
    reference: int | None = None
    publication: str


class TableThree(BaseModel):
    """The table: joints and rows."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    joints: dict[str, Joint]
    rows: list[Row]

    @model_validator(mode="after")
    def _check(self) -> Self:
        if tuple(self.joints) != ("proposed", *OTHERS):
            raise ValueError("the joints are those of the cells, in this order")
        return self

    def row(self, key: str) -> Row:
        """Row of a property."""
        return next(row for row in self.rows if row.key == key)


def parse_interval(text: str) -> tuple[float, float]:
    """Ends of a printed range; ``inf.`` is infinite.

    >>> parse_interval("220-inf.")
    (220.0, inf)
    """
    low, high = re.split("[–-]", text)
    return float(low), math.inf if high == "inf." else float(high)


def splits(run: str, count: int, holds: str) -> Iterator[tuple[str, ...]]:
    """Every way to cut a run of digits into ``count`` numbers, or ranges that rise.

    >>> list(splits("1.23.4", 2, "number"))
    [('1.2', '3.4')]
    """
    if count == 0:
        if not run:
            yield ()
        return
    for end in range(1, len(run) + 1):
        head = run[:end]
        if not _CELL[str(holds)].fullmatch(head):
            continue
        if holds == "interval":
            low, high = parse_interval(head)
            if low >= high:
                continue
        for tail in splits(run[end:], count - 1, holds):
            yield (head, *tail)


@cache
def load_table_3() -> TableThree:
    """Return the table, validated: every run of digits is cut again and held against the readings in the file."""
    from varistiff.core.textfile import parse_yaml

    (data,) = parse_yaml(paper_file("wang_2024", "table_3.yaml").read_text(encoding="utf-8"))
    return TableThree.model_validate(data)


def computed_cells() -> dict[str, str]:
    """What our model of the proposed joint gives, by row; the other four are no devices of varistiff."""
    from varistiff.papers.wang_2024.limits import largest_torque
    from varistiff.papers.wang_2024.stiffness import softest, stiffest

    low, high = largest_torque()
    return {
        "stiffness": f"N × ({softest()[1]:.0f} to {stiffest():.0f}) from 25 to 6 mm, unbounded at 0",
        "torque": f"N × ({low:.0f} to {high:.0f}), at 6 mm",
    }


def table_3_markdown() -> str:
    """Return the table with what is computed, the ambiguous cells and the sources, as Markdown."""
    table, computed = load_table_3(), computed_cells()
    heads = [_head(joint) for joint in table.joints.values()]
    header = ["property", heads[0], "proposed joint, computed here", *heads[1:]]
    lines = [_line(header), _line(["---"] * len(header))]
    for row in table.rows:
        own, *others = (_cell(row.cells[key]) for key in ("proposed", *OTHERS))
        unit = f" [{row.unit}]" if row.unit else ""
        lines.append(_line([row.item + unit, own, computed.get(row.key, "–"), *others]))
    lines += ["", "† The digits of the row run together; likely reading. What else they can mean:", ""]
    for row in table.rows:
        if any(cell.ambiguous for cell in row.cells.values()):
            cuts = len(list(splits(row.run or "", len(OTHERS), row.holds)))
            lines.append(f"- **{row.item}**, `{row.run}`: {cuts} readings. {row.note}")
            lines += [
                f"  - {joint.name}: {', '.join(row.cells[key].readings)}"
                for key, joint in table.joints.items()
                if row.cells[key].ambiguous
            ]
    lines += ["", "Sources, with the paper's reference numbers:", ""]
    lines += [f"- {_head(joint)}: {joint.publication}" for joint in table.joints.values()]
    return "\n".join(lines) + "\n"


def _head(joint: Joint) -> str:
    return joint.name if joint.reference is None else f"{joint.name} \\[{joint.reference}\\]"


def _cell(cell: Cell) -> str:
    return f"{cell.printed} †" if cell.ambiguous else cell.printed


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
