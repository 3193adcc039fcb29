"""Stress of the solved solid: its largest values away from singular lines, and surfaces of it for pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from varistiff.fe import import_ngsolve
from varistiff.fe.torsion_linear import ElasticSolid
from varistiff.fe.torsion_problem import Floats, Integers, StressField
from varistiff.fe.torsion_solid import Solid

States = tuple[
    tuple[ElasticSolid, Any], ...
]  # solids with grid functions: (antisymmetric, symmetric), one of them, whole

_CUTS = 3  # points along an edge of a sampled face, less one


def largest(states: States, *, span: tuple[float, float], lines: Floats, distance: float) -> float:
    """Largest von Mises stress [Pa] for z in a span, farther than a distance [m] from singular lines.

    Parameters
    ----------
    lines : straight lines in the sector, both ends, shape (n, 2, 3) [m]
    """
    lattice, _ = _triangle_lattice()
    reference = [(a, b, c) for c in (0.0, 0.5, 1.0) for a, b in lattice]
    places, values = _sample(states, reference)
    chosen = (places[:, 2] >= span[0]) & (places[:, 2] <= span[1]) & _far(places, lines, distance)
    return float(values[:, chosen].max()) if chosen.any() else float("nan")


def section_field(states: States, name: str, z: float) -> StressField:
    """Von Mises stress on the cross-section at a level of the mesh."""
    solid = states[0][0].solid
    layer = int(np.argmin(np.abs(solid.levels[:-1] - z)))
    lattice, cells = _triangle_lattice()
    count = len(solid.plane.triangles)
    places, values = _sample(states, [(a, b, 0.0) for a, b in lattice])
    rows = np.arange(layer * count * len(lattice), (layer + 1) * count * len(lattice))
    triangles = (cells[None] + len(lattice) * np.arange(count)[:, None, None]).reshape(-1, 3)
    return _whole(solid, name, places[rows], triangles, values[:, rows])


def surface_field(states: States, name: str) -> StressField:
    """Von Mises stress on the outside, the bore and the free end."""
    ng = import_ngsolve()
    solid = states[0][0].solid
    steps = np.linspace(0.0, 1.0, _CUTS)
    square = [(a, b, 0.0) for b in steps for a in steps]
    k, j = np.arange(_CUTS - 1), np.arange(_CUTS - 1)
    corner = (_CUTS * j[:, None] + k).ravel()
    cells = np.concatenate(
        [
            np.stack([corner, corner + 1, corner + _CUTS + 1], axis=1),
            np.stack([corner, corner + _CUTS + 1, corner + _CUTS], axis=1),
        ]
    )
    region = solid.mesh.Boundaries("outer|hole|bearing")
    places, values = _sample(states, square, region=region, shape=ng.ET.QUAD)
    count = len(places) // len(square)
    triangles = (cells[None] + len(square) * np.arange(count)[:, None, None]).reshape(-1, 3)
    return _whole(solid, name, places, triangles, values)


def _sample(
    states: States, reference: list[tuple[float, float, float]], *, region: Any = None, shape: Any = None
) -> tuple[Floats, Floats]:
    """Points (n, 3) and von Mises stresses (sides, n) at reference points of every element: sector, mirror image."""
    ng = import_ngsolve()
    mesh = states[0][0].solid.mesh
    rule = ng.IntegrationRule([tuple(float(c) for c in point) for point in reference], [1.0] * len(reference))
    at = mesh.MapToAllElements(rule, ng.VOL) if region is None else mesh.MapToAllElements({shape: rule}, region)
    places = np.stack([np.asarray(axis(at)).ravel() for axis in (ng.x, ng.y, ng.z)], axis=1)
    parts = []
    for solid, w in states:
        stress = solid.stress(w)
        parts.append(np.asarray((ng.BoundaryFromVolumeCF(stress) if region is not None else stress)(at)).reshape(-1, 9))
    if len(parts) == 2:
        anti, symmetric = parts
        return places, np.stack([_von_mises(symmetric + anti), _von_mises(symmetric - anti)])
    one = _von_mises(parts[0])
    return places, np.stack([one, one] if states[0][0].kind != "whole" else [one])


def _von_mises(stress: Floats) -> Floats:
    sigma = stress.reshape(-1, 3, 3)
    deviator = sigma - np.trace(sigma, axis1=1, axis2=2)[:, None, None] / 3.0 * np.eye(3)
    found: Floats = np.sqrt(1.5 * np.sum(deviator**2, axis=(1, 2)))
    return found


def _triangle_lattice() -> tuple[list[tuple[float, float]], Integers]:
    """Lattice points of the reference triangle and the small triangles between them."""
    n = _CUTS - 1
    index: dict[tuple[int, int], int] = {}
    for b in range(n + 1):
        for a in range(n + 1 - b):
            index[a, b] = len(index)
    cells = []
    for a, b in index:
        if a + b < n:
            cells.append((index[a, b], index[a + 1, b], index[a, b + 1]))
        if a + b < n - 1:
            cells.append((index[a + 1, b], index[a + 1, b + 1], index[a, b + 1]))
    return [(a / n, b / n) for a, b in index], np.array(cells, dtype=np.int64)


def _far(places: Floats, lines: Floats, distance: float) -> NDArray[np.bool_]:
    far = np.full(len(places), True)
    for start, end in lines:
        along = end - start
        t = np.clip((places - start) @ along / max(float(along @ along), 1e-300), 0.0, 1.0)
        far &= np.sum((places - start - t[:, None] * along) ** 2, axis=1) > distance**2
    return far


def _whole(solid: Solid, name: str, places: Floats, triangles: Integers, values: Floats) -> StressField:
    """Repeat a sector's surface around the axis."""
    points, cells, found, number = [], [], [], 0
    mirror = places * np.array([1.0, -1.0, 1.0])
    sides = [(places, triangles, values[0])] + ([(mirror, triangles[:, ::-1], values[1])] if len(values) == 2 else [])
    for copy in range(solid.plane.copies):
        angle = 2.0 * np.pi * copy / solid.plane.copies
        turn = np.array([[np.cos(angle), np.sin(angle), 0.0], [-np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])
        for place, cell, value in sides:
            points.append(place @ turn)
            cells.append(cell + number)
            found.append(value)
            number += len(place)
    return StressField(name, np.concatenate(points), np.concatenate(cells), np.concatenate(found))
