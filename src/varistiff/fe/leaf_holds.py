"""What holds the leaf: the few unknowns beside the displacement, and their equations.

Each hold adds unknowns q to the leaf's displacement v. The equilibrium is

    R(v, q) = dW/dv + dP/dv + (force of the hold) = 0,    c(v, q) = 0

and Newton's method needs dR/dq (columns), dc/dv (rows) and dc/dq (block). The force acts on the section of the contact,
spread evenly over thickness and, in the mean, over width. A stiff spring P keeps the section's mid-line a straight
line, as a rigid roller does: it pushes or pulls where the leaf would bend away over its width, and bears no force in
the mean.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import numpy as np

from varistiff.fe import import_ngsolve
from varistiff.fe.leaf_mesh import Floats
from varistiff.fe.leaf_solid import LeafSolid, half_inertia, unit

_STIFFNESS = 10.0  # of the spring P, in units of E over the span
_LARGEST_TURN = 0.2  # of the force's direction in one step [rad]


class LeafHold(ABC):
    """Unknowns and equations of a hold, on one solid; ``unknowns`` is q."""

    def __init__(self, solid: LeafSolid, unknowns: Floats) -> None:
        self.solid, self.unknowns = solid, unknowns
        self.columns: list[Any] = []
        self.rows: list[Any] = []

    @abstractmethod
    def update(self, residual: Any) -> tuple[Floats, Floats]:
        """Add the hold's force to the residual, set ``columns`` and ``rows``; return c and dc/dq.

        The solid's forms hold the parameters of the last ``place``.
        """

    @abstractmethod
    def place(self) -> None:
        """Hand the unknowns to the solid's forms."""

    def step_limit(self, change: Floats) -> float:
        """Part of a Newton step that may be taken."""
        del change
        return 1.0

    def pushes(self) -> bool:
        """Whether the force has the sign that the contact can bear."""
        return True


class HeldLine(LeafHold):
    """A line across the leaf held at a place by a force of direction n(slope); base of both contacts.

    q = (force, slope, stretch, swelling) or without the slope. The swelling is the thickness of the
    contact's section along n over that of the straight leaf: the spring P must resist neither Poisson's effect nor a
    tilt against n.
    """

    def __init__(
        self, solid: LeafSolid, unknowns: Floats, *, centre: tuple[float, float], radius: float, youngs_modulus: float
    ) -> None:
        super().__init__(solid, unknowns)
        ng = import_ngsolve()
        span = float(solid.grid.along[solid.grid.span])
        self._spring = _STIFFNESS * youngs_modulus / span
        self._centre, self.radius = centre, radius
        self._normal = (ng.Parameter(0.0), ng.Parameter(1.0))
        self._swelling = ng.Parameter(1.0)
        normal = ng.CF((*self._normal, 0.0))
        tangent = ng.CF((self._normal[1], -self._normal[0], 0.0))
        offset = ng.CF((*centre, 0.0))

        def gap(u: Any) -> Any:
            return ng.InnerProduct(normal, solid.position + u - offset) - radius - self._swelling * ng.y

        spring = 0.5 * self._spring * gap(solid.space.TrialFunction()) ** 2
        solid.form += ng.Variation(spring * ng.ds("contact"))
        self._gap = gap(solid.displacement)
        self._slip = ng.InnerProduct(tangent, solid.position + solid.displacement - offset)
        self._apart = self._gap + radius + self._swelling * ng.y
        self._directions = (normal, tangent)
        self._means = [solid.contact_vector(ng.CF(axis) / solid.section) for axis in ((1, 0, 0), (0, 1, 0))]

    def _set(self, slope: float, stretch: float, swelling: float) -> None:
        _, normal = unit(slope)
        for parameter, value in zip(self._normal, normal, strict=True):
            parameter.Set(value)
        self.solid.stretch.Set(stretch)
        self._swelling.Set(swelling)

    def mean(self, direction: tuple[float, float], factor: float = 1.0) -> Any:
        """Vector of v -> factor times the mean over the section of direction . v."""
        result = self.solid.vector()
        result.data = factor * direction[0] * self._means[0]
        result.data += factor * direction[1] * self._means[1]
        return result

    def pushes(self) -> bool:
        """A roller cannot pull; a solution where it does is another one."""
        return bool(self.unknowns[0] > 0.0)

    def distance(self) -> Floats:
        """Mean position of the section relative to the centre, (x, y) [m]."""
        solid = self.solid
        values = [
            solid.over_contact((solid.position + solid.displacement)[i]) / solid.section - self._centre[i]
            for i in range(2)
        ]
        return np.array(values)

    def _swelling_column(self) -> Any:
        ng = import_ngsolve()
        return self.solid.contact_vector(-self._spring * ng.y * self._directions[0])

    def _swelling_equation(self) -> tuple[float, float]:
        """dP/d(swelling) and its own derivative."""
        ng = import_ngsolve()
        first = self.solid.over_contact(-self._spring * self._gap * ng.y)
        second = self.solid.over_contact(self._spring * ng.y * ng.y)
        return first, second


