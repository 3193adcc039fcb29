"""Roller contact of a clamped elastica to 40 digits: what the fast kernel is judged against.

Written from the contact equations alone, with mpmath, and slow on purpose.  With t the slope at the contact,

    I1(t) = int_0^t dp/sqrt(sin p),   I2(t) = int_0^t sqrt(sin p) dp,   tan(gamma) = I2/(2 sqrt(sin t))
    polar angle of the roller's centre:  beta(t) = t - gamma - asin((r/rho) cos(gamma))

beta rises from -asin(r/rho) at rest to the fold.  The fold is located first, as the first zero of d(beta)/dt;
the slope is then bracketed between rest and fold, so that no unstable solution can be returned.  float64 only
chooses brackets, whose signs are checked in high precision.

    python benchmarks/reference_mpmath.py        # times and prints a few points
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath as mp
import numpy as np
from numpy.typing import NDArray
from scipy.special import elliprd

DIGITS = 40
VARPI = 2.62205755429212  # lemniscate constant, for the float64 search only
GUARD = 25  # lost at most: square roots and differences near first contact
Real = Any  # mpmath publishes no types


class NoContactError(ValueError):
    """The roller does not press on the straight beam."""


class BeyondFoldError(ValueError):
    """No stable equilibrium: the beam has slipped off."""


@dataclass(frozen=True)
class Contact:
    """Rod in contact with a lower roller, in the clamp's frame."""

    slope: Real
    force: Real
    length: Real
    root_moment: Real
    moment_max: Real
    energy: Real


@dataclass(frozen=True)
class Joint:
    """Roller beam joint: moment dV/d(theta_j), thrust dV/d(x_r), stiffness d2V/d(theta_j)2."""

    slope: Real
    force: Real
    length: Real
    root_moment: Real
    moment_max: Real
    energy: Real
    moment: Real
    thrust: Real
    stiffness: Real


def first_integral(t: Real) -> Real:
    """I1 for 0 <= t <= pi by Carlson's symmetric integral R_F."""
    if t > mp.pi / 2:
        return 2 * lemniscate(mp.mp.prec) - first_integral(mp.pi - t)
    s = mp.sin(t)
    return 2 * mp.sqrt(s) * mp.elliprf(1 - s, 1 + s, 1)


def second_integral(t: Real) -> Real:
    """I2 for 0 <= t <= pi by Carlson's symmetric integral R_D."""
    if t > mp.pi / 2:
        return 2 * mp.pi / lemniscate(mp.mp.prec) - second_integral(mp.pi - t)
    s = mp.sin(t)
    return 2 * mp.sqrt(s) ** 3 * mp.elliprd(1 - s, 1 + s, 1) / 3


@lru_cache
def lemniscate(_precision: int) -> Real:
    """Lemniscate constant 2.622..., I1 at the right angle."""
    return mp.gamma(mp.mpf(1) / 4) ** 2 / (2 * mp.sqrt(2 * mp.pi))


def integrals_by_quadrature(t: Real) -> tuple[Real, Real]:
    """I1 and I2 by numerical quadrature: checks the two closed forms.

    With sin(p) = q^2 the integrands are smooth at rest; near the right angle they are smooth as they stand.
    """

    def below(end: Real) -> tuple[Real, Real]:
        w = mp.sqrt(mp.sin(end))
        if w < mp.mpf("0.9"):
            return (
                mp.quad(lambda q: 2 / mp.sqrt(1 - q**4), [0, w]),
                mp.quad(lambda q: 2 * q**2 / mp.sqrt(1 - q**4), [0, w]),
            )
        start = mp.asin(mp.mpf("0.8"))
        first, second = below(start)
        return (
            first + mp.quad(lambda p: 1 / mp.sqrt(mp.sin(p)), [start, end]),
            second + mp.quad(lambda p: mp.sqrt(mp.sin(p)), [start, end]),
        )

    if t <= mp.pi / 2:
        return below(mp.mpf(t))
    right, other = below(mp.pi / 2), below(mp.pi - t)
    return 2 * right[0] - other[0], 2 * right[1] - other[1]


def polar_angle(t: Real, ratio: Real) -> Real:
    """beta(t) for a given r/rho."""
    if t == 0:
        return -mp.asin(ratio)
    second = second_integral(t)
    gamma = mp.atan2(second, 2 * mp.sqrt(mp.sin(t)))
    return t - gamma - mp.asin(ratio * mp.cos(gamma))


