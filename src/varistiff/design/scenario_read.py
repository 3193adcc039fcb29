"""From a scenario file to its validated spec."""

from __future__ import annotations

import os
from typing import Any

from pydantic import ValidationError

from varistiff.core.errors import InputError
from varistiff.core.suggest import quoted
from varistiff.core.textfile import one_document, printable_path, read_yaml_documents
from varistiff.design.scenario_spec import ScenarioSpec
from varistiff.design.translate import translated


def read_scenario(path: str | os.PathLike[str]) -> tuple[ScenarioSpec, str, dict[str, Any]]:
    """Return the validated spec of a scenario file, its text, and the mapping that it states.

    Raises
    ------
    InputError : one line with file, field, what is wrong and what is allowed
    """
    file = printable_path(os.fspath(path))
    text, documents = read_yaml_documents(path)
    try:
        document = one_document(documents, file, what="scenario")
        return validated_scenario(document), text, document
    except InputError as error:
        raise error.located(file=file) from None


def validated_scenario(document: Any) -> ScenarioSpec:
    """Return the spec that a YAML document states.

    Raises
    ------
    InputError : with the field, but no file
    """
    if not isinstance(document, dict):
        raise InputError(f"is {quoted(document)}; allowed is a mapping with name, design, duration and plant")
    try:
        return ScenarioSpec.model_validate(document)
    except ValidationError as error:
        raise translated(error, root=ScenarioSpec) from None
