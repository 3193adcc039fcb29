"""STEP file of the elastic element, from the same outline that is computed with."""

from __future__ import annotations

import math
import os
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.core.writing import staged_file
from varistiff.fe import import_ngsolve
from varistiff.fe.torsion_problem import TorsionSection
from varistiff.sections.outline import Arc, Image, Loop, Segment, is_straight

_MILLIMETRES = 1e3  # a STEP file is in millimetres
_DEVIATION = 1e-6  # of the section's radius, wanted of an interpolated curve
_POINTS = (9, 17, 33, 65, 129)


def write_step(
    section: TorsionSection,
    *,
    length: float,
    path: str | os.PathLike[str],
    flange_radius: float | None = None,
    flange_thickness: float | None = None,
) -> float:
    """Write the element as one solid: the section from z = 0 to the length, the flange disc below z = 0.

    Straight lines and circular arcs are exact; other curves are interpolated by splines.

    Parameters
    ----------
    section : cross-section; holes go through the flange too
    length : of the element [m]
    path : of the file, which appears whole or not at all
    flange_radius, flange_thickness : of the drive-side disc [m]; no disc without both

    Returns
    -------
    Largest distance between an interpolated curve and the exact one [m]; 0 without curves.

    Raises
    ------
    InputError : NGSolve is missing, a number is out of range, or the file cannot be written
    """
    import_ngsolve()
    for name, value in (("length", length), ("flange_radius", flange_radius), ("flange_thickness", flange_thickness)):
        if value is not None and not 0.0 < value < math.inf:
            raise InputError(f"{name} is {value!r}; allowed is a finite number above 0", field=name)
    try:
        solid, deviation = _solid(section, length, flange_radius, flange_thickness)
        with tempfile.TemporaryDirectory() as directory:
            written = Path(directory) / "element.step"
            solid.WriteStep(str(written))
            text = written.read_text(encoding="utf-8", errors="replace").replace(directory, "")
    except InputError:
        raise
    except Exception as error:  # OCC raises its own exceptions
        said = (str(error).strip() or type(error).__name__).splitlines()[0]
        raise InputError(
            f"no solid can be made of the section (the CAD kernel says: {said}); allowed is an outline without details "
            "far smaller than the rest",
            field="actuator.section",
        ) from None
    with staged_file(path, option="--step") as stream:
        stream.write(text)
    return deviation


def _solid(section: TorsionSection, length: float, radius: float | None, thickness: float | None) -> tuple[Any, float]:
    from netgen.occ import Axes, Cylinder, Face, Pnt, Vec, X, Z

    outline = section.outline()
    wanted = _DEVIATION * outline.radius
    wires, deviations = zip(*(_wire(loop, wanted) for loop in outline.loops), strict=True)
    solid = _extruded(wires[0], 0.0, length, Face, Vec, Pnt)
    flange = radius is not None and thickness is not None
    if flange:
        assert radius is not None
        assert thickness is not None
        base = Axes(Pnt(0.0, 0.0, -_MILLIMETRES * thickness), Z, X)
        solid = solid + Cylinder(base, r=_MILLIMETRES * radius, h=_MILLIMETRES * thickness)
    for wire in wires[1:]:
        solid = solid - _extruded(wire, -(thickness or 0.0) if flange else 0.0, length, Face, Vec, Pnt)
    solid.name = "elastic element"
    return solid, max(deviations)


def _extruded(wire: Any, low: float, high: float, face: Any, vec: Any, pnt: Any) -> Any:
    """Prism over a wire in the plane z = 0, between two levels [m]."""
    prism = face(wire).Extrude(vec(0.0, 0.0, _MILLIMETRES * (high - low)))
    return prism.Move(vec(0.0, 0.0, _MILLIMETRES * low)) if low else prism


def _wire(loop: Loop, wanted: float) -> tuple[Any, float]:
    from netgen.occ import ArcOfCircle, Pnt, SplineInterpolation, Wire
    from netgen.occ import Segment as StraightEdge

    starts = [segment.point(np.zeros(1))[0] for segment in loop]
    edges, deviation = [], 0.0
    for number, segment in enumerate(loop):
        start, end = starts[number], starts[(number + 1) % len(loop)]  # shared ends meet exactly
        if is_straight(segment):
            edges.append(StraightEdge(_point(start, Pnt), _point(end, Pnt)))
            continue
        if _is_arc(segment):
            # a full circle needs two arcs
            cuts = (0.0, 0.5, 1.0) if abs(_arc(segment).sweep) > math.pi else (0.0, 1.0)
            for a, b in pairwise(cuts):
                first, middle, last = segment.point(np.array([a, 0.5 * (a + b), b]))
                first, last = (start if a == 0.0 else first), (end if b == 1.0 else last)
                edges.append(ArcOfCircle(*(_point(point, Pnt) for point in (first, middle, last))))
            continue
        for count in _POINTS:
            points = segment.point(np.linspace(0.0, 1.0, count))
            points[0], points[-1] = start, end
            edge = SplineInterpolation([_point(point, Pnt) for point in points])
            found = _distance(edge, segment)
            if found <= wanted:
                break
        edges.append(edge)
        deviation = max(deviation, found)
    return Wire(edges), deviation


def _arc(segment: Segment) -> Arc:
    found = segment.segment if isinstance(segment, Image) else segment
    assert isinstance(found, Arc)
    return found


def _is_arc(segment: Segment) -> bool:
    return isinstance(segment.segment if isinstance(segment, Image) else segment, Arc)


def _point(point: NDArray[np.float64], pnt: Any) -> Any:
    return pnt(_MILLIMETRES * float(point[0]), _MILLIMETRES * float(point[1]), 0.0)


def _distance(edge: Any, segment: Segment) -> float:
    """Largest distance of an edge from a segment [m], at many points."""
    low, high = edge.parameter_interval
    values = [edge.Value(s) for s in np.linspace(low, high, 301)]
    places = np.array([[value.x, value.y] for value in values]) / _MILLIMETRES
    exact = segment.point(np.linspace(0.0, 1.0, 4001))
    start, along = exact[:-1], np.diff(exact, axis=0)
    worst = 0.0
    for place in places:
        t = np.clip(np.sum((place - start) * along, axis=1) / np.sum(along * along, axis=1), 0.0, 1.0)
        worst = max(worst, float(np.hypot(*(place - start - t[:, None] * along).T).min()))
    return worst
