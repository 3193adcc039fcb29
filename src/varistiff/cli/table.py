"""Tables that the command line writes: results as CSV, materials as text."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, TextIO

from varistiff.cli.points import PointsTable
from varistiff.core.status import Status
from varistiff.materials import Material, Property

if TYPE_CHECKING:
    from varistiff.design.design import Design


def columns(design: Design) -> list[str]:
    """Return the header of the results: the load and the adjusting load are named by what they are."""
    load = "force" if design.deflection_unit == "m" else "torque"
    adjusting = "adjusting_torque" if design.setting_unit == "rad" else "adjusting_force"
    return ["deflection", "setting", "status", "energy", load, "stiffness", adjusting, "stress"]


def write_results(stream: TextIO, design: Design, points: PointsTable) -> dict[Status, int]:
    """Evaluate the points and write one row each, in order; return how many points have which status."""
    stream.write(",".join(columns(design)) + "\n")
    if not points.deflection:
        return {}
    import numpy as np

    deflection = np.frombuffer(points.deflection, dtype=np.float64)
    setting = np.frombuffer(points.setting, dtype=np.float64)
    answer = design.evaluate(deflection, setting if design.setting_unit is not None else None)
    status = [int(code) for code in np.asarray(answer.status)]
    numbers = [
        np.asarray(field, dtype=np.float64).tolist()
        for field in (answer.energy, answer.load, answer.stiffness, answer.adjusting_load, answer.stress)
    ]
    labels = {int(each): each.label for each in Status}
    for at, left, code, *right in zip(deflection.tolist(), setting.tolist(), status, *numbers, strict=True):
        cells = [number(at), number(left), labels[code], *map(number, right)]
        stream.write(",".join(cells) + "\n")
    return {Status(code): count for code, count in Counter(status).items()}


def number(value: float) -> str:
    """Return a number with 17 significant digits, which give back the double; ``nan`` and ``inf`` stay."""
    return format(value, ".17g")


def material_lines(materials: Iterable[Material], *, sources: bool) -> Iterator[str]:
    """Yield a table of materials, line by line."""
    head = ("material", "E GPa", "G GPa", "kg/m^3", "yield MPa", "fatigue MPa", "name")
    rows = [
        (
            material.key,
            _cell(material.youngs_modulus, 1e9),
            _cell(material.shear_modulus, 1e9),
            _cell(material.density, 1.0),
            _cell(material.yield_strength, 1e6),
            _cell(material.fatigue_limit, 1e6),
            material.name,
        )
        for material in materials
    ]
    widths = [max(len(row[column]) for row in (head, *rows)) for column in range(len(head) - 1)]
    for row, material in zip((head, *rows), (None, *materials), strict=True):
        numbers = [cell.rjust(width) for cell, width in zip(row[1:-1], widths[1:], strict=True)]
        yield "  ".join([row[0].ljust(widths[0]), *numbers, row[-1]])
        if sources and material is not None:
            for name in ("youngs_modulus", "shear_modulus", "density", "yield_strength", "fatigue_limit"):
                known: Property | None = getattr(material, name)
                if known is not None:
                    yield f"    {name}: {known.source}"


def _cell(known: Property | None, unit: float) -> str:
    return "-" if known is None else f"{known.value / unit:.6g}"
