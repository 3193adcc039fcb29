from __future__ import annotations

from pathlib import Path

import pytest

from varistiff.core.kernel_cache import keep_compiled_kernels

NAME = "JAX_COMPILATION_CACHE_DIR"


@pytest.fixture(autouse=True)
def clean(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for variable in (NAME, "JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS", "JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES"):
        monkeypatch.setenv(variable, "")
        monkeypatch.delenv(variable)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.delenv("VARISTIFF_CACHE", raising=False)


def chosen() -> str | None:
    import os

    keep_compiled_kernels()
    return os.environ.get(NAME)


def test_kernels_are_kept_in_the_users_cache(tmp_path: Path) -> None:
    place = chosen()
    assert place is not None
    assert Path(place).is_dir()
    assert Path(place).parent == tmp_path / "varistiff"


def test_another_place_or_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", str(tmp_path / "elsewhere"))
    assert str(chosen()).startswith(str(tmp_path / "elsewhere"))
    monkeypatch.delenv(NAME)
    monkeypatch.setenv("VARISTIFF_CACHE", "off")
    assert chosen() is None


def test_a_cache_of_the_users_own_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(NAME, "mine")
    assert chosen() == "mine"


def test_no_cache_where_none_can_be_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("", encoding="utf-8")
    monkeypatch.setenv("VARISTIFF_CACHE", str(blocked))
    assert chosen() is None
