"""Validation errors in varistiff's words: one line, the field, what is wrong, what is allowed."""

from __future__ import annotations

import types
import typing
from typing import Any

from pydantic import BaseModel, ValidationError

from varistiff.core.errors import InputError
from varistiff.core.suggest import nearest, quoted, unknown
from varistiff.design.spec import DesignSpec

# fields whose value is one of several mappings: the union, what tells them apart, and the word for it
_UNIONS = {
    "actuator": ("kind", "kind"),
    "roller": ("arrangement", "arrangement"),
    "section": ("shape", "shape"),
}
_TAGGED = {*_UNIONS, "setting"}
_TAGS_OF_SETTING = ("length", "angle")
# a misspelt field is also a missing one: say the misspelling first, and a rule between fields last
_ORDER = ("union_tag_invalid", "union_tag_not_found", "extra_forbidden", "", "missing", "varistiff")


def translated(error: ValidationError, document: Any) -> InputError:
    """Return the most telling of pydantic's errors as an InputError with its field."""
    details = error.errors(include_url=False)
    chosen = min(details, key=_rank)
    loc = chosen["loc"]
    field, problem = _clause(chosen, _path(loc), document)
    others = len(details) - 1
    more = f" (and {others} more {'problem' if others == 1 else 'problems'})" if others and _rank(chosen) > 0 else ""
    return InputError(problem + more, field=field or None)


def _rank(detail: Any) -> int:
    kind = detail["type"] if detail["type"] in _ORDER else ""
    if kind == "varistiff" and not detail["ctx"]["field"]:
        kind = ""  # a value, not a rule between fields
    return _ORDER.index(kind)


def _path(loc: tuple[int | str, ...]) -> list[str]:
    """Return the path as the file has it: pydantic adds the tag after a field that is a union."""
    path: list[str] = []
    skip = False
    for position, part in enumerate(loc):
        if skip:
            skip = False
            continue
        path.append(str(part))
        following = loc[position + 1] if position + 1 < len(loc) else None
        skip = part in _UNIONS or (part == "setting" and following in _TAGS_OF_SETTING)
    return path


def _clause(detail: Any, path: list[str], document: Any) -> tuple[str, str]:
    kind, context, given = detail["type"], detail.get("ctx", {}), detail["input"]
    field = ".".join(_short(part) for part in path)
    if kind == "varistiff":
        inner = context["field"]
        return (f"{field}.{inner}" if field and inner else field or inner), context["problem"]
    if kind == "extra_forbidden":
        return ".".join(path[:-1]), _unknown_field(detail, path, document)
    if kind == "missing":
        return field, "is missing; it is required"
    if kind in ("union_tag_invalid", "union_tag_not_found"):
        return _union(path, given)
    if kind in ("model_type", "model_attributes_type", "dict_type"):
        return field, f"is {quoted(given)}; allowed is a mapping of fields"
    if kind == "literal_error":
        return field, unknown("choice", given, _words(context["expected"]))
    if kind.startswith("string") and isinstance(given, str):
        limit = "200 characters at most" if given else "text that is not empty"
        return field, f"is {quoted(given) if given else 'empty'}; allowed is {limit}"
    if kind.startswith("string"):
        return field, f"is {quoted(given)}; allowed is text (put numbers and words like true in quotes)"
    if kind in ("list_type", "too_short", "too_long"):
        return field, _list(detail, path, given)
    if kind.startswith("int") or kind in ("greater_than_equal", "less_than_equal"):
        return field, f"is {quoted(given)}; allowed is a whole number from 1 to 1000"
    return field, f"{quoted(given)} is not allowed here"


def _list(detail: Any, path: list[str], given: Any) -> str:
    if path[-1] in ("points", "holes"):
        allowed = {"points": "a list of 3 to 2000 corners [x, y]", "holes": "a list of at most 100 lists of corners"}
        return f"is {quoted(given)}; allowed is {allowed[path[-1]]}"
    if path[-2:-1] == ["holes"]:
        return f"is {quoted(given)}; allowed is a list of 3 to 2000 corners [x, y]"
    return f"is {quoted(given)}; allowed is a corner [x, y], two lengths with units"


def _short(part: str) -> str:
    return quoted(part)[1:-1]


def _words(expected: str) -> list[str]:
    return [word.strip(" '") for word in expected.replace(" or ", ",").split(",") if word.strip(" '")]


def _union(path: list[str], given: Any) -> tuple[str, str]:
    tag = _UNIONS[path[-1]][0]
    allowed = sorted(_tags(path[-1]))
    field = ".".join([*path, tag])
    if not isinstance(given, dict):
        return ".".join(path), f"is {quoted(given)}; allowed is a mapping with {tag}: {', '.join(allowed)}"
    value = given.get(tag)
    if tag not in given:
        match = nearest(tag, [str(name) for name in given])
        hint = f" (is {quoted(match)} meant?)" if match else ""
        return field, f"is missing{hint}; allowed: {', '.join(allowed)}"
    return field, unknown(tag, value, allowed)


def _unknown_field(detail: Any, path: list[str], document: Any) -> str:
    allowed = model_at(detail["loc"][:-1])
    name = path[-1]
    if name == "setting" and "stiffness" in allowed:
        return "a series_elastic has no setting; leave the field out"
    if name == "clearance" and "radius" in allowed:
        return "a single roller has no clearance; leave the field out"
    return unknown("field", name, allowed)


def _tags(field: str) -> list[str]:
    tag = _UNIONS[field][0]
    found: list[str] = []
    for model in _models(DesignSpec):
        if field in model.model_fields:
            for member in _members(model.model_fields[field].annotation):
                found.extend(typing.get_args(member.model_fields[tag].annotation))
    return found


def model_at(loc: tuple[int | str, ...]) -> list[str]:
    """Return the field names that are allowed in the mapping at pydantic's location."""
    models: list[type[BaseModel]] = [DesignSpec]
    for part in loc:
        inside = [model.model_fields[part].annotation for model in models if part in model.model_fields]
        if inside:
            models = [member for annotation in inside for member in _members(annotation)]
        else:  # a tag
            models = [model for model in models if part in _own_tags(model)] or models
    return sorted({name for model in models for name in model.model_fields})


def _own_tags(model: type[BaseModel]) -> tuple[Any, ...]:
    for tag, _ in _UNIONS.values():
        if tag in model.model_fields:
            return typing.get_args(model.model_fields[tag].annotation)
    return ("angle",) if model.__name__ == "AngleRange" else ("length",)


def _members(annotation: Any) -> list[type[BaseModel]]:
    """Return the models in an annotation, whether it is one, an optional one or a union."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    if typing.get_origin(annotation) in (typing.Annotated, typing.Union, types.UnionType):
        return [member for part in typing.get_args(annotation) for member in _members(part)]
    return []


def _models(root: type[BaseModel]) -> list[type[BaseModel]]:
    found = [root]
    for model in found:
        for field in model.model_fields.values():
            found.extend(member for member in _members(field.annotation) if member not in found)
    return found
