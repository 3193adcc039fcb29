"""The claims of a paper."""

from __future__ import annotations

from collections import Counter
from functools import cache

from varistiff.papers.claim import Claim
from varistiff.papers.registry import paper_entries


@cache
def load_claims(paper: str) -> tuple[Claim, ...]:
    """Return every claim of a paper, in the order of the paper.

    Raises
    ------
    InputError : no such paper
    ValueError : the data file breaks a rule of the board, or an id stands twice
    """
    claims = tuple(Claim.model_validate(entry) for entry in paper_entries(paper, "claims.yaml"))
    twice = [name for name, count in Counter(claim.id for claim in claims).items() if count > 1]
    if twice:
        raise ValueError(f"papers/{paper}/claims.yaml: ids that stand twice: {', '.join(twice)}")
    return claims
