"""The papers that have a package here, and the files and functions in it."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module, resources
from importlib.resources.abc import Traversable
from typing import Any

from varistiff.core.errors import InputError
from varistiff.core.suggest import unknown

PAPERS = ("schuy_2013", "dos_santos_2019", "chacon_2011", "wang_2024")


def check_paper(key: str) -> str:
    """Return a paper's key.

    Raises
    ------
    InputError : no paper has it; says the nearest one

    >>> check_paper("wang_2024")
    'wang_2024'
    """
    if key not in PAPERS:
        raise InputError(unknown("paper", key, PAPERS))
    return key


def paper_file(paper: str, name: str) -> Traversable:
    """Return a data file of a paper's package."""
    return resources.files(f"varistiff.papers.{check_paper(paper)}").joinpath(name)


def paper_entries(paper: str, name: str) -> list[Any]:
    """Return the list that a YAML file of a paper's package holds."""
    from varistiff.core.textfile import parse_yaml

    (entries,) = parse_yaml(paper_file(paper, name).read_text(encoding="utf-8"))
    return list(entries)


def computation(paper: str, name: str) -> Callable[..., Any]:
    """Return the function ``module.function`` of a paper's package.

    Raises
    ------
    LookupError : there is none
    """
    module, _, function = name.rpartition(".")
    try:
        found = getattr(import_module(f"varistiff.papers.{check_paper(paper)}.{module}"), function)
    except (ImportError, AttributeError) as error:
        raise LookupError(f"papers/{paper} has no computation {name}: {error}") from error
    return found
