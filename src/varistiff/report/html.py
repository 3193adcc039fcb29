"""One HTML file that holds everything: no script, no font, no picture from elsewhere."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import xarray as xr
from jinja2 import Environment, PackageLoader
from markupsafe import Markup, escape

from varistiff.characteristic.datasheet import UNBOUNDED_STRESS, Datasheet, Limit, Row
from varistiff.core.citations import citation
from varistiff.core.errors import InputError
from varistiff.report.display import MISSING, display, number
from varistiff.report.view import View

KIND_NAMES = {
    "antagonistic_leaves": "Antagonistic leaf springs",
    "maccepa": "MACCEPA",
    "roller_beam": "Roller beam",
    "series_elastic": "Series elastic actuator",
    "slider_leaf_joint": "Slider leaf joint",
    "torsion_tube": "Variable torsion stiffness",
}
KEY_ROWS = (
    "stiffness_rest",
    "stiffness_rest_min",
    "stiffness_rest_max",
    "stiffness_rest_ratio",
    "torque_peak",
    "force_peak",
    "deflection_limit",
    "deflection_limit_max",
    "energy_capacity",
    "adjusting_force_peak",
    "adjusting_torque_peak",
    "utilisation",
)


@dataclass(frozen=True)
class Picture:
    """A figure as the report embeds it."""

    name: str
    title: str
    caption: str
    svg: str


def render_report(
    dataset: xr.Dataset,
    sheet: Datasheet,
    pictures: Sequence[Picture],
    *,
    warnings: Sequence[str] = (),
    path: str = "",
) -> str:
    """Return the report's HTML; everything that a user wrote is escaped.

    Parameters
    ----------
    dataset : the characteristic map with its provenance
    sheet : its datasheet
    pictures : figures in the order of the report; the one named ``mechanism`` comes first, on its own
    warnings : sentences about the design
    path : design file, as the user wrote it
    """
    view = View.of(dataset)
    shown = [embedded(picture) for picture in pictures]
    attrs = dataset.attrs
    context = {
        "name": sheet.name or "Unnamed design",
        "kind_name": KIND_NAMES.get(sheet.kind, sheet.kind),
        "summary": one_line(sheet),
        "warnings": list(warnings),
        "tiles": [_shown(row, short=True) for row in _key_rows(sheet)],
        "mechanism": next((picture for picture in shown if picture["name"] == "mechanism"), None),
        "figures": [picture for picture in shown if picture["name"] != "mechanism"],
        "groups": [{"title": group.title, "rows": [_shown(row) for row in group.rows]} for group in sheet.groups],
        "setting_name": None if view.setting is None else view.setting_name,
        "load_name": view.load_name.capitalize(),
        "limits": [_limit(limit, sheet.units) for limit in sheet.limits],
        "steps": _steps(view),
        "statuses": [
            {
                "label": entry.status.label,
                "count": entry.count,
                "share": f"{100.0 * entry.fraction:.3g} %",
                "meaning": entry.meaning,
                "remedy": entry.status.remedy,
            }
            for entry in sheet.statuses
        ],
        "shown_units": _shown_units(sheet),
        "sources": [_source(key) for key in _keys(attrs.get("references", ""))],
        "sign_convention": attrs.get("sign_convention", ""),
        "version": attrs.get("varistiff_version", ""),
        "versions": attrs.get("versions", ""),
        "created": attrs.get("created", ""),
        "design_hash": attrs.get("design_hash", ""),
        "design_text": attrs.get("design", ""),
        "path": path,
    }
    return filled("report.html.j2", context)


def filled(template: str, context: Mapping[str, Any]) -> str:
    """Fill one of the templates; everything in ``context`` that is not Markup is escaped."""
    loader = PackageLoader("varistiff.report", "templates")
    environment = Environment(loader=loader, autoescape=True, trim_blocks=True, lstrip_blocks=True)
    return environment.get_template(template).render(context)


def one_line(sheet: Datasheet) -> str:
    """The actuator in one sentence: stiffness, load, deflection, and how much of the map may be used."""
    keys = {row.key: row for row in sheet.rows}
    parts: list[str] = []
    low, high = keys.get("stiffness_ok_min"), keys.get("stiffness_ok_max")
    if low is not None and high is not None and low.value is not None and high.value is not None:
        unit = display(low.unit, high.value)
        same = abs(high.value - low.value) <= 1e-6 * abs(high.value)
        span = number(high.value * unit.factor)
        if not same:
            span = f"{number(low.value * unit.factor)} to {span}"
        parts.append(f"tangent stiffness {span} {unit.unit}")
    load = keys.get("torque_peak") or keys.get("force_peak")
    if load is not None and load.value is not None:
        name = load.key.removesuffix("_peak")
        parts.append(f"{name} up to {display(load.unit, load.value).text(load.value)}")
    reach = keys.get("deflection_limit_max") or keys.get("deflection_limit")
    if reach is not None:
        parts.append(f"deflection up to {display(reach.unit).text(reach.value)}")
    good = next((entry.fraction for entry in sheet.statuses if entry.status == 0), 0.0)
    text = "; ".join(parts) or "No point of the map is ok"
    line = f"{text[:1].upper()}{text[1:]}. {100.0 * good:.3g} % of the map is ok."
    stress = keys.get("stress_peak")
    if stress is not None and stress.note == UNBOUNDED_STRESS:
        line += f" {UNBOUNDED_STRESS[:1].upper()}{UNBOUNDED_STRESS[1:]}."
    return line


def _key_rows(sheet: Datasheet) -> Iterator[Row]:
    rows = {row.key: row for row in sheet.rows}
    return (rows[key] for key in KEY_ROWS if key in rows)


def _shown(row: Row, *, short: bool = False) -> dict[str, str]:
    if row.key == "utilisation" and row.value is not None:
        value = f"{number(100.0 * row.value)} %"
    elif row.unit == "1" and row.value is not None and row.key.startswith("points"):
        value = f"{row.value:.0f}"
    else:
        value = display(row.unit, abs(row.value or 0.0)).text(row.value)
    return {"label": row.label, "value": value, "note": row.note.split(";")[0] if short else row.note}


def _limit(limit: Limit, units: dict[str, str]) -> dict[str, str]:
    def text(value: float | None, unit: str) -> str:
        return MISSING if value is None else display(unit, abs(value)).text(value)

    ending = "edge of the map" if limit.status is None else limit.status.label.replace("_", " ")
    return {
        "setting": text(limit.setting, units["setting"]),
        "stiffness": text(limit.stiffness, units["stiffness"]),
        "deflection": text(limit.deflection, units["deflection"]),
        "load": text(limit.load, units["load"]),
        "ending": ending,
    }


def _steps(view: View) -> str:
    parts = []
    if view.deflection.size > 1:
        parts.append(f"{view.deflection_display.text(float(view.deflection[1] - view.deflection[0]))} in deflection")
    if view.setting is not None and view.setting.size > 1:
        parts.append(f"{view.setting_display.text(float(view.setting[1] - view.setting[0]))} in setting")
    return ", ".join(parts) or "a single point"


def _shown_units(sheet: Datasheet) -> str:
    units = [display(row.unit, abs(row.value or 0.0)).unit for row in sheet.rows if row.value is not None]
    units += [display(sheet.units[key]).unit for key in ("deflection", "setting") if sheet.units.get(key)]
    return ", ".join(dict.fromkeys(unit for unit in units if unit))


def _keys(references: Any) -> list[str]:
    return references.split() if isinstance(references, str) else [str(key) for key in references]


def _source(key: str) -> dict[str, str]:
    try:
        found = citation(key)
    except InputError:
        return {"text": key, "link": ""}
    link = f"https://doi.org/{found.doi}" if found.doi else ""
    return {"text": str(found).removesuffix(link).strip(), "link": link}


def embedded(picture: Picture) -> dict[str, Any]:
    """Make the ids of a picture its own, so that several can share a page, and name it for screen readers."""
    svg = re.sub(r'\bid="([^"]+)"', rf'id="{picture.name}-\1"', picture.svg)
    svg = re.sub(r'href="#([^"]+)"', rf'href="#{picture.name}-\1"', svg)
    svg = re.sub(r"url\(#([^)]+)\)", rf"url(#{picture.name}-\1)", svg)
    label = escape(f"{picture.title}. {picture.caption}")
    svg = svg.replace("<svg ", f'<svg role="img" aria-label="{label}" ', 1)
    return {"name": picture.name, "title": picture.title, "caption": picture.caption, "svg": Markup(svg)}
