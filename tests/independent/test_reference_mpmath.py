"""The 40-digit reference of the roller contact, from quadrature, differences and the boundary-value rod."""

from __future__ import annotations

import math
from types import ModuleType

import mpmath as mp
import pytest

from .references.rod_bvp import roller_contact


@pytest.mark.parametrize("slope", ["0.001", "0.7", "1.5707", "2.5", "3.1"])
def test_integrals(reference: ModuleType, slope: str) -> None:
    """Closed forms against tanh-sinh quadrature, 38 of 40 digits."""
    with mp.workdps(50):
        t = mp.mpf(slope)
        first, second = reference.integrals_by_quadrature(t)
        assert abs(reference.first_integral(t) / first - 1) < mp.mpf("1e-38")
        assert abs(reference.second_integral(t) / second - 1) < mp.mpf("1e-38")


def test_fold(reference: ModuleType) -> None:
    """The fold is where the polar angle stops rising; r = 0: about 171 and 99.6 degrees."""
    with mp.workdps(50):
        t, beta = reference.fold(mp.mpf("0.03"))
        step = mp.mpf("1e-8")
        assert reference.polar_angle(t - step, mp.mpf("0.03")) < beta
        assert reference.polar_angle(t + step, mp.mpf("0.03")) < beta
        t, beta = reference.fold(0)
    assert float(mp.degrees(t)) == pytest.approx(170.94, abs=0.01)
    assert float(mp.degrees(beta)) == pytest.approx(99.57, abs=0.01)


@pytest.mark.parametrize("upper", [False, True])
@pytest.mark.parametrize("angle", ["0.3", "1.5"])
def test_loads_are_derivatives_of_the_energy(reference: ModuleType, upper: bool, angle: str) -> None:
    """Moment, thrust and stiffness against central differences (error of second order in the step 1e-10)."""
    setting, turn = mp.mpf("0.3"), mp.mpf(angle) * (-1 if upper else 1)
    step = mp.mpf("1e-10")

    def energy(along: int, about: int) -> mp.mpf:
        return reference.joint(
            setting + along * step,
            turn + about * step,
            flexural_rigidity=13,
            radius=mp.mpf("0.01"),
            roller_offset=mp.mpf("0.004"),
            mounting_angle=mp.mpf("0.03"),
            clamp_offset_along=mp.mpf("0.02"),
            clamp_offset_across=mp.mpf("-0.006"),
            upper=upper,
        )

    with mp.workdps(50):
        here = energy(0, 0)
        up, down = energy(0, 1).energy, energy(0, -1).energy
        far, near = energy(1, 0).energy, energy(-1, 0).energy
        assert abs((up - down) / (2 * step) / here.moment - 1) < mp.mpf("1e-17")
        assert abs((far - near) / (2 * step) / here.thrust - 1) < mp.mpf("1e-16")
        assert abs((up - 2 * here.energy + down) / step**2 / here.stiffness - 1) < mp.mpf("1e-17")


@pytest.mark.parametrize(("degrees", "radius"), [(12.0, 0.02), (55.0, -0.01), (96.0, 0.0)])
def test_contact_is_the_rod(reference: ModuleType, degrees: float, radius: float) -> None:
    """Boundary-value rod with unknown length, converged to 1e-10."""
    cx, cy = 0.35 * math.cos(math.radians(degrees)), 0.35 * math.sin(math.radians(degrees))
    rod = roller_contact((cx, cy), radius=radius, flexural_rigidity=9.0)
    exact = reference.contact(cx, cy, radius=radius, flexural_rigidity=9)
    assert rod.end_slope == pytest.approx(float(exact.slope), rel=1e-9)
    assert rod.force == pytest.approx(float(exact.force), rel=1e-9)
    assert rod.length == pytest.approx(float(exact.length), rel=1e-9)
    assert rod.root_moment == pytest.approx(float(exact.root_moment), rel=1e-9)
    assert rod.moment_max == pytest.approx(float(exact.moment_max), rel=1e-7)
    assert rod.energy == pytest.approx(float(exact.energy), rel=1e-9)


def test_first_contact_and_no_contact(reference: ModuleType) -> None:
    """Close to rest the linear cantilever; at rest and beyond the fold the solver refuses."""
    found = reference.contact(0.3, 1e-9, radius=0, flexural_rigidity=2)
    assert float(found.force) == pytest.approx(3 * 2 * 1e-9 / 0.3**3, rel=1e-12)
    with pytest.raises(reference.NoContactError):
        reference.contact(0.3, -0.01, radius=0.01, flexural_rigidity=2)
    with pytest.raises(reference.BeyondFoldError):
        reference.contact(-0.1, 0.4, radius=0, flexural_rigidity=2)
