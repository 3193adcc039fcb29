from __future__ import annotations

import platform
from pathlib import Path

import pytest

from varistiff.core import kernel_cache
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


def test_no_home_is_no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    def nowhere(_: type[Path]) -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setattr(Path, "home", classmethod(nowhere))
    assert chosen() is None


def test_the_place_depends_on_the_processor_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def place(model: str, flags: str, host: str, more: str = "") -> str:
        described = tmp_path / "cpuinfo"
        described.write_text(
            f"processor\t: 0\nmodel name\t: {model}\ncpu MHz\t: {len(more)}\nflags\t\t: {flags}\n{more}"
        )
        monkeypatch.setattr(kernel_cache, "_PROCESSORS", described)
        monkeypatch.setattr(platform, "node", lambda: host)
        monkeypatch.delenv(NAME, raising=False)
        return str(chosen())

    one = place("A 1", "fpu avx", "here")
    assert place("A 1", "fpu avx", "there") == one
    assert place("A 1", "fpu avx", "here", more="\nprocessor\t: 1\nmodel name\t: B\nflags\t: fpu\n") == one
    assert len({one, place("A 1", "fpu avx avx512f", "here"), place("A 2", "fpu avx", "here")}) == 3


def test_the_place_without_a_description_of_the_processor(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernel_cache, "_PROCESSORS", tmp_path / "missing")
    places = []
    for machine in ("arm64", "x86_64"):
        monkeypatch.setattr(platform, "machine", lambda each=machine: each)
        monkeypatch.delenv(NAME, raising=False)
        places.append(chosen())
    assert None not in places
    assert len(set(places)) == 2
