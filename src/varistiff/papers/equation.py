"""One numbered equation of a paper, as ``equations.yaml`` states it."""

from __future__ import annotations

from enum import StrEnum
from functools import cache
from typing import Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from varistiff.papers.registry import paper_entries


class Standing(StrEnum):
    """Whether an equation is used as printed."""

    AS_PRINTED = "as_printed"
    CORRECTED = "corrected"


class Equation(BaseModel):
    """A numbered equation: what it says, what implements it, and what is wrong with it.

    Parameters
    ----------
    number : as printed, such as ``(5)``; of an equation without a number, where it stands
    what : in our words
    implemented_by : public names, ``module:name`` or ``module:Class.method``
    standing : as printed or corrected
    correction : of a corrected one, the right form and why the printed one is wrong (in MyST, with dollar maths)
    proof : of a corrected one, the test that shows it, ``tests/....py::name``
    """

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    number: str = Field(min_length=1)
    what: str = Field(min_length=3)
    implemented_by: list[str] = Field(min_length=1)
    standing: Standing = Field(strict=False)
    correction: str = ""
    proof: str | None = None

    @model_validator(mode="after")
    def _check(self) -> Self:
        corrected = self.standing is Standing.CORRECTED
        if corrected != bool(self.correction) or corrected != (self.proof is not None):
            raise ValueError(f"equation {self.number}: a corrected one, and no other, has a correction and a proof")
        return self


@cache
def load_equations(paper: str) -> tuple[Equation, ...]:
    """Return every numbered equation of a paper, in its order.

    Raises
    ------
    InputError : no such paper
    """
    return tuple(Equation.model_validate(entry) for entry in paper_entries(paper, "equations.yaml"))