class SlidingHold(HeldLine):
    """The frictionless roller, q = (force, slope, stretch, swelling): stationary points of one potential L.

        L = W + P - force (n . (x - C) - r)

    so the load is dV/dC = force n exactly, on every mesh.
    """

    def place(self) -> None:
        """Hand the unknowns to the forms."""
        _, slope, stretch, swelling = map(float, self.unknowns)
        self._set(slope, stretch, swelling)

    def step_limit(self, change: Floats) -> float:
        """A force that turns further loses its way."""
        return min(1.0, _LARGEST_TURN / max(abs(float(change[1])), 1e-300))

    def update(self, residual: Any) -> tuple[Floats, Floats]:
        """Derivatives of L."""
        ng = import_ngsolve()
        solid, k = self.solid, self._spring
        force, slope, _, _ = map(float, self.unknowns)
        tangent, normal = unit(slope)
        away = self.distance()
        along, across = float(away @ tangent), float(away @ normal)
        push = self.mean(normal, -1.0)
        residual.data += force * push
        turn = solid.contact_vector(-k * (self._slip * self._directions[0] + self._gap * self._directions[1]))
        turn.data += self.mean(tangent, force)
        stretch, stretch_rate = solid.stretch_derivatives()
        swelling, swelling_rate = self._swelling_equation()
        self.columns = [push, turn, stretch, self._swelling_column()]
        self.rows = self.columns
        spring_turn = solid.over_contact(-k * self._gap * self._slip)
        spring_rate = solid.over_contact(k * (self._slip * self._slip - self._gap * self._apart))
        mixed = solid.over_contact(k * ng.y * self._slip)
        equations = np.array([self.radius - across, spring_turn + force * along, solid.stretch_force(), swelling])
        block = np.array(
            [
                [0.0, along, 0.0, 0.0],
                [along, spring_rate + force * across, 0.0, mixed],
                [0.0, 0.0, stretch_rate, 0.0],
                [0.0, mixed, 0.0, swelling_rate],
            ]
        )
        return equations, block

    def moved(self, axis: int) -> tuple[Any, Floats]:
        """Derivatives of R and c with respect to the centre's coordinate ``axis``."""
        force, slope = map(float, self.unknowns[:2])
        tangent, normal = unit(slope)
        stiffness = self._spring * self.solid.section
        away = self.distance()
        # the spring's couple lets the mean of the section slip by a hair
        turning = stiffness * (normal[axis] * (away @ tangent) + tangent[axis] * (away @ normal - self.radius))
        column = self.mean(normal, -stiffness * normal[axis])
        return column, np.array([normal[axis], turning - force * tangent[axis], 0.0, 0.0])


class UprightHold(HeldLine):
    """The guided leaf's middle, q = (force, stretch, swelling): the force is upright, the length puts it in place."""

    def place(self) -> None:
        """Hand the unknowns to the forms."""
        _, stretch, swelling = map(float, self.unknowns)
        self._set(0.0, stretch, swelling)

    def update(self, residual: Any) -> tuple[Floats, Floats]:
        """Equilibrium, and the two coordinates of the middle."""
        force = float(self.unknowns[0])
        push = self.mean((0.0, 1.0), -1.0)
        residual.data += force * push
        stretch, _ = self.solid.stretch_derivatives()
        swelling, swelling_rate = self._swelling_equation()
        column = self._swelling_column()
        self.columns = [push, stretch, column]
        self.rows = [push, self.mean((1.0, 0.0)), column]
        x, y = self.distance()
        block = np.zeros((3, 3))
        block[2, 2] = swelling_rate
        return np.array([-y, x, swelling]), block

    def moved(self, axis: int) -> tuple[Any, Floats]:
        """Derivatives of R and c with respect to the centre's coordinate ``axis``."""
        upright = float(axis == 1)
        column = self.mean((0.0, 1.0), -self._spring * self.solid.section * upright)
        return column, np.array([upright, upright - 1.0, 0.0])


class TurnedHold(LeafHold):
    """The end turned by a moment, q = (moment,): L = W + moment c, c = sin(angle less the section's mean turn)."""

    def __init__(self, solid: LeafSolid, unknowns: Floats, *, angle: float, width: float) -> None:
        super().__init__(solid, unknowns)
        ng = import_ngsolve()
        self.angle, self._inertia = angle, half_inertia(width, solid.thickness)
        tangent, normal = (ng.CF((*axis, 0.0)) for axis in unit(angle))
        self._turn = ng.InnerProduct(tangent, solid.position + solid.displacement) * ng.y / self._inertia
        self._couple = solid.contact_vector(ng.y * tangent / self._inertia)
        self._follow = solid.contact_vector(ng.y * normal / self._inertia)
        self.rows = self.columns = [self._couple]

    def place(self) -> None:
        """Nothing in the forms depends on the moment."""

    def update(self, residual: Any) -> tuple[Floats, Floats]:
        """Derivatives of L."""
        residual.data += float(self.unknowns[0]) * self._couple
        return np.array([self.solid.over_contact(self._turn)]), np.zeros((1, 1))

    def moved(self) -> tuple[Any, Floats]:
        """Derivatives of R and c with respect to the angle."""
        column = self.solid.vector()
        column.data = float(self.unknowns[0]) * self._follow
        ng = import_ngsolve()
        _, normal = unit(self.angle)
        turned = ng.InnerProduct(ng.CF((*normal, 0.0)), self.solid.position + self.solid.displacement)
        return column, np.array([self.solid.over_contact(turned * ng.y / self._inertia)])
