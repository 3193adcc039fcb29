"""What the check of a torsion element will take, before it begins."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from varistiff.fe.estimate import ALL_KEPT, Estimate, counted, direct_solver
from varistiff.fe.torsion_body import bodies, unknowns
from varistiff.fe.torsion_problem import TorsionProblem
from varistiff.fe.torsion_store import recall

FEWEST, USUAL = 2, 3  # meshes: one change at least says how far a stiffness has settled, and one more is often needed


def torsion_estimate(problem: TorsionProblem, *, meshes: int, whole: bool = False) -> Estimate:
    """Unknowns, memory and time of every load case at one setting, refined over so many meshes.

    Raises
    ------
    InputError : the section cannot be meshed
    """
    return Estimate.one_after_the_other(
        direct_solver(unknowns(body, bearing=bearing), matrices=len(body.kinds))
        for body in islice(bodies(problem, whole=whole), meshes)
        for bearing in (False, True)
        if bearing or problem.active_length > 0.0
    )


def torsion_outlook(problems: Sequence[TorsionProblem], *, tolerance: float) -> str:
    """What a check at several settings is expected to take in all, in one line.

    Raises
    ------
    InputError : the section cannot be meshed
    """
    new = [problem for problem in problems if recall(problem, tolerance=tolerance, whole=False) is None]
    if not new:
        return ALL_KEPT
    least, usual = (
        Estimate.one_after_the_other(torsion_estimate(problem, meshes=meshes) for problem in new)
        for meshes in (FEWEST, USUAL)
    )
    return (
        f"{counted(len(new), len(problems), 'setting')}, in all: about {least.time} and {least.room} where {FEWEST} "
        f"meshes a load are enough, {usual.time} and {usual.room} with {USUAL}; estimates, within a factor of about two"
    )
