"""Hexahedra of half a leaf: refined at the clamp, at the contact and towards the free edge."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from varistiff.fe import import_ngsolve

Floats = NDArray[np.float64]

_SPAN_PIECES = 7.0  # at least so many elements along the span
_TURN = 0.12  # and so much turning [rad] in any of them in the mean: straight elements must follow the curve
_WIDTHS = np.array([0.0, 0.45, 0.8, 1.0])  # of the half width, from its middle to the free edge
_GROWTH = 2.0  # from one element to the next
_CLAMP_PIECES = 20.0  # of the half width: no element at the clamp is shorter, however thin the leaf


@dataclass(frozen=True)
class LeafGrid:
    """Planes of the structured mesh: ``along`` x with ``span`` elements before the contact, ``across`` z [m]."""

    along: Floats
    span: int
    across: Floats


def _graded(length: float, first: float, last: float, largest: float) -> Floats:
    """Fractions 0 ... 1 of a length: elements grow from both ends (first, last), none above ``largest``."""
    left, right = [min(first, length)], [min(last, length)]
    while sum(left) + sum(right) < length:
        shorter = left if left[-1] <= right[-1] else right
        shorter.append(min(shorter[-1] * _GROWTH, largest))
    sizes = np.array(left + right[::-1])
    return np.concatenate([[0.0], np.cumsum(sizes) / sizes.sum()])


def leaf_grid(
    *, length: float, tail: float, width: float, thickness: float, turn: float, uniform_across: bool
) -> LeafGrid:
    """Planes of the mesh of a leaf that is bent over ``length`` and free over ``tail`` [m].

    Parameters
    ----------
    length, tail : before and beyond the contact [m]
    width, thickness : of the leaf [m]
    turn : angle by which the span turns when bent [rad]
    uniform_across : whether nothing varies over the width (Poisson's ratio 0): one element
    """
    half = 0.5 * width
    largest = length / max(_SPAN_PIECES, abs(turn) / _TURN)
    near = min(0.5 * half, largest) if not uniform_across else largest
    # the plate effect at the clamp reaches about half the width, its singular edge about a thickness
    first = min(max(thickness, half / _CLAMP_PIECES), largest) if not uniform_across else largest
    span = length * _graded(length, first, near, largest)
    planes = span
    if tail > 0.0:
        planes = np.concatenate([span, length + tail * _graded(tail, near, tail, tail)[1:]])
    across = half * (np.array([0.0, 1.0]) if uniform_across else _WIDTHS)
    return LeafGrid(planes, span.size - 1, across)


def leaf_mesh(grid: LeafGrid, thickness: float) -> Any:
    """NGSolve mesh with materials span and tail and boundaries clamp, contact, middle, upper and lower."""
    ng = import_ngsolve()
    from netgen.meshing import Element2D, Element3D, FaceDescriptor, MeshPoint, Pnt
    from netgen.meshing import Mesh as NetgenMesh

    mesh = NetgenMesh(dim=3)
    nx, nz = grid.along.size - 1, grid.across.size - 1
    heights = (-0.5 * thickness, 0.5 * thickness)
    corner = {
        (i, j, k): mesh.Add(MeshPoint(Pnt(float(x), y, float(z))))
        for (i, x), (j, y), (k, z) in itertools.product(
            enumerate(grid.along), enumerate(heights), enumerate(grid.across)
        )
    }
    mesh.SetMaterial(1, "span")
    mesh.SetMaterial(2, "tail")
    beyond = 2 if grid.span < nx else 0
    names = ("clamp", "contact", "middle", "middle", "upper", "lower")
    domains = ((1, 0), (1, beyond), (1, 0), (2, 0), (1, 0), (1, 0))
    for number, (name, (inside, outside)) in enumerate(zip(names, domains, strict=True), 1):
        mesh.Add(FaceDescriptor(surfnr=number, domin=inside, domout=outside, bc=number))
        mesh.SetBCName(number - 1, name)
    for i, k in itertools.product(range(nx), range(nz)):
        bottom = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        nodes = bottom + [(a, b, 1) for a, b, _ in bottom]
        mesh.Add(Element3D(1 if i < grid.span else 2, [corner[i + a, b, k + c] for a, b, c in nodes]))

    def face(number: int, *nodes: tuple[int, int, int]) -> None:
        mesh.Add(Element2D(number, [corner[node] for node in nodes]))

    for k in range(nz):
        face(1, (0, 0, k), (0, 0, k + 1), (0, 1, k + 1), (0, 1, k))
        s = grid.span
        face(2, (s, 0, k), (s, 1, k), (s, 1, k + 1), (s, 0, k + 1))
    for i in range(nx):
        face(3 if i < grid.span else 4, (i, 0, 0), (i, 1, 0), (i + 1, 1, 0), (i + 1, 0, 0))
    for i, k in itertools.product(range(grid.span), range(nz)):
        face(5, (i, 1, k), (i, 1, k + 1), (i + 1, 1, k + 1), (i + 1, 1, k))
        face(6, (i, 0, k), (i + 1, 0, k), (i + 1, 0, k + 1), (i, 0, k + 1))
    return ng.Mesh(mesh)
