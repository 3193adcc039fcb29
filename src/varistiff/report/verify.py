"""The three-dimensional check of a design: settings in, comparison, table and files out."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.report.display import display

if TYPE_CHECKING:
    from varistiff.design.design import Design
    from varistiff.fe.comparison import Comparison, Floats
    from varistiff.fe.end_fit import EndFit
    from varistiff.fe.verify_torsion import TorsionHardware

Tell = Callable[[str], None]
SETTINGS = 7  # when none is given
ASSUMED_POISSON = 0.35
KINDS = ("torsion_tube", "roller_beam", "antagonistic_leaves", "slider_leaf_joint")


@dataclass(frozen=True)
class Verification:
    """What the check found.

    Parameters
    ----------
    comparison : every method and its values
    ends : end models of a torsion tube's load cases, fitted to four settings or more
    table : header and rows for people
    """

    comparison: Comparison
    ends: dict[str, EndFit]
    table: tuple[list[str], list[list[str]]]


def verify(
    design: Design,
    output: str | os.PathLike[str],
    *,
    settings: Sequence[float] = (),
    deflections: Sequence[float] = (),
    measured: tuple[Floats, Floats] | None = None,
    tolerance: float = 0.005,
    tell: Tell = lambda text: None,
) -> Verification:
    """Compare a design with a solid of its elastic element and write the comparison to a directory.

    Parameters
    ----------
    design : of a torsion tube or a device with leaves
    output : directory for comparison.csv, comparison.json, figures and report.html
    settings : SI; even over the design's range if there are none
    deflections : SI, for leaves; the largest that the map has numbers for if there are none
    measured : settings and stiffness (or load) of a measurement, SI, drawn beside the rest
    tolerance : relative change of a result in its last refinement
    tell : told what is being done, a line each

    Raises
    ------
    InputError : a kind without a solid, a setting outside, NGSolve missing, no convergence, an output in the way
    """
    from varistiff.core.citations import citation
    from varistiff.core.writing import check_directory
    from varistiff.fe import import_ngsolve
    from varistiff.report.verification import check_output, table_rows, write_verification

    if design.kind not in KINDS:
        raise InputError(f"a {design.kind} has no solid to check; allowed: {', '.join(KINDS)}", file=design.path)
    import_ngsolve()
    check_directory(output)
    check_output(output)
    at = list(settings) or _even(design)
    ratio, assumed = poissons_ratio(design)
    if design.kind == "torsion_tube":
        comparison, ends, method = _torsion(design, at, ratio, tolerance, tell)
    else:
        comparison, ends, method = _leaves(design, at, deflections, ratio, tolerance, tell), {}, LEAF_METHOD
    unit = design.setting_unit or ""
    comparison = replace(comparison, assumptions=(*assumed, *comparison.assumptions), measured=measured)
    about = {key: str(value) for key, value in design.attributes.items()}
    about |= _provenance(design)
    about["sources"] = "; ".join(str(citation(key)) for key in design.actuator.references)
    write_verification(comparison, output, about={**about, "method": method}, setting_unit=unit)
    return Verification(comparison, ends, table_rows(comparison, unit))


LEAF_METHOD = (
    "Solid of the leaf with large rotations and small strains (Saint Venant-Kirchhoff), hexahedra of high order, "
    "frictionless contact, Newton's method; refined until the load settles."
)


def _provenance(design: Design) -> dict[str, str]:
    """As of a map, without what only a point's status needs, and with the unit that a map's variables have."""
    from varistiff.characteristic.provenance import provenance

    found = provenance(design.actuator, packages=("ngsolve", "numpy"))
    del found["broken_assumption"]
    if "strength" in found:
        found["strength"] = f"{found['strength']:.6g} Pa"
    return {key: str(value) for key, value in found.items()}


def poissons_ratio(design: Design) -> tuple[float, tuple[str, ...]]:
    """Poisson's ratio for the solid, and what was assumed about it."""
    wanted = design.spec.verification
    if wanted is not None and wanted.poissons_ratio is not None:
        return wanted.poissons_ratio, ()
    material = design.material
    if material is not None and material.isotropic and material.youngs_modulus and material.shear_modulus:
        ratio = material.youngs_modulus.value / (2.0 * material.shear_modulus.value) - 1.0
        if 0.0 <= ratio <= 0.49:
            return ratio, (f"Poisson's ratio {ratio:.3g}, from E and G of {material.key}.",)
    return ASSUMED_POISSON, (f"Poisson's ratio {ASSUMED_POISSON}: neither design nor material gives one.",)


