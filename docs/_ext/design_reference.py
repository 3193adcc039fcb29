"""The reference of design files, from the JSON schema that editors use."""

from __future__ import annotations

from typing import Any

from varistiff.design.spec import json_schema

Schema = dict[str, Any]

PARTS = {  # heading, and what a table calls it
    "BeamSpec": ("The `beam` of a roller beam", "beam"),
    "SingleRollerSpec": ("`roller`: single_lower, single_upper", "single roller"),
    "FixedPairSpec": ("`roller`: fixed_pair", "fixed pair"),
    "SwivellingPairSpec": ("`roller`: swivelling_pair", "swivelling pair"),
    "CircleSpec": ("`section`: circle", "circle"),
    "HollowCircleSpec": ("`section`: hollow_circle", "hollow circle"),
    "SquareSpec": ("`section`: square", "square"),
    "RectangleSpec": ("`section`: rectangle", "rectangle"),
    "HexagonSpec": ("`section`: hexagon", "hexagon"),
    "OctagonSpec": ("`section`: octagon", "octagon"),
    "EllipseSpec": ("`section`: ellipse", "ellipse"),
    "TriangleSpec": ("`section`: triangle", "triangle"),
    "P3GSpec": ("`section`: p3g", "P3G"),
    "P4CSpec": ("`section`: p4c", "P4C"),
    "SplinedTubeSpec": ("`section`: splined_tube", "splined tube"),
    "PolygonSpec": ("`section`: polygon", "polygon"),
    "EndModelSpec": ("The `end_model` of a torsion tube", "end model"),
    "VerificationSpec": ("The `verification` of a design", "verification"),
    "LeafSpec": ("The `leaf` of antagonistic leaves", "leaf"),
    "CountedLeafSpec": ("The `leaf` of a slider leaf joint", "leaf"),
    "GrooveSpec": ("The `groove` of a slider leaf joint", "groove"),
}
MEANINGS = {  # of fields that say enough by their name to a schema, but not to a table
    "kind": "chooses the model",
    "actuator": "the device",
    "deflection": "range of the map",
    "spring_rate": "of the cable's spring",
    "stiffness": "of the spring",
}
SHARED_PAGE = {"series_elastic": "series_elastic_and_maccepa", "maccepa": "series_elastic_and_maccepa"}


def render() -> str:
    """Return one section per kind and one per part, each with a table of fields."""
    schema = json_schema()
    parts = schema["$defs"]
    kinds = schema["properties"]["actuator"]["discriminator"]["mapping"]
    blocks = [section("## The file", schema, parts)]
    for kind, target in kinds.items():
        blocks.append(section(f"## `kind: {kind}`", parts[_name(target)], parts))
        blocks.append(f"[Theory, statuses, signs](theory/{SHARED_PAGE.get(kind, kind)}.md)")
    blocks += [section(f"({_anchor(name)})=\n### {PARTS[name][0]}", parts[name], parts) for name in PARTS]
    return "\n\n".join(blocks)


def section(heading: str, part: Schema, parts: Schema) -> str:
    """Return heading, description and table of one mapping."""
    required = part.get("required", [])
    lines = [
        heading,
        "",
        part.get("description", ""),
        "",
        "| field | meaning | written | |",
        "|---|---|---|---|",
    ]
    for field, entry in part["properties"].items():
        need = "required" if field in required else "optional"
        meaning = "" if entry.get("examples") and _is_quantity_text(entry) else entry.get("description", "")
        lines.append(f"| `{field}` | {meaning or MEANINGS.get(field, '')} | {written(entry, parts)} | {need} |")
    return "\n".join(lines)


def written(entry: Schema, parts: Schema) -> str:
    """Return how a value is written: choices, an example, or the part that it is."""
    if "$ref" in entry:
        return _part(_name(entry["$ref"]), parts)
    for choice in ("anyOf", "oneOf"):
        if choice in entry:
            kept = [written(option, parts) for option in entry[choice] if option.get("type") != "null"]
            return " or ".join(dict.fromkeys(kept))
    if "const" in entry:
        return f"`{entry['const']}`"
    if "enum" in entry:
        return " or ".join(f"`{value}`" for value in entry["enum"])
    if entry.get("examples"):
        return f"`{entry['examples'][0]}`"
    if entry.get("type") == "array":
        inside = written(entry["items"], parts)
        return "`[x, y]`" if entry["items"].get("type") == "string" else f"list of {inside}"
    return {"string": "text", "integer": "whole number"}.get(entry.get("type", ""), entry.get("type", ""))


def _part(name: str, parts: Schema) -> str:
    if name.endswith("Range"):
        ends = parts[name]["properties"]
        return f"`{{min: {ends['min']['examples'][0]}, max: {ends['max']['examples'][0]}}}`"
    if name in PARTS:
        return f"[{PARTS[name][1]}](#{_anchor(name)})"
    return "one of the kinds below"


def _is_quantity_text(entry: Schema) -> bool:
    return str(entry.get("description", "")).endswith(("above zero", "zero or above", entry["examples"][0]))


def _anchor(name: str) -> str:
    return f"part-{name.lower()}"


def _name(reference: str) -> str:
    return reference.rsplit("/", maxsplit=1)[-1]
