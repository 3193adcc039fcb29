"""One printed statement of a paper, as ``claims.yaml`` states it."""

from __future__ import annotations

from enum import StrEnum
from functools import cached_property
from typing import Any, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from varistiff.core.quantity_units import parse_unit
from varistiff.papers.printed import half_digit, value_of

_PLAIN_UNITS = {"1": 1.0, "%": 0.01}


class Role(StrEnum):
    """Whether the paper starts from a number or arrives at it."""

    RESULT = "result"
    INPUT = "input"


class Inputs(StrEnum):
    """Where the numbers come from that a computation starts from."""

    PUBLISHED = "published"
    ASSUMED = "assumed"
    FITTED = "fitted"


class Relation(StrEnum):
    """How the computed number has to lie to the printed one."""

    EQUALS = "equals"
    AT_MOST = "at_most"
    AT_LEAST = "at_least"
    WITHIN = "within"  # between two printed numbers
    HOLDS = "holds"  # a statement in words; its computation gives a margin that is positive where it is true


class Expected(StrEnum):
    """What the board expects of a result."""

    REPRODUCED = "reproduced"
    CONTRADICTED = "contradicted"
    UNDERDETERMINED = "underdetermined"


class Tolerance(BaseModel):
    """How far a computed number may lie off and why, where that is not half a unit of the last printed digit."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    absolute: float | None = Field(None, ge=0.0, strict=False)  # in the claim's unit
    relative: float | None = Field(None, ge=0.0, strict=False)
    reason: str = Field(min_length=3)

    @model_validator(mode="after")
    def _check_one(self) -> Self:
        if (self.absolute is None) == (self.relative is None):
            raise ValueError("a tolerance is either absolute or relative")
        return self


class Claim(BaseModel):
    """One printed statement: where it stands, what it says, what computes it and what is expected of it.

    Parameters
    ----------
    id : unique in its paper
    locator : table, row and column; equation; figure; or section and paragraph
    quantity : what the number is, in our words; of a statement, what its margin is
    published : digits as printed; two of them for ``within``; our words for a statement; None where unpublished
    unit : of ``published`` and of everything the board says; computations return SI
    conditions : under which the paper says it
    computation : ``module.function`` of the paper's package; its keyword arguments stand in ``with``
    tolerance : half a unit of the last digit where none is given
    inputs : where the computation's numbers come from; ``fitted`` where one was fitted to this very claim
    expected, agrees, reason : what is expected and why; ``agrees`` only of an underdetermined claim with a computation
    proof : test that proves a contradiction, ``tests/....py::name``
    extra : optional dependency that the computation needs
    """

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, ignored_types=(cached_property,))

    id: str = Field(pattern=r"^[a-z][a-z0-9_]*$")
    locator: str = Field(min_length=3)
    quantity: str = Field(min_length=3)
    published: str | list[str] | None
    unit: str = "1"
    conditions: str = ""
    role: Role = Field(Role.RESULT, strict=False)
    relation: Relation = Field(Relation.EQUALS, strict=False)
    computation: str | None = None
    arguments: dict[str, Any] = Field(default_factory=dict, alias="with")
    tolerance: Tolerance | None = None
    inputs: Inputs = Field(Inputs.PUBLISHED, strict=False)
    expected: Expected | None = Field(None, strict=False)
    agrees: bool | None = None
    reason: str = ""
    proof: str | None = None
    extra: str | None = None

    @property
    def numbers(self) -> list[float]:
        """Values of the printed digits, none for a statement in words or an unpublished number."""
        if self.published is None or self.relation is Relation.HOLDS:
            return []
        if self.role is Role.INPUT:
            return []  # an input may be a word, such as a material
        texts = self.published if isinstance(self.published, list) else [self.published]
        return [value_of(text) for text in texts]

    @cached_property
    def factor(self) -> float:
        """SI value of one of the claim's unit."""
        return _PLAIN_UNITS[self.unit] if self.unit in _PLAIN_UNITS else float(parse_unit(self.unit).factor)

    @property
    def allowance(self) -> float:
        """Largest difference that counts as agreement, in the claim's unit."""
        numbers = self.numbers
        if not numbers:
            return 0.0
        if self.tolerance is None:
            texts = self.published if isinstance(self.published, list) else [str(self.published)]
            return max(half_digit(text) for text in texts)
        if self.tolerance.absolute is not None:
            return self.tolerance.absolute
        return float(self.tolerance.relative or 0.0) * max(abs(number) for number in numbers)

    @model_validator(mode="after")
    def _check(self) -> Self:
        problem = next((text for wrong, text in self._problems() if wrong), None)
        if problem is not None:
            raise ValueError(f"claim {self.id}: {problem}")
        if self.unit not in _PLAIN_UNITS:
            parse_unit(self.unit)
        _ = self.allowance  # the digits can be read
        return self

    def _problems(self) -> list[tuple[bool, str]]:
        """Every rule of the board, and whether the claim breaks it."""
        result, expected = self.role is Role.RESULT, self.expected
        computed = self.computation is not None
        undetermined = expected is Expected.UNDERDETERMINED
        pair = isinstance(self.published, list)
        return [
            (result != (expected is not None), "a result has `expected`, an input has none"),
            (not result and computed, "an input has no computation"),
            (result and not computed and not undetermined, "only an underdetermined result may lack a computation"),
            (
                (undetermined and computed and self.published is not None) != (self.agrees is not None),
                "`agrees` belongs to an underdetermined claim that is computed and printed",
            ),
            (result and expected is not Expected.REPRODUCED and not self.reason, "says no `reason`"),
            (
                expected is Expected.REPRODUCED and self.inputs is not Inputs.PUBLISHED,
                "reproduced means published inputs",
            ),
            (
                self.inputs is Inputs.FITTED and not (undetermined and self.agrees),
                "a fitted input reproduces nothing: underdetermined, agrees",
            ),
            (
                (expected is Expected.CONTRADICTED) != (self.proof is not None),
                "a contradiction, and nothing else, has a `proof`",
            ),
            (result and pair != (self.relation is Relation.WITHIN), "`within` takes two printed numbers, others one"),
            (pair and len(self.published or []) != 2, "`within` takes two printed numbers"),
            (result and self.published is None and not undetermined, "what is unpublished cannot be compared"),
            (self.relation is Relation.HOLDS and self.tolerance is not None, "a statement in words has no tolerance"),
        ]
