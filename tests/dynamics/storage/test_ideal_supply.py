"""The supply without a loss."""

from __future__ import annotations

import jax.numpy as jnp
import pytest

from varistiff.core.errors import InputError
from varistiff.dynamics.storage import IdealSupply


@pytest.mark.parametrize("power", [-30.0, 0.0, 12.5])
def test_it_supplies_what_is_asked(power):
    flows = IdealSupply(voltage=24.0).flows(jnp.asarray(0.0), jnp.asarray(power))
    assert float(flows.supplied_power) == power
    assert not any(float(value) for name, value in flows._asdict().items() if name != "supplied_power")


def test_its_voltage_is_above_zero():
    with pytest.raises(InputError, match="voltage"):
        IdealSupply(voltage=0.0)
