"""Newton's method for a leaf and its hold together."""

from __future__ import annotations

from typing import Any

import numpy as np

from varistiff.core.errors import InputError
from varistiff.fe import import_ngsolve
from varistiff.fe.leaf_holds import LeafHold
from varistiff.fe.leaf_mesh import Floats

_ITERATIONS = 30
_CONVERGED = 1e-13  # decrement over energy; the next step would be the square of that
_STALLED = 1e-8  # rounding keeps thin leaves from more; the load's error is its square root times the last step


class NotConvergedError(InputError):
    """Newton's method found no equilibrium."""


class Linearised:
    """The bordered linear system at one state: K and the hold's few rows and columns."""

    def __init__(self, hold: LeafHold) -> None:
        solid = hold.solid
        hold.place()
        solid.form.AssembleLinearization(solid.displacement.vec)
        self.residual = solid.vector()
        solid.form.Apply(solid.displacement.vec, self.residual)
        self.equations, self._block = hold.update(self.residual)
        self._inverse = solid.form.mat.Inverse(solid.free(), inverse="sparsecholesky")
        self._rows = hold.rows
        self._solved = [self._solve(column) for column in hold.columns]
        self._schur = self._block - self._products(self._solved)

    def _solve(self, right: Any) -> Any:
        result = right.CreateVector()
        result.data = self._inverse * right
        return result

    def _products(self, vectors: list[Any]) -> Floats:
        ng = import_ngsolve()
        return np.array([[float(ng.InnerProduct(row, vector)) for vector in vectors] for row in self._rows])

    def solve(self, right: Any, equations: Floats) -> tuple[Any, Floats]:
        """(v, q) with K v + columns q = right and rows v + block q = equations."""
        first = self._solve(right)
        q = np.asarray(np.linalg.solve(self._schur, equations - self._products([first])[:, 0]), dtype=np.float64)
        for value, solved in zip(q, self._solved, strict=True):
            first.data -= float(value) * solved
        return first, q


def find_equilibrium(hold: LeafHold, energy_scale: float) -> int:
    """Move the solid and its hold to equilibrium; return the number of steps.

    Parameters
    ----------
    hold : with the solid at a start
    energy_scale : energy [J] of the size of the solution's

    Raises
    ------
    NotConvergedError : no equilibrium in reach of the start
    """
    ng = import_ngsolve()
    solid, last = hold.solid, np.inf
    for count in range(1, _ITERATIONS + 1):
        try:
            system = Linearised(hold)
            right = solid.vector()
            right.data = -1.0 * system.residual
            step, change = system.solve(right, -system.equations)
        except (np.linalg.LinAlgError, ng.NgException):  # a matrix that cannot be factorised
            break
        decrement = abs(float(ng.InnerProduct(right, step))) + abs(float(system.equations @ change))
        if not np.isfinite(decrement) or decrement > 1e12 * energy_scale:
            break
        part = hold.step_limit(change)
        solid.displacement.vec.data += part * step
        hold.unknowns = hold.unknowns + part * change
        if decrement < _CONVERGED * energy_scale or (last < _STALLED * energy_scale and decrement > 0.1 * last):
            if not hold.pushes():
                break
            hold.place()
            return count
        last = decrement
    raise NotConvergedError(
        "the 3-D leaf found no equilibrium; allowed are deflections short of the leaf's slipping off"
    )
