"""Validation errors in varistiff's words: one line, the field, what is wrong, what is allowed."""

from __future__ import annotations

import types
import typing
from typing import Any

from pydantic import BaseModel, Discriminator, ValidationError
from pydantic.fields import FieldInfo

from varistiff.core.errors import InputError
from varistiff.core.suggest import nearest, quoted, unknown
from varistiff.design.spec import DesignSpec

Loc = tuple[int | str, ...]

# a misspelt field is also a missing one: say the misspelling first, and a rule between fields last
_ORDER = ("union_tag_invalid", "union_tag_not_found", "extra_forbidden", "", "missing", "varistiff")


def translated(error: ValidationError, *, root: type[BaseModel] = DesignSpec) -> InputError:
    """Return the most telling of pydantic's errors as an InputError with its field.

    Parameters
    ----------
    root : model of the whole file
    """
    details = error.errors(include_url=False)
    chosen = min(details, key=_rank)
    path, models = _place(chosen["loc"], root)
    field, problem = _clause(chosen, path, models, root)
    others = len(details) - 1
    more = f" (and {others} more {'problem' if others == 1 else 'problems'})" if others and _rank(chosen) > 0 else ""
    return InputError(problem + more, field=field or None)


def _rank(detail: Any) -> int:
    kind = detail["type"] if detail["type"] in _ORDER else ""
    if kind == "varistiff" and not detail["ctx"]["field"]:
        kind = ""  # a value, not a rule between fields
    return _ORDER.index(kind)


def _place(loc: Loc, root: type[BaseModel]) -> tuple[list[str], list[type[BaseModel]]]:
    """Return the path as the file has it, and the models that may stand there.

    pydantic adds the tag after a field that is a tagged union; in a list of them it does so after the number.
    """
    path: list[str] = []
    models: list[type[BaseModel]] = [root]
    tag_follows = False
    for part in loc:
        if isinstance(part, int):
            path.append(str(part))
        elif tag_follows:
            models = [model for model in models if part in _own_tags(model)] or models
            tag_follows = False
        else:
            path.append(part)
            fields = [model.model_fields[part] for model in models if part in model.model_fields]
            models = [member for field in fields for member in _members(field.annotation)]
            tag_follows = any(_is_tagged(field) for field in fields)
    return path, models


def _clause(detail: Any, path: list[str], models: list[type[BaseModel]], root: type[BaseModel]) -> tuple[str, str]:
    kind, context, given = detail["type"], detail.get("ctx", {}), detail["input"]
    field = ".".join(_short(part) for part in path)
    if kind == "varistiff":
        inner = context["field"]
        return (f"{field}.{inner}" if field and inner else field or inner), context["problem"]
    if kind == "extra_forbidden":
        return ".".join(path[:-1]), _unknown_field(path, _place(detail["loc"][:-1], root)[1])
    if kind == "missing":
        return field, "is missing; it is required"
    if kind in ("union_tag_invalid", "union_tag_not_found"):
        return _union(path, context["discriminator"].strip("'"), models, given)
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
    if kind.startswith("bool"):
        return field, f"is {quoted(given)}; allowed is true or false"
    if kind.startswith("int") or kind in ("greater_than_equal", "less_than_equal"):
        return field, f"is {quoted(given)}; allowed is a whole number from 1 to 1000"
    return field, f"{quoted(given)} is not allowed here"


def _list(detail: Any, path: list[str], given: Any) -> str:
    if path[-1] == "parts":
        return f"is {quoted(given)}; allowed is a list of 1 to 16 signals"
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


def _union(path: list[str], tag: str, models: list[type[BaseModel]], given: Any) -> tuple[str, str]:
    allowed = sorted(word for model in models for word in typing.get_args(model.model_fields[tag].annotation))
    field = ".".join([*path, tag])
    if not isinstance(given, dict):
        return ".".join(path), f"is {quoted(given)}; allowed is a mapping with {tag}: {', '.join(allowed)}"
    value = given.get(tag)
    if tag not in given:
        match = nearest(tag, [str(name) for name in given])
        hint = f" (is {quoted(match)} meant?)" if match else ""
        return field, f"is missing{hint}; allowed: {', '.join(allowed)}"
    return field, unknown(tag, value, allowed)


def _unknown_field(path: list[str], models: list[type[BaseModel]]) -> str:
    allowed = sorted({name for model in models for name in model.model_fields})
    name = path[-1]
    if name == "setting" and {"stiffness", "deflection"} <= set(allowed):
        return "a series_elastic has no setting; leave the field out"
    if name == "clearance" and "radius" in allowed:
        return "a single roller has no clearance; leave the field out"
    return unknown("field", name, allowed)


def _own_tags(model: type[BaseModel]) -> tuple[Any, ...]:
    words: list[Any] = []
    for field in model.model_fields.values():
        if typing.get_origin(field.annotation) is typing.Literal:
            words.extend(typing.get_args(field.annotation))
    if model.__name__.endswith("Range"):
        words.append("angle" if model.__name__ == "AngleRange" else "length")
    return tuple(words)


def _is_tagged(annotation: Any) -> bool:
    """Whether an annotation, or what it holds, is a union whose members have tags."""
    if isinstance(annotation, FieldInfo):
        metadata, inside = [annotation, *annotation.metadata], [annotation.annotation]
    else:
        metadata, inside = list(getattr(annotation, "__metadata__", ())), list(typing.get_args(annotation))
    for entry in metadata:
        if isinstance(entry, Discriminator) or (isinstance(entry, FieldInfo) and entry.discriminator is not None):
            return True
    return any(_is_tagged(part) for part in inside if typing.get_origin(part) is not typing.Literal)


def _members(annotation: Any) -> list[type[BaseModel]]:
    """Return the models in an annotation, whether it is one, an optional one or a union."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    if typing.get_origin(annotation) in (typing.Annotated, typing.Union, types.UnionType, list):
        return [member for part in typing.get_args(annotation) for member in _members(part)]
    return []
