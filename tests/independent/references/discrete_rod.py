"""Energy minimisation of a discretised rod against frictionless obstacles.

The slope theta(s) is continuous and linear on equal elements, so the bending energy is a sum of squares of
the hinge curvatures; positions follow by two-point Gauss quadrature.  No equation of equilibrium is
written: the direction of the contact force, the free tail and stability come out of the minimisation.

`obstacle`: a clamped rod of its full physical length held off a disc.  The offset curve p - r n (for r > 0
the face of the rod that a roller of radius r touches) must run through the disc's centre at some arc length
sigma; sigma is a variable of the minimisation.  That only one such place exists, and that the rod stays on
its side of the disc elsewhere, is checked afterwards.

`sleeve`: a leaf of free length between a clamp and a parallel frictionless sleeve, with an optional bound
on its curvature (cylinders of that radius at both ends).

The discretisation error falls with the square of the element; `extrapolated` removes that term.  The bend in
theta'' where the free tail begins falls inside an element and leaves an error of third order.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

Floats = NDArray[np.float64]
_GAUSS = np.array([0.5 - 0.5 / math.sqrt(3.0), 0.5 + 0.5 / math.sqrt(3.0)])


class NoMinimumError(RuntimeError):
    """The minimiser did not converge."""


@dataclass(frozen=True)
class Minimum:
    """What the minimisation found; forces are the multipliers of the constraints."""

    energy: float
    active_length: float
    slope: float  # at the contact (obstacle) or the largest (sleeve)
    force_x: float
    force_y: float
    curvature_max: float
    x: Floats
    y: Floats

    @property
    def force(self) -> float:
        """Size of the contact force [N]."""
        return math.hypot(self.force_x, self.force_y)


def _element_steps(curvature: Floats, size: float) -> tuple[Floats, Floats, Floats, Floats, Callable[[Floats], Floats]]:
    """Nodal slopes, the steps (dx, dy) of every element, and the steps' derivatives to the nodal slopes."""
    theta = np.concatenate([[0.0], np.cumsum(curvature) * size])
    inside = theta[:-1, None] * (1 - _GAUSS) + theta[1:, None] * _GAUSS
    cosine, sine = np.cos(inside), np.sin(inside)
    half = 0.5 * size
    steps_x, steps_y = half * cosine.sum(axis=1), half * sine.sum(axis=1)

    def to_curvature(weight: Floats) -> Floats:
        """Derivative of sum_e (wx dx + wy dy) to the hinge curvatures; weight has shape (2, elements)."""
        pull = half * (-sine * weight[0][:, None] + cosine * weight[1][:, None])
        nodal = np.zeros_like(theta)
        nodal[:-1] += pull @ (1 - _GAUSS)
        nodal[1:] += pull @ _GAUSS
        return np.asarray(size * np.cumsum(nodal[:0:-1])[::-1])

    return theta, steps_x, steps_y, inside, to_curvature


class _Obstacle:
    """Constraint of the clamped rod: the offset curve passes through the disc's centre at sigma."""

    def __init__(self, centre: tuple[float, float], radius: float, size: float, elements: int) -> None:
        self.centre, self.radius, self.size, self.elements = centre, radius, size, elements

    def evaluate(self, variables: Floats) -> tuple[Floats, Floats]:
        """Gap (2,) and its derivative (2, elements + 1)."""
        curvature, sigma = variables[:-1], variables[-1]
        theta, dx, dy, _, to_curvature = _element_steps(curvature, self.size)
        e = min(max(int(sigma / self.size), 0), self.elements - 1)
        part = sigma - e * self.size
        bend = curvature[e]
        points = part * _GAUSS
        slopes = theta[e] + bend * points
        tip = theta[e] + bend * part
        cosine, sine = math.cos(tip), math.sin(tip)
        half = 0.5 * part
        place = np.array([dx[:e].sum() + half * np.cos(slopes).sum(), dy[:e].sum() + half * np.sin(slopes).sum()])
        gap = place - self.radius * np.array([-sine, cosine]) - np.array(self.centre)
        jacobian = np.zeros((2, self.elements + 1))
        turn = self.radius * np.array([cosine, sine])
        for row in range(2):
            weight = np.zeros((2, self.elements))
            weight[row, :e] = 1.0
            jacobian[row, :-1] = to_curvature(weight)
            pull = -np.sin(slopes) if row == 0 else np.cos(slopes)
            jacobian[row, :e] += self.size * (half * pull.sum() + turn[row])
            jacobian[row, e] += half * float(pull @ points) + turn[row] * part
        tangent = np.array([cosine, sine])
        # d(half * sum f(points)) / d(part): exact for what is coded, not for the integral
        jacobian[0, -1] = 0.5 * np.cos(slopes).sum() - half * float((np.sin(slopes) * bend) @ _GAUSS)
        jacobian[1, -1] = 0.5 * np.sin(slopes).sum() + half * float((np.cos(slopes) * bend) @ _GAUSS)
        jacobian[:, -1] += self.radius * bend * tangent
        return gap, jacobian


