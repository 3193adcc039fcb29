"""How finely a section is solved: a list of rungs, and the error that is stated with the result."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from typing import NamedTuple

import numpy as np

from varistiff.core.errors import InputError
from varistiff.sections.boundary import boundary_of
from varistiff.sections.condensed import place_condensed
from varistiff.sections.outline import Outline
from varistiff.sections.panels import NODES_MAX, Nodes, place_nodes
from varistiff.sections.saint_venant import SaintVenant, Values, solve_torsion
from varistiff.sections.separation import CROWDED

GAP = math.radians(60.0)  # outside a re-entrant corner: from here on order 4 may leave more than 1e-4
QUICK = 1024  # nodes on the whole boundary: of the rungs with fewer, the finest is used


class Rung(NamedTuple):
    """Nodes a panel and share of J given up at a corner, of a solution and of the coarser one that tells its error.

    ``most`` is the number of nodes up to which it counts as quick, ``beside_gaps`` the same where there is a gap
    narrower than GAP.
    """

    fine: tuple[int, float]
    coarse: tuple[int, float]
    most: int = QUICK
    beside_gaps: int = QUICK


RUNGS = (
    Rung((10, 1e-8), (8, 1e-6)),
    Rung((8, 1e-6), (6, 3e-5)),
    Rung((6, 1e-6), (4, 3e-6)),
    Rung((6, 1e-5), (4, 3e-5)),
    Rung((4, 1e-5), (3, 1e-4)),
    Rung((4, 3e-5), (3, 3e-4)),
    Rung((4, 1e-4), (3, 1e-3)),
)
# where corners are condensed the shares are left to the few that are not, and what counts is the nodes
CONDENSED_RUNGS = (
    Rung((10, 1e-9), (8, 1e-8)),
    Rung((8, 1e-8), (6, 1e-7)),
    Rung((6, 1e-7), (5, 1e-6)),
    Rung((5, 1e-6), (4, 1e-5), beside_gaps=1280),
    Rung((4, 1e-5), (3, 1e-4)),
)
ROUNDING = 1e-14
CONDENSED_ERROR = 5e-8  # of what is interpolated over the angle, which both solutions share
LOOSE, LOOSEST = 3e-3, 1e-2  # stated error from which on a finer rung is tried, and the largest that is accepted
SAFETY = 10.0  # times the difference of J, which may cancel by chance
CANCELLED = 0.05  # of the differences of its parts, of which as a rule a thousandth is left


class _Ladder:
    """The rungs of one outline, from the finest, and which of them is quick enough."""

    def __init__(self, outline: Outline) -> None:
        self.boundary = boundary_of(outline)
        self.copies = outline.rotations * (2 if outline.mirror else 1)
        corners = self.boundary.corners
        condensed = self.copies == 1 and any(corner.is_reentrant for corner in corners)
        self.place: Callable[..., Nodes] = place_condensed if condensed else place_nodes
        self.rungs = CONDENSED_RUNGS if condensed else RUNGS
        self.has_gap = 2.0 * math.pi - max((one.interior_angle for one in corners), default=math.pi) < GAP

    def quick(self) -> tuple[int, tuple[Nodes, Nodes]]:
        """Number of the finest rung that stays quick, or else of the last one, and its nodes."""
        for number, rung in enumerate(self.rungs[:-1]):
            most = rung.beside_gaps if self.has_gap else rung.most
            with suppress(InputError):
                return number, self.nodes(number, int(most / math.sqrt(self.copies)))
        last = len(self.rungs) - 1
        return last, self.nodes(last, NODES_MAX)

    def nodes(self, number: int, limit: int) -> tuple[Nodes, Nodes]:
        """Nodes of a rung, at most so many, and those of its coarser solution."""
        rung = self.rungs[number]
        fine, coarse = (
            self.place(self.boundary, order=order, tolerance=share, limit=limit)
            for order, share in (rung.fine, rung.coarse)
        )
        return fine, coarse


def rung_nodes(outline: Outline) -> tuple[Nodes, Nodes]:
    """Nodes of the finest rung that stays quick, or else of the last one, and those of its coarser solution.

    Corners are condensed where the outline has re-entrant ones, at which the stress is unbounded, and no symmetry.

    Raises
    ------
    InputError : walls or gaps too thin, or too many corners
    """
    return _Ladder(outline).quick()[1]


def settled(outline: Outline) -> tuple[SaintVenant, float]:
    """Solve an outline's torsion on the finest quick rung, or on finer ones until the stated error of J is small.

    Raises
    ------
    InputError : walls or gaps too thin, or too many corners, for any rung
    """
    ladder = _Ladder(outline)
    number, nodes = ladder.quick()
    solve = partial(solve_torsion, outline)
    fine, coarse = (solve(nodes=one) for one in nodes)
    while stated_error(fine, coarse) > LOOSE and number > 0:
        number -= 1
        try:
            nodes = ladder.nodes(number, NODES_MAX)
        except InputError:
            break
        fine, coarse = (solve(nodes=one) for one in nodes)
    error = stated_error(fine, coarse)
    if not error < LOOSEST:
        raise InputError(CROWDED)
    return fine, error


def stated_error(fine: SaintVenant, coarse: SaintVenant) -> float:
    """Error of the finer one of two solutions' J, from what the coarser one has else.

    J is a sum over the segments of the boundary, whose errors all but cancel, most of all in thin walls. So the
    difference of J tells more than that of the parts, times SAFETY because it may vanish by chance, and in that case
    the parts tell. More than their sum, twice with condensed corners, was never found. All this is experience, with
    some 1500 random sections, and no bound.
    """
    parts = difference(fine, coarse)
    whole = abs((coarse.torsion_constant - fine.torsion_constant) / fine.torsion_constant)
    most, least = (2.0 * parts, CONDENSED_ERROR) if fine.nodes.condensed else (parts, ROUNDING)
    return max(min(most, max(SAFETY * whole, CANCELLED * parts)), least)


def difference(fine: SaintVenant, coarse: SaintVenant) -> float:
    """Relative difference of J between two solutions of one outline, without cancellation.

    It is the sum over the segments of the boundary: what one corner has too much hides nothing of what another lacks.
    """
    return float(np.abs(_terms(coarse) - _terms(fine)).sum()) / abs(fine.torsion_constant)


def _terms(solution: SaintVenant) -> Values:
    """What J is the sum of [m^4]: the warping along each segment, and the polar moment."""
    nodes, outline = solution.nodes, solution.outline
    along = (nodes.position * nodes.tangent).sum(axis=1)
    starts = np.cumsum([0, *(t.size for t in nodes.parameters[:-1])])
    copies = outline.rotations * (2 if outline.mirror else 1)
    warping = np.add.reduceat(solution.warping * along * nodes.weight, starts)
    return np.append(-copies * warping, sum(solution.second_moments[:2]))
