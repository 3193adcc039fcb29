"""Load cases of the torsion check on one mesh: rigid end flange, and the counter bearing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from varistiff.core.errors import InputError
from varistiff.fe import import_ngsolve
from varistiff.fe.torsion_bearing import Bearing, contact_pressure
from varistiff.fe.torsion_body import ORDER, Body, bearing_faces
from varistiff.fe.torsion_linear import ElasticSolid
from varistiff.fe.torsion_problem import ContactState, Floats, StressField, TorsionProblem
from varistiff.fe.torsion_stress import States, largest, section_field, surface_field

_AWAY = 0.02  # of the section's radius: how far from singular lines stresses are looked for


@dataclass(frozen=True)
class Outcome:
    """What one mesh says: stiffness [N m/rad] and local share per case, contact, stress per torque [Pa/(N m)]."""

    stiffness: dict[str, float]
    unknowns: int
    local: dict[str, float]
    contact: ContactState | None = None
    stress: float = float("nan")
    stress_case: str = ""
    fields: tuple[StressField, ...] = ()


def flange_outcome(body: Body) -> Outcome:
    """Rigid flange at the active length: the end face turns in its plane, its warping free or blocked."""
    solid = body.flange_solid()
    x = body.problem.active_length
    stiffness, unknowns, peak = {}, 0, float("nan")
    field: tuple[StressField, ...] = ()
    for name, blocked in (("end_flange_free", False), ("end_flange_blocked", True)):
        elastic = body.elastic(solid, body.kinds[0], turned="end", blocked=blocked)
        elastic.factorise()
        turned = elastic.turn(1.0)
        stiffness[name] = body.sectors * elastic.twice_energy(turned)
        unknowns = elastic.unknowns
        if not blocked:
            states: States = ((elastic, turned),)
            peak = largest(states, span=(0.499999 * x, 0.500001 * x), lines=_corner_lines(body, x), distance=away(body))
            peak /= stiffness[name]
            field = (_per_torque(section_field(states, "torsion_section", 0.5 * x), stiffness[name]),)
    return Outcome(
        stiffness, unknowns, {}, stress=float(peak / np.sqrt(3.0)), stress_case="end_flange_free", fields=field
    )


def bearing_outcome(body: Body) -> Outcome:
    """The element under its counter bearing."""
    return _bonded(body) if body.problem.bearing_kind == "bonded" else _pressed(body)


def _bonded(body: Body) -> Outcome:
    solid = body.bearing_solid()
    elastic = body.elastic(solid, body.kinds[0], turned="bearing")
    elastic.factorise()
    turned = elastic.turn(1.0)
    stiffness = body.sectors * elastic.twice_energy(turned)
    states: States = ((elastic, turned),)
    local = {"bearing_bonded": 1.0 - core_rotation(body, elastic, turned)}
    return _with_stress(
        body, Outcome({"bearing_bonded": stiffness}, elastic.unknowns, local), states, "bearing_bonded", stiffness
    )


def _pressed(body: Body) -> Outcome:
    solid = body.bearing_solid()
    elastics = tuple(body.elastic(solid, kind) for kind in body.kinds)
    for elastic in elastics:
        elastic.factorise()
    flanks, copies = body.problem.bearing_kind == "flanks", body.plane.copies
    bearing = Bearing(elastics, order=ORDER, one_flank=flanks)
    loads: dict[str, Floats] = {"bearing_pressure": bearing.uniform()} if flanks else {}
    if body.problem.active_length > 0.0:
        loads["bearing_contact"] = contact_pressure(bearing)
        if not bearing.torque(loads["bearing_contact"]) > 0.0:
            raise InputError(
                "the counter bearing finds no hold on the section; allowed is an outline that is not round"
            )
    stiffness, local, contact = {}, {}, None
    states: States = ()
    for name, pressure in loads.items():
        torque, work = bearing.torque(pressure), float(np.sum(pressure * bearing.answer(pressure)))
        stiffness[name] = copies * torque**2 / work
        moved = bearing.displacements(pressure)
        states = tuple((e, e.field(w)) for e, w in zip(elastics, moved, strict=True))
        local[name] = 1.0 - core_rotation(body, *states[0]) * torque / work
        if name == "bearing_contact":
            contact = _contact_state(body.problem, bearing, pressure, copies)
    outcome = Outcome(stiffness, elastics[0].unknowns, local, contact=contact)
    return _with_stress(body, outcome, states, name, copies * torque)


def _contact_state(problem: TorsionProblem, bearing: Bearing, pressure: Floats, copies: int) -> ContactState:
    carries = pressure > 0.0
    torque, force = copies * bearing.torque(pressure), float(np.sum(pressure * bearing.weights))
    area = float(np.sum(bearing.weights[carries]))
    driving = bearing.facing & (bearing.levers > 0.0)
    lever = bearing.torque(pressure) / force
    # rails: conforming flanks close over their mean radius; a sleeve first closes where its lever arm is longest
    one_flank = problem.bearing_kind == "flanks"
    closing = (
        float(np.average(bearing.levers[driving], weights=bearing.weights[driving]))
        if one_flank
        else float(bearing.levers.max())
    )
    return ContactState(
        area_share=float(np.sum(bearing.weights[carries & driving]) / np.sum(bearing.weights[driving])),
        pressure_mean=force / area / torque,
        pressure_max=float(pressure.max()) / torque,
        lever=lever,
        lost_motion=problem.bearing_clearance / closing,
    )


def core_rotation(body: Body, elastic: ElasticSolid, w: Any) -> float:
    """Mean rotation of the core along the bearing: of the bore, or of the material near the axis where there is none.

    Without a bore the rotation (e_z x r).u/r^2 is averaged with the weight r^2 (1 - r^2/r_i^2) within r_i, the
    smallest distance of the outside from the axis.
    """
    ng = import_ngsolve()
    if elastic.kind == "symmetric":
        return 0.0
    mesh, plane = elastic.solid.mesh, body.plane
    turning = ng.CF((-ng.y, ng.x, 0.0)) * elastic.displacement(w)
    square = ng.x**2 + ng.y**2
    near, far = body.problem.active_length, body.problem.bearing_end
    under = ng.IfPos(ng.z - near, 1.0, 0.0) * ng.IfPos(far - ng.z, 1.0, 0.0)
    if any(side.name == "hole" for side in plane.sides):
        measure: dict[str, Any] = {"definedon": mesh.Boundaries("hole")}
    else:
        t = np.linspace(0.0, 1.0, 65)
        inner = min(float(np.hypot(*s.segment.point(t).T).min()) for s in plane.sides if s.name == "outer")
        inside = 1.0 - square / inner**2
        under = under * ng.IfPos(inside, inside, 0.0)
        measure = {}
    parts = [ng.Integrate(under * what, mesh, order=2 * ORDER, **measure) for what in (turning, square)]
    return float(parts[0] / parts[1])


def away(body: Body) -> float:
    """Distance from singular lines within which no stress is reported [m]."""
    return _AWAY * body.problem.section.outline().radius


def _with_stress(body: Body, outcome: Outcome, states: States, name: str, torque: float) -> Outcome:
    near, far = body.problem.active_length, body.problem.bearing_end
    lines = np.concatenate([_corner_lines(body, body.problem.length), _edge_lines(body)])
    span = (max(0.5 * near, away(body)), body.problem.length)
    peak = largest(states, span=span, lines=lines, distance=away(body)) / np.sqrt(3.0)
    fields = tuple(
        _per_torque(field, torque)
        for field in (
            section_field(states, "bearing_section", 0.5 * (near + far)),
            surface_field(states, "bearing_surface"),
        )
    )
    return Outcome(
        outcome.stiffness, outcome.unknowns, outcome.local, outcome.contact, float(peak / torque), name, fields
    )


def _per_torque(field: StressField, torque: float) -> StressField:
    return StressField(field.name, field.points, field.triangles, field.equivalent / torque)


def _corner_lines(body: Body, height: float) -> Floats:
    """Sharp re-entrant corners along the element, shape (n, 2, 3)."""
    return np.array([[(x, y, 0.0), (x, y, height)] for x, y in body.plane.corners]).reshape(-1, 2, 3)


def _edge_lines(body: Body) -> Floats:
    """Edges of the bearing's facing surface, where a rigid bearing's pressure is unbounded."""
    plane = body.plane
    along = plane.points[plane.edges[:, 1]] - plane.points[plane.edges[:, 0]]
    normals = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
    outer = np.array([plane.sides[side].name == "outer" for side in plane.edge_sides])
    facing = outer & bearing_faces(body.problem)(plane.points[plane.edges].mean(axis=1), normals)
    near, far = body.problem.active_length, body.problem.bearing_end
    lines, ends = [], np.bincount(plane.edges[facing].ravel(), minlength=len(plane.points))
    for a, b in plane.edges[facing]:
        for z in (near, far):
            lines.append([(*plane.points[a], z), (*plane.points[b], z)])
    for vertex in np.flatnonzero(ends == 1):
        x, y = plane.points[vertex]
        on_side = abs(np.arctan2(y, x)) < 1e-9 or abs(np.arctan2(y, x) - plane.angle) < 1e-9
        if not (plane.angle and on_side):
            lines.append([(x, y, near), (x, y, far)])
    return np.array(lines).reshape(-1, 2, 3)