def hardware(design: Design, ratio: float) -> tuple[TorsionHardware, tuple[str, ...]]:
    """Bearing and flange of a torsion tube's solid, and what was assumed about them."""
    from varistiff.actuators.torsion_tube import TorsionTube
    from varistiff.fe.verify_torsion import TorsionHardware

    tube, wanted, assumed = design.actuator, design.spec.verification, []
    assert isinstance(tube, TorsionTube)  # by its kind
    length = wanted.bearing_length if wanted else None
    if length is None:
        length = tube.section.outline().radius
        assumed.append(f"A counter bearing of {1e3 * length:.4g} mm along the element, as long as its outer radius.")
    assumed.append("The bearing begins at the active length and lies beyond it.")
    found = TorsionHardware(
        poissons_ratio=ratio,
        bearing_length=length,
        bearing_clearance=(wanted.bearing_clearance if wanted else None) or 0.0,
        flange_radius=wanted.flange_radius if wanted else None,
        flange_thickness=wanted.flange_thickness if wanted else None,
    )
    return found, tuple(assumed)


def _even(design: Design) -> list[float]:
    low, high = design.setting_range or (0.0, 0.0)
    return [float(value) for value in np.linspace(low, high, SETTINGS)]


def _torsion(
    design: Design, settings: Sequence[float], ratio: float, tolerance: float, tell: Tell
) -> tuple[Comparison, dict[str, EndFit], str]:
    from varistiff.actuators.torsion_tube import TorsionTube
    from varistiff.fe.torsion_estimate import torsion_outlook
    from varistiff.fe.torsion_problem import TorsionProblem, TorsionResult
    from varistiff.fe.torsion_solve import solve
    from varistiff.fe.verify_torsion import compare_torsion, fitted_ends, torsion_problem

    tube = design.actuator
    assert isinstance(tube, TorsionTube)  # by its kind
    parts, assumed = hardware(design, ratio)
    with _located(design):
        problems = [torsion_problem(tube, setting, parts) for setting in sorted(set(settings))]
        tell(torsion_outlook(problems, tolerance=tolerance))

    def solved(number: int, problem: TorsionProblem) -> TorsionResult:
        at = f"{1e3 * problem.active_length:.4g} mm"
        where = f"setting {number + 1} of {len(problems)}, {at}"
        tell(where)
        with _located(design, f"setting {at}"):
            return solve(problem, tolerance=tolerance, progress=lambda text, share: tell(f"{where}: {text}"))

    comparison, results = compare_torsion(tube, settings, solved, parts)
    ends = fitted_ends(tube, comparison)
    return replace(comparison, assumptions=assumed), ends, results[-1].method


def _leaves(
    design: Design,
    settings: Sequence[float],
    deflections: Sequence[float],
    ratio: float,
    tolerance: float,
    tell: Tell,
) -> Comparison:
    from varistiff.fe.leaf_check import LeafCheck, check
    from varistiff.fe.leaf_estimate import leaf_outlook
    from varistiff.fe.verify_leaf import compare_leaves

    if deflections:
        points = [(deflection, setting) for setting in settings for deflection in deflections]
    else:
        points = [(_largest_deflection(design, setting), setting) for setting in settings]
    with _located(design):
        tell(leaf_outlook(design.actuator, points, poissons_ratio=ratio, tolerance=tolerance))

    def solved(number: int, deflection: float, setting: float) -> LeafCheck:
        where = f"point {number + 1} of {len(points)}"
        tell(where)
        with _located(design, where):
            return check(
                design.actuator,
                deflection,
                setting,
                poissons_ratio=ratio,
                tolerance=tolerance,
                progress=lambda text: tell(f"{where}: {text}"),
            )

    return compare_leaves(design.actuator, points, solved)


@contextmanager
def _located(design: Design, where: str = "") -> Iterator[None]:
    """Let an error of the block say which design, point and option it is about."""
    try:
        yield
    except InputError as error:
        option = error.field in ("deflection", "setting")
        field = f"--{error.field}" if option else ", ".join(part for part in (where, error.field) if part)
        raise InputError(error.problem, file=error.file or design.path, field=field or None) from None


def _largest_deflection(design: Design, setting: float) -> float:
    """The largest deflection of the design's range that is ok, or has numbers at least."""
    deflection = np.linspace(*design.deflection_range, 201)
    status = design.evaluate(deflection, np.full(deflection.size, setting)).status
    for allowed in ((Status.OK,), (Status.OK, Status.YIELDED)):
        usable = deflection[np.isin(status, allowed)]
        if usable.size:
            far = np.abs(usable)
            return float(usable[far >= (1.0 - 1e-9) * far.max()].max())  # of two sides the positive one
    shown = display(design.setting_unit or "").text(setting)
    problem = f"no deflection of the design's range has numbers at {shown}; allowed is a setting where one has"
    raise InputError(problem, file=design.path, field="--setting")
