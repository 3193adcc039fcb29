"""A kept result belongs to the question and to the code that answered it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from varistiff.fe import cache


def test_another_question_is_another_entry() -> None:
    assert cache.cache_key("torsion", 0.1, np.arange(3.0)) == cache.cache_key("torsion", 0.1, np.arange(3.0))
    assert cache.cache_key("torsion", 0.1, np.arange(3.0)) != cache.cache_key("torsion", 0.1, -np.arange(3.0))
    assert cache.cache_key("torsion", 0.1) != cache.cache_key("torsion", 0.1 + 1e-16)


def test_other_code_is_another_entry(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache.resources, "files", lambda package: tmp_path)
    keys = []
    for sign in "+-":
        cache._sources.cache_clear()
        (tmp_path / "torsion_solid.py").write_text(f"load = {sign}1.0\n", encoding="utf-8")
        keys.append(cache.cache_key("torsion"))
    cache._sources.cache_clear()
    assert keys[0] != keys[1]
