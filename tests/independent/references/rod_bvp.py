"""Planar inextensible rod as a boundary-value problem with an unknown free length.

State (x, y, theta, M, U) over the scaled arc length s/L in [0, 1]; the active length L and the two components
of the force at the far end are unknown numbers.  With EI the flexural rigidity and (X, Y) the force on the
end

    x' = cos(theta),  y' = sin(theta),  EI theta' = M,  M' = X sin(theta) - Y cos(theta),  2 EI U' = M^2

(primes with respect to arc length).  Contact with a frictionless roller is geometry: the end of the active
part lies at the roller's signed radius from its centre, along the rod's normal, and the force has no
component along the rod.  Nothing is reduced, no quadrature is done in closed form.  Collocation (scipy
`solve_bvp`) with continuation in the roller's position.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_bvp

Floats = NDArray[np.float64]


class NoShapeError(RuntimeError):
    """The continuation stopped: no neighbouring equilibrium was found."""


@dataclass(frozen=True)
class Shape:
    """Equilibrium shape of a rod, from the clamp (0, 0, slope 0) to the loaded point."""

    s: Floats  # arc length, increasing from 0 to `length`
    x: Floats
    y: Floats
    slope: Floats
    moment: Floats
    energy: float
    force_x: float
    force_y: float

    @property
    def length(self) -> float:
        """Arc length of the loaded part [m]."""
        return float(self.s[-1])

    @property
    def end_slope(self) -> float:
        """Slope at the loaded point [rad]."""
        return float(self.slope[-1])

    @property
    def force(self) -> float:
        """Size of the end force [N]."""
        return math.hypot(self.force_x, self.force_y)

    @property
    def root_moment(self) -> float:
        """Bending moment at the clamp [N m]."""
        return float(self.moment[0])

    @property
    def moment_max(self) -> float:
        """Largest bending moment on a parabola through the largest node and its neighbours [N m]."""
        k = int(np.argmax(np.abs(self.moment)))
        if k in (0, len(self.s) - 1):
            return float(abs(self.moment[k]))
        coefficients = np.polyfit(self.s[k - 1 : k + 2] - self.s[k], np.abs(self.moment[k - 1 : k + 2]), 2)
        return float(coefficients[2] - coefficients[1] ** 2 / (4 * coefficients[0]))

    def with_tail(self, total_length: float, spacing: float) -> tuple[Floats, Floats]:
        """Points of the shape continued by its straight free end up to a total length."""
        free = np.arange(spacing, max(total_length - self.length, 0.0) + spacing / 2, spacing)
        return (
            np.concatenate([self.x, self.x[-1] + free * math.cos(self.end_slope)]),
            np.concatenate([self.y, self.y[-1] + free * math.sin(self.end_slope)]),
        )


def _slopes(state: Floats, length: float, force_x: float, force_y: float) -> Floats:
    """Right-hand side with EI = 1, per unit of scaled arc length."""
    _, _, theta, moment, _ = state
    cosine, sine = np.cos(theta), np.sin(theta)
    rates = np.vstack([cosine, sine, moment, force_x * sine - force_y * cosine, 0.5 * moment**2])
    return np.asarray(length * rates)


def _small_deflection(height: float, distance: float, nodes: int = 21) -> tuple[Floats, Floats, NDArray[np.float64]]:
    """Linear cantilever with a given end deflection: first guess with EI = 1."""
    t = np.linspace(0.0, 1.0, nodes)
    force = 3.0 * height / distance**3
    x, y = distance * t, height * (3 * t**2 - t**3) / 2
    theta = height * (6 * t - 3 * t**2) / (2 * distance)
    moment = force * distance * (1 - t)
    energy = 0.5 * force**2 * distance**3 * (1 - (1 - t) ** 3) / 3
    return t, np.vstack([x, y, theta, moment, energy]), np.array([distance, 0.0, force])


def _solve(
    centre: tuple[float, float],
    radius: float,
    guess: tuple[Floats, Floats, Floats],
    tolerance: float,
) -> tuple[Floats, Floats, Floats] | None:
    """One collocation solve with EI = 1, or None where it fails."""

    def rhs(_t: Floats, state: Floats, unknown: Floats) -> Floats:
        return _slopes(state, unknown[0], unknown[1], unknown[2])

    def ends(left: Floats, right: Floats, unknown: Floats) -> Floats:
        x, y, theta, moment, _ = right
        return np.array(
            [
                left[0],
                left[1],
                left[2],
                left[4],
                moment,
                x - centre[0] + radius * math.sin(theta),
                y - centre[1] - radius * math.cos(theta),
                unknown[1] * math.cos(theta) + unknown[2] * math.sin(theta),
            ]
        )

    result = solve_bvp(rhs, ends, guess[0], guess[1], p=guess[2], tol=tolerance, max_nodes=2500)
    if not result.success or result.p[0] <= 0:
        return None
    return result.x, result.y, result.p


def _as_shape(solution: tuple[Floats, Floats, Floats], flexural_rigidity: float) -> Shape:
    t, state, unknown = solution
    return Shape(
        s=t * unknown[0],
        x=state[0],
        y=state[1],
        slope=state[2],
        moment=flexural_rigidity * state[3],
        energy=float(flexural_rigidity * state[4, -1]),
        force_x=float(flexural_rigidity * unknown[1]),
        force_y=float(flexural_rigidity * unknown[2]),
    )


def roller_contact(
    centre: tuple[float, float],
    *,
    radius: float,
    flexural_rigidity: float,
    tolerance: float = 1e-9,
) -> Shape:
    """Rod pushed to +y by a lower roller whose centre is given in the clamp's frame.

    Parameters
    ----------
    centre : roller's centre (Cx, Cy) [m]
    radius : signed distance from the centre to the rod's centreline [m]; negative for a swivelling pair
    flexural_rigidity : EI [N m^2]
    tolerance : relative residual of the last collocation

    Raises
    ------
    NoShapeError
        where the continuation along the circle of the centre stops before the centre is reached.

    Notes
    -----
    The centre travels on a circle about the clamp, from 0.05 rad of polar angle past contact to its place,
    so that the shape reached is the one that grows from rest.
    """
    rho, target = math.hypot(*centre), math.atan2(centre[1], centre[0])
    scaled_radius = radius / rho
    touch = -math.asin(scaled_radius)
    if target <= touch:
        raise NoShapeError("the roller does not touch the straight rod")
    angle = min(target, touch + 0.05)
    reach, rise = math.cos(angle), math.sin(angle) + scaled_radius
    guess = _small_deflection(rise, reach)
    step, done = 0.2, touch
    while True:
        place = (math.cos(angle), math.sin(angle))
        found = _solve(place, scaled_radius, guess, tolerance if angle == target else 1e-4)
        if found is None:
            step *= 0.5
            if step < 2e-3 or done == touch:
                raise NoShapeError(f"stopped at a polar angle of {math.degrees(done):.2f} degrees")
            angle = min(target, done + step)
            continue
        guess = found
        if angle == target:
            break
        done, angle = angle, min(target, angle + step)
    t, state, unknown = guess
    lengths = np.array([rho, rho, 1.0, 1.0 / rho, 1.0 / rho])
    scaled = (t, state * lengths[:, None], unknown * np.array([rho, rho**-2, rho**-2]))
    return _as_shape(scaled, flexural_rigidity)


def dead_load(load: float, *, length: float, flexural_rigidity: float, tolerance: float = 1e-9) -> Shape:
    """Cantilever of a given length under an end force that stays vertical: the textbook elastica."""
    return _given_length(load, length=length, flexural_rigidity=flexural_rigidity, follows=False, tolerance=tolerance)


def follower_load(load: float, *, length: float, flexural_rigidity: float, tolerance: float = 1e-9) -> Shape:
    """Cantilever of a given length under an end force that stays normal to its end."""
    return _given_length(load, length=length, flexural_rigidity=flexural_rigidity, follows=True, tolerance=tolerance)


def _given_length(load: float, *, length: float, flexural_rigidity: float, follows: bool, tolerance: float) -> Shape:
    final = load * length**2 / flexural_rigidity
    guess: tuple[Floats, Floats, Floats] = _small_deflection(0.05, 1.0)
    for value in np.append(np.arange(0.5, final, 0.5), final):

        def rhs(_t: Floats, state: Floats, unknown: Floats) -> Floats:
            return _slopes(state, 1.0, unknown[0], unknown[1])

        def ends(left: Floats, right: Floats, unknown: Floats, value: float = float(value)) -> Floats:
            tilt = right[2] if follows else 0.0
            aim = [unknown[0] + value * math.sin(tilt), unknown[1] - value * math.cos(tilt)]
            return np.array([left[0], left[1], left[2], left[4], right[3], *aim])

        sharp = tolerance if value == final else 1e-4
        result = solve_bvp(rhs, ends, guess[0], guess[1], p=guess[2][-2:], tol=sharp, max_nodes=2500)
        if not result.success:
            raise NoShapeError(f"no shape at a load parameter of {value}")
        guess = (result.x, result.y, np.append(1.0, result.p))
    t, state, unknown = guess
    lengths = np.array([length, length, 1.0, 1.0 / length, 1.0 / length])
    scaled = (t, state * lengths[:, None], np.array([length, *(unknown[1:] / length**2)]))
    return _as_shape(scaled, flexural_rigidity)
