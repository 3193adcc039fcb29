"""Torsion constants of sections: ours and sectionproperties, error and time side by side."""

from __future__ import annotations

import importlib.metadata
import math
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from benchmarks import outlines
from benchmarks.timing import in_turn
from varistiff.core.errors import InputError
from varistiff.sections import P3G, Hexagon, Rectangle, SplinedTube, Square
from varistiff.sections.outline import Arc, Loop, Outline, is_straight
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.regular_polygon import regular_polygon
from varistiff.sections.rungs import rung_nodes
from varistiff.sections.saint_venant import solve_torsion
from varistiff.sections.solved import solved_properties

MESHES = (200, 1500, 6000)  # triangles, about
FACET = 1.5  # length of a facet of a curved edge over the root of a triangle's area, about that of straight edges
KERNEL = 20  # operations for each pair of nodes and image: a complex quotient, a difference, four sums
TUBE = {"outer_radius": 11.0, "inner_radius": 8.7, "rails": 6, "rail_width": 4.0, "rail_height": 2.5}
CORNERS = (20, 40, 100)  # of polygons whose symmetry the solver is not told


@dataclass(frozen=True)
class Row:
    """One line of the table."""

    method: str
    size: str
    seconds: float
    error: float
    stated: str


def _circle(centre: tuple[float, float], radius: float, way: float) -> Loop:
    quarter = 0.5 * math.pi * way
    return tuple(Arc(centre, radius, k * quarter, quarter) for k in range(4))


def shapes() -> dict[str, Outline]:
    """Outlines in millimetres."""
    return {
        "square": Square(across_flats=20.0).outline(),
        "hexagon": Hexagon(across_flats=20.0).outline(),
        "P3G, e = 4 % of Dm": P3G(mean_diameter=20.0, eccentricity=0.8).outline(),
        "splined tube, sharp roots": SplinedTube(**TUBE, root_fillet=0.0).outline(),
        "splined tube, fillets 0.5 mm": SplinedTube(**TUBE, root_fillet=0.5).outline(),
        "L of three squares": polygon_of_points(outlines.ELL).outline(),
        "tube with eccentric bore": Outline((_circle((0.0, 0.0), 10.0, 1.0), _circle((3.0, 0.0), 5.0, -1.0))),
        **{_many(corners): _polygon(corners) for corners in CORNERS},
        **{name: polygon_of_points(corners).outline() for name, (corners, *_) in outlines.RE_ENTRANT.items()},
    }


def _polygon(corners: int) -> Outline:
    """Regular, 20 mm between parallel sides, corner by corner."""
    radius = 0.01 / math.cos(math.pi / corners)
    angles = 2.0 * math.pi * np.arange(corners) / corners
    return polygon_of_points(np.stack([radius * np.cos(angles), radius * np.sin(angles)], axis=1).tolist()).outline()


def _reference(name: str, outline: Outline) -> float:
    """J of a far finer, graded solution, of one part of what repeats, or from the series."""
    if name == "square":
        return Rectangle(width=20.0, height=20.0).torsion_constant
    known = {_many(corners): regular_polygon(corners, 0.02) for corners in CORNERS}
    known |= {name: outlines.part(*shape) for name, shape in outlines.RE_ENTRANT.items()}
    outline = known.get(name, outline)
    for order, share in ((16, 1e-12), (12, 1e-10), (10, 1e-9)):
        with suppress(InputError):
            return solve_torsion(outline, order=order, tolerance=share).torsion_constant
    raise AssertionError(f"no reference for {name}")


def _many(corners: int) -> str:
    return f"polygon of {corners} corners"


def _polyline(loop: Loop, facet: float) -> np.ndarray:
    """Corners of a loop, curved segments in facets of about that length."""
    corners = []
    for segment in loop:
        length = float(np.hypot(*segment.velocity(np.linspace(0.0, 1.0, 33)).T).mean())
        count = 1 if is_straight(segment) else max(2, math.ceil(length / facet))
        corners.append(segment.point(np.arange(count) / count))
    return np.concatenate(corners)


def _rate() -> float:
    """Operations a second of a product of matrices: what a dense solver is held to."""
    a = np.random.default_rng(0).normal(size=(800, 800))
    return 2.0 * 800.0**3 / float(in_turn([lambda: a @ a], rounds=7).seconds[0])


