"""Synthetic runs of every example, made once."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from varistiff.design.design import load

from .synthetic import Made, make

KINDS = ("antagonistic_leaves", "maccepa", "roller_beam", "series_elastic", "slider_leaf_joint", "torsion_tube")


@pytest.fixture(scope="session")
def made(root: Path) -> Callable[[str], Made]:
    """Run of an example by its name."""
    return cache(lambda name: make(load(root / "examples" / f"{name}.yaml"), samples=401))


@pytest.fixture(params=KINDS)
def run_of_kind(request: pytest.FixtureRequest, made: Callable[[str], Made]) -> Made:
    """Run of every kind, one after the other."""
    return made(str(request.param))
