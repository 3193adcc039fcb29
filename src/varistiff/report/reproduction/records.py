"""The board as plain data: JSON and CSV."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Sequence
from typing import Any

from varistiff.papers.finding import Finding

COLUMNS = (
    "paper",
    "id",
    "locator",
    "quantity",
    "conditions",
    "role",
    "relation",
    "published",
    "unit",
    "computed",
    "difference",
    "tolerance",
    "agrees",
    "expected",
    "verdict",
    "reason",
    "inputs",
    "computation",
    "proof",
    "extra",
)


def record(finding: Finding) -> dict[str, Any]:
    """One finding as plain data; numbers in the claim's unit, an interval as a list of its ends, unknown as null."""
    claim = finding.claim
    found = finding.computed
    return {
        "paper": finding.paper,
        "id": claim.id,
        "locator": claim.locator,
        "quantity": claim.quantity,
        "conditions": claim.conditions,
        "role": claim.role.value,
        "relation": claim.relation.value,
        "published": claim.published,
        "unit": claim.unit,
        "computed": [_plain(end) for end in found] if isinstance(found, tuple) else _plain(found),
        "difference": _plain(finding.difference),
        "tolerance": _plain(claim.allowance) if claim.numbers else None,
        "agrees": finding.agrees,
        "expected": None if claim.expected is None else claim.expected.value,
        "verdict": finding.verdict.value,
        "reason": "; ".join(text for text in (finding.trouble, claim.reason) if text),
        "inputs": claim.inputs.value,
        "computation": claim.computation,
        "proof": claim.proof,
        "extra": claim.extra,
    }


def as_json(findings: Sequence[Finding]) -> str:
    """The board as a JSON list with an object for each claim."""
    records = [record(finding) for finding in findings]
    return json.dumps(records, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def as_csv(findings: Sequence[Finding]) -> str:
    """The board as CSV with a row for each claim; two numbers in a cell are joined by ``..``, unknown is empty."""
    stream = io.StringIO()
    table = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
    table.writeheader()
    table.writerows({key: _cell(value) for key, value in record(finding).items()} for finding in findings)
    return stream.getvalue()


def _plain(value: float | None) -> float | None:
    return None if value is None or not math.isfinite(value) else value


def _cell(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, list):
        return "..".join(map(_cell, value))
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:.17g}" if isinstance(value, float) else str(value)
