"""Material names become numbers; the numbers become a hash."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from varistiff.core.errors import InputError
from varistiff.core.quantity import LENGTH, parse_quantity
from varistiff.core.suggest import nearest, quoted
from varistiff.design.section_spec import OutlineSpec, PolygonSpec
from varistiff.design.spec import AnyActuatorSpec, LeafSpec, SliderLeafJointSpec, TorsionTubeSpec
from varistiff.materials import Material, find_material

_OUTLINES = (".csv", ".dxf")


def resolved(
    spec: AnyActuatorSpec, materials: Mapping[str, Material] | None = None, *, directory: Path = Path()
) -> AnyActuatorSpec:
    """Return the spec with its material's modulus and yield strength filled in where it gives none, and outlines read.

    ``directory`` is where a relative path to an outline starts.

    Raises
    ------
    InputError : unknown material, one without the modulus that the element needs, or a laminate in torsion without
        a yield_strength of the design's own
    """
    if isinstance(spec, TorsionTubeSpec):
        update: dict[str, Any] = _filled(spec, "shear_modulus", "actuator", materials)
        if isinstance(spec.section, PolygonSpec):
            update["section"] = _outlined(spec.section, directory)
        return spec.model_copy(update=update)
    for name in ("beam", "leaf"):
        leaf = getattr(spec, name, None)
        if isinstance(leaf, LeafSpec):
            update = _filled(leaf, "youngs_modulus", f"actuator.{name}", materials)
            return spec.model_copy(update={name: leaf.model_copy(update=update)})
    return spec


def _outlined(section: PolygonSpec, directory: Path) -> OutlineSpec:
    """A polygon with its loops checked, from its own corners or its file."""
    from varistiff.sections.loops import check_loops
    from varistiff.sections.polygon_loops import loop_of_points

    if section.file is not None:
        from varistiff.design.outline_file import read_outline

        try:
            return OutlineSpec(loops=read_outline(directory / section.file, unit=_unit(section.unit)))
        except InputError as error:
            if error.file is None:  # about the design's own fields unit and file
                raise InputError(error.problem, field=f"actuator.section.{error.field}") from None
            said = ": ".join(part for part in (error.file, error.field, error.problem) if part)
            raise InputError(said + _meant(directory / section.file), field="actuator.section.file") from None
    outlines = [section.points or [], *(section.holes or [])]
    try:
        return OutlineSpec(loops=check_loops(tuple(loop_of_points(corners) for corners in outlines)))
    except InputError as error:
        raise InputError(error.problem, field=f"actuator.section.{error.field or 'points'}") from None


def _meant(path: Path) -> str:
    """What a file that is not there may have been meant to be."""
    if path.exists() or not path.parent.is_dir():
        return ""
    match = nearest(path.name, [other.name for other in path.parent.iterdir() if other.suffix.lower() in _OUTLINES])
    return f" (did you mean {quoted(match)}?)" if match else ""


def _unit(name: str | None) -> float | None:
    """What 1 in a file stands for [m]."""
    if name is None:
        return None
    try:
        return parse_quantity(f"1 {name}", LENGTH)
    except InputError:
        raise InputError(
            f"{quoted(name)} is no unit of length; allowed is one such as mm", field="actuator.section.unit"
        ) from None


def _filled(
    part: LeafSpec | TorsionTubeSpec, modulus: str, field: str, materials: Mapping[str, Material] | None
) -> dict[str, float]:
    if part.material is None:
        return {}
    try:
        material = find_material(part.material, extra=materials)
    except InputError as error:
        raise error.located(field=f"{field}.material") from None
    if isinstance(part, TorsionTubeSpec) and part.yield_strength is None and not material.isotropic:
        # a strength along the fibres over sqrt(3) would be many times the strength in shear
        raise InputError(
            f"material {part.material} is not isotropic: its strength along the fibres does not limit torsion; give "
            "yield_strength here: torsion is held to yield_strength/sqrt(3), so sqrt(3) times the laminate's in-plane "
            "shear strength",
            field=f"{field}.yield_strength",
        )
    update: dict[str, float] = {}
    for name in (modulus, "yield_strength"):
        known = getattr(material, name)
        if getattr(part, name) is None and known is not None:
            update[name] = known.value
    if modulus not in update and getattr(part, modulus) is None:
        raise InputError(f"material {part.material} has no known {modulus}; give it here", field=f"{field}.{modulus}")
    return update


def unlimited(spec: AnyActuatorSpec) -> tuple[str, ...]:
    """Return a warning for each element of a resolved spec that has no yield strength, from itself or a material."""
    parts = {f"actuator.{name}": getattr(spec, name, None) for name in ("beam", "leaf")} | {"actuator": spec}
    return tuple(
        f"{field}: no yield strength: nothing is reported as yielded"
        for field, part in parts.items()
        if isinstance(part, LeafSpec | TorsionTubeSpec) and part.yield_strength is None
    )


def canonical(spec: AnyActuatorSpec) -> str:
    """Return a resolved spec as canonical JSON: SI, sorted names, no absent fields, no material names."""
    plain = _plain(spec.model_dump())
    if isinstance(spec, SliderLeafJointSpec):
        plain["driven_by"] = spec.driven_by  # a length and an angle of the same number differ
    return json.dumps(plain, sort_keys=True, separators=(",", ":"), allow_nan=False)


def design_hash(spec: AnyActuatorSpec) -> str:
    """Return the SHA-256 of the canonical spec, in hexadecimal.

    Two files have one hash exactly if every number in SI units is the same: layout, comments, units, the
    design's name, and whether a value was written or came from a material do not matter.
    """
    return hashlib.sha256(canonical(spec).encode()).hexdigest()


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items() if item is not None and key != "material"}
    return value