def floor_operations(outline: Outline) -> tuple[int, float]:
    """Nodes of the finer solution, and operations of both: 2/3 N^3 each and the kernel."""
    counts = [nodes.weight.size for nodes in rung_nodes(outline)]
    images = outline.rotations * (2 if outline.mirror else 1)
    return counts[0], sum(2.0 / 3.0 * n**3 + KERNEL * images * n**2 for n in counts)


def _ours(outline: Outline, reference: float, rate: float) -> tuple[Row, Row]:
    seconds = float(in_turn([lambda: solved_properties(outline)], rounds=5).seconds[0])
    found = solved_properties(outline)
    nodes, operations = floor_operations(outline)
    error = abs(found.torsion_constant / reference - 1.0)
    return (
        Row("**varistiff, all properties**", f"{nodes} nodes", seconds, error, f"{found.error:.0e}"),
        Row("floor: its dense solutions alone", f"{operations / 1e6:.0f} M operations", operations / rate, error, ""),
    )


def _meshed(outline: Outline, triangles: int) -> Callable[[], tuple[float, int]]:
    """J of sectionproperties, quadratic triangles, and how many: meshing and solving."""
    from sectionproperties.analysis import Section
    from sectionproperties.pre import Geometry
    from shapely import Polygon

    area = solve_torsion(outline, nodes=rung_nodes(outline)[1]).area / triangles
    outer, *holes = (_polyline(loop, FACET * math.sqrt(area)) for loop in outline.loops)

    def solve() -> tuple[float, int]:
        # its refinement to angles of 30 degrees makes triangles of 0.6 of the largest area on average
        geometry = Geometry(Polygon(outer, holes)).create_mesh(mesh_sizes=[area / 0.6])
        section = Section(geometry)
        return float(section.calculate_frame_properties()[4]), len(section.elements)

    return solve


def _theirs(outline: Outline, reference: float) -> list[Row]:
    try:
        version = importlib.metadata.version("sectionproperties")
    except importlib.metadata.PackageNotFoundError:
        return [Row("sectionproperties is not installed", "", math.nan, math.nan, "")]
    rows = []
    _meshed(outline, MESHES[0])()  # its first call compiles
    for triangles in MESHES:
        solve = _meshed(outline, triangles)
        start = time.process_time()
        constant, count = solve()  # once: it takes seconds
        seconds = time.process_time() - start
        error = abs(constant / reference - 1.0)
        rows.append(Row(f"sectionproperties {version}", f"{count} triangles", seconds, error, ""))
    return rows


def _spent(seconds: float) -> str:
    milli = 1e3 * seconds
    return f"{milli:.2f} ms" if milli < 10.0 else f"{milli:.0f} ms"


def table() -> list[str]:
    """Rows of the Markdown table."""
    rate = _rate()
    rows = [
        "Errors of J are against the series for the square, else against a graded solution of ours with order 10 to 16 "
        "and a share of 1e-9 to 1e-12 for corners, which is told the symmetry of the polygons; the tests hold both "
        "against exact ones. "
        "sectionproperties: quadratic triangles, curved "
        "edges in facets as long as the triangles, meshing included, torsion alone. Floor: the operations of the dense "
        f"solutions, 2/3 N^3 and {KERNEL} N^2 for each image, at the {rate / 1e9:.0f} G operations/s of a product of "
        "matrices.",
        "",
        "| section | method | size | time | error of J | stated error |",
        "|---|---|---|---|---|---|",
    ]
    for name, outline in shapes().items():
        reference = _reference(name, outline)
        found = [*_ours(outline, reference, rate), *_theirs(outline, reference)]
        if name == "square":
            bar = Rectangle(width=20.0, height=20.0)
            seconds = float(in_turn([lambda bar=bar: bar.torsion_constant], rounds=25).seconds[0])
            found.insert(0, Row("series", "20 terms", seconds, 0.0, "0"))
        for row in found:
            error = "" if row.method.startswith("floor") or math.isnan(row.error) else f"{row.error:.0e}"
            spent = "" if math.isnan(row.seconds) else _spent(row.seconds)
            rows.append(f"| {name} | {row.method} | {row.size} | {spent} | {error} | {row.stated} |")
    return rows
