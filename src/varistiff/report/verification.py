"""A three-dimensional check as files: table, figures and one HTML page."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from datetime import UTC, datetime
from typing import Any

import numpy as np

from varistiff.core.writing import staged_directory
from varistiff.fe.comparison import Comparison, Method
from varistiff.report.display import display
from varistiff.report.figures import comparison as comparison_figure
from varistiff.report.figures import leaf_stress, solid_stress
from varistiff.report.files import saved
from varistiff.report.html import Picture, embedded, filled
from varistiff.report.replaceable import FIGURES, check_replaceable

MARKERS = ("comparison.csv", "comparison.json", "report.html")


def write_verification(
    comparison: Comparison, output: str | os.PathLike[str], *, about: dict[str, str], setting_unit: str
) -> None:
    """Write comparison.csv, comparison.json, figures/ and report.html; together or not at all.

    Parameters
    ----------
    comparison : the methods and their values
    output : directory; made, or replaced if it holds an earlier result
    about : what the result says of itself: title, kind, design, design_hash, versions and more
    setting_unit : SI unit of the setting

    Raises
    ------
    InputError : the directory cannot be written
    """
    check_output(output)
    about = {**about, "created": datetime.now(UTC).isoformat(timespec="seconds")}
    drawings = [comparison_figure.draw(comparison, setting_unit), *solid_stress.draw_all(comparison.fields)]
    if comparison.leaf is not None:
        drawings.append(leaf_stress.draw(comparison.leaf))
    with staged_directory(output) as folder:
        (folder / "comparison.csv").write_text(as_csv(comparison), encoding="utf-8")
        text = json.dumps(as_dict(comparison, about), indent=2, ensure_ascii=False, allow_nan=False)
        (folder / "comparison.json").write_text(text + "\n", encoding="utf-8")
        pictures = [saved(drawing, folder / FIGURES) for drawing in drawings]
        (folder / "report.html").write_text(_page(comparison, about, pictures, setting_unit), encoding="utf-8")


def check_output(output: str | os.PathLike[str]) -> None:
    """Refuse a directory with anything in it that an earlier verification did not write."""
    check_replaceable(output, markers=MARKERS, files=MARKERS)


def as_csv(comparison: Comparison) -> str:
    """One row a setting and method, SI units, 17 significant digits."""
    stream = io.StringIO()
    table = csv.writer(stream, lineterminator="\n")
    table.writerow(["setting", "deflection", "method", comparison.quantity, "error", "difference"])
    for method in comparison.methods:
        difference = comparison.difference(method)
        for row, setting in enumerate(comparison.setting):
            deflection = math.nan if comparison.deflection is None else comparison.deflection[row]
            values = (setting, deflection, method.values[row], method.errors[row], difference[row])
            at, bent, value, error, off = (f"{number:.17g}" for number in values)
            table.writerow([at, bent, method.name, value, error, off])
    for at, value in zip(*(comparison.measured or ((), ())), strict=True):
        table.writerow([f"{at:.17g}", "nan", "measured", f"{value:.17g}", "nan", "nan"])
    return stream.getvalue()


def as_dict(comparison: Comparison, about: dict[str, str]) -> dict[str, Any]:
    """The comparison as plain data; unknown numbers are null."""
    return {
        "about": about,
        "quantity": comparison.quantity,
        "unit": comparison.unit,
        "setting": _plain(comparison.setting),
        "deflection": None if comparison.deflection is None else _plain(comparison.deflection),
        "methods": [
            {
                "name": method.name,
                "label": method.label,
                "values": _plain(method.values),
                "errors": _plain(method.errors),
                "difference": _plain(comparison.difference(method)),
            }
            for method in comparison.methods
        ],
        "measured": None
        if comparison.measured is None
        else {"setting": _plain(comparison.measured[0]), "values": _plain(comparison.measured[1])},
        "assumptions": list(comparison.assumptions),
        "remarks": list(comparison.remarks),
    }


def table_rows(comparison: Comparison, setting_unit: str) -> tuple[list[str], list[list[str]]]:
    """Header and rows of the table for people: a row a setting, a column a method."""
    shown = display(comparison.unit, float(np.nanmax(np.abs(comparison.reference.values))))
    at = display(setting_unit)
    header = [f"setting [{at.unit}]"]
    bent = None
    if comparison.deflection is not None:
        bent = display("rad" if comparison.unit.startswith("N*m") else "m")
        header.append(f"deflection [{bent.unit}]")
    header += [f"{method.label} [{shown.unit}]" for method in comparison.methods]
    places, values = comparison.measured or (np.empty(0), np.empty(0))
    if places.size:
        header.append(f"measured [{shown.unit}]")
    rows = []
    for row, setting in enumerate(comparison.setting):
        cells = [f"{setting * at.factor:.4g}"]
        if bent is not None and comparison.deflection is not None:
            cells.append(f"{comparison.deflection[row] * bent.factor:.4g}")
        cells += [_cell(comparison, method, row, shown.factor) for method in comparison.methods]
        same = np.flatnonzero(np.isclose(places, setting, rtol=1e-6, atol=1e-9))
        if places.size:
            cells.append(
                _difference(values[same[0]], comparison.reference.values[row], shown.factor) if same.size else "-"
            )
        rows.append(cells)
    for place, value in zip(places, values, strict=True):
        if not np.isclose(comparison.setting, place, rtol=1e-6, atol=1e-9).any():
            blank = ["-"] * (len(header) - 2)
            rows.append([f"{place * at.factor:.4g}", *blank, f"{value * shown.factor:.4g}"])
    return header, rows


def _difference(value: float, reference: float, factor: float) -> str:
    text = f"{value * factor:.4g}"
    return f"{text} ({100.0 * (value / reference - 1.0):+.2g} %)" if math.isfinite(reference) else text


def _cell(comparison: Comparison, method: Method, row: int, factor: float) -> str:
    value = float(method.values[row])
    if not math.isfinite(value):
        return "-"
    if method is comparison.reference:
        return f"{value * factor:.4g}"
    return _difference(value, float(comparison.reference.values[row]), factor)


def _plain(values: Any) -> list[float | None]:
    return [float(value) if math.isfinite(value) else None for value in values]


def _page(comparison: Comparison, about: dict[str, str], pictures: list[Picture], setting_unit: str) -> str:
    header, rows = table_rows(comparison, setting_unit)
    errors = [float(np.nanmax(method.errors)) for method in comparison.methods if np.isfinite(method.errors).any()]
    context = {
        "about": about,
        "header": header,
        "rows": rows,
        "error": f"{100.0 * max(errors):.2g} %" if errors else None,
        "reference": comparison.reference.label,
        "assumptions": comparison.assumptions,
        "remarks": comparison.remarks,
        "pictures": [embedded(picture) for picture in pictures],
    }
    return filled("verification.html.j2", context)
