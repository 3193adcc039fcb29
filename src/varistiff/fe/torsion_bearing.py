"""The counter bearing: pressure on the outside of the solid, given or found by unilateral contact."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.fe import import_ngsolve
from varistiff.fe.torsion_linear import ElasticSolid

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


class Bearing:
    """Normal pressure at Gauss points of the bearing surface and the displacement that answers it.

    With a mirror plane the surface consists of the sector's points and of their mirror images; pressures p1 and p2
    there are the sum of an antisymmetric load (p1 - p2)/2 and a symmetric one (p1 + p2)/2, each solved on the sector:

        inward displacement  v1 = C_s p_s + C_a p_a,  v2 = C_s p_s - C_a p_a,   C = B^T K^-1 B.

    Arrays over the surface have the shape (sides, points): two sides with a mirror, one without.

    Parameters
    ----------
    solids : (antisymmetric, symmetric) or (whole,), factorised
    order : of the displacement; the pressure is one order less smooth: (order - 1)^2 points on a face
    one_flank : only one side of each rail can be pressed, the one that drives counter-clockwise
    """

    def __init__(self, solids: tuple[ElasticSolid, ...], *, order: int, one_flank: bool) -> None:
        ng = import_ngsolve()
        from ngsolve.comp import IntegrationRuleSpaceSurface

        self.solids = solids
        mesh = solids[0].solid.mesh
        region = mesh.Boundaries("bearing")
        self._space = IntegrationRuleSpaceSurface(mesh, order=order - 2, definedon=region)
        rules = self._space.GetIntegrationRules()
        pressure = self._space.TrialFunction()
        normal = ng.specialcf.normal(3)
        self._loads = []
        for solid in solids:
            form = ng.BilinearForm(trialspace=self._space, testspace=solid.space)
            inward = -1.0 * (solid.displacement(solid.space.TestFunction()) * normal)
            form += pressure * inward * ng.ds(definedon=region, intrules=rules)
            form.Assemble()
            self._loads.append((form.mat, form.mat.CreateTranspose()))
        measure = ng.LinearForm(self._space)
        measure += 1.0 * self._space.TestFunction() * ng.ds(definedon=region, intrules=rules)
        measure.Assemble()
        weights = np.array(measure.vec.FV().NumPy())
        self.points = np.stack([self._values(axis, region) for axis in (ng.x, ng.y, ng.z)], axis=1)
        normals = np.stack([self._values(normal[axis], region) for axis in (0, 1)], axis=1)
        # the bearing turns by +1 about z: its inward motion at a point is -(e_z x r).n
        lever = self.points[:, 1] * normals[:, 0] - self.points[:, 0] * normals[:, 1]
        both = len(solids) == 2
        self.weights = np.stack([weights, weights]) if both else weights[None]
        self.levers = np.stack([lever, -lever]) if both else lever[None]
        self.facing: Flags = self.levers > 0.0 if one_flank else np.full(self.levers.shape, True)
        self.solves = 0

    def _values(self, function: Any, region: Any) -> Floats:
        ng = import_ngsolve()
        grid = ng.GridFunction(self._space)
        grid.Interpolate(function, definedon=region)
        return np.array(grid.vec.FV().NumPy())

    def torque(self, pressure: Floats) -> float:
        """Torque of a pressure on one sector and its mirror image [N m]."""
        return float(np.sum(self.levers * self.weights * pressure))

    def displacements(self, pressure: Floats) -> tuple[Any, ...]:
        """Components of the displacement for each solid, as vectors."""
        parts = (
            (0.5 * (pressure[0] - pressure[1]), 0.5 * (pressure[0] + pressure[1])) if len(pressure) == 2 else pressure
        )
        found = []
        for part, solid, (load, _) in zip(parts, self.solids, self._loads, strict=True):
            values = load.CreateRowVector()
            values.FV().NumPy()[:] = part
            force = load.CreateColVector()
            force.data = load * values
            found.append(solid.solve(force))
            self.solves += 1
        return tuple(found)

    def answer(self, pressure: Floats) -> Floats:
        """C p: inward displacement times the area of each point [m^3]."""
        parts = []
        for w, (load, transposed) in zip(self.displacements(pressure), self._loads, strict=True):
            values = load.CreateRowVector()
            values.data = transposed * w
            parts.append(np.array(values.FV().NumPy()))
        if len(parts) == 1:
            return parts[0][None]
        return np.stack([parts[1] + parts[0], parts[1] - parts[0]])

    def uniform(self) -> Floats:
        """Pressure of 1 Pa on all that faces the bearing."""
        return self.facing.astype(float)


def contact_pressure(bearing: Bearing, *, tolerance: float = 1e-6, steps: int = 40) -> Floats:
    """Pressure of a rigid frictionless bearing that has turned by one radian (linear theory), without clearance.

        p >= 0,   C p >= A l,   p (C p - A l) = 0,   l the lever arm, A the area of a point

    by a primal-dual active set, the system on the active points by conjugate gradients.

    Raises
    ------
    InputError : the active set does not settle
    """
    wanted = bearing.weights * bearing.levers
    active = bearing.facing & (bearing.levers > 0.0)
    pressure = np.zeros(bearing.levers.shape)
    for _ in range(steps):
        if not active.any():
            break
        pressure, answer = _solve_active(bearing, wanted, active, np.where(active, pressure, 0.0), tolerance)
        slack = (answer - wanted) / np.sqrt(np.mean(wanted**2))  # below zero: the bearing would enter the solid
        keep = active & (pressure > 0.0)
        enter = bearing.facing & ~active & (slack < -10.0 * tolerance)
        if np.array_equal(keep | enter, active):
            return pressure
        active = keep | enter
    raise InputError(
        "the contact with the counter bearing does not settle; allowed is a bearing that can turn the element"
    )


def _solve_active(
    bearing: Bearing, wanted: Floats, active: Flags, start: Floats, tolerance: float
) -> tuple[Floats, Floats]:
    """Solve C p = wanted on the active points; return p and C p everywhere."""
    scale = np.where(active, bearing.weights**-1.5, 0.0)  # C acts like an operator of order -1
    pressure, answer = start, bearing.answer(start)
    residual = np.where(active, wanted - answer, 0.0)
    goal = tolerance**2 * float(np.sum(wanted[active] ** 2 * scale[active]))
    direction, before = np.zeros_like(start), 1.0
    for _ in range(400):
        preconditioned = scale * residual
        now = float(np.sum(residual * preconditioned))
        if now <= goal:
            break
        direction = preconditioned + (now / before if direction.any() else 0.0) * direction
        image = bearing.answer(direction)
        step = now / float(np.sum(direction * image))
        pressure, answer = pressure + step * direction, answer + step * image
        residual = np.where(active, wanted - answer, 0.0)
        before = now
    return pressure, answer
