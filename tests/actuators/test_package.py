"""The package's names, each imported where it is first asked for."""

from __future__ import annotations

import subprocess
import sys

import pytest

from varistiff import actuators


def test_every_name_is_there() -> None:
    assert set(actuators.__all__) <= set(dir(actuators))
    for name in actuators.__all__:
        assert getattr(actuators, name).__name__ in (name, "Union")  # Rollers is one of several
    with pytest.raises(AttributeError, match="no attribute 'RolerBeam'"):
        actuators.RolerBeam  # noqa: B018 - the access is the test


def test_importing_the_package_alone_switches_to_double_precision() -> None:
    script = "import varistiff.actuators, sys, jax; sys.exit(not jax.config.jax_enable_x64)"
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0
