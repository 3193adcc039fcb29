"""The solid under torsion: a plane mesh extruded in graded layers, curved to the exact outline."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from varistiff.fe import import_ngsolve
from varistiff.fe.torsion_plane import PlaneMesh

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

NAMES = ("clamp", "end", "outer", "hole", "bearing", "ray0", "ray1")


@dataclass(frozen=True)
class Solid:
    """Curved mesh of prisms.

    Parameters
    ----------
    mesh : NGSolve mesh with the boundaries of ``NAMES``; "bearing" is the part of "outer" under the counter bearing
    plane : the plane mesh that was extruded
    levels : z of the layers' ends [m], shape (layers + 1,)
    face_edges : plane edge of every side face, in the order of the mesh's boundary elements; -1 for clamp and end
    """

    mesh: Any
    plane: PlaneMesh
    levels: Floats
    face_edges: Integers


def layers(breaks: Sequence[float], graded: Sequence[float], *, size: float, finest: float, rate: float) -> Floats:
    """Levels that contain every break, short at the graded ones and growing geometrically away from them.

    Parameters
    ----------
    breaks : ascending z [m], the first and last are the ends
    graded : those where fields vary quickly
    size, finest : largest and smallest thickness of a layer [m]
    rate : growth of the thickness per distance from a graded level
    """
    marks = np.array(graded, dtype=float)

    def wanted(z: Floats) -> Floats:
        near = np.abs(z[:, None] - marks).min(axis=1) if marks.size else np.full(z.shape, np.inf)
        return np.minimum(size, finest + rate * near)

    found = [np.array([breaks[0]])]
    for low, high in pairwise(breaks):
        z = low + (high - low) * (0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 2001)))  # fine at both ends
        middle = 0.5 * (z[1:] + z[:-1])
        count = np.concatenate([[0.0], np.cumsum(np.diff(z) / wanted(middle))])
        number = max(1, round(count[-1]))
        found.append(np.interp(np.linspace(0.0, count[-1], number + 1)[1:], count, z))
        found[-1][-1] = high
    return np.concatenate(found)


def extrude(plane: PlaneMesh, levels: Floats, *, order: int, is_bearing: Callable[[Floats, Floats], NDArray[np.bool_]],
            bearing: tuple[float, float] | None) -> Solid:  # fmt: skip
    """Build the solid between the first and the last level.

    Parameters
    ----------
    order : polynomial order of the curved geometry
    is_bearing : which edges of the outside the counter bearing may touch, from their midpoints and outward normals
    bearing : z where it begins and ends [m], both among the levels; None without one
    """
    ng = import_ngsolve()
    from netgen.meshing import Element2D, Element3D, FaceDescriptor, Mesh, MeshPoint, Pnt

    mesh = Mesh(dim=3)
    for number, name in enumerate(NAMES):
        mesh.Add(FaceDescriptor(surfnr=number + 1, domin=1, domout=0, bc=number + 1))
        mesh.SetBCName(number, name)
    mesh.SetMaterial(1, "solid")
    nodes = [[mesh.Add(MeshPoint(Pnt(float(x), float(y), float(z)))) for x, y in plane.points] for z in levels]
    touched = _touched(plane, is_bearing)
    faces = []
    for low, (below, above) in enumerate(pairwise(nodes)):
        for a, b, c in plane.triangles:
            mesh.Add(Element3D(1, [below[a], below[b], below[c], above[a], above[b], above[c]]))
        middle = 0.5 * (levels[low] + levels[low + 1])
        under = bearing is not None and bearing[0] < middle < bearing[1]
        for number, (a, b) in enumerate(plane.edges):
            name = plane.sides[plane.edge_sides[number]].name
            label = "bearing" if under and touched[number] else name
            mesh.Add(Element2D(NAMES.index(label) + 1, [below[a], below[b], above[b], above[a]]))
            faces.append(number)
    for a, b, c in plane.triangles:
        mesh.Add(Element2D(1, [nodes[0][a], nodes[0][c], nodes[0][b]]))
        mesh.Add(Element2D(2, [nodes[-1][a], nodes[-1][b], nodes[-1][c]]))
    faces += [-1] * (2 * len(plane.triangles))
    solid = Solid(ng.Mesh(mesh), plane, levels, np.array(faces, dtype=np.int64))
    _curve(solid, order)
    return solid


def _touched(plane: PlaneMesh, is_bearing: Callable[[Floats, Floats], NDArray[np.bool_]]) -> NDArray[np.bool_]:
    along = plane.points[plane.edges[:, 1]] - plane.points[plane.edges[:, 0]]
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
    outer = np.array([plane.sides[side].name == "outer" for side in plane.edge_sides])
    return outer & is_bearing(plane.points[plane.edges].mean(axis=1), normal)


def _curve(solid: Solid, order: int) -> None:
    """Move the straight faces onto the outline: an L2 projection on the faces that keeps the vertices in place."""
    ng = import_ngsolve()
    from ngsolve.comp import IntegrationRuleSpaceSurface

    plane, mesh = solid.plane, solid.mesh
    region = mesh.Boundaries("outer|hole|bearing")
    if order < 2 or all(side.straight for side in plane.sides):
        return
    points_space = IntegrationRuleSpaceSurface(mesh, order=order + 1, definedon=region)
    rules = points_space.GetIntegrationRules()
    place = ng.GridFunction(points_space)
    coordinates = []
    for axis in (ng.x, ng.y):
        place.Interpolate(axis, definedon=region)
        coordinates.append(np.array(place.vec.FV().NumPy()))
    missing = _deviation(solid, np.stack(coordinates, axis=1), region)
    space = ng.H1(mesh, order=order)
    free = _inside_faces(space, mesh, region)
    u, v = space.TnT()
    mass = ng.BilinearForm(space)
    mass += u * v * ng.ds(definedon=region, intrules=rules)
    mass.Assemble()
    inverse = mass.mat.Inverse(free, inverse="sparsecholesky")
    vector = ng.VectorH1(mesh, order=order)
    deformation = ng.GridFunction(vector)
    for axis in range(2):
        place.vec.FV().NumPy()[:] = missing[:, axis]
        load = ng.LinearForm(space)
        load += place * v * ng.ds(definedon=region, intrules=rules)
        load.Assemble()
        deformation.components[axis].vec.data = inverse * load.vec
    mesh.SetDeformation(deformation)


def _inside_faces(space: Any, mesh: Any, region: Any) -> Any:
    """Degrees of freedom of a region without those of vertices."""
    free = space.GetDofs(region)
    for vertex in mesh.vertices:
        for number in space.GetDofNrs(vertex):
            free[number] = False
    return free


def _deviation(solid: Solid, places: Floats, region: Any) -> Floats:
    """From points on the straight faces to the boundary, at the same fraction of the edge; shape (n, 2)."""
    ng = import_ngsolve()
    plane, mask = solid.plane, region.Mask()
    indices = [element.index for element in solid.mesh.Elements(ng.BND)]
    chosen = np.array([edge for edge, index in zip(solid.face_edges, indices, strict=True) if mask[index]])
    edge = np.repeat(chosen, len(places) // len(chosen))
    start, end = plane.points[plane.edges[edge, 0]], plane.points[plane.edges[edge, 1]]
    along = end - start
    fraction = np.sum((places - start) * along, axis=1) / np.sum(along * along, axis=1)
    return plane.curve_points(edge, fraction) - places
