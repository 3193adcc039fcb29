"""Linear elasticity of the solid on its symmetric sector: one factorised stiffness matrix for each symmetry."""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np

from varistiff.core.errors import InputError
from varistiff.fe import import_ngsolve
from varistiff.fe.torsion_solid import Solid

Kind = Literal["antisymmetric", "symmetric", "whole"]


class ElasticSolid:
    """Displacements of a clamped solid under loads of one symmetry.

    On the two mirror planes that bound a sector the displacement of torsion is normal to the plane (antisymmetric),
    that of a squeeze lies in it (symmetric). With the displacement written in an oblique basis,

        u = a_0 w_0 + a_1 w_1 + e_z w_2,   a_k = e_theta of plane k (antisymmetric) or e_r of plane k (symmetric),

    both conditions say that one component vanishes on one plane, so they hold exactly whatever the angle is. Two
    planes that are one (an angle of 180 degrees) need no oblique basis.

    Parameters
    ----------
    solid : the mesh
    kind : symmetry of loads and displacements
    order : polynomial order of the displacement
    shear_modulus, poissons_ratio : [Pa], [1]
    turned : boundaries whose in-plane displacement is prescribed (a rotation about z), such as ``"end"``
    blocked : whether those may not move along z either
    """

    def __init__(self, solid: Solid, kind: Kind, *, order: int, shear_modulus: float, poissons_ratio: float,
                 turned: str = "", blocked: bool = False) -> None:  # fmt: skip
        ng = import_ngsolve()
        self.solid, self.kind, self.turned = solid, kind, turned
        angle = solid.plane.angle
        if kind == "whole" or math.isclose(angle, math.pi):
            self._basis = np.eye(3)
        else:
            turn = 0.5 * math.pi if kind == "antisymmetric" else 0.0
            self._basis = np.eye(3)
            self._basis[:2, 0] = math.cos(turn), math.sin(turn)
            self._basis[:2, 1] = math.cos(angle + turn), math.sin(angle + turn)
        fixed = self._fixed(angle, blocked)
        self.space = ng.VectorH1(solid.mesh, order=order, dirichletx=fixed[0], dirichlety=fixed[1], dirichletz=fixed[2])
        self._basis_field = ng.CF(tuple(self._basis.ravel()), dims=(3, 3))
        u, v = self.space.TnT()
        shear, lame = 2.0 * shear_modulus, 2.0 * shear_modulus * poissons_ratio / (1.0 - 2.0 * poissons_ratio)
        self._moduli = shear, lame
        self._form = ng.BilinearForm(self.space, symmetric=True)
        self._form += ng.InnerProduct(self._stress_of(self._strain(ng.Grad(u))), self._strain(ng.Grad(v))) * ng.dx
        self._inverse: Any = None

    @property
    def unknowns(self) -> int:
        """Number of unknowns, prescribed ones included."""
        return int(self.space.ndof)

    def _fixed(self, angle: float, blocked: bool) -> tuple[str, str, str]:
        """Boundaries on which each component of w is prescribed."""
        everywhere = ["clamp"] + ([self.turned] if self.turned else [])
        axial = ["clamp"] + ([self.turned] if self.turned and blocked else [])
        first, second = list(everywhere), list(everywhere)
        if self.kind != "whole":
            anti = self.kind == "antisymmetric"
            if math.isclose(angle, math.pi):
                (first if anti else second).extend(["ray0", "ray1"])
            else:
                first.append("ray1")
                second.append("ray0")
            if anti:
                axial += ["ray0", "ray1"]
        return "|".join(first), "|".join(second), "|".join(axial)

    def _strain(self, gradient: Any) -> Any:
        full = self._basis_field * gradient
        return 0.5 * (full + full.trans)

    def _stress_of(self, strain: Any) -> Any:
        ng = import_ngsolve()
        shear, lame = self._moduli
        return shear * strain + lame * ng.Trace(strain) * ng.Id(3)

    def displacement(self, w: Any) -> Any:
        """u of the components w in the oblique basis; for grid, trial and test functions."""
        return self._basis_field * w

    def stress(self, w: Any) -> Any:
        """Stress [Pa] of a grid function, 3 by 3."""
        ng = import_ngsolve()
        return self._stress_of(self._strain(ng.Grad(w)))

    def factorise(self) -> None:
        """Assemble and factorise the stiffness matrix.

        Raises
        ------
        InputError : the matrix cannot be factorised, or memory runs out
        """
        try:
            self._form.Assemble()
            self._inverse = self._form.mat.Inverse(self.space.FreeDofs(), inverse="sparsecholesky")
        except (MemoryError, RuntimeError) as error:
            raise InputError(f"the 3-D problem cannot be solved: {error}") from None
        except Exception as error:
            if type(error).__module__.partition(".")[0] not in ("ngsolve", "netgen", "pyngcore"):
                raise
            raise InputError(f"the 3-D problem cannot be solved: {error}") from None

    def solve(self, load: Any) -> Any:
        """Components w under a load vector, as a new vector."""
        found = load.CreateVector()
        found.data = self._inverse * load
        return found

    def turn(self, angle: float) -> Any:
        """Grid function w with the turned boundaries rotated by an angle [rad] about z and no other load."""
        ng = import_ngsolve()
        w = ng.GridFunction(self.space)
        inverse = np.linalg.inv(self._basis)
        inverse_field = ng.CF(tuple(inverse.ravel()), dims=(3, 3))
        w.Set(
            inverse_field * ng.CF((-angle * ng.y, angle * ng.x, 0.0)), definedon=self.solid.mesh.Boundaries(self.turned)
        )
        residual = w.vec.CreateVector()
        residual.data = -1.0 * (self._form.mat * w.vec)
        w.vec.data += self._inverse * residual
        return w

    def twice_energy(self, w: Any) -> float:
        """u.K u [J], of the sector."""
        ng = import_ngsolve()
        image = w.vec.CreateVector()
        image.data = self._form.mat * w.vec
        return float(ng.InnerProduct(image, w.vec))

    def field(self, vector: Any) -> Any:
        """Grid function with the given components w."""
        ng = import_ngsolve()
        w = ng.GridFunction(self.space)
        w.vec.data = vector
        return w
