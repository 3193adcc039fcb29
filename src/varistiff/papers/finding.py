"""A claim beside what varistiff computes for it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from importlib.util import find_spec

from varistiff.papers.claim import Claim, Expected, Inputs, Relation, Role
from varistiff.papers.registry import computation
from varistiff.papers.verdict import Verdict

Computed = float | tuple[float, float]  # a number, or what it can be over everything that the paper leaves open
EXTRAS = {"fe": "ngsolve", "dxf": "ezdxf"}  # extra: the module that it brings


@dataclass(frozen=True)
class Finding:
    """What the board says of one claim; numbers in the claim's unit.

    Parameters
    ----------
    paper, claim : what is judged
    computed : number, interval, or None where nothing was computed
    agrees : whether the two agree within the claim's allowance; None where nothing was computed
    verdict : on the claim
    trouble : what went wrong, where the verdict is ``unexpected``
    """

    paper: str
    claim: Claim
    computed: Computed | None
    agrees: bool | None
    verdict: Verdict
    trouble: str = ""

    @property
    def difference(self) -> float | None:
        """Computed minus printed; of an interval or two printed numbers the part by which they miss each other."""
        numbers = self.claim.numbers
        if self.computed is None or not numbers:
            return None
        return _gap(self.computed, numbers)


def find(paper: str, claim: Claim) -> Finding:
    """Compute a claim and judge it."""
    if claim.role is Role.INPUT:
        return Finding(paper, claim, None, None, Verdict.INPUT)
    if claim.extra is not None and find_spec(EXTRAS[claim.extra]) is None:
        return Finding(paper, claim, None, None, Verdict.NOT_RUN)
    if claim.computation is None:
        return Finding(paper, claim, None, None, Verdict.UNDERDETERMINED)
    try:
        computed = _in_unit(computation(paper, claim.computation)(**claim.arguments), claim.factor)
    except Exception as error:  # a computation that fails is a red claim, not the end of the board
        return Finding(paper, claim, None, None, Verdict.UNEXPECTED, f"{type(error).__name__}: {error}")
    return judge(paper, claim, computed)


def judge(paper: str, claim: Claim, computed: Computed) -> Finding:
    """Hold a computed number [claim's unit] against a claim and against what is expected of it."""
    ends = computed if isinstance(computed, tuple) else (computed,)
    if any(math.isnan(end) for end in ends):
        return Finding(paper, claim, computed, None, Verdict.UNEXPECTED, "the computation gives no number")
    if claim.published is None:
        return Finding(paper, claim, computed, None, Verdict.UNDERDETERMINED)
    agrees = _agrees(claim, computed)
    wanted = {Expected.REPRODUCED: True, Expected.CONTRADICTED: False, Expected.UNDERDETERMINED: claim.agrees}
    assert claim.expected is not None  # a result has it
    if agrees != wanted[claim.expected]:
        trouble = "agrees, which is not expected" if agrees else "does not agree, which is not expected"
        return Finding(paper, claim, computed, agrees, Verdict.UNEXPECTED, trouble)
    verdict = Verdict.FITTED if claim.inputs is Inputs.FITTED else Verdict[claim.expected.name]
    return Finding(paper, claim, computed, agrees, verdict)


def _agrees(claim: Claim, computed: Computed) -> bool:
    if claim.relation is Relation.HOLDS:
        return (max(computed) if isinstance(computed, tuple) else computed) > 0.0  # true in one reading at least
    gap = _gap(computed, claim.numbers)
    if claim.relation is Relation.AT_MOST:
        return gap <= claim.allowance
    if claim.relation is Relation.AT_LEAST:
        return gap >= -claim.allowance
    return abs(gap) <= claim.allowance * (1.0 + 1e-9)  # digits in binary


def _gap(computed: Computed, numbers: list[float]) -> float:
    low, high = computed if isinstance(computed, tuple) else (computed, computed)
    least, largest = min(numbers), max(numbers)
    if low > largest:
        return low - largest
    return min(high - least, 0.0)


def _in_unit(computed: object, factor: float) -> Computed:
    if isinstance(computed, tuple):
        low, high = computed
        return float(low) / factor, float(high) / factor
    return float(computed) / factor  # type: ignore[arg-type]  # whatever a computation returns has to be a number
