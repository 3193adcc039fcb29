"""The command line in this process, and the example designs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from varistiff.cli.main import main

EXAMPLES = Path(__file__).parents[2] / "examples"


class Run(NamedTuple):
    status: int
    out: str
    err: str

    @property
    def line(self) -> str:
        """What was said, which must be one line that a person can read."""
        assert self.err.endswith("\n")
        assert self.err.count("\n") == 1
        assert "Traceback" not in self.err
        assert len(self.err) < 700
        return self.err.strip()


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., Run]:
    def call(*arguments: object) -> Run:
        capsys.readouterr()
        status = main([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        return Run(status, captured.out, captured.err)

    return call


@pytest.fixture
def example() -> Callable[[str], str]:
    def read(kind: str) -> str:
        return (EXAMPLES / f"{kind}.yaml").read_text(encoding="utf-8")

    return read


@pytest.fixture
def series(tmp_path: Path, example: Callable[[str], str]) -> Path:
    """A design of the kind that computes fastest."""
    path = tmp_path / "series.yaml"
    path.write_text(example("series_elastic"), encoding="utf-8")
    return path


@pytest.fixture
def points(tmp_path: Path) -> Path:
    path = tmp_path / "points.csv"
    path.write_text("deflection\n0.1\n-0.05\n", encoding="utf-8")
    return path
