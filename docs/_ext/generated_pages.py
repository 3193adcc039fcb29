"""Write the tables that the code already knows, so that no page repeats them by hand."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import api_pages
import design_reference
import paper_tables
import scenario_reference
import section_4_tables
import torsion_tables

from varistiff.core.citations import citations
from varistiff.core.status import Status
from varistiff.materials.table import PROPERTIES, builtin_materials
from varistiff.papers.registry import PAPERS
from varistiff.papers.wang_2024.table_3 import table_3_markdown


def statuses() -> str:
    """Return the table of statuses with their flag values and remedies."""
    rows = [f"| {int(status)} | `{status.label}` | {status.meaning} | {status.remedy} |" for status in Status]
    return "\n".join(["| value | status | meaning | remedy |", "|---|---|---|---|", *rows])


def references() -> str:
    """Return the publications, each with a target to link to."""
    blocks = []
    for key, entry in citations().items():
        link = f" <https://doi.org/{entry.doi}>" if entry.doi else ""
        text = f"{entry.authors}: *{entry.title}.* {entry.source}, {entry.year}.{link}"
        blocks.append(f"({key.replace('_', '-')})=\n`{key}`\n: {text}")
    return "\n\n".join(blocks)


def lacking() -> str:
    """Return the table of properties and the materials whose value is not known."""
    rows = ["| property | not known of |", "|---|---|"]
    for name in PROPERTIES:
        keys = [f"`{key}`" for key, material in builtin_materials().items() if getattr(material, name) is None]
        if keys:
            rows.append(f"| `{name}` | {', '.join(keys)} |")
    return "\n".join(rows)


def materials() -> str:
    """Return one table per material that says value and source."""
    scale = {"density": (1.0, "kg/m³"), "youngs_modulus": (1e-9, "GPa"), "shear_modulus": (1e-9, "GPa")}
    parts = []
    for material in builtin_materials().values():
        rows = []
        for name in PROPERTIES:
            entry = getattr(material, name)
            factor, unit = scale.get(name, (1e-6, "MPa"))
            value = "not known" if entry is None else f"{entry.value * factor:.6g} {unit}"
            rows.append(f"| `{name}` | {value} | {'' if entry is None else entry.source} |")
        kind = "" if material.isotropic else " Not isotropic."
        head = f"### `{material.key}`\n\n{material.name}.{kind}\n\n| property | value | source |\n|---|---|---|"
        parts.append("\n".join([head, *rows]))
    return "\n\n".join(parts)


PAGES: dict[str, Callable[[], str]] = {
    "statuses": statuses,
    "references": references,
    "materials": materials,
    "materials_lacking": lacking,
    "design_fields": design_reference.render,
    "scenario_fields": scenario_reference.render,
    "torsion_sections": torsion_tables.sections_table,
    "torsion_table_one": torsion_tables.table_one,
    "torsion_common_modulus": torsion_tables.common_modulus,
    "torsion_stress_ratios": torsion_tables.stress_ratios,
    "papers_overview": paper_tables.overview,
    "paper_wang_2024_table_3": table_3_markdown,
    "wang_section_4_facts": section_4_tables.facts,
    "wang_section_4_sets": section_4_tables.sets,
    "wang_section_4_motors": section_4_tables.motors,
    "wang_section_4_chains": section_4_tables.chains,
    "wang_section_4_sensing": section_4_tables.sensing,
    "papers_verdicts": paper_tables.verdicts,
    **{f"paper_{key}_scoreboard": partial(paper_tables.scoreboard, key) for key in PAPERS},
    **{f"paper_{key}_equations": partial(paper_tables.equations, key) for key in PAPERS},
    **{f"paper_{key}_figures": partial(paper_tables.figures, key) for key in PAPERS},
    **{f"paper_{key}_reading": partial(paper_tables.reading, key) for key in PAPERS},
    **{f"api_{room}": partial(api_pages.render, room) for room in api_pages.ROOMS},
}


def write_all(app: Any) -> None:
    """Write every table into generated/."""
    folder = Path(app.srcdir) / "generated"
    folder.mkdir(exist_ok=True)
    for name, render in PAGES.items():
        (folder / f"{name}.md").write_text(render() + "\n", encoding="utf-8")


def setup(app: Any) -> dict[str, Any]:
    """Register with Sphinx."""
    app.connect("builder-inited", write_all)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