def _rate(t: Real, ratio: Real) -> Real:
    """d(beta)/dt in closed form; the tests compare it with a difference of `polar_angle`."""
    second = second_integral(t)
    root = mp.sqrt(mp.sin(t))
    tangent = second / (2 * root)
    turn = (mp.mpf(1) / 2 - second * mp.cos(t) / (4 * root**3)) / (1 + tangent**2)
    gamma = mp.atan(tangent)
    return 1 - turn + ratio * mp.sin(gamma) * turn / mp.sqrt(1 - (ratio * mp.cos(gamma)) ** 2)


def _float_rates(rest: NDArray[np.float64], ratio: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Values of beta and d(beta)/dt at t = pi - rest in float64: only to find where to look."""
    t, s, c = math.pi - rest, np.sin(rest), -np.cos(rest)
    below = 2 * s**1.5 * elliprd(1 - s, 1 + s, 1.0) / 3
    second = np.where(t > rest, 2 * math.pi / VARPI - below, below)
    tangent = second / (2 * np.sqrt(s))
    gamma = np.arctan(tangent)
    turn = (0.5 - second * c / (4 * s**1.5)) / (1 + tangent**2)
    beta = t - gamma - np.arcsin(ratio * np.cos(gamma))
    return beta, 1 - turn + ratio * np.sin(gamma) * turn / np.sqrt(1 - (ratio * np.cos(gamma)) ** 2)


@lru_cache(maxsize=4096)
def _near_fold(ratio: float) -> tuple[float, float]:
    """180 degrees less the slopes just below and just beyond the fold, where beta first falls."""
    # measured from 180 degrees, where the fold goes when r/rho goes to 1
    rest = np.append(np.linspace(math.pi - 1e-3, 0.01, 400), np.geomspace(0.01, 1e-12, 400)[1:])
    for _ in range(3):
        falling = _float_rates(rest, ratio)[1] < 0
        if not falling.any():
            raise BeyondFoldError("no fold below 180 degrees")
        first = max(int(np.argmax(falling)), 1)
        rest = np.linspace(rest[first - 1], rest[first], 400)
    return rest[0] * (1 + 1e-8), rest[-1] * (1 - 1e-8)


@lru_cache(maxsize=4096)
def _fold(ratio: Real, _precision: int) -> Real:
    low, high = (mp.pi - mp.mpf(rest) for rest in _near_fold(float(ratio)))
    return _bracketed(lambda t: -_rate(t, ratio), low, high)


def fold(ratio: Real) -> tuple[Real, Real]:
    """Slope and polar angle at the fold, for a given r/rho."""
    t = _fold(mp.mpf(ratio), mp.mp.prec)
    return t, polar_angle(t, mp.mpf(ratio))


def contact(cx: Real, cy: Real, *, radius: Real, flexural_rigidity: Real) -> Contact:
    """Stable equilibrium against a lower roller at (cx, cy), signed radius r; a few milliseconds.

    Raises
    ------
    NoContactError, BeyondFoldError
    """
    with mp.workdps(DIGITS + GUARD):
        cx, cy, r, rigidity = (mp.mpf(v) for v in (cx, cy, radius, flexural_rigidity))
        rho, beta = mp.hypot(cx, cy), mp.atan2(cy, cx)
        ratio = r / rho
        if cy + r <= 0:
            raise NoContactError
        t = _slope(ratio, beta)
        first, second = first_integral(t), second_integral(t)
        s = mp.sin(t)
        k = (cx * mp.cos(t) + cy * s) / (2 * mp.sqrt(s))
        root_moment = rigidity * mp.sqrt(s) / k
        return Contact(
            slope=t,
            force=rigidity / (2 * k**2),
            length=k * first,
            root_moment=root_moment,
            moment_max=root_moment if t <= mp.pi / 2 else rigidity / k,
            energy=rigidity * second / (2 * k),
        )


def _slope(ratio: Real, beta: Real) -> Real:
    """Slope at the contact on the stable branch."""
    end = mp.pi - mp.mpf(_near_fold(float(ratio))[0])
    if beta > polar_angle(end, ratio):  # within 1e-4 rad of the fold: the fold itself bounds the bracket
        low, (end, beta_fold) = end, fold(ratio)
        if beta > beta_fold:
            raise BeyondFoldError
        return _bracketed(lambda v: polar_angle(v, ratio) - beta, low, end)
    low, high = 0.0, float(end)
    for _ in range(2):
        grid = np.linspace(low, high, 2001)
        values = np.append(-np.inf, _float_rates(math.pi - grid[1:], float(ratio))[0])
        cell = min(max(int(np.searchsorted(values, float(beta))), 1), 2000)
        low, high = float(grid[cell - 1]), float(grid[cell])
    bracket = mp.mpf(low), mp.mpf(high)
    if not polar_angle(bracket[0], ratio) <= beta <= polar_angle(bracket[1], ratio):
        bracket = mp.mpf(0), end  # float64 was not good enough, as close to first contact
    return _bracketed(lambda v: polar_angle(v, ratio) - beta, *bracket)


def _bracketed(f: Any, low: Real, high: Real) -> Real:
    """Illinois method: keeps the bracket, converges faster than linearly."""
    f_low, f_high = f(low), f(high)
    if f_high == 0:
        return high
    if f_low == 0:
        return low
    if (f_low < 0) == (f_high < 0):
        raise ArithmeticError("no sign change in the bracket")
    tolerance = mp.mpf(10) ** -(DIGITS + GUARD - 6)
    for _ in range(300):
        middle = high - f_high * (high - low) / (f_high - f_low)
        f_middle = f(middle)
        if (f_middle < 0) == (f_high < 0):
            f_low /= 2
        else:
            low, f_low = high, f_high
        step = abs(middle - high)
        high, f_high = middle, f_middle
        if f_high == 0 or step < tolerance * abs(middle):
            return middle
    raise ArithmeticError("the bracket did not close")


def joint(
    setting: Real,
    deflection: Real,
    *,
    flexural_rigidity: Real,
    radius: Real,
    roller_offset: Real = 0,
    mounting_angle: Real = 0,
    clamp_offset_along: Real = 0,
    clamp_offset_across: Real = 0,
    upper: bool = False,
) -> Joint:
    """Roller beam at (x_r, theta_j) with one acting roller; `radius` is -clearance for a swivelling pair."""
    with mp.workdps(DIGITS + GUARD):
        sign = -1 if upper else 1
        x_r, along = mp.mpf(setting), mp.mpf(clamp_offset_along)
        d_r, d_0 = sign * mp.mpf(roller_offset), sign * mp.mpf(clamp_offset_across)
        wall = sign * mp.mpf(mounting_angle)
        turn = wall + sign * mp.mpf(deflection)
        cx = -along * mp.cos(wall) + d_0 * mp.sin(wall) + x_r * mp.cos(turn) - d_r * mp.sin(turn)
        cy = -along * mp.sin(wall) - d_0 * mp.cos(wall) + x_r * mp.sin(turn) + d_r * mp.cos(turn)
        found = contact(cx, cy, radius=radius, flexural_rigidity=flexural_rigidity)
        moment, thrust, stiffness = _loads(
            found.slope, turn - found.slope, (cx, cy), x_r, d_r, mp.mpf(radius), mp.mpf(flexural_rigidity)
        )
        return Joint(
            slope=sign * found.slope,
            force=found.force,
            length=found.length,
            root_moment=sign * found.root_moment,
            moment_max=found.moment_max,
            energy=found.energy,
            moment=sign * moment,
            thrust=thrust,
            stiffness=stiffness,
        )


def _loads(
    t: Real, zeta: Real, centre: tuple[Real, Real], x_r: Real, d_r: Real, r: Real, rigidity: Real
) -> tuple[Real, Real, Real]:
    """Moment, thrust and stiffness of a lower roller from the force and the Hessian of the energy."""
    s, second = mp.sin(t), second_integral(t)
    k = (centre[0] * mp.cos(t) + centre[1] * s) / (2 * mp.sqrt(s))
    force = rigidity / (2 * k**2)
    q_t = x_r * mp.cos(zeta) - d_r * mp.sin(zeta)
    q_n = x_r * mp.sin(zeta) + d_r * mp.cos(zeta)
    b = k * mp.cos(t) / mp.sqrt(s) + k * second + r
    d = 2 * k * s + second * b
    h_nn = rigidity * b / (k**3 * d)
    h_tn = -rigidity * mp.sqrt(s) / (k**2 * d)
    h_tt = -force * second / d
    stiffness = h_tt * q_n**2 - 2 * h_tn * q_n * q_t + h_nn * q_t**2 - force * q_n
    return force * q_t, force * mp.sin(zeta), stiffness


def _main() -> None:
    start = time.perf_counter()
    points = [(0.2 + 0.004 * i, math.radians(1 + i), 0.01 - 0.0002 * i) for i in range(90)]
    for setting, deflection, radius in points:
        try:
            found = joint(setting, deflection, flexural_rigidity=13, radius=radius)
        except (NoContactError, BeyondFoldError) as reason:
            print(f"{math.degrees(deflection):6.1f} deg  {type(reason).__name__}")
            continue
        if round(math.degrees(deflection)) % 15 == 0:
            print(f"{math.degrees(deflection):6.1f} deg  moment {mp.nstr(found.moment, DIGITS)} N m")
    seconds = time.perf_counter() - start
    print(f"{len(points)} points in {seconds:.2f} s")


if __name__ == "__main__":
    _main()
