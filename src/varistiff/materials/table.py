"""The built-in material table, and tables that users bring."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cache
from importlib import resources
from typing import Any

from varistiff.core.errors import InputError
from varistiff.core.quantity import DENSITY, STRESS, Kind, parse_quantity
from varistiff.core.suggest import quoted, unknown
from varistiff.core.textfile import parse_yaml, read_yaml_documents

_KEY = re.compile(r"[a-z][a-z0-9_]{0,63}", re.ASCII)


@dataclass(frozen=True, slots=True)
class Property:
    """A value in SI units and where it comes from."""

    value: float
    source: str


@dataclass(frozen=True, slots=True)
class Material:
    """An isotropic material, or a laminate along its fibres; a property that is not known is None.

    A laminate's strength along its fibres limits bending, not torsion: there nothing takes it.

    Parameters
    ----------
    key : name in design files
    name : name for people, with its condition
    youngs_modulus : E [Pa]; of a laminate along its fibres
    shear_modulus : G [Pa]; of a laminate in its plane
    density : [kg/m^3]
    yield_strength : tensile yield or proof strength [Pa]; without one, the stress that its source allows
    fatigue_limit : amplitude of fully reversed stress that a smooth specimen survives [Pa]
    isotropic : False for a laminate
    """

    key: str
    name: str
    youngs_modulus: Property | None = None
    shear_modulus: Property | None = None
    density: Property | None = None
    yield_strength: Property | None = None
    fatigue_limit: Property | None = None
    isotropic: bool = True


PROPERTIES: dict[str, Kind] = {
    "youngs_modulus": STRESS,
    "shear_modulus": STRESS,
    "density": DENSITY,
    "yield_strength": STRESS,
    "fatigue_limit": STRESS,
}
_FIELDS = ("name", "source", "isotropic", *PROPERTIES)


@cache
def builtin_materials() -> Mapping[str, Material]:
    """Return the built-in materials by key."""
    text = resources.files("varistiff.materials").joinpath("materials.yaml").read_text(encoding="utf-8")
    (document,) = parse_yaml(text)
    return _table(document)


def read_materials(path: str | os.PathLike[str]) -> Mapping[str, Material]:
    """Return the materials of a user's file by key.

    The file maps a key to a mapping with ``name`` and any of ``youngs_modulus``, ``shear_modulus``,
    ``density``, ``yield_strength`` and ``fatigue_limit``: text with a unit, or ``{value: ..., source: ...}``.
    ``source`` beside them is the source of every value without its own; ``isotropic: false`` marks a laminate.

    Raises
    ------
    InputError : unreadable file, unknown field, a wrong quantity, or a value without a source
    """
    _, documents = read_yaml_documents(path)
    try:
        if len(documents) != 1:
            raise InputError(f"holds {len(documents)} YAML documents; allowed is one")
        return _table(documents[0])
    except InputError as error:
        raise error.located(file=os.fspath(path)) from None


def find_material(key: str, *, extra: Mapping[str, Material] | None = None) -> Material:
    """Return a material by key; a user's own comes before a built-in one of the same key.

    Raises
    ------
    InputError : no such material; says the nearest one

    >>> find_material("pa2200").name
    'PA 2200 (polyamide 12), laser-sintered'
    """
    known = {**builtin_materials(), **(extra or {})}
    if key not in known:
        raise InputError(unknown("material", key, known))
    return known[key]


def _table(document: Any) -> dict[str, Material]:
    if not isinstance(document, dict):
        raise InputError(f"is {quoted(document)}; allowed is a mapping from material names to their properties")
    return {key: _material(key, entry) for key, entry in document.items()}


def _material(key: str, entry: Any) -> Material:
    if not _KEY.fullmatch(key):
        raise InputError("is no material name; allowed are lower case letters, digits and _", field=quoted(key))
    if not isinstance(entry, dict):
        raise InputError("allowed is a mapping of properties", field=key)
    for field in entry:
        if field not in _FIELDS:
            raise InputError(unknown("field", field, _FIELDS), field=key)
    name, source = entry.get("name", key), entry.get("source")
    if not isinstance(name, str) or not (source is None or isinstance(source, str)):
        raise InputError("name and source must be text", field=key)
    isotropic = entry.get("isotropic", True)
    if not isinstance(isotropic, bool):
        raise InputError(f"is {quoted(isotropic)}; allowed is true or false", field=f"{key}.isotropic")
    values = {field: _property(entry.get(field), source, f"{key}.{field}", kind) for field, kind in PROPERTIES.items()}
    return Material(key=key, name=name, isotropic=isotropic, **values)


def _property(entry: Any, source: str | None, field: str, kind: Kind) -> Property | None:
    if entry is None:
        return None
    value = entry
    if isinstance(entry, dict):
        for part in entry:
            if part not in ("value", "source"):
                raise InputError(unknown("field", part, ("value", "source")), field=field)
        value, source = entry.get("value"), entry.get("source", source)
        if value is None:
            return None
    try:
        number = parse_quantity(value, kind)
    except InputError as error:
        raise error.located(field=field) from None
    if number <= 0.0:
        raise InputError(f"{quoted(value)} is not allowed; {kind.allowed('above zero')}", field=field)
    if not isinstance(source, str) or not source.strip():
        raise InputError("has no source; give the handbook, datasheet or measurement it comes from", field=field)
    return Property(value=number, source=source.strip())


# the loader fills the dataclass by name: the two lists of properties must be one
if [field.name for field in fields(Material)] != ["key", "name", *PROPERTIES, "isotropic"]:
    raise AssertionError("Material and PROPERTIES differ")
