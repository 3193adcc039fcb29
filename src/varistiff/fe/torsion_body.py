"""From a torsion problem to its meshes, at one level of refinement."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.fe import import_ngsolve
from varistiff.fe.torsion_linear import ElasticSolid, Kind
from varistiff.fe.torsion_plane import PlaneMesh, plane_mesh, thickness
from varistiff.fe.torsion_problem import TorsionProblem
from varistiff.fe.torsion_solid import Solid, extrude, layers

Floats = NDArray[np.float64]

ORDER = 3


@dataclass(frozen=True)
class Level:
    """Mesh sizes as shares of the section's thickness (twice the area over the perimeter)."""

    size: float  # of a triangle; on an outside that a sleeve touches half of it
    root: float  # at a re-entrant corner
    finest: float  # first layer at the clamp and at the bearing's edges
    rate: float  # growth of the layers
    turn: float  # of the tangent along an edge [degrees]


LEVELS = (
    Level(1.2, 0.1, 0.4, 1.2, 30.0),
    Level(0.8, 0.05, 0.2, 0.8, 20.0),
    Level(0.5, 0.025, 0.1, 0.5, 13.0),
    Level(0.3, 0.0125, 0.05, 0.4, 9.0),
    Level(0.2, 0.006, 0.025, 0.3, 6.0),
)
_THICKEST = 30.0  # layer, of the thickness


class Body:
    """Meshes of one problem at one level: the bar under the end flange, and the element under the bearing.

    Parameters
    ----------
    problem : what to compute
    level : how fine
    whole : leave the symmetry of the section unused
    """

    def __init__(self, problem: TorsionProblem, level: Level, *, whole: bool = False) -> None:
        self.problem, self.level = problem, level
        outline = problem.section.outline()
        self.thickness = thickness(outline)
        size = level.size * self.thickness
        self.plane: PlaneMesh = plane_mesh(
            outline,
            size=size,
            edge=0.5 * size if problem.bearing_kind == "sleeve" else size,
            root=level.root * self.thickness,
            turn=math.radians(level.turn),
            centre=centre(problem),
            whole=whole,
        )
        self.kinds: tuple[Kind, ...] = ("whole",) if self.plane.angle == 0.0 else ("antisymmetric", "symmetric")

    def _layers(self, breaks: list[float], graded: list[float]) -> Floats:
        distinct = sorted(set(breaks))
        return layers(distinct, graded, size=_THICKEST * self.thickness, finest=self.level.finest * self.thickness,
                      rate=self.level.rate)  # fmt: skip

    def flange_levels(self) -> Floats:
        """Layers of the bar that ends at the active length."""
        x = self.problem.active_length
        return self._layers([0.0, 0.5 * x, x], [0.0, x])

    def bearing_levels(self) -> Floats:
        """Layers of the whole element."""
        near, far = self.problem.active_length, self.problem.bearing_end
        breaks = [0.0, 0.5 * near, near, 0.5 * (near + far), far, self.problem.length]
        return self._layers(breaks, [0.0, near, far])

    def flange_solid(self) -> Solid:
        """The bar that ends at the active length."""
        return extrude(self.plane, self.flange_levels(), order=ORDER, is_bearing=_nowhere, bearing=None)

    def bearing_solid(self) -> Solid:
        """The whole element."""
        span = (self.problem.active_length, self.problem.bearing_end)
        solid = extrude(
            self.plane, self.bearing_levels(), order=ORDER, is_bearing=bearing_faces(self.problem), bearing=span
        )
        if not any(element.mat == "bearing" for element in solid.mesh.Elements(import_ngsolve().BND)):
            problem = "the rails have no flat flank; allowed are root fillets smaller than the rails"
            raise InputError(problem, field="actuator.section")
        return solid

    def elastic(self, solid: Solid, kind: Kind, *, turned: str = "", blocked: bool = False) -> ElasticSolid:
        """The elastic problem on a solid, not yet factorised."""
        return ElasticSolid(solid, kind, order=ORDER, shear_modulus=self.problem.shear_modulus,
                            poissons_ratio=self.problem.poissons_ratio, turned=turned, blocked=blocked)  # fmt: skip

    @property
    def sectors(self) -> int:
        """How many meshed sectors make the section."""
        return self.plane.copies * len(self.kinds)


def bodies(problem: TorsionProblem, *, whole: bool = False) -> Iterator[Body]:
    """The problem's meshes from coarse to fine, without those that cannot be made.

    A long edge on the bore may cut through a wall that is thin beside it; on a finer mesh it no longer does.

    Raises
    ------
    InputError : the section cannot be meshed at any level
    """
    failed: InputError | None = None
    found = False
    for level in LEVELS:
        try:
            body = Body(problem, level, whole=whole)
        except InputError as error:
            failed = error
            continue
        found = True
        yield body
    if failed is not None and not found:
        raise failed


def unknowns(body: Body, *, bearing: bool) -> int:
    """Number of unknowns of a body's largest problem, from its mesh alone: exact for prisms of order 3."""
    levels = body.bearing_levels() if bearing else body.flange_levels()
    vertices, triangles, edges = len(body.plane.points), len(body.plane.triangles), len(body.plane.edges)
    lines = (3 * triangles + edges) // 2
    plane = vertices + 2 * lines + triangles  # order 3: two more per line, one per triangle
    return 3 * plane * (3 * (len(levels) - 1) + 1)


def centre(problem: TorsionProblem) -> tuple[float, float]:
    """Axis of rotation [m]: the shear centre, which an element in pure torsion turns about; so no bending is added."""
    outline = problem.section.outline()
    if outline.rotations > 1 or not hasattr(problem.section, "properties"):
        return (0.0, 0.0)
    x, y = problem.section.properties().shear_centre
    return (float(x), 0.0 if outline.mirror else float(y))


def bearing_faces(problem: TorsionProblem) -> Callable[[Floats, Floats], NDArray[np.bool_]]:
    """Which parts of the outside the counter bearing faces, from points and outward normals of shape (n, 2)."""
    if problem.bearing_kind != "flanks":
        return lambda points, _: np.full(len(points), True)
    section = problem.section
    side, rails = 0.5 * float(section.rail_width), int(section.rails)  # type: ignore[attr-defined]  # only a splined tube has flanks

    def on_flank(points: Floats, normals: Floats) -> NDArray[np.bool_]:
        found = np.full(len(points), False)
        for rail in range(rails):
            turn = 2.0 * np.pi * rail / rails
            along, across = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
            y, normal = points @ across, normals @ across
            found |= (points @ along > 0.0) & (np.abs(np.abs(y) - side) < 1e-6 * side) & (np.abs(normal) > 1.0 - 1e-9)
        return found

    return on_flank


def _nowhere(points: Floats, _: Floats) -> NDArray[np.bool_]:
    return np.full(len(points), False)
