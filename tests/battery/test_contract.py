"""What the statuses promise about the numbers, far outside every device's range too."""

from __future__ import annotations

from pathlib import Path

import jax.numpy as jnp
import numpy as np
import pytest

import varistiff
from varistiff.core.status import Status

from .catalogue import CATALOGUE, Case
from .evaluation import energy, energy_gradient, respond

NUMBERS = ("energy", "load", "stiffness", "adjusting_load")


def _wide(case: Case) -> tuple[np.ndarray, np.ndarray]:
    """Half as far again as the catalogue's range, settings from below zero, and rest itself."""
    rng = np.random.default_rng(11)
    reach = 1.5 * max(abs(end) for region in case.deflections for end in region)
    low, high = case.setting or (0.0, 1.0)
    deflection = np.append(rng.uniform(-reach, reach, 396), [0.0, 0.0, 0.0, -1e-9])
    setting = np.append(rng.uniform(-0.2 * high, 1.6 * high, 396), [low, 0.0, high, low])
    return deflection, setting


@pytest.mark.parametrize("case", CATALOGUE, ids=lambda case: case.name)
def test_numbers_and_statuses(case: Case) -> None:
    """NaN exactly where nothing exists, zero exactly without contact, one energy everywhere else."""
    deflection, setting = _wide(case)
    found = respond(case.actuator, deflection, setting)
    status = found["status"]
    absent = np.isin(status, [Status.NO_SOLUTION, Status.ELEMENT_TOO_SHORT])
    # both rollers of a fixed pair: the only invalid points without numbers
    absent |= (status == Status.OUTSIDE_VALIDITY) & (case.name == "roller_fixed_pair")
    apart = status == Status.NO_CONTACT
    numbers = NUMBERS[:3] if case.setting is None else NUMBERS
    for name in numbers:
        np.testing.assert_array_equal(np.isnan(found[name]), absent, err_msg=name)
        assert np.isfinite(found[name][~absent]).all()
        assert (found[name][apart] == 0).all()
    assert (found["energy"][~absent] >= 0).all()
    if case.name not in ("series_elastic", "maccepa"):  # a spring and a slack cable have numbers everywhere
        assert absent.any()
    there = ~absent
    stored, (slope, across) = (
        energy(case.actuator, deflection, setting),
        energy_gradient(case.actuator, deflection, setting),
    )
    np.testing.assert_allclose(stored[there], found["energy"][there], rtol=1e-12, atol=1e-300)
    scale = float(np.max(np.abs(found["load"][there])))
    np.testing.assert_allclose(slope[there], found["load"][there], rtol=0, atol=1e-11 * scale)
    if case.setting is not None:
        scale = float(np.max(np.abs(found["adjusting_load"][there])))
        np.testing.assert_allclose(across[there], found["adjusting_load"][there], rtol=0, atol=1e-11 * scale)


@pytest.mark.parametrize(
    "path", sorted((Path(__file__).parents[2] / "examples").glob("*.yaml")), ids=lambda path: path.stem
)
def test_plain_floats_give_what_arrays_give(path: Path) -> None:
    """A script passes Python's own floats, whose comparisons are Python's own truths."""
    design = varistiff.load(path)
    deflection, setting = 0.3 * design.deflection_range[1], float(np.mean(design.setting_range or (0.0,)))
    plain, _ = design.actuator.respond(deflection, setting)
    arrays, _ = design.actuator.respond(jnp.asarray(deflection), jnp.asarray(setting))
    assert int(plain.status) == Status.OK
    np.testing.assert_array_equal([float(each) for each in plain], [float(each) for each in arrays])