def obstacle(
    centre: tuple[float, float],
    *,
    radius: float,
    flexural_rigidity: float,
    length: float,
    elements: int,
) -> Minimum:
    """Clamped rod of a given total length held above a disc (a lower roller).

    Raises
    ------
    NoMinimumError
        where SLSQP does not converge, the rod slips off the disc, the disc pulls instead of pushes, or the
        rod crosses the disc elsewhere.
    """
    size = length / elements
    contact = _Obstacle(centre, radius, size, elements)
    reach = math.hypot(*centre)
    # curvature = variable/sqrt(size reach): the energy is half the sum of squares, in units of EI/reach
    units = np.append(np.full(elements, 1.0 / math.sqrt(size * reach)), reach)

    def split(z: Floats) -> Floats:
        return np.asarray(z * units)

    start = np.append(np.zeros(elements), min(1.02, 0.98 * length / reach))
    s = (np.arange(elements) + 0.5) * size
    bend = np.where(s < reach, 3.0 * centre[1] * (reach - s) / reach**3, 0.0)
    start[:-1] = bend / units[:-1]

    def objective(z: Floats) -> tuple[float, Floats]:
        return 0.5 * float(z[:-1] @ z[:-1]), np.append(z[:-1], 0.0)

    def gap(z: Floats) -> Floats:
        return np.asarray(contact.evaluate(split(z))[0] / reach)

    def gap_slope(z: Floats) -> Floats:
        return np.asarray(contact.evaluate(split(z))[1] * units / reach)

    found = minimize(
        objective,
        start,
        jac=True,
        method="SLSQP",
        bounds=[(None, None)] * elements + [(1e-3, length / reach)],
        constraints={"type": "eq", "fun": gap, "jac": gap_slope},
        options={"maxiter": 500, "ftol": 1e-14},
    )
    if not found.success or float(np.abs(gap(found.x)).max()) > 1e-8:
        raise NoMinimumError(str(found.message))
    variables = split(found.x)
    curvature, sigma = variables[:-1], float(variables[-1])
    theta, dx, dy, _, _ = _element_steps(curvature, size)
    if sigma > length * (1 - 1e-6):
        raise NoMinimumError("the rod has slipped off: its far end is at the disc")
    multiplier, *_ = np.linalg.lstsq(gap_slope(found.x).T, objective(found.x)[1], rcond=None)
    unit = flexural_rigidity / reach**2
    e = min(int(sigma / size), elements - 1)
    x, y = np.concatenate([[0.0], np.cumsum(dx)]), np.concatenate([[0.0], np.cumsum(dy)])
    minimum = Minimum(
        energy=float(found.fun) * flexural_rigidity / reach,
        active_length=sigma,
        slope=float(theta[e] + curvature[e] * (sigma - e * size)),
        force_x=float(multiplier[0]) * unit,
        force_y=float(multiplier[1]) * unit,
        curvature_max=float(np.abs(curvature).max()),
        x=x,
        y=y,
    )
    if -minimum.force_x * math.sin(minimum.slope) + minimum.force_y * math.cos(minimum.slope) < 0:
        raise NoMinimumError("the disc would have to pull")
    if float(np.hypot(x - centre[0], y - centre[1]).min()) < radius * (1 - 1e-6) - size**2 / reach:
        raise NoMinimumError("the rod crosses the disc")
    return minimum


