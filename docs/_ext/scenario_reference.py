"""The reference of scenario files, from the JSON schema that editors use."""

from __future__ import annotations

from typing import Any

from varistiff.design.scenario_spec import scenario_json_schema

Schema = dict[str, Any]

SIGNALS = {
    "ConstantSpec": "constant",
    "StepSpec": "step",
    "MinimumJerkSpec": "minimum_jerk",
    "SineSpec": "sine",
    "ChirpSpec": "chirp",
    "PulseSpec": "pulse",
    "TrajectorySpec": "trajectory",
    "GaitSpec": "gait",
    "SumSpec": "sum",
}
SECTIONS: dict[str, dict[str, str]] = {  # heading of a group, and its parts with theirs
    "Start, reference and load": {
        "StartSpec": "`start`",
        "ReferenceSpec": "`reference`",
        "LoadSpec": "`load`",
    },
    "The plant": {
        "PlantSpec": "`plant`",
        "LinkSpec": "`link`",
        "GravitySpec": "`gravity`",
        "DryFrictionSpec": "`dry_friction`",
        "StopsSpec": "`stops`",
        "MainDriveSpec": "`drive`",
        "SettingDriveSpec": "`setting_drive`",
        "MotorSpec": "`motor`: a data sheet of your own",
        "HeatingSpec": "`heating`",
        "DirectSpec": "`transmission`: direct",
        "ScrewSpec": "`transmission`: screw",
        "BeltSpec": "`transmission`: belt",
        "LineSpec": "`transmission`: line",
        "GrooveTransmissionSpec": "`transmission`: groove",
        "CarriedMassSpec": "`carried_mass`",
        "SupplySpec": "`storage`: supply",
        "BatterySpec": "`storage`: battery",
        "SupercapacitorSpec": "`storage`: supercapacitor",
    },
    "Control": {
        "ControlSpec": "`control`",
        "EncodersSpec": "`encoders`",
        "EncoderSpec": "An encoder",
        "PositionPidSpec": "`drive`: pid",
        "TorqueControlSpec": "`drive`: torque",
        "ImpedanceSpec": "`drive`: impedance",
        "DecouplingSpec": "`drive`: decoupling",
        "LqrSpec": "`drive`: lqr",
        "StiffnessPidSpec": "`setting`: pid",
        "SettingHoldSpec": "`setting`: hold",
        "SettingScheduleSpec": "`setting`: schedule",
        "VirtualSpringDamperSpec": "`setting`: virtual_spring_damper",
    },
    "Signals": {name: f"`kind: {kind}`" for name, kind in SIGNALS.items()},
}
MEANINGS = {  # of fields that say enough by their name to a schema, but not to a table
    "kind": "chooses the model",
    "design": "what moves; a file relative to this one, or the design itself",
    "plant": "link, drives and storage",
    "start": "state at the time 0",
    "reference": "what is wanted",
    "load": "what acts from outside",
    "link": "the output side",
    "motor": "name in the table, or data",
    "transmission": "between motor and output",
    "encoders": "without them ideal ones",
}
LINKED = {name: heading for parts in SECTIONS.values() for name, heading in parts.items()}


def render() -> str:
    """Return one table per part, in groups."""
    schema = scenario_json_schema()
    parts = schema["$defs"]
    blocks = [table("## The file", schema)]
    for group, members in SECTIONS.items():
        blocks.append(f"({_anchor(group)})=\n## {group}")
        blocks += [table(f"({_anchor(name)})=\n### {heading}", parts[name]) for name, heading in members.items()]
    return "\n\n".join(blocks)


def table(heading: str, part: Schema) -> str:
    """Return heading, description and table of one mapping."""
    required = part.get("required", [])
    lines = [heading, "", part.get("description", ""), "", "| field | meaning | written | |", "|---|---|---|---|"]
    for field, entry in part["properties"].items():
        need = "required" if field in required else "optional"
        said = entry.get("description", "")
        meaning = "" if "for example" in said else said
        lines.append(f"| `{field}` | {meaning or MEANINGS.get(field, '')} | {written(entry)} | {need} |")
    return "\n".join(lines)


def written(entry: Schema) -> str:
    """Return how a value is written: choices, examples, or the part that it is."""
    if "$ref" in entry:
        return _part(entry["$ref"].rsplit("/", maxsplit=1)[-1])
    for choice in ("anyOf", "oneOf"):
        if choice in entry:
            return _choice(entry[choice])
    if "const" in entry:
        return f"`{entry['const']}`"
    if "enum" in entry:
        return " or ".join(f"`{value}`" for value in entry["enum"])
    if entry.get("examples"):
        return " or ".join(f"`{example}`" for example in entry["examples"][:2])
    if entry.get("type") == "array":
        return f"list of {written(entry['items'])}"
    words = {"string": "text", "integer": "whole number", "boolean": "`true` or `false`", "number": "number"}
    return words.get(entry.get("type", ""), "")


def _choice(options: list[Schema]) -> str:
    names = {option.get("$ref", "").rsplit("/", maxsplit=1)[-1] for option in options}
    if names == set(SIGNALS):
        return f"[signal](#{_anchor('Signals')})"
    kept = [written(option) for option in options if option.get("type") != "null"]
    return " or ".join(dict.fromkeys(kept))


def _part(name: str) -> str:
    if name == "DesignSpec":
        return "[design](design_files.md)"
    return f"[{LINKED[name].rsplit(': ', maxsplit=1)[-1].strip('`')}](#{_anchor(name)})"


def _anchor(name: str) -> str:
    return f"scenario-{name.lower().replace(' ', '-').replace(',', '')}"
