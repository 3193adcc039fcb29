"""Results appear whole or not at all."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest

from varistiff.core.errors import InputError
from varistiff.core.writing import staged_directory, staged_file


def fail(_: object, failure: type[BaseException]) -> None:
    raise failure


def names(directory: Path) -> list[str]:
    return sorted(str(path.relative_to(directory)) for path in directory.rglob("*"))


def test_a_file_appears_when_the_block_ends(tmp_path: Path) -> None:
    target = tmp_path / "new" / "out.csv"
    with staged_file(target) as stream:
        stream.write("a\n")
        assert not target.exists()
    assert target.read_text() == "a\n"
    assert names(tmp_path) == ["new", "new/out.csv"]


@pytest.mark.parametrize("failure", [ValueError, KeyboardInterrupt, SystemExit])
def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path: Path, failure: type[BaseException]) -> None:
    target = tmp_path / "out.csv"
    target.write_text("old")
    with pytest.raises(failure), staged_file(target) as stream:
        fail(stream.write("new"), failure)
    assert target.read_text() == "old"
    assert names(tmp_path) == ["out.csv"]
    with pytest.raises(failure), staged_file(tmp_path / "a" / "b" / "out.csv"):
        raise failure
    with pytest.raises(failure), staged_directory(tmp_path / "a" / "b") as staged:
        fail((staged / "part").write_text("new"), failure)
    assert names(tmp_path) == ["out.csv"]


def test_a_full_disk_is_one_line_and_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    said = pytest.raises(InputError, match=r"out\.csv: cannot be written: no space left on device")
    with said, staged_file(tmp_path / "out.csv") as stream:
        stream.write("a")
    assert names(tmp_path) == []


def test_a_device_is_written_to_and_stays_a_device() -> None:
    with pytest.raises(InputError, match="no space left"), staged_file("/dev/full") as stream:
        stream.write("a")
    with staged_file("/dev/null") as stream:
        stream.write("a")
    assert Path("/dev/null").is_char_device()
    assert Path("/dev/full").is_char_device()


def test_a_path_below_a_file_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(InputError, match="cannot be written: not a directory"), staged_file(tmp_path / "file" / "o"):
        pass
    said = pytest.raises(InputError, match="cannot be written: not a directory")
    with said, staged_directory(tmp_path / "file" / "o"):
        pass
    with pytest.raises(InputError, match="is a file"), staged_directory(tmp_path / "file"):
        pass
    with pytest.raises(InputError, match="is a directory"), staged_file(tmp_path):
        pass
    assert names(tmp_path) == ["file"]


def test_a_directory_appears_whole_and_keeps_other_files(tmp_path: Path) -> None:
    target = tmp_path / "results"
    with staged_directory(target) as staged:
        (staged / "map.nc").write_text("1")
        (staged / "figures").mkdir()
        (staged / "figures" / "a.svg").write_text("1")
        assert not target.exists()
    (target / "notes.txt").write_text("mine")
    (target / "figures" / "mine.svg").write_text("mine")
    with staged_directory(target) as staged:
        (staged / "map.nc").write_text("2")
        (staged / "figures").mkdir()
        (staged / "figures" / "a.svg").write_text("2")
    assert names(tmp_path) == [
        "results",
        "results/figures",
        "results/figures/a.svg",
        "results/figures/mine.svg",
        "results/map.nc",
        "results/notes.txt",
    ]
    assert (target / "map.nc").read_text() == "2"
    assert (target / "notes.txt").read_text() == "mine"


def test_a_link_is_followed(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link.csv").symlink_to(tmp_path / "real" / "out.csv")
    with staged_file(tmp_path / "link.csv") as stream:
        stream.write("a")
    assert (tmp_path / "link.csv").is_symlink()
    assert (tmp_path / "real" / "out.csv").read_text() == "a"
