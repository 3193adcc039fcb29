"""The board: every claim of the papers, computed and judged."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from varistiff.papers.claim import Role
from varistiff.papers.claims import load_claims
from varistiff.papers.finding import Finding, find
from varistiff.papers.registry import PAPERS, check_paper
from varistiff.papers.verdict import Verdict


def reproduce(papers: Sequence[str] = PAPERS, *, tell: Callable[[str], None] = lambda text: None) -> list[Finding]:
    """Compute every claim of the papers.

    Parameters
    ----------
    papers : keys, as ``PAPERS`` lists them
    tell : is told what is going on

    Returns
    -------
    One finding a claim, in the order of the papers.

    Raises
    ------
    InputError : no such paper
    """
    findings: list[Finding] = []
    for paper in map(check_paper, papers):
        claims = load_claims(paper)
        for number, claim in enumerate(claims, start=1):
            tell(f"{paper}: claim {number} of {len(claims)}, {claim.id}")
            findings.append(find(paper, claim))
    return findings


def counts(findings: Iterable[Finding]) -> dict[Verdict, int]:
    """How many results have each verdict; inputs are not counted."""
    found = Counter(finding.verdict for finding in findings if finding.claim.role is Role.RESULT)
    return {verdict: found[verdict] for verdict in Verdict if verdict is not Verdict.INPUT}
