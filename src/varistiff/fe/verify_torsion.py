"""A torsion element by section theory and in three dimensions, over its active length."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.core.errors import InputError
from varistiff.fe.comparison import Comparison, Floats, Method
from varistiff.fe.end_fit import EndFit, fit_end_effect
from varistiff.fe.torsion_problem import TorsionProblem, TorsionResult, turns_at_the_lock
from varistiff.sections.hollow_circle import HollowCircle
from varistiff.sections.splined_tube import SplinedTube

LABELS = {
    "end_flange_free": "3-D, end flange, free to warp",
    "end_flange_blocked": "3-D, end flange, warping blocked",
    "bearing_pressure": "3-D, pressure on the bearing areas",
    "bearing_contact": "3-D, contact with the bearing",
    "bearing_bonded": "3-D, bonded bearing",
}
BEARING_CASES = ("bearing_contact", "bearing_bonded", "bearing_pressure")


@dataclass(frozen=True)
class TorsionHardware:
    """What a torsion tube's design leaves open and the solid needs.

    Parameters
    ----------
    poissons_ratio : nu
    bearing_length : of the counter bearing along the element [m]
    bearing_clearance : between bearing and element [m]
    flange_radius, flange_thickness : of the drive-side disc [m]; None leaves it out
    """

    poissons_ratio: float
    bearing_length: float
    bearing_clearance: float = 0.0
    flange_radius: float | None = None
    flange_thickness: float | None = None


def torsion_problem(tube: TorsionTube, setting: float, hardware: TorsionHardware) -> TorsionProblem:
    """The solid of a torsion tube at one setting.

    An element without a length ends with the bearing.

    Raises
    ------
    InputError : a setting outside the element, or a number out of its range
    """
    length = tube.length if math.isfinite(tube.length) else setting + hardware.bearing_length
    if not 0.0 <= setting < length:
        raise InputError(
            f"{1e3 * setting:.6g} mm is outside the element; allowed is 0 mm to below {1e3 * length:.6g} mm",
            field="--setting",
        )
    if setting == 0.0 and not turns_at_the_lock(tube.section):
        raise InputError(
            f"0 mm is the rigid lock, where the bearing meets the clamp and no {tube.section.shape} turns; allowed is "
            "above 0 mm, or a splined_tube, whose rails give way there",
            field="--setting",
        )
    return TorsionProblem(
        section=tube.section,
        shear_modulus=tube.shear_modulus,
        poissons_ratio=hardware.poissons_ratio,
        length=length,
        active_length=setting,
        bearing_length=hardware.bearing_length,
        bearing_clearance=hardware.bearing_clearance,
        flange_radius=hardware.flange_radius,
        flange_thickness=hardware.flange_thickness,
    )


def compare_torsion(
    tube: TorsionTube,
    settings: Sequence[float],
    solve: Callable[[int, TorsionProblem], TorsionResult],
    hardware: TorsionHardware,
) -> tuple[Comparison, tuple[TorsionResult, ...]]:
    """Stiffness of the whole drive train over the active length: formula, section theory, three dimensions.

    Parameters
    ----------
    settings : active lengths [m], from 0 (the rigid lock, where only the solid has a stiffness)
    solve : the solver, called with the number of the setting and its problem
    hardware : what the design leaves open
    """
    x = np.array(sorted({float(setting) for setting in settings}))
    problems = [torsion_problem(tube, float(setting), hardware) for setting in x]
    results = tuple(solve(number, problem) for number, problem in enumerate(problems))
    rigidity = tube.shear_modulus * tube.torsion_constant
    label = "section theory" + (", G J/x" if math.isinf(tube.series_stiffness) else " with the drive train")
    methods = [_theory("section_theory", label, rigidity, x, tube)]
    if isinstance(tube.section, SplinedTube):
        bare = HollowCircle(outer_radius=tube.section.outer_radius, inner_radius=tube.section.inner_radius)
        methods.append(_theory("bare_tube", "tube without rails", tube.shear_modulus * bare.torsion_constant, x, tube))
    for name in dict.fromkeys(case.name for result in results for case in result.cases):
        methods.append(_solid(name, results, tube))
    last = results[-1]
    comparison = Comparison(
        quantity="stiffness",
        unit="N*m/rad",
        setting=x,
        deflection=None,
        methods=tuple(methods),
        remarks=tuple(_remarks(tube, x, results, hardware.bearing_length)),
        fields=last.fields,
    )
    return comparison, results


def fitted_ends(tube: TorsionTube, comparison: Comparison) -> dict[str, EndFit]:
    """End models of the load cases at the bearing, by the label of the case; none where there are too few settings.

    Contact, or the bonded bearing, is what the device does. A uniform pressure has a stiffness at the lock too, where a
    rigid bearing beside a rigid clamp has none.
    """
    found = {}
    for method in comparison.methods:
        element = 1.0 / (1.0 / method.values - 1.0 / tube.series_stiffness)
        known = np.isfinite(element)
        if method.name in BEARING_CASES and known.sum() >= 4:
            found[method.label] = fit_end_effect(
                active_length=comparison.setting[known],
                stiffness=element[known],
                rigidity=tube.shear_modulus * tube.torsion_constant,
            )
    return found


def _theory(name: str, label: str, rigidity: float, x: Floats, tube: TorsionTube) -> Method:
    with np.errstate(divide="ignore"):
        values = np.where(x > 0.0, 1.0 / (x / rigidity + 1.0 / tube.series_stiffness), np.nan)
    return Method(name, label, values, np.full(x.size, np.nan))


def _solid(name: str, results: Sequence[TorsionResult], tube: TorsionTube) -> Method:
    found = [next((case for case in result.cases if case.name == name), None) for result in results]
    series = 1.0 / tube.series_stiffness
    values = np.array([math.nan if case is None else 1.0 / (1.0 / case.stiffness + series) for case in found])
    errors = np.array([math.nan if case is None else case.error for case in found])
    return Method(name, LABELS.get(name, name), values, errors)


def _remarks(tube: TorsionTube, x: Floats, results: Sequence[TorsionResult], bearing_length: float) -> list[str]:
    said = []
    if math.isfinite(tube.series_stiffness):
        said.append(f"Every stiffness includes the drive train in series, {tube.series_stiffness:.6g} N m/rad.")
    if tube.torsion_modulus == 0.0:
        said.append(
            "The section has sharp re-entrant corners: the ideal stress there is unbounded, and what a mesh finds "
            "depends on the mesh. A root fillet has a stress."
        )
    shares = [(case.local_share, at) for at, result in zip(x, results, strict=True) for case in result.cases]
    local = [(share, at) for share, at in shares if math.isfinite(share)]
    if local:
        ends = [
            f"{100.0 * share:.2g} % of the rotation (x = {1e3 * at:.4g} mm)" for share, at in (min(local), max(local))
        ]
        said.append(f"Local deflection at the bearing: {' to '.join(dict.fromkeys(ends))}.")
    contact = results[-1].contact
    if contact is not None and contact.lost_motion > 0.0:
        lost = math.degrees(contact.lost_motion)
        said.append(
            f"Lost motion from the bearing's clearance: {lost:.3g} deg either way; it is no part of the stiffness."
        )
    cut = [f"{1e3 * at:.4g}" for at in x if at + bearing_length > tube.length * (1.0 + 1e-9)]
    if cut:
        said.append(f"The bearing reaches beyond the element's end and is cut off there: x = {', '.join(cut)} mm.")
    stress = results[-1].stress
    if math.isfinite(stress.bearing_ratio):
        said.append(
            f"Largest equivalent stress with the bearing's load superimposed: {stress.bearing_ratio:.3g} times that "
            f"of torsion alone ({stress.bearing_case}, x = {1e3 * x[-1]:.4g} mm), {1e3 * stress.distance:.2g} mm away "
            "from edges where the ideal stress is unbounded; it changed by "
            f"{100.0 * stress.bearing_error:.2g} % in the last refinement, so it is a size and no limit."
        )
    return said
