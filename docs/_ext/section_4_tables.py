"""The tables of the page on Section 4 of Wang et al. (2024), from the stored sets."""

from __future__ import annotations

import math
from collections.abc import Sequence

from varistiff.dynamics.drives.motor_table import motor_table
from varistiff.papers.wang_2024.section_4 import POSITION_SETS, stored
from varistiff.papers.wang_2024.section_4_chain import CHAINS, LEAVES, sensed_torque, stiffness_errors
from varistiff.papers.wang_2024.section_4_motors import demand, drives
from varistiff.papers.wang_2024.section_4_table import lines

_ANGLES = ("small", "large")
_UNITS = {
    "load_inertia": "load, inertia, kg m²",
    "load_torque": "load, torque, N m",
    "drive_inertia": "drive, inertia, kg m²",
    "drive_friction": "drive, friction, N m s/rad",
    "proportional": "proportional, N m/rad",
    "integral": "integral, N m/rad/s",
    "derivative": "derivative, N m s/rad",
    "limit": "limit, N m",
    "small": "small stroke, deg",
    "large": "large stroke, deg",
}
_LEAF = {"small": "Eq. (9)", "exact": "exact leaf"}
_CHAIN = {"line": "line of Eq. (16)", "exact": "exact groove"}


def facts() -> str:
    """Return the printed facts beside what the sets give."""
    rows = []
    for line in lines():
        fact = line.fact
        rows.append(
            (
                fact.words,
                fact.locator,
                f"{fact.printed} {fact.unit}",
                f"{line.own:.3g} {fact.unit}",
                _met(line.own_meets),
                "" if line.together is None else f"{line.together:.3g} {fact.unit}",
                "" if line.together_meets is None else _met(line.together_meets),
            )
        )
    return _table(("fact", "where", "printed", "own set", "", "one set for all of the position", ""), rows)


def sets() -> str:
    """Return the numbers of the sets."""
    columns = [stored(name) for name in (*POSITION_SETS, "stiffness")]
    rows = []
    for field, words in _UNITS.items():
        cells = []
        for column in columns:
            value = column.values.get(field)
            angle = field in _ANGLES and value is not None
            cells.append("" if value is None else f"{math.degrees(value) if angle else value:.3g}")
        rows.append((words, *cells))
    rows.append(("simulations", *(str(column.simulations) for column in columns)))
    rows.append(("misses, squared", *(f"{column.cost:.3g}" for column in columns)))
    return _table(("", *(f"`{name}`" for name in (*POSITION_SETS, "stiffness"))), rows)


def motors() -> str:
    """Return what each set asks of its drive, and which motors could give it."""
    rows = []
    for name in POSITION_SETS:
        need = demand(name)
        found = [f"`{one.motor}` {one.lowest:.0f} to {one.highest:.0f}" for one in drives(name)]
        rows.append(
            (
                f"`{name}`",
                f"{need.rate:.1f} rad/s",
                f"{need.torque:.1f} N m",
                f"{need.torque_rms:.1f} N m",
                f"{len(found)} of {len(motor_table())}: {', '.join(found[:3]) or 'none'}",
            )
        )
    return _table(("set", "fastest", "limit", "rms in the sine, load", "motors, the first with their ratios"), rows)


def chains() -> str:
    """Return the stiffness errors of both chains and both leaves in the closed loop."""
    rows = []
    for leaf in LEAVES:
        for chain in CHAINS:
            free, loaded = (stiffness_errors(leaf=leaf, chain=chain, loaded=loaded) for loaded in (False, True))
            cells = (f"{value:.2f}" for value in (free.first, free.later, loaded.first, loaded.later))
            rows.append((_LEAF[leaf], _CHAIN[chain], *cells))
    return _table(("leaf of the plant", "chain of the controller", *_ERRORS), rows)


_ERRORS = ("no load, N m/rad", "after 1 s", "load, N m/rad", "after 1 s")


def sensing() -> str:
    """Return how far the sensed external torque lies from the true one."""
    rows = []
    for leaf in LEAVES:
        found = sensed_torque(leaf=leaf)
        rows.append((_LEAF[leaf], *(f"{value:.2g}" for value in found)))
    header = (
        "leaf of the plant",
        "true torque, largest, N m",
        "error of Eq. (9) alone",
        "error less the link's own, N m",
    )
    return _table(header, rows)


def _met(met: bool) -> str:
    return "met" if met else "**not met**"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(row) + " |" for row in (head, *rows)]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])


PAGES = {
    "wang_section_4_facts": facts,
    "wang_section_4_sets": sets,
    "wang_section_4_motors": motors,
    "wang_section_4_chains": chains,
    "wang_section_4_sensing": sensing,
}
