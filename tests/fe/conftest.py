from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _own_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    """Checks compute; the ones about the cache set their own."""
    monkeypatch.setenv("VARISTIFF_CACHE", "off")
