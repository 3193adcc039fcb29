"""The report directory: complete, self-contained, escaped, and whole or not there at all."""

from __future__ import annotations

import html
import json
import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from varistiff.core.errors import InputError
from varistiff.design.design import Design, load
from varistiff.report import analyse as module
from varistiff.report.analyse import analyse

from .conftest import ACTUATORS, design_of

HOSTILE = '<script>alert(1)</script> & "quoted" {{ 7*7 }} $x_1$ </title><img src=x onerror=y>'


class _Page(HTMLParser):
    """Collects what a browser would load, and every tag."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        values = dict(attrs)
        if tag != "a":
            self.loaded += [
                values[key] or "" for key in ("src", "href", "xlink:href", "data", "srcset") if key in values
            ]
        self.loaded += re.findall(r"url\(([^)]*)\)", values.get("style") or "")


def _page(text: str) -> _Page:
    page = _Page()
    page.feed(text)
    return page


def _small(design: Design, monkeypatch: pytest.MonkeyPatch) -> Design:
    """The same design with a coarse map: these tests are about files."""
    whole = Design.map
    monkeypatch.setattr(Design, "map", lambda self, **_: whole(self, deflection_points=21, setting_points=9))
    return design


@pytest.fixture
def joint(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Design:
    return _small(design_of("series_elastic", folder), monkeypatch)


def test_every_kind_makes_a_whole_report(
    kind: str, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    design = _small(design_of(kind, folder), monkeypatch)
    result = analyse(design, tmp_path / "result")
    files = {path.relative_to(result.output).as_posix() for path in result.output.rglob("*") if path.is_file()}
    assert {"map.nc", "datasheet.json", "datasheet.csv", "report.html", "figures/mechanism.svg"} <= files
    svgs = {name.removesuffix(".svg") for name in files if name.endswith(".svg")}
    assert svgs == {name.removesuffix(".png") for name in files if name.endswith(".png")}
    text = (result.output / "report.html").read_text(encoding="utf-8")
    page = _page(text)
    assert page.tags.count("svg") == len(svgs)
    assert "script" not in page.tags
    assert "link" not in page.tags
    assert all(reference.startswith(("#", "data:")) for reference in page.loaded)
    style = text[text.index("<style>") : text.index("</style>")]
    assert "@import" not in style
    assert "url(" not in style
    ids = re.findall(r'\sid="([^"]+)"', text)
    assert len(ids) == len(set(ids))
    assert design.hash in text
    with xr.open_dataset(result.output / "map.nc", engine="h5netcdf") as stored:
        assert stored.attrs["design_hash"] == design.hash
        np.testing.assert_array_equal(stored.energy.values, result.dataset.energy.values)
    json.loads((result.output / "datasheet.json").read_text(encoding="utf-8"))


def test_what_a_user_wrote_is_escaped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "hostile.yaml"
    comment, name = "# --> </pre><script>alert(2)</script>", json.dumps(HOSTILE)
    path.write_text(f"{comment}\nname: {name}\nactuator: {ACTUATORS['series_elastic']}\n", encoding="utf-8")
    result = analyse(_small(load(path), monkeypatch), tmp_path / "result")
    text = (result.output / "report.html").read_text(encoding="utf-8")
    assert f"<h1>{html.escape(HOSTILE).replace('&quot;', '&#34;')}</h1>" in text
    tags = _page(text).tags
    assert "script" not in tags
    assert "img" not in tags


def test_summary_counts_and_explains_what_is_not_ok(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    result = analyse(_small(design_of("torsion_tube", folder), monkeypatch), tmp_path / "result")
    counts = {entry.status.label: entry.count for entry in result.datasheet.statuses}
    assert counts["yielded"] > 0
    assert any(line.startswith(f"yielded: {counts['yielded']} points") for line in result.summary)
    assert any("warning: actuator.setting.max" in line for line in result.summary)


def test_an_earlier_result_is_replaced_as_a_whole(joint: Design, tmp_path: Path) -> None:
    target = tmp_path / "result"
    analyse(joint, target)
    (target / "figures" / "stale.svg").write_text("old", encoding="utf-8")
    analyse(joint, target)
    assert not (target / "figures" / "stale.svg").exists()
    assert [path.name for path in tmp_path.iterdir()] == ["result"]


def test_an_empty_directory_is_used(joint: Design, tmp_path: Path) -> None:
    (tmp_path / "result").mkdir()
    assert (analyse(joint, tmp_path / "result").output / "report.html").is_file()


@pytest.mark.parametrize("where", ["notes.txt", "figures/notes.txt"])
def test_other_people_s_files_are_never_replaced(joint: Design, tmp_path: Path, where: str) -> None:
    target = tmp_path / "result"
    analyse(joint, target)
    (target / where).write_text("mine", encoding="utf-8")
    before = sorted(target.rglob("*"))
    with pytest.raises(InputError, match="result"):
        analyse(joint, target)
    assert sorted(target.rglob("*")) == before
    assert (target / where).read_text(encoding="utf-8") == "mine"


def test_a_directory_of_something_else_is_refused(joint: Design, tmp_path: Path) -> None:
    (tmp_path / "map.nc").write_text("", encoding="utf-8")
    with pytest.raises(InputError, match="earlier result"):
        analyse(joint, tmp_path)
    with pytest.raises(InputError, match="is a file"):
        analyse(joint, tmp_path / "map.nc")


@pytest.mark.parametrize("failure", [KeyboardInterrupt(), RuntimeError("no"), OSError(28, "No space left on device")])
@pytest.mark.parametrize("earlier", [False, True])
def test_a_run_that_fails_leaves_everything_as_it_was(
    joint: Design, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failure: BaseException, earlier: bool
) -> None:
    target = tmp_path / "deep" / "result"
    if earlier:
        analyse(joint, target)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}

    def fail(*_: object) -> None:
        raise failure

    monkeypatch.setattr(module, "_write_data", fail)  # the last thing that is written
    expected = InputError if isinstance(failure, OSError) else type(failure)
    with pytest.raises(expected):
        analyse(joint, target)
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before
    if not earlier:
        assert list(tmp_path.iterdir()) == []


def test_a_failed_swap_brings_the_earlier_result_back(
    joint: Design, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "result"
    analyse(joint, target)
    report = (target / "report.html").read_bytes()
    whole = Path.rename

    def rename(self: Path, to: Path) -> Path:
        if to == target and self.name == "fresh":
            raise OSError(5, "Input/output error")
        return whole(self, to)

    monkeypatch.setattr(Path, "rename", rename)
    with pytest.raises(InputError):
        analyse(joint, target)
    assert (target / "report.html").read_bytes() == report
    assert [path.name for path in tmp_path.iterdir()] == ["result"]


def test_a_file_that_somebody_adds_meanwhile_is_not_replaced(
    joint: Design, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "result"
    analyse(joint, target)
    whole = module._write_data

    def write(*arguments: Any) -> None:
        whole(*arguments)
        (target / "notes.txt").write_text("mine", encoding="utf-8")

    monkeypatch.setattr(module, "_write_data", write)
    with pytest.raises(InputError, match=r"notes\.txt"):
        analyse(joint, target)
    assert (target / "notes.txt").read_text(encoding="utf-8") == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["result"]


def test_a_disk_that_fills_up_under_the_map_is_said(
    joint: Design, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object, **__: object) -> None:  # what HDF5 says when it closes the file
        raise RuntimeError("Can't decrement id ref count (file write failed: errno = 28, error message = ...)")

    monkeypatch.setattr(xr.Dataset, "to_netcdf", full)
    with pytest.raises(InputError, match="result: cannot be written: no space left on device"):
        analyse(joint, tmp_path / "result")
    assert list(tmp_path.iterdir()) == []


def test_progress_goes_to_standard_error(joint: Design, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    analyse(joint, tmp_path / "result", progress=True)
    streams = capsys.readouterr()
    assert streams.out == ""
    assert "report" in streams.err
