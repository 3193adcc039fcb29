"""Results appear whole or not at all."""

from __future__ import annotations

import errno
import functools
import itertools
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

from varistiff.core import writing
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


def fill(staged: Path, text: str) -> None:
    (staged / "map.nc").write_text(text)
    (staged / "figures").mkdir()
    (staged / "figures" / "a.svg").write_text(text)


def test_a_directory_appears_whole_and_is_replaced_as_a_whole(tmp_path: Path) -> None:
    target = tmp_path / "results"
    with staged_directory(target) as staged:
        fill(staged, "1")
        assert not target.exists()
    (target / "figures" / "stale.svg").write_text("1")
    with staged_directory(target) as staged:
        fill(staged, "2")
        assert (target / "map.nc").read_text() == "1"
    assert names(tmp_path) == ["results", "results/figures", "results/figures/a.svg", "results/map.nc"]
    assert (target / "map.nc").read_text() == "2"


class Signal:
    """Interrupts at one line of the code that puts results in their place, as a signal may."""

    files = (writing.__file__, shutil.__file__)

    def __init__(self, line: int) -> None:
        self.left = line

    def __call__(self, frame: FrameType, event: str, _: object) -> Signal | None:
        if frame.f_code.co_filename not in self.files:
            return None
        if event == "line":
            self.left -= 1
            if self.left == 0:
                raise KeyboardInterrupt  # which also ends the tracing
        return self


def interrupted_at(line: int, action: Callable[[], None]) -> bool:
    before = sys.gettrace()
    sys.settrace(Signal(line))
    try:
        action()
    except KeyboardInterrupt:
        return True
    finally:
        sys.settrace(before)
    return False


@pytest.mark.filterwarnings("ignore:unclosed file:ResourceWarning")  # interrupted on the way into close
@pytest.mark.parametrize("parents", [".", "deep/er"])
@pytest.mark.parametrize("earlier", [False, True])
@pytest.mark.parametrize("what", ["file", "directory"])
def test_an_interruption_anywhere_leaves_the_old_or_the_new_and_nothing_else(
    tmp_path: Path, what: str, earlier: bool, parents: str
) -> None:
    def make(target: Path, text: str) -> None:
        if what == "file":
            with staged_file(target) as stream:
                stream.write(text)
        else:
            with staged_directory(target) as staged:
                fill(staged, text)

    def content(place: Path) -> dict[str, str]:
        return {name: (place / name).read_text() if (place / name).is_file() else "" for name in names(place)}

    found = []
    for line in itertools.count(1):
        place = tmp_path / str(line)
        place.mkdir()
        target = place / parents / "results"
        if earlier:
            make(target, "old")
        old = content(place)
        stopped = interrupted_at(line, functools.partial(make, target, "new"))
        after = content(place)
        if not stopped:
            break
        assert after == old or {text for text in after.values() if text} == {"new"}
        assert not [name for name in after if "/." in f"/{name}"]
        found.append(after == old)
    assert set(after.values()) - {""} == {"new"}
    assert any(found)  # interrupted before the swap
    assert not all(found)  # and after it
    assert found == sorted(found, reverse=True)  # once the new one stands, it stays


def test_a_result_that_cannot_be_put_back_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "results"
    with staged_directory(target) as staged:
        fill(staged, "old")
    whole = Path.rename

    def rename(self: Path, to: Path) -> Path:
        if to == target:
            raise OSError(errno.EIO, os.strerror(errno.EIO), str(self))
        return whole(self, to)

    monkeypatch.setattr(Path, "rename", rename)
    said = pytest.raises(InputError, match="cannot be put back: input/output error; it is in ")
    with said as caught, staged_directory(target) as staged:
        fill(staged, "new")
    assert (Path(str(caught.value).rpartition("it is in ")[2]) / "map.nc").read_text() == "old"


def test_a_directory_without_write_permission_is_said_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)  # permissions do not hold for root
    with pytest.raises(InputError, match="cannot be written: permission denied"), staged_directory(tmp_path):
        pytest.fail("began")


@pytest.mark.parametrize("stage", [staged_file, staged_directory])
def test_an_error_of_the_block_is_not_blamed_on_the_output(tmp_path: Path, stage: Callable[..., Any]) -> None:
    with pytest.raises(FileNotFoundError, match="missing"), stage(tmp_path / "out"):
        (tmp_path / "missing").read_text()
    with pytest.raises(ConnectionResetError), stage(tmp_path / "out"):
        raise ConnectionResetError(errno.ECONNRESET, os.strerror(errno.ECONNRESET))
    elsewhere = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(tmp_path / "elsewhere"))
    with pytest.raises(OSError, match="elsewhere"), stage(tmp_path / "out"):
        raise elsewhere
    assert names(tmp_path) == []


def test_an_error_below_the_staged_directory_is_about_the_output(tmp_path: Path) -> None:
    said = pytest.raises(InputError, match="out: cannot be written: no such file or directory")
    with said, staged_directory(tmp_path / "out") as staged:
        (staged / "missing" / "a.svg").write_text("")
    assert names(tmp_path) == []


def test_a_pipe_is_written_to(tmp_path: Path) -> None:
    script = (
        "from varistiff.core.writing import staged_file, staged_directory\n"
        "with staged_file('/dev/stdout') as stream: stream.write('a')\n"
        "try:\n"
        "    with staged_directory('/dev/stdout'): pass\n"
        "except ValueError as error: print(error)\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.stderr == ""
    assert done.stdout == "a/dev/stdout: is a file; allowed is the name of a directory\n"


def test_a_pipe_without_a_reader_is_no_wrong_input(tmp_path: Path) -> None:
    reading, writing_end = os.pipe()
    os.close(reading)
    try:
        with pytest.raises(BrokenPipeError), staged_file(f"/dev/fd/{writing_end}") as stream:
            stream.write("a")
    finally:
        os.close(writing_end)


def test_a_link_is_followed(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link.csv").symlink_to(tmp_path / "real" / "out.csv")
    with staged_file(tmp_path / "link.csv") as stream:
        stream.write("a")
    assert (tmp_path / "link.csv").is_symlink()
    assert (tmp_path / "real" / "out.csv").read_text() == "a"
