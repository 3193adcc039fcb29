"""One figure of a paper, as ``figures.yaml`` states it."""

from __future__ import annotations

from functools import cache
from typing import Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from varistiff.papers.registry import paper_entries


class PaperFigure(BaseModel):
    """A figure of a paper and ours of the same computation.

    Parameters
    ----------
    number : as printed, such as ``Figure 3``
    shows : what it shows, in our words
    drawn_by : function of ``varistiff.report.papers.<paper>`` that draws ours; None for a photograph or a sketch
    claims : ids of the statements about it
    reason : why there is none of ours
    """

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    number: str = Field(min_length=3)
    shows: str = Field(min_length=3)
    drawn_by: str | None = None
    claims: list[str] = Field(default_factory=list)
    reason: str = ""

    @model_validator(mode="after")
    def _check(self) -> Self:
        if (self.drawn_by is None) != bool(self.reason):
            raise ValueError(f"{self.number}: drawn by us, or a reason why not")
        return self


@cache
def load_figures(paper: str) -> tuple[PaperFigure, ...]:
    """Return every figure of a paper, in its order.

    Raises
    ------
    InputError : no such paper
    """
    return tuple(PaperFigure.model_validate(entry) for entry in paper_entries(paper, "figures.yaml"))
