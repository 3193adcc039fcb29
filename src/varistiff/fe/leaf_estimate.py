"""What a leaf will take, before it begins."""

from __future__ import annotations

from collections.abc import Sequence

from varistiff.actuators.actuator import Actuator
from varistiff.fe.estimate import ALL_KEPT, Estimate, counted
from varistiff.fe.leaf_devices import problems_of
from varistiff.fe.leaf_problem import LeafProblem
from varistiff.fe.leaf_solve import ORDERS, elements_of
from varistiff.fe.leaf_store import recall

_BASE = 1.5e8  # of the program itself [bytes]
_BYTES = 2.6e4  # of matrix, factor and vectors, per unknown at order 4 [bytes]
_ELEMENT_SECONDS = 0.045  # assembly and factorisation of one element of order 4 in one step of Newton's method
_STEPS = 10.0  # of Newton's method over the levels, as steps at order 4


def leaf_estimate(problem: LeafProblem) -> Estimate:
    """Unknowns, memory and time of one leaf at its second level, where nearly all leaves end.

    Raises
    ------
    InputError : no contact, or no equilibrium in beam theory
    """
    along, across = elements_of(problem)
    order = ORDERS[1]
    unknowns = 3 * (along * order + 1) * (across * order + 1) * (order + 1)
    # a leaf without lateral contraction starts at its solution
    steps = _STEPS if problem.poissons_ratio != 0.0 else 0.5 * _STEPS
    return Estimate(unknowns, _BASE + _BYTES * unknowns, steps * _ELEMENT_SECONDS * along * across)


def leaf_outlook(
    actuator: Actuator, points: Sequence[tuple[float, float]], *, poissons_ratio: float, tolerance: float
) -> str:
    """What a check at several points (deflection, setting) is expected to take in all, in one line.

    Raises
    ------
    InputError : a point without a load
    """
    ratios = dict.fromkeys((0.0, poissons_ratio))  # each point is solved with both
    problems = [
        problem
        for deflection, setting in points
        for ratio in ratios
        for problem in problems_of(actuator, deflection, setting, poissons_ratio=ratio)
    ]
    new = [problem for problem in problems if recall(problem, tolerance=tolerance) is None]
    if not new:
        return ALL_KEPT
    whole = Estimate.one_after_the_other(leaf_estimate(problem) for problem in new)
    return (
        f"{counted(len(new), len(problems), 'solid')}, in all: about {whole.time} and {whole.room}; "
        "estimates, within a factor of about two"
    )
