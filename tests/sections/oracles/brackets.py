"""Two bounds of J by finite elements: the stress function gives the lower one, the warping function the upper one.

Both are energy principles, so they hold on any mesh of the true shape: J lies between them whatever the mesh.
scikit-fem, quadrilaterals of order 4; curved edges by quadratic maps, whose error is far below the bracket's width.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementQuadP, LinearForm, Mesh, MeshQuad, MeshQuad1, MeshQuad2
from skfem.helpers import dot, grad

from varistiff.sections.outline import Outline, is_straight

ORDER = 4
Rectangles = list[tuple[float, float, float, float]]


@dataclass(frozen=True)
class Bracket:
    """Lower and upper bound of J."""

    lower: float
    upper: float

    @property
    def width(self) -> float:
        """Relative."""
        return self.upper / self.lower - 1.0

    def __contains__(self, value: object) -> bool:
        return isinstance(value, float) and self.lower <= value <= self.upper


@BilinearForm
def _stiffness(u: object, v: object, _: object) -> object:
    return dot(grad(u), grad(v))


@LinearForm
def _unit(v: object, _: object) -> object:
    return 2.0 * v


@LinearForm
def _twist(v: object, w: object) -> object:
    return w.x[1] * grad(v)[0] - w.x[0] * grad(v)[1]


def bracket(mesh: Mesh, *, holes: list[tuple[np.ndarray, float]], mirrors: np.ndarray | None, copies: int) -> Bracket:
    """Bound J of ``copies`` copies of a mesh.

    Parameters
    ----------
    holes : facets of each hole and the area that it has within the mesh's sector
    mirrors : facets on lines of symmetry, where the warping vanishes
    """
    basis = Basis(mesh, ElementQuadP(ORDER), intorder=2 * ORDER + 2)
    matrix = _stiffness.assemble(basis).tocsc()
    load, twist = _unit.assemble(basis), _twist.assemble(basis)
    polar = float((basis.dx * (basis.global_coordinates() ** 2).sum(axis=0)).sum())
    inner = np.concatenate([facets for facets, _ in holes]) if holes else np.zeros(0, dtype=int)
    symmetric = np.zeros(0, dtype=int) if mirrors is None else mirrors
    outer = np.setdiff1d(mesh.boundary_facets(), np.concatenate([inner, symmetric]))
    lower = _stress_function(basis, matrix, load, outer, holes)
    # a fixed degree of freedom where nothing else holds the constant
    fixed = np.zeros(1, dtype=int) if mirrors is None else basis.get_dofs(symmetric).flatten()
    free = np.setdiff1d(np.arange(basis.N), fixed)
    gain = twist[free] @ splu(matrix[free][:, free]).solve(twist[free])
    return Bracket(copies * lower, copies * (polar - gain))


def _stress_function(
    basis: Basis, matrix: csr_matrix, load: np.ndarray, outer: np.ndarray, holes: list[tuple[np.ndarray, float]]
) -> float:
    """Twice its integral: zero on the outer boundary, one unknown constant on each hole, which counts too."""
    group = np.arange(basis.N)
    for facets, _ in holes:  # hierarchical elements: a constant is carried by the vertices alone
        group[basis.get_dofs(facets).flatten()] = -1
        vertices = basis.nodal_dofs[0, np.unique(basis.mesh.facets[:, facets])]
        group[vertices] = vertices[0]
    group[basis.get_dofs(outer).flatten()] = -1
    names, column = np.unique(group[group >= 0], return_inverse=True)
    rows = np.flatnonzero(group >= 0)
    tie = csr_matrix((np.ones(rows.size), (rows, column)), shape=(basis.N, names.size))
    right = tie.T @ load
    for facets, area in holes:
        first = basis.nodal_dofs[0, basis.mesh.facets[:, facets].min()]
        right[np.searchsorted(names, first)] += 2.0 * area
    return float(right @ splu((tie.T @ matrix @ tie).tocsc()).solve(right))


def graded(*ends: float, levels: int, ratio: float = 0.25) -> np.ndarray:
    """Marks from the first to the last of ``ends``, graded geometrically to both sides of each."""
    marks = [np.array([ends[0]])]
    share = 0.5 * ratio ** np.arange(levels, -1.0, -1.0)
    for low, high in pairwise(ends):
        marks.append(low + (high - low) * np.concatenate([share, 1.0 - share[-2::-1], [1.0]]))
    return np.concatenate(marks)


def halved(marks: np.ndarray, times: int = 1) -> np.ndarray:
    """Marks with the middles between them, so many times."""
    for _ in range(times):
        marks = np.sort(np.concatenate([marks, 0.5 * (marks[1:] + marks[:-1])]))
    return marks


def rectangles_bracket(x: list[float], y: list[float], empty: Rectangles, *, hole: bool, levels: int) -> Bracket:
    """Bound J of the rectangle spanned by the lines x and y without the ``empty`` ones (x0, x1, y0, y1)."""
    mesh = MeshQuad.init_tensor(halved(graded(*x, levels=levels)), halved(graded(*y, levels=levels)))
    cx, cy = mesh.p[:, mesh.t].mean(axis=1)
    gone = np.zeros(cx.size, dtype=bool)
    for x0, x1, y0, y1 in empty:
        gone |= (x0 < cx) & (cx < x1) & (y0 < cy) & (cy < y1)
    mesh = mesh.remove_elements(np.flatnonzero(gone))
    if not hole:
        return bracket(mesh, holes=[], mirrors=None, copies=1)
    ((x0, x1, y0, y1),) = empty
    small = 1e-9
    inside = mesh.facets_satisfying(
        lambda p: (p[0] > x0 - small) & (p[0] < x1 + small) & (p[1] > y0 - small) & (p[1] < y1 + small),
        boundaries_only=True,
    )
    return bracket(mesh, holes=[(inside, (x1 - x0) * (y1 - y0))], mirrors=None, copies=1)


def ring_bracket(outline: Outline, *, levels: int, layers: int, splits: int) -> Bracket:
    """Bound J of a mirror-symmetric tube with a circular bore by half a sector, meshed in rays from the axis."""
    outer, (bore,) = outline.pieces
    marks = [
        graded(0.0, 1.0, levels=levels) if is_straight(segment) else graded(0.0, 0.5, 1.0, levels=levels)
        for segment in outer
    ]
    marks = [halved(halved(m, splits)) for m in marks]  # the last halving gives the middles of the edges
    points = [segment.point(m)[1 if n else 0 :] for n, (segment, m) in enumerate(zip(outer, marks, strict=True))]
    outside = np.concatenate(points) @ [1.0, 1.0j]
    radius = float(np.hypot(*bore.point(np.zeros(1))[0]))
    v = graded(0.0, 1.0, levels=layers, ratio=0.3)
    v = halved(halved(v, splits))
    around = outside / np.abs(outside)
    grid = radius * around[:, None] * (1.0 - v) + outside[:, None] * v
    mesh = _quadratic(grid)
    index = np.round(_logical(mesh, grid.shape)[1]).astype(int)
    column = np.round(_logical(mesh, grid.shape)[0]).astype(int)
    bore_facets = np.flatnonzero((index[mesh.facets] == 0).all(axis=0))
    mirrors = np.flatnonzero(
        (column[mesh.facets] == 0).all(axis=0) | (column[mesh.facets] == grid.shape[0] - 1).all(axis=0)
    )
    sector = np.pi / outline.rotations
    return bracket(mesh, holes=[(bore_facets, 0.5 * sector * radius**2)], mirrors=mirrors, copies=2 * outline.rotations)


def _logical(mesh: Mesh, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Grid indices of the mesh's corner nodes, which ``_quadratic`` numbers row by row."""
    number = np.arange(mesh.p.shape[1])
    across = (shape[1] + 1) // 2
    return 2 * (number // across), 2 * (number % across)


def _quadratic(grid: np.ndarray) -> MeshQuad2:
    """Quadratic quadrilaterals from a grid of complex points, every other one a corner."""
    rows, across = (grid.shape[0] + 1) // 2, (grid.shape[1] + 1) // 2
    n = np.arange(rows * across).reshape(rows, across)
    t = np.stack([n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]]).reshape(4, -1)
    corners = grid[::2, ::2].ravel()
    flat = MeshQuad1(np.stack([corners.real, corners.imag]), t)
    curved = MeshQuad2.from_mesh(flat)
    # place the nodes of edges and elements where the grid has them
    dofs, p = curved.dofs.element_dofs, curved.doflocs.copy()
    i, j = 2 * (flat.t // across), 2 * (flat.t % across)
    for local in range(dofs.shape[0]):
        ij = _REFERENCE[local]
        weights = [(1 - ij[0]) * (1 - ij[1]), ij[0] * (1 - ij[1]), ij[0] * ij[1], (1 - ij[0]) * ij[1]]
        at_i = np.round(sum(w * row for w, row in zip(weights, i, strict=True))).astype(int)
        at_j = np.round(sum(w * row for w, row in zip(weights, j, strict=True))).astype(int)
        z = grid[at_i, at_j]
        p[:, dofs[local]] = np.stack([z.real, z.imag])
    return MeshQuad2(p, flat.t)


_REFERENCE = MeshQuad2.elem().doflocs
