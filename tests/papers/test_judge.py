"""A verdict follows from agreement and from what is expected, whichever way they differ."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.papers.claim import Claim
from varistiff.papers.finding import find, judge
from varistiff.papers.printed import half_digit, value_of
from varistiff.papers.verdict import Verdict

PAPER = "schuy_2013"
CONTRADICTED = {"expected": "contradicted", "reason": "because", "proof": "tests/papers/test_judge.py::test_x"}
OPEN = {"expected": "underdetermined", "reason": "unpublished"}


def claim(**fields: Any) -> Claim:
    plain = {
        "id": "one",
        "locator": "Table I",
        "quantity": "a number",
        "published": "71.56",
        "computation": "module.function",
        "expected": "reproduced",
    }
    return Claim.model_validate({**plain, **fields})


@pytest.mark.parametrize(
    "fields, computed, verdict",
    [
        ({}, 71.5649, Verdict.REPRODUCED),
        ({}, 71.5651, Verdict.UNEXPECTED),
        (CONTRADICTED, 72.0, Verdict.CONTRADICTED),
        (CONTRADICTED, 71.56, Verdict.UNEXPECTED),  # a disagreement that disappears is as red
        ({**OPEN, "agrees": True}, 71.56, Verdict.UNDERDETERMINED),
        ({**OPEN, "agrees": True}, 80.0, Verdict.UNEXPECTED),
        ({**OPEN, "agrees": False}, 80.0, Verdict.UNDERDETERMINED),
        ({**OPEN, "agrees": True}, (60.0, 80.0), Verdict.UNDERDETERMINED),
        ({**OPEN, "agrees": True}, (72.0, 80.0), Verdict.UNEXPECTED),
        ({**OPEN, "agrees": True, "inputs": "fitted"}, 71.56, Verdict.FITTED),
        ({**OPEN, "published": None}, 3.0, Verdict.UNDERDETERMINED),
        ({"relation": "at_most"}, 12.0, Verdict.REPRODUCED),
        ({"relation": "at_most"}, 71.57, Verdict.UNEXPECTED),
        ({"relation": "at_least"}, 71.57, Verdict.REPRODUCED),
        ({"relation": "at_least"}, 12.0, Verdict.UNEXPECTED),
        ({"relation": "within", "published": ["6", "25"]}, 25.4, Verdict.REPRODUCED),
        ({"relation": "within", "published": ["6", "25"]}, 5.4, Verdict.UNEXPECTED),
        ({"relation": "holds", "published": "higher above 0.04 m"}, 0.1, Verdict.REPRODUCED),
        ({"relation": "holds", "published": "higher above 0.04 m"}, -0.1, Verdict.UNEXPECTED),
        ({**OPEN, "relation": "holds", "published": "a", "agrees": True}, (-0.1, 0.1), Verdict.UNDERDETERMINED),
        ({**CONTRADICTED, "relation": "holds", "published": "a"}, (-0.1, 0.1), Verdict.UNEXPECTED),  # a reading is true
        ({"tolerance": {"relative": 0.1, "reason": "about"}}, 78.0, Verdict.REPRODUCED),
        ({"tolerance": {"absolute": 0.1, "reason": "about"}}, 71.7, Verdict.UNEXPECTED),
        ({}, float("nan"), Verdict.UNEXPECTED),
        (CONTRADICTED, float("nan"), Verdict.UNEXPECTED),  # no number proves nothing
    ],
)
def test_verdict(fields: dict[str, Any], computed: float | tuple[float, float], verdict: Verdict) -> None:
    assert judge(PAPER, claim(**fields), computed).verdict is verdict


@pytest.mark.parametrize(
    "fields, said",
    [
        ({"expected": None}, "a result has `expected`"),
        ({"role": "input"}, "a result has `expected`"),
        ({"role": "input", "expected": None}, "no computation"),
        ({"computation": None}, "only an underdetermined result"),
        ({"expected": "contradicted", "reason": "because"}, "has a `proof`"),
        ({"proof": "tests/a.py::test_b"}, "has a `proof`"),
        ({**OPEN}, "`agrees` belongs"),
        ({**OPEN, "agrees": True, "reason": ""}, "no `reason`"),
        ({"inputs": "fitted"}, "published inputs"),
        ({"inputs": "assumed"}, "published inputs"),
        ({**OPEN, "agrees": False, "inputs": "fitted"}, "reproduces nothing"),
        ({"relation": "within"}, "two printed numbers"),
        ({"published": ["1", "2"]}, "two printed numbers"),
        ({"published": None}, "cannot be compared"),
        ({"published": "about 3"}, "no printed number"),
        ({"unit": "parsec"}, "unknown unit"),
        ({"tolerance": {"absolute": 1.0, "relative": 1.0, "reason": "why"}}, "either absolute or relative"),
        ({"tolerance": {"absolute": 1.0}}, "reason"),
        ({"publishd": "1"}, "publishd"),
    ],
)
def test_a_claim_that_breaks_a_rule_of_the_board_is_refused(fields: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        claim(**fields)


def test_numbers_come_in_the_unit_of_the_claim() -> None:
    stiffness = claim(published="2.000", unit="N*m/deg")
    assert stiffness.factor == pytest.approx(57.29577951308232, rel=1e-15)  # 180/pi, to rounding
    assert claim(unit="%").factor == 0.01


def test_a_computation_that_fails_is_a_red_claim() -> None:
    found = find(PAPER, claim(computation="no_such.function"))
    assert found.verdict is Verdict.UNEXPECTED
    assert "no_such" in found.trouble


def test_without_its_extra_a_claim_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("varistiff.papers.finding.find_spec", lambda name: None)
    assert find(PAPER, claim(extra="fe")).verdict is Verdict.NOT_RUN


@given(st.integers(-(10**6), 10**6), st.integers(0, 5))
def test_half_a_digit_is_what_rounding_loses(number: int, places: int) -> None:
    text = f"{number / 10**places:.{places}f}"
    assert value_of(text) == pytest.approx(number / 10**places, rel=1e-15)  # the nearest double
    assert half_digit(text) == pytest.approx(0.5 * 10.0**-places, rel=1e-15)
