"""The hash of a scenario: what a run depends on, and nothing else."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

from pydantic import BaseModel

from varistiff.core.textfile import read_bytes
from varistiff.design.scenario_fields import Amount
from varistiff.design.scenario_signal_spec import TrajectorySpec
from varistiff.design.scenario_spec import ScenarioSpec
from varistiff.design.spec import DesignSpec
from varistiff.design.trajectory_file import TRAJECTORY_LIMIT


def scenario_hash(spec: ScenarioSpec, *, design_hash: str, directory: Path) -> str:
    """SHA-256 of a scenario's content in SI units, its design's hash and the content of its trajectory files.

    Layout, comments, units and the scenario's name do not matter, nor where its files lie.

    Parameters
    ----------
    directory : that the trajectory files are relative to
    """
    plain = _plain(spec, directory)
    plain.pop("name")
    plain["design"] = design_hash
    text = json.dumps(plain, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


def _plain(value: Any, directory: Path) -> Any:
    """Plain data without what is absent; an amount with its SI unit, a file as its content's hash."""
    if isinstance(value, Amount):
        return [value.value, value.kind.unit]
    if isinstance(value, DesignSpec):
        return None  # it has a hash of its own
    if isinstance(value, BaseModel):
        fields = {name: getattr(value, name) for name in type(value).model_fields}
        plain = {name: _plain(field, directory) for name, field in fields.items() if field is not None}
        if isinstance(value, TrajectorySpec):
            data = read_bytes(directory / value.file, limit=TRAJECTORY_LIMIT)
            plain["file"] = hashlib.sha256(data).hexdigest()
        return plain
    return [_plain(part, directory) for part in value] if isinstance(value, list) else value
