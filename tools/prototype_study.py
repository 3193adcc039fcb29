"""Compute the three-dimensional table of the torsion prototype in docs/theory/three_dimensional_check.md.

Run ``python tools/prototype_study.py``; it needs the extra ``fe`` and takes some minutes. Interrupting is safe: solved
settings are kept.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.design.design import Design, load
from varistiff.fe.comparison import Comparison
from varistiff.fe.end_fit import EndFit
from varistiff.fe.torsion_problem import TorsionProblem, TorsionResult
from varistiff.fe.torsion_solve import solve
from varistiff.fe.verify_torsion import compare_torsion, fitted_ends
from varistiff.report.figures import comparison as comparison_figure
from varistiff.report.figures import solid_stress
from varistiff.report.verify import hardware

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs/theory/three_dimensional_check.md"
IMAGES = ROOT / "docs/images"
SETTINGS = (0.0, 0.011, 0.031, 0.051, 0.071, 0.091, 0.111, 0.131, 0.151, 0.166)  # the paper's, and the lock
PRINTED = (np.array([0.166]), np.array([71.56]))  # the one measured value that the paper prints [m, N m/rad]
PICTURED = 0.051  # setting of the stress pictures, the one of the paper's Fig. 11 is not printed


def solver(number: int, problem: TorsionProblem) -> TorsionResult:
    """Solve one setting and say so."""
    result = solve(problem, progress=lambda text, _: print(f"setting {number + 1}: {text}", file=sys.stderr))
    print(f"{problem.active_length:.3f} m: {result.unknowns} unknowns, {result.seconds:.0f} s", file=sys.stderr)
    return result


def main() -> None:
    """Write table and figures."""
    design = load(ROOT / "examples/splined_tube.yaml")
    tube = design.actuator
    assert isinstance(tube, TorsionTube)
    parts, _ = hardware(design, design.spec.verification.poissons_ratio or 0.35)
    comparison, results = compare_torsion(tube, SETTINGS, solver, parts)
    bare = tube_alone(design)
    alone, _ = compare_torsion(bare, SETTINGS, solver, parts)
    ends = fitted_ends(tube, comparison)
    text = PAGE.read_text(encoding="utf-8")
    for name, body in (("stiffness", table(alone)), ("state", states(results)), ("ends", models(ends, bare))):
        text = filled(text, name, body)
    PAGE.write_text(text, encoding="utf-8")
    pictured = results[SETTINGS.index(PICTURED)]
    shown = replace(
        comparison, setting=comparison.setting[1:], methods=tuple(without_lock(comparison)), measured=PRINTED
    )
    drawings = [comparison_figure.draw(shown, "m"), *solid_stress.draw_all(pictured.fields)]
    for drawing in drawings:
        (IMAGES / f"prototype_{drawing.name}.svg").write_text(drawing.svg() + "\n", encoding="utf-8")


def filled(text: str, name: str, body: str) -> str:
    """The page with what stands between two markers replaced."""
    pattern = rf"(<!-- {name} -->\n).*?(<!-- end -->)"
    return re.sub(pattern, lambda found: f"{found[1]}{body}\n{found[2]}", text, flags=re.DOTALL)


def tube_alone(design: Design) -> TorsionTube:
    """The element without the rest of the drive train."""
    tube = design.actuator
    assert isinstance(tube, TorsionTube)
    return TorsionTube(shear_modulus=tube.shear_modulus, section=tube.section, length=tube.length)


def without_lock(comparison: Comparison) -> Iterator[object]:
    """Every method without the first setting, where the formulas have no value."""
    return (replace(one, values=one.values[1:], errors=one.errors[1:]) for one in comparison.methods)


def table(comparison: Comparison) -> str:
    """Stiffness of the element alone, and in brackets its ratio to the tube without rails."""
    names = [method.label for method in comparison.methods]
    bare = next(method for method in comparison.methods if method.name == "bare_tube")
    lines = ["| x [mm] | " + " | ".join(names) + " |", "|---" * (len(names) + 1) + "|"]
    for row, setting in enumerate(comparison.setting):
        cells = [f"{1e3 * setting:.0f}"]
        for method in comparison.methods:
            value, ratio = method.values[row], method.values[row] / bare.values[row]
            number = f"{value:.4g}" if np.isfinite(value) else "–"
            cells.append(f"{number} ({ratio:.3f})" if np.isfinite(ratio) and method is not bare else number)
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def states(results: tuple[TorsionResult, ...]) -> str:
    """Local deflection, contact and superimposed stress over the active length."""
    lines = [
        "| x [mm] | local share, pressure | local share, contact | mean pressure [MPa/(N·m)] "
        "| stress over torsion alone (its change in refinement) | unknowns | time [s] | error of the stiffness |",
        "|---" * 8 + "|",
    ]
    for setting, result in zip(SETTINGS, results, strict=True):
        found = {case.name: f"{100.0 * case.local_share:.2g} %" for case in result.cases}
        contact, stress = result.contact, result.stress
        ratio = f"{stress.bearing_ratio:.2f} ({100.0 * stress.bearing_error:.0f} %)"
        cells = [
            f"{1e3 * setting:.0f}",
            found["bearing_pressure"],
            found.get("bearing_contact", "–"),
            "–" if contact is None else f"{1e-6 * contact.pressure_mean:.2f}",
            ratio if np.isfinite(stress.bearing_ratio) else "–",
            f"{result.unknowns}",
            f"{result.seconds:.0f}",
            f"{100.0 * result.error:.2g} %",
        ]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def models(ends: dict[str, EndFit], tube: TorsionTube) -> str:
    """The end models in words and numbers."""
    return "\n".join(f"- {label}: {model(fit, tube)}" for label, fit in ends.items())


def model(ends: EndFit, tube: TorsionTube) -> str:
    """One end model in words and numbers."""
    effect = ends.effect
    text = f"offset {1e3 * effect.offset:.2f} mm"
    if effect.lock_offset != 0.0:
        lock = tube.shear_modulus * tube.torsion_constant / ends.lock_length
        text += (
            f", lock length {1e3 * ends.lock_length:.2f} mm ({lock:.0f} N m/rad at the lock), decay length "
            f"{1e3 * effect.decay:.2f} mm"
        )
    return f"{text}; largest difference from the computed stiffness {100.0 * ends.residual:.2g} %."


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    main()
