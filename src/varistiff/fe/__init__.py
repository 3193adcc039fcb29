"""Independent three-dimensional check with NGSolve, the optional extra ``fe``."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from varistiff.core.errors import InputError

MISSING = "the 3-D check needs NGSolve; install it with: pip install 'varistiff[fe]'"


def import_ngsolve() -> ModuleType:
    """NGSolve, imported where it is first needed.

    Raises
    ------
    InputError : it is not installed
    """
    try:
        return import_module("ngsolve")
    except ImportError:
        raise InputError(MISSING) from None
