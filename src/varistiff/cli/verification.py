"""What ``varistiff verify`` reads and prints."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from varistiff.cli.points import read_columns
from varistiff.core import quantity
from varistiff.core.errors import InputError

if TYPE_CHECKING:
    from varistiff.design.design import Design
    from varistiff.fe.comparison import Floats
    from varistiff.fe.end_fit import EndFit
    from varistiff.report.verify import Verification

TOLERANCE = (1e-4, 0.1)  # allowed from, to


def report_verification(
    design: Design,
    directory: str,
    *,
    settings: Sequence[str],
    deflections: Sequence[str],
    measured: str | None,
    tolerance: float,
) -> None:
    """Run the check and print its table, its remarks and, for a torsion tube, the end model.

    Raises
    ------
    InputError : an option that is not allowed, or what the check itself refuses
    """
    from varistiff.report.verify import verify

    if not TOLERANCE[0] <= tolerance <= TOLERANCE[1]:
        raise InputError(f"is {tolerance:g}; allowed is from {TOLERANCE[0]:g} to {TOLERANCE[1]:g}", field="--tolerance")
    if deflections and design.kind == "torsion_tube":
        raise InputError("is given, but a torsion tube's stiffness does not depend on it", field="--deflection")
    found = verify(
        design,
        directory,
        settings=_quantities(settings, "--setting", design.setting_unit),
        deflections=_quantities(deflections, "--deflection", design.deflection_unit),
        measured=None if measured is None else _measured(design, measured),
        tolerance=tolerance,
        tell=lambda text: print(f"varistiff: {text}", file=sys.stderr),
    )
    for line in _lines(found):
        print(line)


def write_element(design: Design, path: str) -> None:
    """Write a torsion tube's element as STEP, with its flange where the design has one.

    Raises
    ------
    InputError : another kind, no length, NGSolve missing, or a file that cannot be written
    """
    from varistiff.actuators.torsion_tube import TorsionTube
    from varistiff.fe.step import write_step

    tube, wanted = design.actuator, design.spec.verification
    if not isinstance(tube, TorsionTube):
        problem = f"a {design.kind} has no element to write; allowed: torsion_tube"
        raise InputError(problem, file=design.path, field="--step")
    if not math.isfinite(tube.length):
        raise InputError(
            "is missing; the STEP file needs the element's length", file=design.path, field="actuator.length"
        )
    try:
        deviation = write_step(
            tube.section,
            length=tube.length,
            path=path,
            flange_radius=wanted.flange_radius if wanted else None,
            flange_thickness=wanted.flange_thickness if wanted else None,
        )
    except InputError as error:  # about the file that was to be written, or else the design
        raise error.located(file=design.path) from None
    print(f"The elastic element is in {path}")
    if deviation > 0.0:
        print(f"Curves are interpolated to {1e6 * deviation:.2g} micrometres; lines and arcs are exact.")


def _quantities(texts: Sequence[str], option: str, unit: str | None) -> list[float]:
    kind = quantity.ANGLE if unit == "rad" else quantity.LENGTH
    found = []
    for text in texts:
        try:
            found.append(quantity.parse_quantity(text, kind))
        except InputError as error:
            raise error.located(field=option) from None
    return found


def _measured(design: Design, path: str) -> tuple[Floats, Floats]:
    import numpy as np

    load = "force" if design.deflection_unit == "m" else "torque"
    name = "stiffness" if design.kind == "torsion_tube" else load
    columns, ignored = read_columns(path, ("setting", name))
    if ignored:
        print(f"varistiff: {path}: columns not used: {', '.join(ignored)}", file=sys.stderr)
    setting = np.array(columns["setting"])
    length = getattr(design.elements, "length", None) or math.inf
    beyond = np.flatnonzero((setting < 0.0) | (setting > length))
    if design.kind == "torsion_tube" and beyond.size:
        raise InputError(
            f"{setting[beyond[0]]:g} m is outside the element; allowed is 0 to {length:g}, in metres",
            file=path,
            field=f"row {beyond[0] + 1}, column setting",
        )
    return setting, np.array(columns[name])


def _lines(found: Verification) -> Iterator[str]:
    import numpy as np

    header, rows = found.table
    # a name and its column, one a line, so that the table fits a terminal
    keys = [f"({number})" for number in range(1, len(header) + 1)]
    for key, name in zip(keys, header, strict=True):
        yield f"{key} {name}"
    widths = [max(len(row[column]) for row in [keys, *rows]) for column in range(len(header))]
    for row in [keys, *rows]:
        yield "  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
    errors = [method.errors[np.isfinite(method.errors)] for method in found.comparison.methods]
    worst = max((float(error.max()) for error in errors if error.size), default=0.0)
    reference = keys[header.index(next(name for name in header if name.startswith(found.comparison.reference.label)))]
    yield f"In brackets: the difference from {reference}."
    yield f"Largest change of a 3-D value in its last refinement: {100.0 * worst:.2g} %."
    yield from found.comparison.remarks
    yield from (f"Assumed: {text}" for text in found.comparison.assumptions)
    for label, ends in found.ends.items():
        yield f"End model for the design file, {label}, met to {100.0 * ends.residual:.2g} %:"
        yield f"  {end_model(ends)}"


def end_model(ends: EndFit) -> str:
    """A fitted end model as the design file writes it."""
    effect = ends.effect
    # a design's active length is above zero; a fit that includes the lock holds as close to it as one likes
    low, high = (f"{max(1e3 * value, 1e-3):.6g} mm" for value in (effect.shortest, effect.longest))
    parts = [f"offset: {1e3 * effect.offset:.4g} mm"]
    if effect.lock_offset != 0.0 and ends.lock_length > 0.0:
        parts += [f"lock_length: {1e3 * ends.lock_length:.4g} mm", f"decay_length: {1e3 * effect.decay:.4g} mm"]
    return f"end_model: {{{', '.join(parts)}, valid: {{min: {low}, max: {high}}}}}"
