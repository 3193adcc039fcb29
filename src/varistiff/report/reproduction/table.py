"""The board as rows for people."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from varistiff.papers.claim import Inputs, Relation
from varistiff.papers.finding import Computed, Finding
from varistiff.papers.reproduce import counts
from varistiff.papers.verdict import Verdict
from varistiff.report.display import MISSING, number

_MINUS = re.compile(r"(?<![^\W\d_])-(?=\d)")  # before a number; not the hyphen of a word
HEADER = ("where", "what", "published", "computed", "difference", "tolerance", "verdict")
_SIGNS = {Relation.AT_MOST: "≤ ", Relation.AT_LEAST: "≥ "}
_UNITS = {"1": "", "N*m": "N·m", "N*m/rad": "N·m/rad", "deg": "°", "mm^4": "mm⁴", "mm^3": "mm³", "mm^2": "mm²"}


@dataclass(frozen=True)
class Line:
    """One finding as words: the cells of ``HEADER``, and why."""

    where: str
    what: str
    published: str
    computed: str
    difference: str
    tolerance: str
    verdict: str
    reason: str

    @property
    def cells(self) -> tuple[str, ...]:
        """Cells in the order of ``HEADER``."""
        return self.where, self.what, self.published, self.computed, self.difference, self.tolerance, self.verdict


def line(finding: Finding) -> Line:
    """Say a finding in words, four significant digits, with units."""
    claim = finding.claim
    unit = _unit(claim.unit)
    shown = finding.claim.numbers != []
    reason = ". ".join(text.rstrip(".") for text in (finding.trouble, claim.reason) if text)
    if claim.tolerance is not None:
        reason = ". ".join(text for text in (reason, f"Tolerance: {claim.tolerance.reason.rstrip('.')}") if text)
    if claim.inputs is Inputs.FITTED:
        reason = f"Fitted input. {reason}"
    difference = finding.difference
    return Line(
        where=claim.locator,
        what=claim.quantity + (f" ({claim.conditions})" if claim.conditions else ""),
        published=_published(finding, unit),
        computed=_computed(finding.computed, unit),
        difference=_with(number(difference), unit) if difference is not None else MISSING,
        tolerance=_with(number(claim.allowance), unit) if shown else MISSING,
        verdict=finding.verdict.value.replace("_", " "),
        reason=reason,
    )


def summary(findings: Iterable[Finding]) -> str:
    """How many results have each verdict, as one sentence."""
    found = counts(findings)
    total = sum(found.values())
    parts = [f"{count} {verdict.value.replace('_', ' ')}" for verdict, count in found.items() if count]
    return f"{total} results: {', '.join(parts)}." if parts else "No results."


def unexpected(findings: Iterable[Finding]) -> list[Finding]:
    """The findings that differ from what is expected of them."""
    return [finding for finding in findings if finding.verdict is Verdict.UNEXPECTED]


def of_paper(findings: Sequence[Finding], paper: str) -> list[Finding]:
    """The findings of one paper."""
    return [finding for finding in findings if finding.paper == paper]


def _published(finding: Finding, unit: str) -> str:
    claim = finding.claim
    if claim.published is None:
        return "unpublished"
    if isinstance(claim.published, list):
        return _with(" to ".join(claim.published), unit)
    if claim.relation is Relation.HOLDS:
        return claim.published
    return _SIGNS.get(claim.relation, "") + _with(_MINUS.sub("\N{MINUS SIGN}", claim.published), unit)


def _computed(computed: Computed | None, unit: str) -> str:
    if computed is None:
        return MISSING
    if isinstance(computed, tuple):
        return _with(" to ".join(map(number, computed)), unit)
    return _with(number(computed), unit)


def _with(text: str, unit: str) -> str:
    return f"{text} {unit}".rstrip() if unit != "°" else f"{text}°"


def _unit(unit: str) -> str:
    return _UNITS.get(unit, unit.replace("*", "·"))
