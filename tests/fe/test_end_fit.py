"""The end model: what is fitted is found again, and what cannot be told apart is said."""

from __future__ import annotations

import numpy as np
import pytest

from varistiff.core.errors import InputError
from varistiff.fe.end_fit import fit_end_effect

X = np.array([0.0, 0.002, 0.005, 0.011, 0.03, 0.07, 0.166])
RIGIDITY = 9.4


def test_a_known_end_effect_is_found_again() -> None:
    length = X + 0.0013 + 0.0021 * np.exp(-X / 0.0045)
    found = fit_end_effect(active_length=X, stiffness=RIGIDITY / length, rigidity=RIGIDITY)
    assert found.residual < 1e-7  # exact data: the minimiser's own tolerance
    assert found.effect.offset == pytest.approx(0.0013, rel=1e-4)
    assert found.lock_length == pytest.approx(0.0034, rel=1e-4)
    assert found.effect.decay == pytest.approx(0.0045, rel=1e-4)
    assert (found.effect.shortest, found.effect.longest) == (0.0, 0.166)


def test_a_stiffening_flange_has_a_negative_offset() -> None:
    x = X[2:]
    found = fit_end_effect(active_length=x, stiffness=RIGIDITY / (x - 0.0008), rigidity=RIGIDITY)
    assert found.effect.offset == pytest.approx(-0.0008, rel=1e-3)
    assert found.residual < 1e-6


def test_a_compliance_in_series_looks_like_an_offset() -> None:
    x = X[3:]
    stiffness = 1.0 / (x / RIGIDITY + 1.0 / 650.0)
    found = fit_end_effect(active_length=x, stiffness=stiffness, rigidity=RIGIDITY)
    assert found.effect.offset == pytest.approx(RIGIDITY / 650.0, rel=1e-3)


def test_noise_shows_in_the_residual() -> None:
    wiggle = 1.0 + 0.01 * np.array([1, -1, 1, -1, 1, -1, 1])
    found = fit_end_effect(active_length=X, stiffness=RIGIDITY / (X + 0.003) * wiggle, rigidity=RIGIDITY)
    assert 0.002 < found.residual < 0.02


def test_three_settings_are_too_few() -> None:
    with pytest.raises(InputError, match="needs results at 4 settings or more, not 3"):
        fit_end_effect(active_length=[0.1, 0.2, 0.3, 0.3], stiffness=[3.0, 2.0, 1.0, 1.0], rigidity=1.0)
