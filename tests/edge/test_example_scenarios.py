"""Every scenario that ships runs to its end, and its energy balance closes."""

from __future__ import annotations

from pathlib import Path

import pytest

import varistiff
from varistiff.dynamics.outcome import Outcome

FOLDER = Path(__file__).parents[2] / "examples" / "scenarios"
FILES = sorted(path for path in FOLDER.glob("*.yaml") if "duration:" in path.read_text(encoding="utf-8"))


def test_all_of_them_are_here() -> None:
    assert len(FILES) >= 9
    designs = {path.name for path in FOLDER.glob("*.yaml")} - {path.name for path in FILES}
    assert designs == {"knee_beam.yaml"}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_an_example_is_done_and_its_balance_closes(path: Path) -> None:
    found = varistiff.load_scenario(path).simulate()
    assert found.outcome is Outcome.DONE, found.failed_at
    assert found.audit.closes
    assert found.audit.relative <= found.audit.allowance <= 1e-4  # what the audit allows with impact or stick
