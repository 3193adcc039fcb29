"""`varistiff analyse`: the directory appears whole or not at all."""

from __future__ import annotations

import errno
import os
import shutil
import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import varistiff

RESULTS = ["datasheet.csv", "datasheet.json", "figures", "map.nc", "report.html"]


def names(directory: Path) -> list[str]:
    return sorted(path.name for path in directory.iterdir())


def test_results_appear_where_they_were_asked_for(
    run: Callable[..., Any], series: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    output = series.parent / "new" / "results"
    done = run("analyse", series, "--output", output)
    assert (done.status, done.err) == (0, "")
    assert "160 N" in done.out.splitlines()[0]
    assert done.out.splitlines()[-1] == f"Results are in {output}"
    assert names(output) == RESULTS
    before = (output / "map.nc").stat().st_mtime_ns
    assert run("analyse", series, "--output", output).status == 0  # again, over the first
    assert (output / "map.nc").stat().st_mtime_ns > before
    assert names(output) == RESULTS
    assert names(series.parent) == ["new", "series.yaml"]
    assert names(series.parent / "new") == ["results"]
    monkeypatch.chdir(series.parent / "new")
    assert run("analyse", series).status == 0
    assert names(Path.cwd()) == ["results", "series_analysis"]  # named after the design


def full_disk(*_: object) -> None:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def interrupt(*_: object) -> None:
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(5.0)


def break_down(*_: object) -> None:
    raise ZeroDivisionError("a mistake of ours")


@pytest.mark.parametrize(
    "action, status, said",
    [
        (full_disk, 2, "cannot be written: no space left on device"),
        (interrupt, 2, "varistiff: interrupted"),
        (break_down, 1, "varistiff itself failed (ZeroDivisionError: a mistake of ours)"),
    ],
)
@pytest.mark.parametrize("where", ["map", "figures", "over an earlier result"])
def test_a_run_that_fails_leaves_nothing(
    run: Callable[..., Any],
    series: Path,
    monkeypatch: pytest.MonkeyPatch,
    action: Callable[..., None],
    status: int,
    said: str,
    where: str,
) -> None:
    output = series.parent / "results"
    if where == "over an earlier result":
        output.mkdir()
        for name in ("map.nc", "datasheet.json", "report.html"):
            (output / name).write_text("old")
    place = "varistiff.characteristic.map.characteristic_map" if where == "map" else "varistiff.report.figures.draw_all"
    monkeypatch.setattr(place, lambda *_, **__: action())
    result = run("analyse", series, "--output", output)
    assert result.status == status
    assert said in result.line
    assert result.out == ""
    if where == "over an earlier result":
        assert names(series.parent) == ["results", "series.yaml"]
        assert {path.read_text() for path in output.iterdir()} == {"old"}
    else:
        assert names(series.parent) == ["series.yaml"]


@pytest.mark.parametrize("when", ["after the swap", "while the earlier result goes away"])
def test_an_interruption_after_the_swap_leaves_the_new_result_alone(
    run: Callable[..., Any], series: Path, monkeypatch: pytest.MonkeyPatch, when: str
) -> None:
    output = series.parent / "results"
    output.mkdir()
    for name in ("map.nc", "datasheet.json", "report.html"):
        (output / name).write_text("old")
    rename, rmtree = Path.rename, shutil.rmtree
    standing = []

    def renamed(self: Path, to: Path) -> Path:
        done = rename(self, to)
        if to == output:
            standing.append(to)
            if when == "after the swap":
                os.kill(os.getpid(), signal.SIGTERM)
        return done

    def removed(*arguments: Any, **options: Any) -> None:
        if standing and when != "after the swap":
            standing.clear()
            os.kill(os.getpid(), signal.SIGTERM)
        rmtree(*arguments, **options)

    monkeypatch.setattr(Path, "rename", renamed)
    monkeypatch.setattr(shutil, "rmtree", removed)
    result = run("analyse", series, "--output", output)
    assert (result.status, result.line) == (2, "varistiff: interrupted")
    assert names(series.parent) == ["results", "series.yaml"]
    assert names(output) == RESULTS
    assert "old" not in (output / "report.html").read_text()[:3]


def test_the_output_is_tried_before_anything_is_computed(
    run: Callable[..., Any], series: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("varistiff.characteristic.map.characteristic_map", lambda *_, **__: pytest.fail("computed"))
    for output in (series, series / "results", series.parent):
        result = run("analyse", series, "--output", output)
        assert result.status == 2
        assert result.line.startswith(f"varistiff: {output}: ")
    assert names(series.parent) == ["series.yaml"]
    with pytest.raises(varistiff.InputError, match="is a file"):
        varistiff.analyse(series, series)