def sleeve(
    span: float,
    height: float,
    *,
    flexural_rigidity: float,
    elements: int,
    curvature_limit: float = math.inf,
) -> Minimum:
    """Leaf of free length, clamped at one end, held parallel to the clamp by a sleeve (span, height) away.

    ``force_x`` is what the leaf pushes the sleeve outward with [N], -dU/d(span).
    """
    reach = math.hypot(span, height)

    def parts(z: Floats) -> tuple[Floats, Floats, Floats, Floats, Callable[[Floats], Floats], float]:
        length = z[-1] * reach
        curvature = z[:-1] / length
        theta, dx, dy, inside, pull = _element_steps(curvature, length / elements)
        return theta, dx, dy, inside, pull, length

    def objective(z: Floats) -> tuple[float, Floats]:
        square = float(z[:-1] @ z[:-1]) / elements
        return 0.5 * square / z[-1], np.append(z[:-1] / elements / z[-1], -0.5 * square / z[-1] ** 2)

    def gap(z: Floats) -> Floats:
        theta, dx, dy, *_ = parts(z)
        return np.array([(dx.sum() - span) / reach, (dy.sum() - height) / reach, theta[-1]])

    def gap_slope(z: Floats) -> Floats:
        _, dx, dy, _, pull, length = parts(z)
        jacobian = np.zeros((3, elements + 1))
        # slopes depend on z / elements only: the length scales every step
        for row, steps in enumerate((dx, dy)):
            weight = np.zeros((2, elements))
            weight[row] = 1.0
            jacobian[row, :-1] = pull(weight) / length / reach
            jacobian[row, -1] = steps.sum() / length
        jacobian[2, :-1] = 1.0 / elements
        return jacobian

    t = (np.arange(elements) + 0.5) / elements
    start = np.append(6.0 * height / reach * (1 - 2 * t), 1.05)
    constraints: list[dict[str, object]] = [{"type": "eq", "fun": gap, "jac": gap_slope}]
    if math.isfinite(curvature_limit):
        bound = curvature_limit * reach
        start[:-1] = np.clip(start[:-1], -bound * start[-1], bound * start[-1])
        wall = np.vstack([-np.eye(elements), np.eye(elements)])
        wall = np.hstack([wall, np.full((2 * elements, 1), bound)])
        constraints.append({"type": "ineq", "fun": lambda z: wall @ z, "jac": lambda z: wall})
    found = minimize(
        objective,
        start,
        jac=True,
        method="SLSQP",
        bounds=[(None, None)] * elements + [(0.5, 20.0)],
        constraints=constraints,
        options={"maxiter": 500, "ftol": 1e-14},
    )
    if not found.success or float(np.abs(gap(found.x)).max()) > 1e-8:
        raise NoMinimumError(str(found.message))
    theta, dx, dy, _, _, length = parts(found.x)
    free = np.abs(found.x[:-1]) < 0.999 * curvature_limit * length
    rows = np.append(free, math.isinf(curvature_limit))  # equations without an active bound
    multiplier, *_ = np.linalg.lstsq(gap_slope(found.x)[:, rows].T, objective(found.x)[1][rows], rcond=None)
    return Minimum(
        energy=float(found.fun) * flexural_rigidity / reach,
        active_length=length,
        slope=float(np.abs(theta).max()),
        force_x=-float(multiplier[0]) * flexural_rigidity / reach**2,
        force_y=float(multiplier[1]) * flexural_rigidity / reach**2,
        curvature_max=float(np.abs(found.x[:-1]).max() / length),
        x=np.concatenate([[0.0], np.cumsum(dx)]),
        y=np.concatenate([[0.0], np.cumsum(dy)]),
    )


def extrapolated(coarse: float, fine: float) -> float:
    """Richardson: remove the term of second order from values at `elements` and twice as many."""
    return fine + (fine - coarse) / 3.0
