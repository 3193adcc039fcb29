"""The three-dimensional check of a torsion element, refined until its stiffness settles."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

from varistiff.core.errors import InputError
from varistiff.fe import import_ngsolve
from varistiff.fe.estimate import available_memory, direct_solver
from varistiff.fe.torsion_body import ORDER, Body, bodies, unknowns
from varistiff.fe.torsion_cases import Outcome, away, bearing_outcome, flange_outcome
from varistiff.fe.torsion_problem import LoadCase, Progress, StressPeaks, TorsionProblem, TorsionResult
from varistiff.fe.torsion_store import recall, remember

Run = Callable[[Body], Outcome]


def solve(
    problem: TorsionProblem,
    *,
    tolerance: float = 0.005,
    memory_limit: float | None = None,
    progress: Progress | None = None,
    whole: bool = False,
) -> TorsionResult:
    """Solve every load case of a torsion element in linear elasticity.

    The clamp holds z = 0. Cases: a rigid flange at the active length x on a bar that ends there (warping free, and
    blocked); on the whole element the counter bearing over z in [x, x + bearing_length], by a uniform pressure on the
    driving flank of every rail, and as a rigid frictionless bearing in unilateral contact (a sleeve of the section's
    own outline where there are no rails; bonded where the outside is round).
    At x = 0 only the pressure on the rails' flanks is left.
    The element turns about the section's shear centre.

    Conforming elements make the stiffness under a prescribed rotation too large; a case's error is its relative
    change from the next coarser mesh (half as fine).

    Parameters
    ----------
    tolerance : relative change of every stiffness at which refinement ends
    memory_limit : [bytes]; by default what is free
    progress : called with what begins and with the share of the work that is done
    whole : leave the symmetry of the section unused

    Raises
    ------
    InputError : NGSolve is missing, the section cannot be meshed, or the stiffness does not settle within the memory
    """
    import_ngsolve()
    kept = recall(problem, tolerance=tolerance, whole=whole)
    if kept is not None:
        return kept
    began = time.monotonic()
    limit = available_memory() if memory_limit is None else memory_limit
    say = progress or (lambda _text, _share: None)
    flange, bearing = Body.flange_levels, Body.bearing_levels
    groups: list[tuple[str, Run, Callable[[Body], object]]] = [("counter bearing", bearing_outcome, bearing)]
    if problem.active_length > 0.0:
        groups.insert(0, ("end flange", flange_outcome, flange))
    outcomes, errors = [], []
    for number, (text, run, _) in enumerate(groups):
        share = number / len(groups)
        outcome, error = _settled(problem, text, run, tolerance, limit, whole, say, share, 1.0 / len(groups))
        outcomes.append(outcome)
        errors.append(error)
    result = _result(problem, outcomes, errors, time.monotonic() - began, whole)
    remember(problem, result, tolerance=tolerance, whole=whole)
    say("done", 1.0)
    return result


def _settled(
    problem: TorsionProblem, text: str, run: Run, tolerance: float, limit: float, whole: bool,
    say: Progress, share: float, part: float,
) -> tuple[Outcome, dict[str, float]]:  # fmt: skip
    """Refine until every stiffness changes by no more than the tolerance; return the changes, the stress's too."""
    ng = import_ngsolve()
    before: Outcome | None = None
    errors: dict[str, float] = {}
    for number, body in enumerate(bodies(problem, whole=whole)):
        estimate = direct_solver(unknowns(body, bearing=text != "end flange"), matrices=len(body.kinds))
        if estimate.memory > limit:
            raise InputError(
                f"the 3-D check needs about {estimate.room} for {estimate.unknowns} unknowns and has "
                f"{limit / 2**30:.1f} GiB{_reached(errors)}; allowed are a simpler section or a looser tolerance"
            )
        say(
            f"{text}, mesh {number + 1}: {estimate.unknowns} unknowns, about {estimate.time} and {estimate.room}",
            share + 0.3 * number * part,
        )
        with ng.TaskManager():
            after = run(body)
        if before is not None:
            errors = {name: abs(value / before.stiffness[name] - 1.0) for name, value in after.stiffness.items()}
            if max(errors.values()) <= tolerance:
                return after, {**errors, "stress": abs(after.stress / before.stress - 1.0)}
        before = after
    raise InputError(f"the stiffness of the 3-D check does not settle to {tolerance:.2%}{_reached(errors)}")


def _reached(errors: dict[str, float]) -> str:
    return f" (it last changed by {max(errors.values()):.2%})" if errors else ""


def _result(
    problem: TorsionProblem, outcomes: list[Outcome], errors: list[dict[str, float]], seconds: float, whole: bool
) -> TorsionResult:
    cases = tuple(
        LoadCase(name, stiffness, error[name], outcome.local.get(name, math.nan))
        for outcome, error in zip(outcomes, errors, strict=True)
        for name, stiffness in outcome.stiffness.items()
    )
    bearing = outcomes[-1]
    body = next(bodies(problem, whole=whole))
    torsion = outcomes[0].stress if len(outcomes) == 2 else math.nan
    modulus = float(problem.section.torsion_modulus)
    stress = StressPeaks(
        torsion=torsion,
        torsion_ratio=torsion * modulus if modulus > 0.0 else math.nan,
        bearing=bearing.stress,
        bearing_case=bearing.stress_case,
        bearing_ratio=bearing.stress / torsion,
        distance=away(body),
        sharp=len(body.plane.corners) > 0,
        torsion_error=errors[0]["stress"] if len(outcomes) == 2 else math.nan,
        bearing_error=errors[-1]["stress"],
    )
    sector = (
        "the whole section" if body.plane.angle == 0.0 else f"a sector of {math.degrees(body.plane.angle):.4g} degrees"
    )
    return TorsionResult(
        cases=cases,
        contact=bearing.contact,
        stress=stress,
        fields=tuple(field for outcome in outcomes for field in outcome.fields),
        order=ORDER,
        unknowns=max(outcome.unknowns for outcome in outcomes),
        seconds=seconds,
        method=f"linear elasticity, curved prisms of order {ORDER} on {sector}",
    )
