"""The leaf as a solid: large rotations, small strains, and a span whose undeformed length is an unknown.

Saint Venant-Kirchhoff material, the right one for small strains: with the deformation gradient F and the strain
E = (F^T F - 1)/2 the energy density is

    w = G E:E + lambda (tr E)^2/2,    S = dw/dE = 2 G E + lambda tr(E) 1

The mesh stays as it is while the material slides through the contact: the span's undeformed length is
``stretch`` times that of the mesh, so F = (dx/dX) diag(1/stretch, 1, 1) and dX = stretch dX_mesh there. The derivative

    dW/d(stretch) = integral of w - (F^T F S)_11

is the configurational force; where it vanishes the leaf slides no further.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from varistiff.fe import import_ngsolve
from varistiff.fe.leaf_mesh import Floats, LeafGrid, leaf_mesh

_STEP = 1e-5  # of the stretch, for central differences: exact to 1e-9 in a polynomial of 1/stretch


class LeafSolid:
    """Half a leaf (z >= 0) on a structured mesh; all forces and energies here are those of the half.

    Parameters
    ----------
    grid : planes of the mesh
    thickness : h [m]
    order : polynomial order of the displacement
    youngs_modulus, poissons_ratio : [Pa], [-]
    """

    def __init__(
        self, grid: LeafGrid, thickness: float, *, order: int, youngs_modulus: float, poissons_ratio: float
    ) -> None:
        ng = import_ngsolve()
        self.grid, self.thickness, self.order = grid, thickness, order
        self.mesh = leaf_mesh(grid, thickness)
        self._upper: Any = None
        self._build(order, youngs_modulus, poissons_ratio)
        self.section = thickness * float(grid.across[-1])
        self.position = ng.CF((ng.x, ng.y, ng.z))

    def _build(self, order: int, youngs_modulus: float, poissons_ratio: float) -> None:
        ng = import_ngsolve()
        mesh = self.mesh
        self.space = ng.VectorH1(mesh, order=order, dirichlet="clamp", dirichletz="middle")
        self.stretch = ng.Parameter(1.0)
        self.displacement = ng.GridFunction(self.space)
        self.span_region, self.contact_region = mesh.Materials("span"), mesh.Boundaries("contact")
        ratio = mesh.MaterialCF({"span": self.stretch}, default=1.0)
        scale = ng.CF((1.0 / ratio, 0, 0, 0, 1, 0, 0, 0, 1), dims=(3, 3))
        shear = 0.5 * youngs_modulus / (1.0 + poissons_ratio)
        lame = youngs_modulus * poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio))

        def state(u: Any) -> tuple[Any, Any, Any]:
            gradient = (ng.Id(3) + ng.Grad(u)) * scale
            metric = gradient.trans * gradient
            strain = 0.5 * (metric - ng.Id(3))
            density = shear * ng.InnerProduct(strain, strain) + 0.5 * lame * ng.Trace(strain) ** 2
            return density, metric, 2.0 * shear * strain + lame * ng.Trace(strain) * ng.Id(3)

        trial = self.space.TrialFunction()
        self.form = ng.BilinearForm(self.space, symmetric=True)
        self.form += ng.Variation((ratio * state(trial)[0]).Compile() * ng.dx)
        density, metric, stress = state(self.displacement)
        self._energy = (ratio * density).Compile()
        self._release = (density - (metric * stress)[0, 0]).Compile()
        self.stress = stress

    def add_upper(self, density: Callable[[Any], Any]) -> None:
        """Add an energy per undeformed area [J/m^2] of the span's upper face, a function of the displacement."""
        ng = import_ngsolve()
        self.form += ng.Variation((self.stretch * density(self.space.TrialFunction())).Compile() * ng.ds("upper"))
        self._upper = density(self.displacement).Compile()

    def _upper_energy(self) -> float:
        """Of the face, for a stretch of 1 [J]."""
        if self._upper is None:
            return 0.0
        ng = import_ngsolve()
        region = self.mesh.Boundaries("upper")
        return float(ng.Integrate(self._upper, self.mesh, order=2 * self.order, definedon=region))

    def vector(self) -> Any:
        """An empty vector of the displacement's unknowns."""
        return self.displacement.vec.CreateVector()

    def free(self) -> Any:
        """Which unknowns the clamp and the symmetry leave free."""
        return self.space.FreeDofs()

    def energy(self) -> float:
        """Strain energy [J]."""
        ng = import_ngsolve()
        stored = float(ng.Integrate(self._energy, self.mesh, order=2 * self.order))
        return stored + float(self.stretch.Get()) * self._upper_energy()

    def stretch_force(self) -> float:
        """dW/d(stretch) [J]."""
        ng = import_ngsolve()
        value = ng.Integrate(self._release, self.mesh, order=2 * self.order, definedon=self.span_region)
        return float(value) + self._upper_energy()

    def stretch_derivatives(self) -> tuple[Any, float]:
        """Derivatives of the residual (a vector) and of ``stretch_force`` with respect to the stretch."""
        at = float(self.stretch.Get())
        column, other = self.vector(), self.vector()
        self.stretch.Set(at + _STEP)
        self.form.Apply(self.displacement.vec, column)
        high = self.stretch_force()
        self.stretch.Set(at - _STEP)
        self.form.Apply(self.displacement.vec, other)
        low = self.stretch_force()
        self.stretch.Set(at)
        column.data -= other
        column.data *= 0.5 / _STEP
        return column, (high - low) * 0.5 / _STEP

    def over_contact(self, integrand: Any) -> float:
        """Integral over the contact's section."""
        ng = import_ngsolve()
        value = ng.Integrate(integrand, self.mesh, order=2 * self.order, definedon=self.contact_region)
        return float(value)

    def contact_vector(self, field: Any) -> Any:
        """Vector of the functional v -> integral of field . v over the contact's section."""
        ng = import_ngsolve()
        form = ng.LinearForm(self.space)
        form += ng.InnerProduct(field, self.space.TestFunction()) * ng.ds("contact")
        form.Assemble()
        result = self.vector()
        result.data = form.vec
        return result

    def shape(self, arc: Floats, turn: Floats, line: Floats) -> None:
        """Start from sections that follow a curve: points ``line`` (n, 2) and slopes ``turn`` (n,) at ``arc`` (n,)."""
        ng = import_ngsolve()
        knots = [float(arc[0]), *map(float, arc)]

        def along(values: Floats) -> Any:
            return ng.BSpline(2, knots, [*map(float, values), float(values[-1])])(ng.x)

        height = ng.y
        self.displacement.Set(
            ng.CF(
                (
                    along(line[:, 0]) - height * along(np.sin(turn)) - ng.x,
                    along(line[:, 1]) + height * along(np.cos(turn)) - height,
                    0.0,
                )
            )
        )

    def sample(self, count: int = 81, across: int = 9) -> tuple[Floats, ...]:
        """Arc, width, deformed mid-plane and stress along the leaf in the upper and lower face, for z >= 0.

        Shapes (count,), (across,), (count, across, 3) and twice (count, across).
        """
        planes = self.grid.along
        inside = np.union1d(np.linspace(0.0, planes[-1], count), [planes[-1]])
        z = np.linspace(0.0, self.grid.across[-1], across)
        mesh_x, width = (values.ravel() for values in np.meshgrid(inside, z, indexing="ij"))

        def at(field: Any, height: float) -> Floats:
            # points on a face may fall outside by rounding
            x = np.clip(mesh_x, planes[-1] * 1e-9, planes[-1] * (1.0 - 1e-9))
            w = np.minimum(width, z[-1] * (1.0 - 1e-9))
            return np.asarray(field(self.mesh(x, np.full_like(x, height * (1.0 - 1e-9)), w)))

        moved = at(self.displacement, 0.0)
        points = np.stack([mesh_x, 0.0 * mesh_x, width], axis=1) + moved
        shape = (inside.size, z.size)
        half = 0.5 * self.thickness
        faces = [at(self.stress[0, 0], height).reshape(shape) for height in (half, -half)]
        stretch = float(self.stretch.Get())
        span = planes[self.grid.span]
        arc = np.where(inside <= span, stretch * inside, inside + (stretch - 1.0) * span)
        return arc, z, points.reshape(*shape, 3), *faces

    def middle_stress(self, distance: float) -> float:
        """Largest stress along the leaf [Pa] in the outer fibres at z = 0, ``distance`` [m] and more from the clamp."""
        span = float(self.grid.along[self.grid.span])
        x = np.linspace(min(distance, 0.5 * span), span * (1.0 - 1e-9), 201)
        half = 0.5 * self.thickness * (1.0 - 1e-9)
        faces = [self.stress[0, 0](self.mesh(x, np.full_like(x, y), 0.0 * x)) for y in (half, -half)]
        return float(np.abs(np.asarray(faces)).max())


def half_inertia(width: float, thickness: float) -> float:
    """Second moment of area of half the width [m^4]."""
    return 0.5 * width * thickness**3 / 12.0


def unit(angle: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Tangent and normal (x, y) of a slope."""
    return (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
