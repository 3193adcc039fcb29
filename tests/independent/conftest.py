"""The 40-digit reference lives with the benchmarks, which are scripts and no package."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture(scope="session")
def reference() -> ModuleType:
    """Load benchmarks/reference_mpmath.py."""
    path = Path(__file__).parents[2] / "benchmarks" / "reference_mpmath.py"
    spec = importlib.util.spec_from_file_location("reference_mpmath", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module
