"""From a design file to its validated spec."""

from __future__ import annotations

import os
from typing import Any

from pydantic import ValidationError

from varistiff.core.errors import InputError
from varistiff.core.suggest import quoted
from varistiff.core.textfile import one_document, printable_path, read_yaml_documents
from varistiff.design.spec import DesignSpec
from varistiff.design.translate import translated


def read_spec(path: str | os.PathLike[str]) -> tuple[DesignSpec, str]:
    """Return the validated spec of a design file and its text.

    Raises
    ------
    InputError : one line with file, field, what is wrong and what is allowed
    """
    file = printable_path(os.fspath(path))
    text, documents = read_yaml_documents(path)
    try:
        return validated(one_document(documents, file)), text
    except InputError as error:
        raise error.located(file=file) from None


def validated(document: Any) -> DesignSpec:
    """Return the spec that a YAML document states.

    Raises
    ------
    InputError : with the field, but no file
    """
    if not isinstance(document, dict):
        raise InputError(f"is {quoted(document)}; allowed is a mapping with name and actuator")
    try:
        return DesignSpec.model_validate(document)
    except ValidationError as error:
        raise translated(error) from None
